/// An invalid parameter: `NAME: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{name}: {what}; {remedy}")]
pub struct ParameterError {
    /// The name of the parameter.
    pub name: String,
    /// What is wrong with it.
    pub what: String,
    /// How to fix it.
    pub remedy: String,
}

impl ParameterError {
    /// Returns the error with these three parts.
    pub fn new(name: impl Into<String>, what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            what: what.into(),
            remedy: remedy.into(),
        }
    }
}
