//! Recordings of moving cameras: images, depth, sensor outputs and poses.
//!
//! A [`Recorder`] first receives its cameras, then one [`Moment`] after the other, which it writes at once. The contents do
//! not depend on the format:
//!
//! | channel of a camera | contents |
//! |---|---|
//! | `rgb` | the colour image |
//! | `depth` | ground-truth z-depth |
//! | `measured` | the depth sensor's output |
//! | `depth_points`, `measured_points` | point clouds of both in the camera's optical frame, with colours |
//!
//! and the camera's intrinsics and lens, and the transforms world → body → camera → optical frame (ROS's REP-103 and
//! REP-105): the axes of the world and the optical frame are the caller's, those of a camera are a body's (x forward, y left, z up).
//!
//! Invalid depth follows REP-117 and REP-118: NaN for no measurement (0 in a sensor's output), `+inf` for a miss, 0 in
//! millimetres.
//!
//! [`Mcap`] writes ROS 2 messages, and with the feature `rerun`, `Rrd` writes Rerun's format.
//!
//! ```
//! use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
//! use oaktwin_dataset::recording::{DepthView, Mcap, Moment, RecordedCamera, Recorder, Time};
//! use oaktwin_image::Image;
//!
//! let intrinsics = Intrinsics::from_hfov(ImageSize::new(4, 3), 1.2);
//! let mut recorder = Mcap::new(Vec::new())?;
//! let camera = recorder.add_camera(&RecordedCamera {
//!     name: "left".to_owned(),
//!     camera: Camera::new(intrinsics, LensModel::Pinhole),
//!     body: None,
//! })?;
//! let depth = Image::filled(4, 3, 1.5f32);
//! recorder.record(camera, &Moment {
//!     depth: Some(DepthView::Metres((&depth).into())),
//!     ..Moment::new(Time::from_seconds(0.5)?, RigidTransform::IDENTITY)
//! })?;
//! let file: Vec<u8> = recorder.finish()?;
//! assert!(file.starts_with(b"\x89MCAP0\r\n"));
//! # Ok::<(), oaktwin_dataset::recording::RecordingError>(())
//! ```

mod cdr;
mod cloud;
mod lens;
mod mcap;
mod message;
mod names;
#[cfg(feature = "rerun")]
mod rrd;
mod schema;
mod time;

use std::io;

use oaktwin_camera::{Camera, ImageSize, RigidTransform};
use oaktwin_image::ImageView;

pub use lens::ros_lens_loss;
pub use mcap::Mcap;
#[cfg(feature = "rerun")]
pub use rrd::Rrd;
pub use time::Time;

/// Writes a recording.
pub trait Recorder {
    /// The output.
    type Output;

    /// Adds a camera, before its first moment. Its name is converted to a valid, unique ROS name.
    ///
    /// # Errors
    /// Returns an error if the output cannot be written or the camera's images are too large.
    fn add_camera(&mut self, camera: &RecordedCamera) -> Result<CameraId, RecordingError>;

    /// Records a camera at a moment.
    ///
    /// # Errors
    /// Returns an error if the output cannot be written, an image does not have the camera's size, or the camera is not one of this
    /// recorder.
    fn record(&mut self, camera: CameraId, moment: &Moment<'_>) -> Result<(), RecordingError>;

    /// Completes the recording.
    ///
    /// # Errors
    /// Returns an error if the output cannot be written.
    fn finish(self) -> Result<Self::Output, RecordingError>;
}

/// A camera of a [`Recorder`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CameraId(usize);

/// A camera to be recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedCamera {
    /// The name: the first part of the names of its topics and frames.
    pub name: String,
    /// The intrinsics and lens.
    pub camera: Camera,
    /// The body that carries the camera, if any.
    pub body: Option<Body>,
}

/// A moving body with cameras.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// The name. Bodies with the same name are the same body.
    pub name: String,
    /// The pose of the camera's optical frame in the body, metres.
    pub body_from_camera: RigidTransform,
}

