use std::borrow::Cow;

/// Bytes that are no image, or an image that a format cannot hold. Whoever opened the file puts its name in front.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{format}: {place}: {problem}; {remedy}")]
pub struct CodecError {
    /// The file format.
    pub format: &'static str,
    /// Where in the file.
    pub place: Cow<'static, str>,
    /// What is wrong there.
    pub problem: String,
    /// What to do about it.
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
