//! Errors as Python exceptions, with the text that the program prints.

use std::fmt::Display;
use std::fs::{self, File};
use std::io;
use std::path::Path;

use pyo3::exceptions::{
    PyFileNotFoundError, PyIsADirectoryError, PyOSError, PyPermissionError, PyUserWarning, PyValueError,
};
use pyo3::prelude::*;

pyo3::create_exception!(
    oaktwin,
    Error,
    PyValueError,
    "What cannot be: the text says where, what is wrong and what to do, as the program's does."
);

pyo3::create_exception!(
    oaktwin,
    FindingWarning,
    PyUserWarning,
    "Something odd about a result that holds: what the program prints as a warning."
);

/// The program's options, and Python's for the same.
const OPTIONS: [(&str, &str); 18] = [
    (" with -o", ""),
    (", --resample for images of the model's size", ""),
    ("--align-size", "size"),
    ("--align", "to"),
    ("--depth-scale", "the depth's scale"),
    ("--engine", "engine"),
    ("--filter", "filters"),
    ("--focal-px", "focal_px"),
    ("--force", "force=True"),
    ("--from", "measured_from"),
    ("--fx", "fx"),
    ("--hfov", "hfov_deg"),
    ("--scale", "scale"),
    ("--sensor", "sensor"),
    ("--stereo-width", "width_px"),
    ("--subdivide", "subdivide"),
    ("--time", "time"),
    ("--up", "up"),
];

/// A text of the program's, with Python's names for its options.
pub(crate) fn plain(text: &str) -> String {
    OPTIONS
        .iter()
        .fold(text.to_owned(), |text, (option, name)| text.replace(option, name))
}

/// An exception of an error.
#[expect(clippy::needless_pass_by_value, reason = "what `map_err` hands over")]
pub(crate) fn error(error: impl ToString) -> PyErr {
    Error::new_err(plain(&error.to_string()))
}

/// An exception that says where, what is wrong and what to do.
pub(crate) fn wrong(what: impl Display, is: impl Display, remedy: impl Display) -> PyErr {
    Error::new_err(plain(&format!("{what}: {is}; {remedy}")))
}

/// An error about a file that was to be read: an `OSError` where the file system is the reason.
pub(crate) fn reading(path: &Path, error: &impl ToString) -> PyErr {
    let text = plain(&error.to_string());
    if path.is_dir() {
        return PyIsADirectoryError::new_err(text);
    }
    match File::open(path) {
        Ok(_) => Error::new_err(text),
        Err(error) => of_kind(error.kind(), text),
    }
}

/// An error about a file that was to be written.
pub(crate) fn writing(path: &Path, error: &impl ToString) -> PyErr {
    let text = plain(&error.to_string());
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
