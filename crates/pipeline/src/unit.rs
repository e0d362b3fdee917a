//! The twin of one unit: a model of the catalog with a calibration file.

use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::{Finding, Level, Message, message, opt};
use oaktwin_base::parameter::Platform;
use oaktwin_calibration::raw::MAX_BYTES;
use oaktwin_calibration::{self as calibration, Calibration, CalibrationError, Raw, Socket};
use oaktwin_catalog::{Catalog, Device, Twin, UnknownModel};
use oaktwin_files::{self as files, FileError};

/// An error that prevents a unit's twin from being created.
#[derive(Debug, thiserror::Error)]
pub enum UnitError {
    /// The file cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// The calibration is invalid.
    #[error(transparent)]
    Calibration(#[from] CalibrationError),
    /// The calibration does not fit the model.
    #[error("{}: {}: {}; {}", path.display(), finding.place, finding.message, finding.remedy)]
    Unfit {
        /// The file.
        path: PathBuf,
        /// The first error.
        finding: Finding,
    },
}

/// Returns a note if the axes of an inertial unit come from a calibration, so that a chosen source of them has no effect.
#[must_use]
pub fn imu_frame_without_effect(catalog: &Catalog, device: &Device, twin: &Twin) -> Option<Finding> {
    (twin.body_from_imu != catalog.nominal(device).body_from_imu).then(|| {
        Finding::new(
            "imu-frame",
            Level::Note,
            "imuExtrinsics",
            message![
                "has the axes of the inertial unit; ",
                opt("imu-frame"),
                " has no effect"
            ],
            "",
        )
    })
}

/// Reads a calibration file: as written and checked. The findings include errors that [`calibration::force`] turns into
/// warnings.
///
/// # Errors
/// Returns an error if the file cannot be read or is not a calibration.
pub fn read_calibration(path: &Path) -> Result<(Raw, Calibration, Vec<Finding>), UnitError> {
    let bytes = files::read(path, MAX_BYTES as u64, "a calibration")?;
    let raw = Raw::parse(&bytes, &path.display().to_string())?;
    let (calibration, findings) = Calibration::from_raw(&raw)?;
    Ok((raw, calibration, findings))
}

/// Returns the twin of the unit with a calibration file, and the findings.
///
/// # Errors
/// Returns an error if the file cannot be read, is not a calibration, or does not fit the model; with `force` the last is a finding.
pub fn open(
    catalog: &Catalog,
    device: &Device,
    path: &Path,
    force: bool,
) -> Result<(Twin, Vec<Finding>), UnitError> {
    let (raw, _, _) = read_calibration(path)?;
    of_raw(catalog, device, &raw, path, force)
}

/// Returns the twin of the unit with a calibration that was read from `path`, and the findings.
///
/// # Errors
/// Returns an error if the calibration is invalid or does not fit the model; with `force` the last is a finding.
pub fn of_raw(
    catalog: &Catalog,
    device: &Device,
    raw: &Raw,
    path: &Path,
    force: bool,
) -> Result<(Twin, Vec<Finding>), UnitError> {
    let nominal = catalog.nominal(device);
    let (calibration, mut findings) = Calibration::from_raw(raw)?;
    findings.extend(calibration::check_against(&calibration, &nominal, catalog));
    accept(path, &mut findings, force)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (twin, more) = calibration::twin(&calibration, &nominal, &name)?;
    findings.extend(more);
    Ok((twin, findings))
}

/// Returns the twin of a rig with a calibration that was read from `path`, and the findings; see [`calibration::rig`]. `known` is the model of
/// the catalog that the calibration names, if it names one; its processor is used by default, and RVC2 if it has none.
///
/// # Errors
/// Returns an error if the calibration is invalid, or does not determine a stereo pair.
pub fn rig_of_raw(
    raw: &Raw,
    path: &Path,
    pair: Option<(Socket, Socket)>,
    platform: Option<Platform>,
    known: Result<&Device, UnknownModel>,
    force: bool,
) -> Result<(Twin, Vec<Finding>), UnitError> {
    let own = known.as_ref().ok().and_then(|device| device.depthai_platform());
    let platform = platform.or(own).unwrap_or(Platform::Rvc2);
    let (calibration, mut findings) = Calibration::from_raw(raw)?;
    accept(path, &mut findings, force)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (twin, more) = calibration::rig(&calibration, pair, platform, &name)?;
    findings.extend(more);
    findings.extend(known.err().as_ref().map(no_model));
    Ok((twin, findings))
}

/// Says that a calibration is of no model in the catalog, so that its rig is known from it alone.
fn no_model(unknown: &UnknownModel) -> Finding {
    let remedy = match unknown.nearest.is_empty() {
        true => Message::default(),
        false => message![
            opt("model"),
            format!(" compares them with a model: {}", unknown.nearest.join(" or "))
        ],
    };
    Finding::new(
        "no-model",
        Level::Note,
        "productName",
        "of no model in the catalog; the cameras are the calibration's alone",
        remedy,
    )
}

/// Rejects errors; `force` turns those that can be ignored into warnings.
///
/// # Errors
/// Returns the first remaining error.
pub fn accept(path: &Path, findings: &mut [Finding], force: bool) -> Result<(), UnitError> {
    if force {
        calibration::force(findings);
    }
    match findings.iter().find(|finding| finding.level == Level::Error) {
        Some(finding) => Err(UnitError::Unfit {
            path: path.to_owned(),
            finding: finding.clone(),
        }),
        None => Ok(()),
    }
}
