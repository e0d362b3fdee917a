//! Recordings of cameras that move: what they see, what a depth sensor reports of it, and where everything stands.
//!
//! A [`Recorder`] is told of its cameras, then of one [`Moment`] after the other, and writes each at once. What a recording
//! holds does not depend on its format:
//!
//! | of a camera | what |
//! |---|---|
//! | `rgb` | the picture |
//! | `depth` | exact depth, along the optical axis |
//! | `measured` | what the sensor reports |
//! | `depth_points`, `measured_points` | clouds of both, in the camera's optical frame, with the picture's colours |
//!
//! and the camera's intrinsics and lens, and the transforms world → body → camera → its optical frame (ROS's REP-103 and
//! REP-105): the world's and the optical frame's axes are the caller's, a camera's are a body's (x forward, y left, z up).
//!
//! Invalid depth is as REP-117 and REP-118 have it: NaN for what is no measurement (0 in a sensor's output), `+inf` where
//! nothing is in reach, 0 in millimetres.
//!
//! [`Mcap`] writes ROS 2's messages; with the feature `rerun`, `Rrd` what Rerun reads.
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

/// Writes a recording, into an output of its own.
pub trait Recorder {
    /// Where it writes to.
    type Output;

    /// Adds a camera, any time before its first moment. Its name is made one that ROS allows, and unique.
    ///
    /// # Errors
    /// The output cannot be written, or the camera's images are too large.
    fn add_camera(&mut self, camera: &RecordedCamera) -> Result<CameraId, RecordingError>;

    /// Records what there is of a camera at a moment.
    ///
    /// # Errors
    /// The output cannot be written, an image has another size than the camera's, or the camera is another recorder's.
    fn record(&mut self, camera: CameraId, moment: &Moment<'_>) -> Result<(), RecordingError>;

    /// Writes what is left, after which the recording is whole.
    ///
    /// # Errors
    /// The output cannot be written.
    fn finish(self) -> Result<Self::Output, RecordingError>;
}

/// A camera of a [`Recorder`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CameraId(usize);

/// A camera to be recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedCamera {
    /// What it is called: the first part of its topics' names, and of its frames'.
    pub name: String,
    /// Intrinsics and lens.
    pub camera: Camera,
    /// What carries it, where that is something else than the camera itself.
    pub body: Option<Body>,
}

/// Something that moves and carries cameras.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// What it is called. Cameras whose bodies have one name are on one body.
    pub name: String,
    /// The place of the camera's optical frame on it, metres.
    pub body_from_camera: RigidTransform,
}

/// What there is of a camera at one time. Images have the camera's size.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// When it is.
    pub time: Time,
    /// Where the camera's body stands, or the camera's optical frame if it has none, metres.
    pub world_from_mount: RigidTransform,
    /// The picture, sRGB; the fourth channel is left out.
    pub rgb: Option<ImageView<'a, [u8; 4]>>,
    /// Exact depth.
    pub depth: Option<DepthView<'a>>,
    /// What the sensor reports.
    pub measured: Option<DepthView<'a>>,
    /// Whether there is a cloud of the exact depth.
    pub depth_points: bool,
    /// Whether there is a cloud of what the sensor reports.
    pub measured_points: bool,
}

impl Moment<'_> {
    /// Without images.
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

/// Depth along the optical axis. What is not above 0 is invalid.
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

/// Why something cannot be recorded.
#[derive(Debug, thiserror::Error)]
pub enum RecordingError {
    /// No stamp can say the time.
    #[error("{seconds} s is no time of a recording; give seconds from 0 to 2^31")]
    Time {
        /// The time, seconds.
        seconds: f64,
    },
    /// An image of another size than its camera's.
    #[error(
        "{camera}: {image} is {found}, the camera's images are {expected}; give the camera of the images"
    )]
    Size {
        /// The camera.
        camera: String,
        /// Which image.
        image: &'static str,
        /// Its size.
        found: ImageSize,
        /// The camera's size.
        expected: ImageSize,
    },
    /// An image whose message would be longer than messages can be.
    #[error("{camera}: images of {size} do not fit into a message; record smaller ones")]
    TooLarge {
        /// The camera.
        camera: String,
        /// Its images' size.
        size: ImageSize,
    },
    /// A camera of another recorder.
    #[error("the camera is not one of this recording; add it first")]
    NoCamera,
    /// The output cannot be written.
    #[error("cannot be written ({0})")]
    Io(#[from] io::Error),
    /// The format's own library cannot go on.
    #[error("{0}")]
    Format(String),
}

/// Refuses cameras whose images are too large for a message.
fn check_camera(camera: &RecordedCamera) -> Result<(), RecordingError> {
    let size = camera.camera.intrinsics.size;
    // 16 bytes a pixel are the most, those of a point.
    if u64::from(size.width) * u64::from(size.height) > u64::from(u32::MAX) / 16 {
        return Err(RecordingError::TooLarge {
            camera: camera.name.clone(),
            size,
        });
    }
    Ok(())
}

/// Refuses images that are not the camera's.
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
