use pyo3::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::{error, with_arguments};

/// Converts a value to Python dictionaries, lists, numbers and strings.
pub(crate) fn to_python<'py>(py: Python<'py>, value: &impl Serialize) -> PyResult<Bound<'py, PyAny>> {
    let text = with_arguments(|| serde_json::to_string(value)).map_err(error)?;
    py.import("json")?.call_method1("loads", (text,))
}

/// Converts Python dictionaries, lists, numbers and strings to a value. Errors name the argument.
pub(crate) fn from_python<T: DeserializeOwned>(argument: &str, value: &Bound<'_, PyAny>) -> PyResult<T> {
    let py = value.py();
    let text = py
        .import("oaktwin._settings")?
        .call_method1("as_json", (argument, value))?;
    serde_json::from_str(text.extract()?).map_err(|failed| {
        // The message's line and column refer to a text that the caller never sees.
        let failed = failed.to_string();
        let what = failed.rsplit_once(" at line ").map_or(&*failed, |(what, _)| what);
        error(format!("{argument}: {what}"))
    })
}
