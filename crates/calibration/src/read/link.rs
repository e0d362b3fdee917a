use std::collections::BTreeSet;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};

use crate::Socket;
use crate::model::ExtrinsicLink;
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
/// The orthonormality error that causes a warning. Exports are rounded to 32 bits (1e-6), manual edits to four digits.
const SUSPICIOUS_ROTATION: f64 = 1e-4;
/// The orthonormality error that makes a rotation invalid.
const INVALID_ROTATION: f64 = 1e-2;

/// Reads the extrinsics of a camera; `None` at a root. A camera without a rotation is a root if it refers to one of
/// `without_intrinsics`.
pub(super) fn camera_link(
    reader: &mut Reader,
    field: &Field<'_>,
    without_intrinsics: &BTreeSet<Socket>,
) -> Option<ExtrinsicLink> {
    let read = link(reader, field)?;
    let Some(to) = read.to else {
        if read.translation_m != DVec3::ZERO {
            let message = "has a translation but refers to no camera; ignored, as in DepthAI";
            reader.warn("root-translation", &field.path, message, "set toCameraSocket");
        }
        return None;
    };
    let Some(rotation) = read.rotation else {
        if without_intrinsics.contains(&to) {
            return None;
        }
        let message = format!("missing, but the extrinsics refer to {to}");
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

/// Reads the extrinsics of the IMU or the housing; `None` if they are empty.
pub(super) fn placed(reader: &mut Reader, field: &Field<'_>) -> Option<ExtrinsicLink> {
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
    fn into_link(self, place: &str, to: Socket, rotation: DMat3) -> ExtrinsicLink {
        let spec = self.spec_translation_m;
        ExtrinsicLink {
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
        let message = "not centimetres (1); ignored, as in DepthAI: translations are read as centimetres";
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
        let message = "refers to another device; read as a camera of this device";
        reader.warn(
            "other-device",
            device.path,
            message,
            "calibrate this device alone",
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
        let message = "255 is read as -1 (none); DepthAI itself reads it as a socket";
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

/// Reads a rotation; `Some(None)` for `[]` and for zeros, which mean "none".
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
        let message = "is a reflection (its determinant is not positive), not a rotation";
        reader.error("not-a-rotation", &field.path, message, "calibrate again");
        return None;
    }
    let message = format!("is not orthonormal: the largest entry of |R'R - I| is {error:.2e}");
    if error.is_nan() || error > INVALID_ROTATION {
        reader.error("not-a-rotation", &field.path, message, "calibrate again");
        return None;
    }
    if error > SUSPICIOUS_ROTATION {
        reader.warn(
            "odd-rotation",
            &field.path,
            message,
            "write it with more digits, or calibrate again",
        );
    }
    Some(Some(rotation))
}
