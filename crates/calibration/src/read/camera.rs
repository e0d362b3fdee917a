use std::collections::{BTreeMap, BTreeSet};

use oaktwin_camera::{ImageSize, Intrinsics, LensModel, OpenCvFisheye, OpenCvPinhole};

use super::link::camera_link;
use super::size::size;
use super::uncalibrated::uncalibrated;
use crate::Socket;
use crate::model::{CameraCalibration, CameraKind, ExtrinsicLink};
use crate::reader::{Field, Reader};

const CAMERA_KEYS: [&str; 9] = [
    "cameraType",
    "width",
    "height",
    "lensPosition",
    "intrinsicMatrix",
    "distortionCoeff",
    "specHfovDeg",
    "extrinsics",
    "measuredFovDeg",
];

/// The cameras of a file.
pub(super) struct Cameras {
    pub(super) calibrated: BTreeMap<Socket, CameraCalibration>,
    /// The extrinsics of the cameras without intrinsics.
    pub(super) uncalibrated: BTreeMap<Socket, Option<ExtrinsicLink>>,
}

pub(super) fn cameras(reader: &mut Reader, root: &Field<'_>) -> Option<Cameras> {
    let list = reader.require(root, "cameraData")?;
    let list = reader.array(&list)?;
    let without_intrinsics = uncalibrated(&list);
    let mut cameras = BTreeMap::new();
    let mut uncalibrated = BTreeMap::new();
    for item in list {
        let Some(pair) = reader.array(&item) else { continue };
        let [socket, info] = pair.as_slice() else {
            let message = format!("line {} is not a [socket, camera] pair", item.node.at.line);
            reader.error("wrong-type", item.path, message, "export the calibration again");
            continue;
        };
        let Some(number) = reader.integer(socket, i32::MIN.into(), i32::MAX.into()) else {
            continue;
        };
        let socket = match Socket::from_file(number) {
            Ok(Some(socket)) => socket,
            Ok(None) => {
                reader.warn(
                    "no-socket",
                    &item.path,
                    "the camera has no socket; skipped",
                    "set one",
                );
                continue;
            }
            Err(what) => {
                reader.error("bad-socket", &item.path, what, "use 0 (CAM_A) to 9 (CAM_J)");
                continue;
            }
        };
        // The camera is the pair's second element; findings omit that [1].
        let info = &Field {
            node: info.node,
            path: item.path.clone(),
        };
        if without_intrinsics.contains(&socket) {
            uncalibrated.insert(socket, link_without_intrinsics(reader, socket, info));
            continue;
        }
        let Some(camera) = camera(reader, socket, info, &without_intrinsics) else {
            continue;
        };
        if cameras.insert(socket, camera).is_some() {
            let message = format!("{socket} is repeated");
            reader.error("repeated-socket", &item.path, message, "remove one of them");
        }
    }
    if cameras.is_empty() && reader.errors.is_empty() {
        let message = match uncalibrated.is_empty() {
            true => "the list is empty",
            false => "no camera has intrinsics",
        };
        reader.error(
            "no-cameras",
            "cameraData",
            message,
            "calibrate the device, then export again",
        );
    }
    let is_known =
        |link: &ExtrinsicLink| cameras.contains_key(&link.to) || without_intrinsics.contains(&link.to);
    let uncalibrated = uncalibrated
        .into_iter()
        .map(|(socket, link)| (socket, link.filter(is_known)))
        .collect();
    Some(Cameras {
        calibrated: cameras,
        uncalibrated,
    })
}

/// Reports a camera without intrinsics, and returns its extrinsics if they are usable.
fn link_without_intrinsics(reader: &mut Reader, socket: Socket, info: &Field<'_>) -> Option<ExtrinsicLink> {
    let message = format!(
        "{socket} has no intrinsics (the focal lengths are 0, or the matrix is empty); it counts as missing"
    );
    reader.warn(
        "uncalibrated",
        info.key_path("intrinsicMatrix"),
        message,
        "calibrate the camera to use it",
    );
    let extrinsics = info.get("extrinsics")?;
    // Other cameras may refer to this one; its own errors do not matter otherwise.
    camera_link(&mut Reader::default(), &extrinsics, &BTreeSet::new())
}

