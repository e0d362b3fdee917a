use std::ffi::CString;
use std::sync::{Mutex, PoisonError};

use oaktwin::diagnostic::{self, Level};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::error::{FindingWarning, text};

/// A note, warning or error about an input or result; str() is the line that the program prints.
///
/// code: a short stable identifier, such as "own-focal-length".
/// level: "note", "warning" or "error".
/// place: the path of the field or prim concerned.
/// message: what was found.
/// remedy: what to do about it; empty if nothing is required.
#[pyclass(frozen, eq, hash, module = "oaktwin")]
#[derive(Debug, PartialEq, Eq, Hash)]
pub(crate) struct Finding {
    #[pyo3(get)]
    code: String,
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
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let restore = py.import("oaktwin._oaktwin")?.getattr("_finding")?;
        let state = [
            &self.code[..],
            &self.level,
            &self.place,
            &self.message,
            &self.remedy,
            &self.line,
        ];
        Ok((restore, PyTuple::new(py, state)?))
    }

    fn __str__(&self) -> &str {
        &self.line
    }

    fn __repr__(&self) -> String {
        format!("<oaktwin.Finding {}>", self.line)
    }
}

/// Restores the finding of a pickle.
#[pyfunction]
pub(crate) fn _finding(
    code: String,
    level: String,
    place: String,
    message: String,
    remedy: String,
    line: String,
) -> Finding {
    Finding {
        code,
        level,
        place,
        message,
        remedy,
        line,
    }
}

/// Converts findings to a Python list.
pub(crate) fn list(findings: &[diagnostic::Finding]) -> Vec<Finding> {
    let one = |finding: &diagnostic::Finding| Finding {
        code: finding.code.to_owned(),
        level: finding.level.to_string(),
        place: finding.place.clone(),
        message: text(&finding.message),
        remedy: text(&finding.remedy),
        line: text(finding),
    };
    findings.iter().map(one).collect()
}

/// The findings about the inputs of an object, each of which is shown once.
#[derive(Debug, Default)]
pub(crate) struct Notices(Mutex<Vec<diagnostic::Finding>>);

impl Notices {
    /// Keeps a finding and issues it as a Python warning, unless the object has one of its code.
    pub(crate) fn notice(&self, py: Python<'_>, finding: Option<diagnostic::Finding>) -> PyResult<()> {
        let Some(finding) = finding else {
            return Ok(());
        };
        {
            let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            if known.iter().any(|known| known.code == finding.code) {
                return Ok(());
            }
            known.push(finding.clone());
        }
        warn(py, &[finding])
    }

    /// The findings so far.
    pub(crate) fn all(&self) -> Vec<diagnostic::Finding> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

/// Issues warnings and errors as Python warnings about the line that calls the package.
pub(crate) fn warn(py: Python<'_>, findings: &[diagnostic::Finding]) -> PyResult<()> {
    warn_at(py, findings, 1)
}

/// The same for functions that the package wraps in Python.
pub(crate) fn warn_caller(py: Python<'_>, findings: &[diagnostic::Finding]) -> PyResult<()> {
    warn_at(py, findings, 2)
}

fn warn_at(py: Python<'_>, findings: &[diagnostic::Finding], level: i32) -> PyResult<()> {
    for finding in findings.iter().filter(|finding| finding.level > Level::Note) {
        let text = CString::new(text(finding).replace('\0', " "))?;
        PyErr::warn(py, &py.get_type::<FindingWarning>(), &text, level)?;
    }
    Ok(())
}
