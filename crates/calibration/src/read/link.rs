use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};

use crate::Socket;
use crate::model::Link;
use crate::reader::{Field, Reader, from_rows};

const EXTRINSICS_KEYS: [&str; 8] = [
    "rotationMatrix",
    "translation",
    "specTranslation",
    "toCameraSocket",
    "lengthUnit",
    "toDeviceId",
    "fromCameraSocket",
    "measuredTranslation",
];
/// `LengthUnit::CENTIMETER`.
const CENTIMETRES: i64 = 1;
const M_PER_CM: f64 = 0.01;
/// How far a rotation may be from orthonormal: exports round to 32 bits (1e-6), people to four digits.
const ODD_ROTATION: f64 = 1e-4;
const NO_ROTATION: f64 = 1e-2;

/// The extrinsics of a camera; none at a root.
pub(super) fn camera_link(reader: &mut Reader, field: &Field<'_>) -> Option<Link> {
    let read = link(reader, field)?;
    let Some(to) = read.to else {
        if read.translation_m != DVec3::ZERO {
            let message = "leads to no camera, but has a translation; ignored, as DepthAI does";
            reader.warn("root-translation", &field.path, message, "set toCameraSocket");
        }
        return None;
    };
    let Some(rotation) = read.rotation else {
        let message = format!("there is none, but the extrinsics lead to {to}");
        let place = field.key_path("rotationMatrix");
        reader.error(
            "no-rotation",
            place,
            message,
            "calibrate the camera, or set toCameraSocket to -1",
        );
        return None;
    };
    Some(read.into_link(&field.path, to, rotation))
}

/// The extrinsics of the IMU or the housing; none where the file does not place it.
pub(super) fn placed(reader: &mut Reader, field: &Field<'_>) -> Option<Link> {
    let read = link(reader, field)?;
    match (read.to, read.rotation) {
        (Some(to), Some(rotation)) => Some(read.into_link(&field.path, to, rotation)),
        _ => None,
    }
}

struct ReadLink {
    to: Option<Socket>,
    rotation: Option<DMat3>,
    translation_m: DVec3,
    spec_translation_m: DVec3,
}

impl ReadLink {
    fn into_link(self, place: &str, to: Socket, rotation: DMat3) -> Link {
        let spec = self.spec_translation_m;
        Link {
            place: place.to_owned(),
            to,
            camera_from_self: RigidTransform::new(rotation, self.translation_m),
            spec_translation: (spec != DVec3::ZERO).then_some(spec),
        }
    }
}

fn link(reader: &mut Reader, field: &Field<'_>) -> Option<ReadLink> {
    reader.object(field, &EXTRINSICS_KEYS)?;
    let to = match field.get("toCameraSocket") {
        Some(socket) => self::socket(reader, &socket)?,
        None => None,
    };
    let rotation = match field.get("rotationMatrix") {
        Some(rotation) => self::rotation(reader, &rotation)?,
        None => None,
    };
    let mut point = |keys: &[&str]| match field.get_any(keys) {
        Some(point) => reader.point(&point),
        None => Some(DVec3::ZERO),
    };
    let (translation, spec) = (
        point(&["translation"])?,
        point(&["specTranslation", "measuredTranslation"])?,
    );
    if let Some(unit) = field.get("lengthUnit")
        && reader.integer(&unit, i32::MIN.into(), i32::MAX.into())? != CENTIMETRES
    {
        let message =
            "not centimetres (1); DepthAI takes the numbers for centimetres whatever it says, and so do we";
        reader.warn(
            "length-unit",
            unit.path,
            message,
            "write the translations in centimetres",
        );
    }
    if let Some(device) = field.get("toDeviceId")
        && !reader.text(&device)?.is_empty()
    {
        let message = "leads to another device; taken for this one's camera";
        reader.warn(
            "other-device",
            device.path,
            message,
            "calibrate the device by itself",
        );
    }
    Some(ReadLink {
        to,
        rotation,
        translation_m: translation * M_PER_CM,
        spec_translation_m: spec * M_PER_CM,
    })
}

#[expect(
    clippy::option_option,
    reason = "an unusable field, no socket, and a socket are three things"
)]
pub(super) fn socket(reader: &mut Reader, field: &Field<'_>) -> Option<Option<Socket>> {
    let number = reader.integer(field, i32::MIN.into(), i32::MAX.into())?;
    if number == 255 {
        let message = "255 is read as -1, none; DepthAI itself looks for a camera of that number";
        reader.note("socket-255", &field.path, message);
    }
    match Socket::from_file(number) {
        Ok(socket) => Some(socket),
        Err(what) => {
            reader.error(
                "bad-socket",
                &field.path,
                what,
                "use 0 (CAM_A) to 9 (CAM_J), or -1 for none",
            );
            None
        }
    }
}

/// `Some(None)` for `[]` and for zeros, which mean that there is none.
#[expect(
    clippy::option_option,
    reason = "an unusable field, no rotation, and a rotation are three things"
)]
pub(super) fn rotation(reader: &mut Reader, field: &Field<'_>) -> Option<Option<DMat3>> {
    let Some(rows) = reader.matrix(field)? else {
        return Some(None);
    };
    if rows == [[0.0; 3]; 3] {
        return Some(None);
    }
    let rotation = from_rows(rows);
    let error = RigidTransform::new(rotation, DVec3::ZERO).orthonormality_error();
    if rotation.determinant() <= 0.0 {
        let message = "mirrors (its determinant is not positive); that is no rotation";
        reader.error("not-a-rotation", &field.path, message, "calibrate again");
        return None;
    }
    let message = format!("is not orthonormal: the largest entry of |R'R - I| is {error:.2e}");
    if error.is_nan() || error > NO_ROTATION {
        reader.error("not-a-rotation", &field.path, message, "calibrate again");
        return None;
    }
    if error > ODD_ROTATION {
        reader.warn(
            "odd-rotation",
            &field.path,
            message,
            "write it with more digits, or calibrate again",
        );
    }
    Some(Some(rotation))
}