fn camera(
    reader: &mut Reader,
    socket: Socket,
    info: &Field<'_>,
    without_intrinsics: &BTreeSet<Socket>,
) -> Option<CameraCalibration> {
    reader.object(info, &CAMERA_KEYS)?;
    let kind = match info.get("cameraType") {
        None => Some(CameraKind::Perspective),
        Some(field) => kind(reader, &field),
    };
    let matrix = reader
        .require(info, "intrinsicMatrix")
        .and_then(|field| reader.matrix(&field)?);
    let size = size(reader, info, matrix);
    let distortion = reader
        .require(info, "distortionCoeff")
        .and_then(|field| reader.numbers(&field));
    let spec_hfov_deg = match info.get_any(&["specHfovDeg", "measuredFovDeg"]) {
        Some(field) => reader.number(&field),
        None => {
            reader.missing(info, "specHfovDeg");
            None
        }
    };
    let lens_position = match info.get("lensPosition") {
        Some(field) => reader.integer(&field, 0, 255),
        None => Some(0),
    };
    let extrinsics = reader
        .require(info, "extrinsics")
        .and_then(|field| camera_link(reader, &field, without_intrinsics));
    let (kind, size, matrix, distortion) = (kind?, size?, matrix?, distortion?);
    let (lens, distortion) = lens(reader, info, kind, distortion)?;
    Some(CameraCalibration {
        socket,
        place: info.path.clone(),
        kind,
        intrinsics: intrinsics(reader, info, size, matrix)?,
        lens,
        distortion,
        spec_hfov_deg: spec_hfov_deg?,
        lens_position: u8::try_from(lens_position?).ok()?,
        extrinsics,
    })
}

fn kind(reader: &mut Reader, field: &Field<'_>) -> Option<CameraKind> {
    let name = match reader.integer(field, i8::MIN.into(), i8::MAX.into())? {
        0 => return Some(CameraKind::Perspective),
        1 => return Some(CameraKind::Fisheye),
        2 => "equirectangular",
        3 => "radial division",
        4 => "cylindrical",
        _ => "unknown",
    };
    let message = format!("the camera model is {name}; only perspective (0) and fisheye (1) are supported");
    reader.error(
        "camera-type",
        &field.path,
        message,
        "calibrate the camera with one of these",
    );
    None
}

fn intrinsics(
    reader: &mut Reader,
    info: &Field<'_>,
    size: ImageSize,
    k: [[f64; 3]; 3],
) -> Option<Intrinsics> {
    let place = info.key_path("intrinsicMatrix");
    if k[0][0] <= 0.0 || k[1][1] <= 0.0 {
        let message = format!(
            "focal lengths {} and {} px; both must be positive",
            k[0][0], k[1][1]
        );
        reader.error("focal-length", place, message, "calibrate the camera");
        return None;
    }
    if k[0][1] != 0.0 || k[1][0] != 0.0 || k[2] != [0.0, 0.0, 1.0] {
        let message = "not of the form [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]; the other entries are ignored";
        reader.warn("intrinsic-form", place, message, "calibrate without skew");
    }
    Some(Intrinsics::from_opencv_matrix(size, k))
}

fn lens(
    reader: &mut Reader,
    info: &Field<'_>,
    kind: CameraKind,
    mut coefficients: Vec<f64>,
) -> Option<(LensModel, Vec<f64>)> {
    let place = info.key_path("distortionCoeff");
    let n = coefficients.len();
    if n > 14 {
        let message = format!("{n} coefficients; the largest model has 14");
        reader.error(
            "distortion-length",
            place,
            message,
            "export the calibration again",
        );
        return None;
    }
    let at = |i: usize| coefficients.get(i).copied().unwrap_or(0.0);
    let lens = match kind {
        CameraKind::Fisheye => {
            let k = [at(0), at(1), at(2), at(3)];
            if coefficients.iter().skip(4).any(|c| *c != 0.0) {
                reader.note(
                    "fisheye-extra",
                    place,
                    "a fisheye has four coefficients; the others are ignored",
                );
            }
            coefficients.truncate(4);
            LensModel::OpenCvFisheye(OpenCvFisheye { k })
        }
        CameraKind::Perspective => {
            if ![0, 4, 5, 8, 12, 14].contains(&n) {
                let message = format!("{n} coefficients; OpenCV has models of 0, 4, 5, 8, 12 and 14");
                reader.warn(
                    "distortion-length",
                    place,
                    message,
                    "missing ones are assumed to be 0",
                );
            }
            if coefficients.iter().all(|c| *c == 0.0) {
                LensModel::Pinhole
            } else {
                LensModel::OpenCvPinhole(OpenCvPinhole::new(std::array::from_fn(at)))
            }
        }
    };
    Some((lens, coefficients))
}
