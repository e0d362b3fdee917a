use oaktwin_base::diagnostic::Message;
use oaktwin_pipeline::render::RigError;
use oaktwin_pipeline::sensor::ParameterError;

/// The reason why a coverage cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CoverageError {
    /// The depth sensor does not exist.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The rig cannot be made, or cannot measure.
    #[error(transparent)]
    Rig(#[from] RigError),
    /// An option is invalid, or the region has no surface: `OPTION: what is wrong; what to do`.
    #[error("{0}")]
    Option(Message),
}

impl From<Message> for CoverageError {
    fn from(message: Message) -> Self {
        Self::Option(message)
    }
}
