use oaktwin_base::diagnostic::Message;
use oaktwin_pipeline::pair::PairError;
use oaktwin_pipeline::render::{CameraError, DepthSensorError};
use oaktwin_pipeline::sensor::ParameterError;

/// The reason why a coverage cannot be measured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CoverageError {
    /// A parameter of the sensor is invalid.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The depth sensor of a camera is invalid.
    #[error(transparent)]
    Sensor(#[from] DepthSensorError),
    /// The camera is invalid.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// The stereo pair is invalid.
    #[error(transparent)]
    Pair(#[from] PairError),
    /// An option is invalid, or the region has no surface: `OPTION: what is wrong; what to do`.
    #[error("{0}")]
    Option(Message),
}

impl From<Message> for CoverageError {
    fn from(message: Message) -> Self {
        Self::Option(message)
    }
}
