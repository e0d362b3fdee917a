use std::collections::BTreeMap;

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{ImageSize, Intrinsics, LensModel, OpenCvFisheye, OpenCvPinhole, RigidTransform};
use oaktwin_diagnostic::Finding;

use crate::model::{Board, Calibration, CameraCalibration, CameraKind, Link, StereoRectification};
use crate::raw::{Raw, Value};
use crate::reader::{Field, Reader, from_rows};
use crate::{CalibrationError, Socket, check};

const TOP_KEYS: [&str; 21] = [
    "version",
    "productName",
    "boardName",
    "boardRev",
    "boardConf",
    "hardwareConf",
    "boardCustom",
    "deviceName",
    "batchName",
    "batchTime",
    "boardOptions",
    "cameraData",
    "stereoRectificationData",
    "imuExtrinsics",
    "housingExtrinsics",
    "miscellaneousData",
    "stereoUseSpecTranslation",
    "stereoEnableDistortionCorrection",
    "verticalCameraSocket",
    "imuCalibrationParams",
    "swapLeftRightCam",
];
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
const STEREO_KEYS: [&str; 4] = [
    "leftCameraSocket",
    "rightCameraSocket",
    "rectifiedRotationLeft",
    "rectifiedRotationRight",
];
/// `LengthUnit::CENTIMETER`.
const CENTIMETRES: i64 = 1;
const M_PER_CM: f64 = 0.01;
/// How far a rotation may be from orthonormal: exports round to 32 bits (1e-6), people to four digits.
const ODD_ROTATION: f64 = 1e-4;
const NO_ROTATION: f64 = 1e-2;

impl Calibration {
    /// Reads and checks a document. The findings are what is odd; among them a baseline that is far from the board's
    /// design is an [error](oaktwin_diagnostic::Level::Error) that [`crate::force`] makes a warning.
    ///
    /// # Errors
    /// [`CalibrationError::Meaningless`] with everything that makes the file no calibration.
    pub fn from_raw(raw: &Raw) -> Result<(Self, Vec<Finding>), CalibrationError> {
        let mut reader = Reader::default();
        let calibration = document(&mut reader, raw);
        if reader.errors.is_empty()
            && let Some(calibration) = &calibration
        {
            check::cameras(&mut reader, calibration);
            check::links(&mut reader, calibration);
            if reader.errors.is_empty() {
                check::stereo(&mut reader, calibration);
            }
        }
        match calibration {
            Some(calibration) if reader.errors.is_empty() => Ok((calibration, reader.findings)),
            _ => Err(CalibrationError::Meaningless {
                file: raw.name.clone(),
                errors: reader.errors,
            }),
        }
    }
}

/// `None` has an error in the reader, as has any value that could not be read.
fn document(reader: &mut Reader, raw: &Raw) -> Option<Calibration> {
    let root = Field::root(&raw.root);
    reader.object(&root, &TOP_KEYS)?;
    let version = version(reader, &root)?;
    let board = board(reader, &root);
    let cameras = cameras(reader, &root)?;
    if reader.errors.is_empty() {
        old_names(reader, &root, version);
    }
    let link = |reader: &mut Reader, key| root.get(key).and_then(|field| placed(reader, &field));
    let imu = link(reader, "imuExtrinsics");
    let housing = link(reader, "housingExtrinsics");
    let stereo = root
        .get("stereoRectificationData")
        .and_then(|field| stereo(reader, &field, &cameras));
    Some(Calibration {
        file_name: raw.name.clone(),
        version,
        board,
        cameras,
        stereo,
        imu,
        housing,
    })
}

