//! Errors as Python exceptions, with the text that the program prints.

use std::fmt::Display;
use std::fs::{self, File};
use std::io;
use std::path::Path;

use oaktwin::diagnostic::{Opt, with_style};
use pyo3::exceptions::{
    PyFileNotFoundError, PyIsADirectoryError, PyOSError, PyPermissionError, PyUserWarning, PyValueError,
};
use pyo3::prelude::*;

pyo3::create_exception!(
    oaktwin,
    Error,
    PyValueError,
    "Raised for invalid input; the message says where, what is wrong and what to do."
);

pyo3::create_exception!(
    oaktwin,
    FindingWarning,
    PyUserWarning,
    "A non-fatal problem with a result."
);

/// The arguments whose names differ from the program's options.
const ARGUMENTS: [(&str, &str); 12] = [
    ("align", "to"),
    ("align-size", "size"),
    ("filter", "filters"),
    ("force", "force=True"),
    ("from", "measured_from"),
    ("hfov", "hfov_deg"),
    ("imu-part", "part"),
    ("imu-rate", "rate"),
    ("memory-limit", "the limit of set_memory_limit()"),
    ("stereo-width", "width_px"),
    ("tilt", "tilt_deg"),
    ("tolerance", "tolerance_mm"),
];

/// An option as an argument: `fx=500`, `engine="single-view"`; a command as a function: `oaktwin.models()`.
fn argument(option: &Opt) -> String {
    if option.is_command() {
        return format!("oaktwin.{}()", option.name());
    }
    if option.name() == "param"
        && let Some((name, value)) = option.value().and_then(|value| value.split_once('='))
    {
        return format!("parameters={{{name:?}: {value}}}");
    }
    let own = ARGUMENTS.iter().find(|(name, _)| *name == option.name());
    let name = own.map_or_else(|| option.name().replace('-', "_"), |(_, own)| (*own).to_owned());
    match option.value() {
        None => name,
        Some(value) if value.parse::<f64>().is_ok() => format!("{name}={value}"),
        Some(value) => format!("{name}={value:?}"),
    }
}

/// Runs `print` with options spelled as Python's arguments.
pub(crate) fn with_arguments<T>(print: impl FnOnce() -> T) -> T {
    with_style(argument, print)
}

/// The text with options spelled as Python's arguments.
pub(crate) fn text(value: &impl ToString) -> String {
    with_arguments(|| value.to_string())
}

/// Converts an error to an exception.
#[expect(clippy::needless_pass_by_value, reason = "what `map_err` hands over")]
pub(crate) fn error(error: impl ToString) -> PyErr {
    Error::new_err(text(&error))
}

/// Returns an exception that names the place, the problem and the remedy.
pub(crate) fn wrong(what: impl Display, is: impl Display, remedy: impl Display) -> PyErr {
    Error::new_err(with_arguments(|| format!("{what}: {is}; {remedy}")))
}

/// Returns an exception for a file that could not be read: an `OSError` if the file system is the cause.
pub(crate) fn reading(path: &Path, error: &impl ToString) -> PyErr {
    let text = text(error);
    if path.is_dir() {
        return PyIsADirectoryError::new_err(text);
    }
    match File::open(path) {
        Ok(_) => Error::new_err(text),
        Err(error) => of_kind(error.kind(), text),
    }
}

/// Returns an exception for a file that could not be written.
pub(crate) fn writing(path: &Path, error: &impl ToString) -> PyErr {
    let text = text(error);
    if path.is_dir() {
        return PyIsADirectoryError::new_err(text);
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    match fs::metadata(folder) {
        Ok(_) => PyOSError::new_err(text),
        Err(error) => of_kind(error.kind(), text),
    }
}

fn of_kind(kind: io::ErrorKind, text: String) -> PyErr {
    match kind {
        io::ErrorKind::NotFound => PyFileNotFoundError::new_err(text),
        io::ErrorKind::PermissionDenied => PyPermissionError::new_err(text),
        _ => PyOSError::new_err(text),
    }
}
