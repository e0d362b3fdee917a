use pyo3::prelude::*;
use serde::Serialize;

use crate::error::{error, with_arguments};

/// Converts a value to Python dictionaries, lists, numbers and strings.
pub(crate) fn to_python<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let text = with_arguments(|| serde_json::to_string(value)).map_err(error)?;
    py.import("json")?.call_method1("loads", (text,))
}
