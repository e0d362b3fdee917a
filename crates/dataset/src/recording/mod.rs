//! Recordings of moving cameras: their images, the output of their depth sensors, and their poses.
//!
//! A [`Recorder`] receives its cameras, then one [`Moment`] after the other, and writes each immediately. The content does not
//! depend on the format:
//!
//! | name | content for each camera |
//! |---|---|
//! | `rgb` | the colour image |
//! | `depth` | exact depth along the optical axis |
//! | `measured` | the depth sensor's output |
//! | `depth_points`, `measured_points` | point clouds of both in the camera's optical frame, with colours |
//!
//! It also contains the intrinsics and the lens, and the transforms world → body → camera → optical frame (ROS's REP-103 and
//! REP-105). The caller defines the axes of the world and the optical frame; a camera's frame is x forward, y left, z up.
//!
//! Invalid depth follows REP-117 and REP-118: NaN for no measurement (0 in a sensor's output), `+inf` for out of range, 0 in
//! millimetres.
//!
//! [`Mcap`] writes ROS 2 messages. The crate `oaktwin-rrd`, outside this workspace, writes Rerun's format.
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
//!     frame: None,
//!     camera: Camera::new(intrinsics, LensModel::Pinhole),
//!     measured: None,
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
mod schema;
mod time;

use std::io;

use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Camera, ImageSize, RigidTransform};
use oaktwin_image::ImageView;

pub use cloud::{measured_colors, points, rays};
pub use lens::ros_lens_loss;
pub use mcap::Mcap;
pub use names::unique_name;
pub use time::Time;

/// A writer of recordings.
pub trait Recorder {
    /// The type of its output.
    type Output;

    /// Adds a camera before its first moment. Its name is made valid for ROS, and unique.
    ///
    /// # Errors
    /// Returns an error if the output cannot be written or the camera's images are too large.
    fn add_camera(&mut self, camera: &RecordedCamera) -> Result<CameraId, RecordingError>;

    /// Records a moment of a camera.
    ///
    /// # Errors
    /// Returns an error if the output cannot be written, the size of an image is not the camera's, or the camera belongs to another
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

impl CameraId {
    /// Identifies the camera that was added as number `index`, from 0; for the authors of recorders.
    #[must_use]
    pub const fn new(index: usize) -> Self {
        Self(index)
    }

    /// Returns the number of cameras that were added before.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0
    }
}

/// A camera to record.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedCamera {
    /// The name, which is the first part of the names of its topics and frames.
    pub name: String,
    /// The name of its frame, if it is another one, such as [`frame_names::camera`](oaktwin_camera::frame_names::camera).
    pub frame: Option<String>,
    /// The intrinsics and the lens.
    pub camera: Camera,
    /// The camera that the depth sensor's outputs are images of, if it is another one.
    pub measured: Option<MeasuredCamera>,
    /// The body that carries the camera, if any.
    pub body: Option<MovingBody>,
}

/// The camera that a depth sensor's outputs are images of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeasuredCamera {
    /// The intrinsics and the lens.
    pub camera: Camera,
    /// The transform from its optical frame to the recorded camera's, metres.
    pub camera_from_measured: RigidTransform,
}

impl RecordedCamera {
    /// Returns the camera of measured images.
    #[must_use]
    pub fn measured(&self) -> MeasuredCamera {
        self.measured.unwrap_or(MeasuredCamera {
            camera: self.camera,
            camera_from_measured: RigidTransform::IDENTITY,
        })
    }

    /// Checks that the camera's images fit into messages.
    ///
    /// # Errors
    /// Returns an error if they are too large.
    pub fn check(&self) -> Result<(), RecordingError> {
        let size = self.camera.intrinsics.size;
        // A point has 16 bytes, the maximum per pixel.
        if u64::from(size.width) * u64::from(size.height) > u64::from(u32::MAX) / 16 {
            return Err(RecordingError::TooLarge {
                camera: self.name.clone(),
                size,
            });
        }
        Ok(())
    }
}

/// A moving body that carries cameras.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingBody {
    /// The name. Cameras whose bodies have the same name are on the same body.
    pub name: String,
    /// The pose of the camera's optical frame on the body, metres.
    pub body_from_camera: RigidTransform,
}

