//! One unit's twin: a model of the catalog, and the calibration file of the device on one's desk.

use std::path::{Path, PathBuf};

use oaktwin_calibration::raw::MAX_BYTES;
use oaktwin_calibration::{self as calibration, Calibration, CalibrationError, Raw};
use oaktwin_catalog::{Catalog, Device, Twin};
use oaktwin_diagnostic::{Finding, Level};
use oaktwin_files::{self as files, FileError};

/// Why there is no twin of a unit.
#[derive(Debug, thiserror::Error)]
pub enum UnitError {
    /// The file could not be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// It is no calibration.
    #[error(transparent)]
    Calibration(#[from] CalibrationError),
    /// It does not fit the model.
    #[error("{}: {}: {}; {}", path.display(), finding.place, finding.message, finding.remedy)]
    Unfit {
        /// The file.
        path: PathBuf,
        /// The first of the errors.
        finding: Finding,
    },
}

/// Reads a calibration file: as written and checked. The findings are what is odd in it, errors that [`calibration::force`] makes warnings
/// among them.
///
/// # Errors
/// The file cannot be read, or is no calibration.
pub fn read_calibration(path: &Path) -> Result<(Raw, Calibration, Vec<Finding>), UnitError> {
    let bytes = files::read(path, MAX_BYTES as u64, "a calibration")?;
    let raw = Raw::parse(&bytes, &path.display().to_string())?;
    let (calibration, findings) = Calibration::from_raw(&raw)?;
    Ok((raw, calibration, findings))
}

/// The twin of the unit that a calibration file is of, taken as a device of `catalog`; the findings are what is odd.
///
/// # Errors
/// The file cannot be read, is no calibration, or does not fit the model; with `force` the last is a finding.
pub fn open(
    catalog: &Catalog,
    device: &Device,
    path: &Path,
    force: bool,
) -> Result<(Twin, Vec<Finding>), UnitError> {
    let (raw, _, _) = read_calibration(path)?;
    of_raw(catalog, device, &raw, path, force)
}

/// The twin of the unit that a calibration is of that has been read; `path` is the file that it was in.
///
/// # Errors
/// It is no calibration, or does not fit the model; with `force` the last is a finding.
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

/// Refuses errors, or makes warnings of those that a person may decide to live with.
///
/// # Errors
/// The first error that is left.
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
