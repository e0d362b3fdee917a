use std::borrow::Cow;
use std::path::Path;

use oaktwin_base::diagnostic::Message;
use oaktwin_files::FileError;
use oaktwin_files::memory::Shortage;

/// An error of a codec: invalid bytes, or an image that the format does not support. Callers add the file name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{format}: {place}: {problem}; {remedy}")]
pub struct CodecError {
    /// The file format.
    pub format: &'static str,
    /// The place in the file.
    pub place: Cow<'static, str>,
    /// The problem.
    pub problem: String,
    /// The remedy.
    pub remedy: Message,
}

impl CodecError {
    pub(crate) fn new(
        format: &'static str,
        place: impl Into<Cow<'static, str>>,
        problem: impl Into<String>,
        remedy: impl Into<Message>,
    ) -> Self {
        Self {
            format,
            place: place.into(),
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }

    /// Returns the error for the file that has these bytes.
    #[must_use]
    pub fn in_file(&self, path: &Path) -> FileError {
        let message = format!("{}: {}: {}", self.format, self.place, self.problem);
        FileError::new(path, message, &self.remedy)
    }

    /// Returns the error for an image that needs more memory than there is.
    pub(crate) fn shortage(format: &'static str, (width, height): (u64, u64), shortage: Shortage) -> Self {
        let problem = format!("{width} × {height} pixels: {}", shortage.what());
        Self::new(format, "header", problem, shortage.remedy())
    }
}
