use std::ffi::CString;

use oaktwin::diagnostic::{self, Level};
use pyo3::prelude::*;

use crate::error::{FindingWarning, text};

/// A note, warning or error about an input or result; str() is the line that the program prints.
///
/// code: a short stable identifier, such as "own-focal-length".
/// level: "note", "warning" or "error".
/// place: the path of the field or prim concerned.
/// message: what was found.
/// remedy: what to do about it; empty if nothing is required.
#[pyclass(frozen, module = "oaktwin")]
#[derive(Debug)]
pub(crate) struct Finding {
    #[pyo3(get)]
    code: &'static str,
    #[pyo3(get)]
    level: String,
    #[pyo3(get)]
    place: String,
    #[pyo3(get)]
    message: String,
    #[pyo3(get)]
    remedy: String,
    line: String,
}

#[pymethods]
impl Finding {
    fn __str__(&self) -> &str {
        &self.line
    }

    fn __repr__(&self) -> String {
        format!("<oaktwin.Finding {}>", self.line)
    }
}

/// Converts findings to a Python list.
pub(crate) fn list(findings: &[diagnostic::Finding]) -> Vec<Finding> {
    let one = |finding: &diagnostic::Finding| Finding {
        code: finding.code,
        level: finding.level.to_string(),
        place: finding.place.clone(),
        message: text(&finding.message),
        remedy: text(&finding.remedy),
        line: text(finding),
    };
    findings.iter().map(one).collect()
}

/// Issues warnings and errors as Python warnings.
pub(crate) fn warn(py: Python<'_>, findings: &[diagnostic::Finding]) -> PyResult<()> {
    for finding in findings.iter().filter(|finding| finding.level > Level::Note) {
        let text = CString::new(text(finding).replace('\0', " "))?;
        PyErr::warn(py, &py.get_type::<FindingWarning>(), &text, 1)?;
    }
    Ok(())
}
