use crate::limits::SizeError;
use oaktwin_camera::RectifyError;
use oaktwin_depth::ParameterError;

/// An error that prevents a stereo pair from being rendered.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PairError {
    /// The device has no left or right camera.
    #[error("{device}: no {role} camera; choose a model with a stereo pair: {others}")]
    NoCamera {
        /// The device.
        device: String,
        /// The role of the camera, such as `left`.
        role: &'static str,
        /// The models with a stereo pair.
        others: String,
    },
    /// The depth sensors to render have different pairs.
    #[error(
        "{device}: {} have different stereo pairs; choose one of them by its name",
        sensors.join(", ")
    )]
    SeveralPairs {
        /// The device.
        device: String,
        /// The prims of the depth sensors.
        sensors: Vec<String>,
    },
    /// The device has no projector.
    #[error("{device}: projector: the model has no dot projector; turn it off, or choose a Pro model")]
    NoProjector {
        /// The device.
        device: String,
    },
    /// An option is out of range.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The image size is invalid.
    #[error("{device}: {error}")]
    Size {
        /// The device.
        device: String,
        /// What is wrong.
        error: SizeError,
    },
    /// The cameras cannot be rectified.
    #[error("{device}: left and right camera: {error}")]
    Rectify {
        /// The device.
        device: String,
        /// What is wrong.
        error: RectifyError,
    },
}
