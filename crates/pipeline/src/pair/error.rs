use crate::limits::SizeError;
use oaktwin_camera::RectifyError;
use oaktwin_depth::ParameterError;

/// Why there is no pair.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PairError {
    /// A device without a left or right camera.
    #[error("{device}: it has no {role} camera; choose a device with a stereo pair")]
    NoCamera {
        /// The device.
        device: String,
        /// `left` or `right`.
        role: &'static str,
    },
    /// The projector of a device that has none.
    #[error("{device}: projector: it has no dot projector; leave it off, or choose a Pro model")]
    NoProjector {
        /// The device.
        device: String,
    },
    /// An option out of its range.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// An image that cannot be.
    #[error("{device}: {error}")]
    Size {
        /// The device.
        device: String,
        /// What is wrong.
        error: SizeError,
    },
    /// Cameras that cannot be rectified.
    #[error("{device}: left and right camera: {error}")]
    Rectify {
        /// The device.
        device: String,
        /// What is wrong.
        error: RectifyError,
    },
}