/// The data of a camera at one time. Images have the camera's size.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// The time.
    pub time: Time,
    /// The pose of the camera's body, or of its optical frame without a body, metres.
    pub world_from_mount: RigidTransform,
    /// The colour image, sRGB; alpha is ignored.
    pub rgb: Option<ImageView<'a, [u8; 4]>>,
    /// The ground-truth depth.
    pub depth: Option<DepthView<'a>>,
    /// The depth sensor's output.
    pub measured: Option<DepthView<'a>>,
    /// Whether the point cloud of the ground truth is recorded.
    pub depth_points: bool,
    /// Whether the point cloud of the sensor's output is recorded.
    pub measured_points: bool,
}

impl Moment<'_> {
    /// Creates a moment without images.
    #[must_use]
    pub fn new(time: Time, world_from_mount: RigidTransform) -> Self {
        Self {
            time,
            world_from_mount,
            rgb: None,
            depth: None,
            measured: None,
            depth_points: false,
            measured_points: false,
        }
    }
}

/// Z-depth. Values that are not above 0 are invalid.
#[derive(Clone, Copy, Debug)]
pub enum DepthView<'a> {
    /// `float32`: ROS's `32FC1`.
    Metres(ImageView<'a, f32>),
    /// `uint16`: ROS's `16UC1`.
    Millimetres(ImageView<'a, u16>),
}

impl DepthView<'_> {
    fn size(&self) -> ImageSize {
        match self {
            Self::Metres(image) => ImageSize::new(image.width(), image.height()),
            Self::Millimetres(image) => ImageSize::new(image.width(), image.height()),
        }
    }
}

/// An error while something is recorded.
#[derive(Debug, thiserror::Error)]
pub enum RecordingError {
    /// The time is out of range.
    #[error("the time {seconds} s is out of range; give 0 to 2^31 seconds")]
    Time {
        /// The time, seconds.
        seconds: f64,
    },
    /// An image does not have its camera's size.
    #[error(
        "{camera}: {image} is {found}, but the camera's images are {expected}; give images of the camera's size"
    )]
    Size {
        /// The camera.
        camera: String,
        /// The name of the image.
        image: &'static str,
        /// Its size.
        found: ImageSize,
        /// The camera's size.
        expected: ImageSize,
    },
    /// A message would exceed the maximum size.
    #[error("{camera}: images of {size} exceed the message size; record smaller images")]
    TooLarge {
        /// The camera.
        camera: String,
        /// Its images' size.
        size: ImageSize,
    },
    /// The camera belongs to another recorder.
    #[error("the camera is not one of this recording; add it first")]
    NoCamera,
    /// The output cannot be written.
    #[error("cannot be written ({0})")]
    Io(#[from] io::Error),
    /// The library of the format failed.
    #[error("{0}")]
    Format(String),
}

/// Rejects cameras with images that are too large for a message.
fn check_camera(camera: &RecordedCamera) -> Result<(), RecordingError> {
    let size = camera.camera.intrinsics.size;
    // At most 16 bytes per pixel, for points.
    if u64::from(size.width) * u64::from(size.height) > u64::from(u32::MAX) / 16 {
        return Err(RecordingError::TooLarge {
            camera: camera.name.clone(),
            size,
        });
    }
    Ok(())
}

/// Rejects images that do not have the camera's size.
fn check_moment(camera: &RecordedCamera, moment: &Moment<'_>) -> Result<(), RecordingError> {
    let expected = camera.camera.intrinsics.size;
    let rgb = moment
        .rgb
        .map(|image| ImageSize::new(image.width(), image.height()));
    let images = [
        ("rgb", rgb),
        ("depth", moment.depth.map(|depth| depth.size())),
        ("measured", moment.measured.map(|depth| depth.size())),
    ];
    match images
        .into_iter()
        .find(|(_, found)| found.is_some_and(|found| found != expected))
    {
        Some((image, Some(found))) => Err(RecordingError::Size {
            camera: camera.name.clone(),
            image,
            found,
            expected,
        }),
        _ => Ok(()),
    }
}