fn version(reader: &mut Reader, root: &Field<'_>) -> Option<u32> {
    let Some(field) = root.get("version") else {
        reader.warn(
            "no-version",
            "version",
            "the key is missing; read as version 7, as DepthAI does",
            "add it",
        );
        return Some(7);
    };
    let version = reader.integer(&field, 0, u32::MAX.into())?;
    if version < 4 {
        let message = format!("version {version} has no camera parameters that DepthAI reads; 5 to 7 have");
        reader.error(
            "old-version",
            "version",
            message,
            "calibrate again with a current DepthAI",
        );
        return None;
    }
    if version > 7 {
        let message = format!("version {version} is newer than 7; read as 7");
        reader.warn(
            "new-version",
            "version",
            message,
            "compare the result with DepthAI's",
        );
    }
    u32::try_from(version).ok()
}

fn board(reader: &mut Reader, root: &Field<'_>) -> Board {
    let mut text = |key| {
        root.get(key)
            .and_then(|field| reader.text(&field))
            .unwrap_or_default()
    };
    let mut board = Board {
        product_name: text("productName"),
        board_name: text("boardName"),
        board_rev: text("boardRev"),
        board_conf: text("boardConf"),
        hardware_conf: text("hardwareConf"),
        board_custom: text("boardCustom"),
        device_name: text("deviceName"),
        ..Board::default()
    };
    let mut number = |key, most| {
        root.get(key)
            .and_then(|field| reader.integer(&field, 0, most))
            .unwrap_or_default()
    };
    board.batch_time = number("batchTime", 1 << 52);
    board.board_options = number("boardOptions", u32::MAX.into());
    board
}

/// What only version 5 has. `DepthAI` refuses such files, so whoever uses one should know.
fn old_names(reader: &mut Reader, root: &Field<'_>, version: u32) {
    let mut old: Vec<&str> = Vec::new();
    let mut lacking: Vec<&str> = Vec::new();
    let items = root
        .get("cameraData")
        .and_then(|f| reader.array(&f))
        .unwrap_or_default();
    for camera in items
        .iter()
        .filter_map(|item| reader.array(item)?.get(1).cloned())
    {
        let has = |key| camera.get(key).is_some();
        let extrinsics_has = |key| camera.get("extrinsics").is_some_and(|e| e.get(key).is_some());
        old.extend(["measuredFovDeg"].into_iter().filter(|key| has(key)));
        old.extend(
            ["measuredTranslation", "fromCameraSocket"]
                .into_iter()
                .filter(|key| extrinsics_has(key)),
        );
        lacking.extend(["cameraType", "lensPosition"].into_iter().filter(|key| !has(key)));
    }
    for keys in [&mut old, &mut lacking] {
        keys.sort_unstable();
        keys.dedup();
    }
    if old.is_empty() && lacking.is_empty() {
        return;
    }
    let mut message = format!("version {version}");
    if !old.is_empty() {
        message += &format!(" with the old keys {}", old.join(", "));
    }
    if !lacking.is_empty() {
        message += &format!(
            " without {} (read as 0: perspective, fixed focus)",
            lacking.join(", ")
        );
    }
    message += "; DepthAI itself refuses such a file";
    reader.warn(
        "old-names",
        "cameraData",
        message,
        "export it again with a current DepthAI",
    );
}

fn cameras(reader: &mut Reader, root: &Field<'_>) -> Option<BTreeMap<Socket, CameraCalibration>> {
    let list = reader.require(root, "cameraData")?;
    let mut cameras = BTreeMap::new();
    for item in reader.array(&list)? {
        let Some(pair) = reader.array(&item) else { continue };
        let [socket, info] = pair.as_slice() else {
            let message = format!("line {} has no [socket, camera] pair", item.node.at.line);
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
                    "the camera has no socket; left out",
                    "give it one",
                );
                continue;
            }
            Err(what) => {
                reader.error("bad-socket", &item.path, what, "use 0 (CAM_A) to 9 (CAM_J)");
                continue;
            }
        };
        let Some(camera) = camera(reader, socket, &item.path, info) else {
            continue;
        };
        if cameras.insert(socket, camera).is_some() {
            let message = format!("{socket} is there twice");
            reader.error("repeated-socket", &item.path, message, "remove one of them");
        }
    }
    if cameras.is_empty() && reader.errors.is_empty() {
        let message = "no camera is calibrated";
        reader.error(
            "no-cameras",
            "cameraData",
            message,
            "calibrate the device, then export again",
        );
    }
    Some(cameras)
}

