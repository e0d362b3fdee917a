use oaktwin::calibration::export::{self, Format};
use oaktwin::calibration::{Calibration, Raw};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::error;
use crate::finding;

/// Returns the files of a format by name.
pub(crate) fn export<'py>(
    py: Python<'py>,
    raw: &Raw,
    calibration: &Calibration,
    format: Format,
) -> PyResult<Bound<'py, PyDict>> {
    let made = export::export(raw, calibration, format).map_err(error)?;
    finding::warn(py, &made.findings)?;
    let files = PyDict::new(py);
    for (name, text) in &made.files {
        files.set_item(name, text)?;
    }
    Ok(files)
}
