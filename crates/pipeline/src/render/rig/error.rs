use oaktwin_base::diagnostic::Message;

use crate::pair::PairError;
use crate::render::{CameraError, DepthSensorError};
use crate::sensor::ParameterError;

/// An error that prevents a rig from being made or from measuring.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RigError {
    /// A camera cannot be chosen.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// The stereo pair cannot be rendered.
    #[error(transparent)]
    Pair(#[from] PairError),
    /// A depth sensor cannot be created.
    #[error(transparent)]
    Sensor(#[from] DepthSensorError),
    /// A parameter of the depth sensor is invalid, or its input is of the wrong kind.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The outputs of a depth sensor are requested, and no camera has one.
    #[error("{0}")]
    NoDepthSensor(Message),
    /// An option does not suit the cameras: `OPTION: what is wrong; what to do`.
    #[error("{0}")]
    Option(Message),
    /// A scene cannot be read at a time within a frame.
    #[error("{0}")]
    Moment(String),
}
