use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::Message;
use oaktwin_files::FileError;

/// A robot's file that cannot be read or used.
#[derive(Debug, thiserror::Error)]
pub enum RobotFileError {
    /// The file cannot be opened.
    #[error(transparent)]
    File(#[from] FileError),
    /// A mistake in a file: `FILE: PLACE: what is wrong; what to do`.
    #[error("{}: {place}: {message}; {remedy}", file.display())]
    At {
        /// The file.
        file: PathBuf,
        /// The line and element.
        place: String,
        /// What is wrong.
        message: String,
        /// What to do.
        remedy: String,
    },
    /// An argument that does not fit the robot.
    #[error("{0}")]
    Option(Message),
}

impl RobotFileError {
    pub(super) fn new(file: &Path, place: String, message: String, remedy: String) -> Self {
        Self::At {
            file: file.to_owned(),
            place,
            message,
            remedy,
        }
    }
}
