use oaktwin::calibration::export::{self, Format};
use oaktwin::calibration::{Calibration, Raw};
use oaktwin::catalog::InertialPart;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::error;
use crate::finding;

/// Returns the files of a format by name. Kalibr's include the inertial part's.
pub(crate) fn export<'py>(
    py: Python<'py>,
    raw: &Raw,
    calibration: &Calibration,
    format: Format,
    part: Option<&InertialPart>,
) -> PyResult<Bound<'py, PyDict>> {
    let mut made = export::export(raw, calibration, format).map_err(error)?;
    if let Some(part) = part.filter(|_| format == Format::Kalibr) {
        made.extend(export::kalibr_imu(part));
    }
    finding::warn(py, &made.findings)?;
    let files = PyDict::new(py);
    for (name, text) in &made.files {
        files.set_item(name, text)?;
    }
    Ok(files)
}
