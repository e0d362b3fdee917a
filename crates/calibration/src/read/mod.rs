use oaktwin_base::diagnostic::Finding;

use crate::model::{Board, Calibration};
use crate::raw::Raw;
use crate::reader::{Field, Reader};
use crate::{CalibrationError, check};

mod camera;
mod link;
mod size;
mod stereo;
mod uncalibrated;

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

impl Calibration {
    /// Reads and checks a document. Among the findings, a baseline that differs much from the board's design is an
    /// [error](oaktwin_base::diagnostic::Level::Error), which [`crate::force`] downgrades to a warning.
    ///
    /// # Errors
    /// Returns [`CalibrationError::Invalid`] with all errors of the document.
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
            _ => Err(CalibrationError::Invalid {
                file: raw.name.clone(),
                errors: reader.errors,
            }),
        }
    }
}

/// Returns `None` after recording an error in the reader.
fn document(reader: &mut Reader, raw: &Raw) -> Option<Calibration> {
    let root = Field::root(&raw.root);
    reader.object(&root, &TOP_KEYS)?;
    let version = version(reader, &root)?;
    let board = board(reader, &root);
    let use_spec_translation = use_spec_translation(reader, &root);
    let cameras = camera::cameras(reader, &root)?;
    if reader.errors.is_empty() {
        old_names(reader, &root, version);
    }
    let link = |reader: &mut Reader, key| root.get(key).and_then(|field| link::placed(reader, &field));
    let imu = link(reader, "imuExtrinsics");
    let housing = link(reader, "housingExtrinsics");
    let stereo = root
        .get("stereoRectificationData")
        .and_then(|field| stereo::stereo(reader, &field, &cameras.calibrated));
    Some(Calibration {
        file_name: raw.name.clone(),
        version,
        board,
        cameras: cameras.calibrated,
        uncalibrated: cameras.uncalibrated,
        stereo,
        imu,
        housing,
        use_spec_translation,
    })
}

fn version(reader: &mut Reader, root: &Field<'_>) -> Option<u32> {
    let Some(field) = root.get("version") else {
        reader.warn(
            "no-version",
            "version",
            "missing; assumed to be 7, as in DepthAI",
            "add it",
        );
        return Some(7);
    };
    let version = reader.integer(&field, 0, u32::MAX.into())?;
    if version < 4 {
        let message =
            format!("version {version} is not supported; DepthAI reads camera parameters of versions 5 to 7");
        reader.error(
            "old-version",
            "version",
            message,
            "calibrate again with a current DepthAI",
        );
        return None;
    }
    if version > 7 {
        let message = format!("version {version} is newer than 7; assumed to be 7");
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
    let mut number = |key, max| {
        root.get(key)
            .and_then(|field| reader.integer(&field, 0, max))
            .unwrap_or_default()
    };
    board.batch_time = number("batchTime", 1 << 52);
    board.board_options = number("boardOptions", u32::MAX.into());
    board
}

/// Reads the flag of the baseline, and checks the types of the others, with which `DepthAI` rejects a file.
fn use_spec_translation(reader: &mut Reader, root: &Field<'_>) -> bool {
    let mut flag = |key| root.get(key).and_then(|field| reader.flag(&field));
    flag("stereoEnableDistortionCorrection");
    flag("swapLeftRightCam");
    flag("stereoUseSpecTranslation").unwrap_or(true)
}

/// Warns about files with keys of version 5, which `DepthAI` rejects.
fn old_names(reader: &mut Reader, root: &Field<'_>, version: u32) {
    let mut old: Vec<&str> = Vec::new();
    let mut missing: Vec<&str> = Vec::new();
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
        missing.extend(["cameraType", "lensPosition"].into_iter().filter(|key| !has(key)));
    }
    for keys in [&mut old, &mut missing] {
        keys.sort_unstable();
        keys.dedup();
    }
    if old.is_empty() && missing.is_empty() {
        return;
    }
    let mut message = format!("version {version}");
    if !old.is_empty() {
        message += &format!(" with the old keys {}", old.join(", "));
    }
    if !missing.is_empty() {
        message += &format!(
            " without {} (assumed to be 0: perspective, fixed focus)",
            missing.join(", ")
        );
    }
    message += "; DepthAI rejects such files";
    reader.warn(
        "old-names",
        "cameraData",
        message,
        "export it again with a current DepthAI",
    );
}
