use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::Message;
use oaktwin_files::xml::XmlError;

/// An error that occurred while importing a file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {place}{}{message}; {remedy}", file.display(), if place.is_empty() { "" } else { ": " })]
pub struct ImportError {
    /// The file.
    pub file: PathBuf,
    /// The line or element; empty if the whole file is concerned.
    pub place: String,
    /// The problem.
    pub message: String,
    /// The remedy.
    pub remedy: Message,
}

/// An error without the file's name.
#[derive(Debug)]
pub(super) struct Fault {
    place: String,
    message: String,
    remedy: Message,
}

/// The remedy for a file that contradicts its own format.
pub(super) const DAMAGED: &str = "the file is damaged: export or copy it again";

impl Fault {
    pub(super) fn damaged(place: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(place, message, DAMAGED)
    }

    pub(super) fn new(
        place: impl Into<String>,
        message: impl Into<String>,
        remedy: impl Into<Message>,
    ) -> Self {
        Self {
            place: place.into(),
            message: message.into(),
            remedy: remedy.into(),
        }
    }

    pub(super) fn of(self, file: &Path) -> ImportError {
        ImportError {
            file: file.to_path_buf(),
            place: self.place,
            message: self.message,
            remedy: self.remedy,
        }
    }
}

impl From<XmlError> for Fault {
    fn from(error: XmlError) -> Self {
        Self::new(error.place, error.message, error.remedy)
    }
}
