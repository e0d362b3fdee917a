use std::path::{Path, PathBuf};

/// Why a file could not be imported: where, what is wrong and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}: {place}{}{message}; {remedy}", file.display(), if place.is_empty() { "" } else { ": " })]
pub struct ImportError {
    /// The file.
    pub file: PathBuf,
    /// Where in it: a line, an element; empty for the whole.
    pub place: String,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub remedy: String,
}

/// What is wrong in a file whose name is not at hand.
#[derive(Debug)]
pub(super) struct Fault {
    place: String,
    message: String,
    remedy: &'static str,
}

/// The remedy for a file that is not what it says it is.
pub(super) const DAMAGED: &str = "export or copy it again: it is damaged";

impl Fault {
    /// Of a file that contradicts itself.
    pub(super) fn damaged(place: impl Into<String>, message: impl Into<String>) -> Self {
        Self::new(place, message, DAMAGED)
    }

    pub(super) fn new(place: impl Into<String>, message: impl Into<String>, remedy: &'static str) -> Self {
        Self {
            place: place.into(),
            message: message.into(),
            remedy,
        }
    }

    pub(super) fn of(self, file: &Path) -> ImportError {
        ImportError {
            file: file.to_path_buf(),
            place: self.place,
            message: self.message,
            remedy: self.remedy.into(),
        }
    }
}
