use oaktwin::diagnostic::Finding;

/// A file to be saved.
#[derive(Debug, Default)]
pub(crate) struct File {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
    /// What the format cannot represent.
    pub(crate) findings: Vec<Finding>,
}

impl File {
    pub(crate) fn new(name: impl Into<String>, bytes: Vec<u8>) -> Self {
        Self {
            name: name.into(),
            bytes,
            findings: Vec::new(),
        }
    }

    pub(crate) fn text(name: &str, text: String) -> Self {
        Self::new(name, text.into_bytes())
    }
}