/// An inertial sensor to record.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedImu {
    /// The name, which is the first part of the names of its topic and frame.
    pub name: String,
    /// The name of the body that carries it, as in [`MovingBody::name`].
    pub body: String,
    /// The pose of the sensor on the body, metres.
    pub body_from_imu: RigidTransform,
    /// The standard deviation of the white noise of a sample's angular velocity, rad/s.
    pub angular_velocity_deviation: DVec3,
    /// The standard deviation of the white noise of a sample's acceleration, m/s².
    pub linear_acceleration_deviation: DVec3,
}

/// The data of a camera at one time. Images have the camera's size; measured images have their own camera's size.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// The time.
    pub time: Time,
    /// The pose of the camera's body, or of its optical frame if it has no body, metres.
    pub world_from_mount: RigidTransform,
    /// The colour image, sRGB; the fourth channel is ignored.
    pub rgb: Option<ImageView<'a, [u8; 4]>>,
    /// Exact depth.
    pub depth: Option<DepthView<'a>>,
    /// The depth sensor's output.
    pub measured: Option<DepthView<'a>>,
    /// Whether to record the point cloud of the exact depth.
    pub depth_points: bool,
    /// Whether to record the point cloud of the sensor's output.
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

    /// Checks that the images have their camera's size.
    ///
    /// # Errors
    /// Returns an error for the first image that has another one.
    pub fn check(&self, camera: &RecordedCamera) -> Result<(), RecordingError> {
        let expected = camera.camera.intrinsics.size;
        let rgb = self
            .rgb
            .map(|image| ImageSize::new(image.width(), image.height()));
        let of_measured = camera.measured().camera.intrinsics.size;
        let images = [
            ("rgb", rgb, expected),
            ("depth", self.depth.map(|depth| depth.size()), expected),
            ("measured", self.measured.map(|depth| depth.size()), of_measured),
        ];
        match images
            .into_iter()
            .find(|(_, found, expected)| found.is_some_and(|found| found != *expected))
        {
            Some((image, Some(found), expected)) => Err(RecordingError::Size {
                camera: camera.name.clone(),
                image,
                found,
                expected,
            }),
            _ => Ok(()),
        }
    }
}

/// A depth image along the optical axis; values that are not above 0 are invalid.
#[derive(Clone, Copy, Debug)]
pub enum DepthView<'a> {
    /// Metres in `float32`, ROS's `32FC1`.
    Metres(ImageView<'a, f32>),
    /// Millimetres in `uint16`, ROS's `16UC1`.
    Millimetres(ImageView<'a, u16>),
}

impl DepthView<'_> {
    /// Returns the width and height in pixels.
    #[must_use]
    pub fn size(&self) -> ImageSize {
        match self {
            Self::Metres(image) => ImageSize::new(image.width(), image.height()),
            Self::Millimetres(image) => ImageSize::new(image.width(), image.height()),
        }
    }
}

/// An error of a recording.
#[derive(Debug, thiserror::Error)]
pub enum RecordingError {
    /// A time is out of range.
    #[error("time {seconds} s is out of range; use seconds from 0 to 2^31")]
    Time {
        /// The time, seconds.
        seconds: f64,
    },
    /// The size of an image is not the camera's.
    #[error(
        "{camera}: {image} is {found}, the camera's images are {expected}; give the camera of the images"
    )]
    Size {
        /// The camera.
        camera: String,
        /// The name of the image.
        image: &'static str,
        /// The size of the image.
        found: ImageSize,
        /// The camera's size.
        expected: ImageSize,
    },
    /// The message of an image would be too long.
    #[error("{camera}: images of {size} are too large for a message; record smaller ones")]
    TooLarge {
        /// The camera.
        camera: String,
        /// The size of its images.
        size: ImageSize,
    },
    /// The camera belongs to another recorder.
    #[error("the camera does not belong to this recording; add it first")]
    NoCamera,
    /// The recording has no inertial sensor.
    #[error("the recording has no inertial sensor; set it first")]
    NoImu,
    /// The output cannot be written.
    #[error("cannot be written ({0})")]
    Io(#[from] io::Error),
    /// The library of the format fails.
    #[error("{0}")]
    Format(String),
}