fn camera(reader: &mut Reader, socket: Socket, place: &str, info: &Field<'_>) -> Option<CameraCalibration> {
    // The pair's second element is the camera; findings leave that [1] out.
    let info = &Field {
        node: info.node,
        path: place.to_owned(),
    };
    reader.object(info, &CAMERA_KEYS)?;
    let kind = match info.get("cameraType") {
        None => Some(CameraKind::Perspective),
        Some(field) => kind(reader, &field),
    };
    let mut side = |key| {
        let field = reader.require(info, key)?;
        reader
            .integer(&field, 1, u16::MAX.into())
            .and_then(|n| u32::try_from(n).ok())
    };
    let size = (side("width"), side("height"));
    let matrix = reader
        .require(info, "intrinsicMatrix")
        .and_then(|field| match reader.matrix(&field)? {
            Some(matrix) => Some(matrix),
            None => {
                reader.error("no-intrinsics", field.path, "the camera has none", "calibrate it");
                None
            }
        });
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
        .and_then(|field| camera_link(reader, &field));
    let (kind, size, matrix, distortion) = (kind?, ImageSize::new(size.0?, size.1?), matrix?, distortion?);
    let (lens, distortion) = lens(reader, info, kind, distortion)?;
    Some(CameraCalibration {
        socket,
        place: place.to_owned(),
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
                    "the absent ones are taken to be 0",
                );
            }
            if coefficients.iter().all(|c| *c == 0.0) {
                LensModel::Pinhole
            } else {
                LensModel::OpenCvPinhole(OpenCvPinhole {
                    coefficients: std::array::from_fn(at),
                })
            }
        }
    };
    Some((lens, coefficients))
}

/// The extrinsics of a camera; none at a root.
fn camera_link(reader: &mut Reader, field: &Field<'_>) -> Option<Link> {
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
fn placed(reader: &mut Reader, field: &Field<'_>) -> Option<Link> {
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
fn socket(reader: &mut Reader, field: &Field<'_>) -> Option<Option<Socket>> {
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
fn rotation(reader: &mut Reader, field: &Field<'_>) -> Option<Option<DMat3>> {
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

fn stereo(
    reader: &mut Reader,
    field: &Field<'_>,
    cameras: &BTreeMap<Socket, CameraCalibration>,
) -> Option<StereoRectification> {
    if let Value::Object(entries) = &field.node.value
        && entries.is_empty()
    {
        return None;
    }
    reader.object(field, &STEREO_KEYS)?;
    let mut side = |socket_key: &str, rotation_key: &str| {
        let socket = reader.require(field, socket_key)?;
        let place = socket.path.clone();
        let socket = self::socket(reader, &socket)?;
        let rotation = reader.require(field, rotation_key)?;
        let rotation = self::rotation(reader, &rotation)?;
        if let Some(socket) = socket
            && !cameras.contains_key(&socket)
        {
            let message = format!("{socket} is not in cameraData; the rectification is left out");
            reader.warn("dangling-socket", place, message, "calibrate the stereo pair");
            return Some((None, rotation));
        }
        Some((socket, rotation))
    };
    let left = side("leftCameraSocket", "rectifiedRotationLeft");
    let right = side("rightCameraSocket", "rectifiedRotationRight");
    let ((left, rectified_from_left), (right, rectified_from_right)) = (left?, right?);
    let (left, right) = (left?, right?);
    if left == right {
        let message = format!("left and right are both {left}");
        reader.error("stereo-pair", &field.path, message, "name two cameras");
        return None;
    }
    Some(StereoRectification {
        left,
        right,
        rectified_from_left,
        rectified_from_right,
    })
}
