use std::borrow::Cow;

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
    pub remedy: &'static str,
}

impl CodecError {
    pub(crate) fn new(
        format: &'static str,
        place: impl Into<Cow<'static, str>>,
        problem: impl Into<String>,
        remedy: &'static str,
    ) -> Self {
        Self {
            format,
            place: place.into(),
            problem: problem.into(),
            remedy,
        }
    }
}
