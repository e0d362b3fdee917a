//! Cameras to render, from any source.

use oaktwin_render::{Clip, View};

use crate::limits::SizeError;
use oaktwin_base::diagnostic::{Message, suggestion};
use oaktwin_camera::{Camera, RigidTransform, UsdOptics};
use oaktwin_depth::imager::Photosites;
use oaktwin_usd::depth_sensor::StageDepthSensor;
use oaktwin_usd::optics::OpticsError;

/// A camera in a scene, with its pose unless a trajectory moves it.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedCamera {
    /// The name in messages: a prim's path, or a model and its camera's prim.
    pub path: String,
    /// The folder if there are several cameras, from [`folder_names`](super::folder_names).
    pub folder: String,
    /// What the camera is on its device: `rgb`, `left`, `right`, `tof`, `stereo_depth`, …; `None` for a camera of the scene.
    pub role: Option<String>,
    /// The intrinsics and lens.
    pub camera: Camera,
    /// The clipping range.
    pub clip: Clip,
    /// The pose of the camera's optical frame in the frame that a trajectory moves, metres: the body of an OAK; the identity for
    /// a camera of the scene.
    pub mount_from_camera: RigidTransform,
    /// The pose of that frame in the world, metres.
    pub world_from_mount: RigidTransform,
    /// The readout time, s: how much later the last row is exposed than the first. 0 for a global shutter; `None` for a camera of the scene, whose
    /// shutter is unknown.
    pub readout_s: Option<f64>,
    /// What its pixels are made of. A camera of the scene has one photosite for each pixel, as large as its aperture says, and at most 3 µm.
    pub photosites: Photosites,
    /// The attributes of the camera's prim.
    pub attributes: CameraAttributes,
    /// The depth sensor of the camera.
    pub depth_sensor: Option<DepthSensorSource>,
}

/// The source of a depth sensor's parameters.
#[derive(Clone, Debug, PartialEq)]
pub enum DepthSensorSource {
    /// A twin, with the name of the sensor's prim.
    Twin(String),
    /// A stage.
    Stage {
        /// The name of the camera's prim.
        camera: String,
        /// The authored attributes.
        sensor: Box<StageDepthSensor>,
    },
}

/// The attributes of a camera prim that are written but not rendered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraAttributes {
    /// The focal length and apertures in the units of the prim; millimetres for an OAK.
    pub optics: UsdOptics,
    /// `focusDistance`.
    pub focus_distance: f64,
    /// `fStop`.
    pub f_stop: f64,
}

impl PlacedCamera {
    /// Whether a name is the camera's: what it is on its device, its path, or the last part of the path.
    #[must_use]
    pub fn is_called(&self, name: &str) -> bool {
        let last = self.path.rsplit('/').next();
        self.role.as_deref() == Some(name) || self.path == name || last == Some(name)
    }

    /// Returns the view with the mount at a pose.
    #[must_use]
    pub fn view(&self, world_from_mount: &RigidTransform) -> View {
        View {
            camera: self.camera,
            world_from_camera: *world_from_mount * self.mount_from_camera,
            clip: self.clip,
        }
    }
}

/// An error that prevents a camera from being rendered.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CameraError {
    /// An unknown name.
    #[error("{place}: unknown camera '{name}'; {}", suggestion(nearest, known))]
    Unknown {
        /// The file or the model.
        place: String,
        /// The name.
        name: String,
        /// The nearest names, best first.
        nearest: Vec<String>,
        /// Valid names.
        known: Vec<String>,
    },
    /// An ambiguous name.
    #[error("{place}: '{name}' is ambiguous: {}; give the whole path", paths.join(", "))]
    Ambiguous {
        /// The file.
        place: String,
        /// The name.
        name: String,
        /// The cameras.
        paths: Vec<String>,
    },
    /// The scene has no camera.
    #[error("{file}: the scene has no camera; {remedy}")]
    NoCamera {
        /// The file.
        file: String,
        /// An OAK and a pose from which much of the scene is seen.
        remedy: Message,
    },
    /// The attributes are invalid.
    #[error("{file}: {error}")]
    Optics {
        /// The file.
        file: String,
        /// What is wrong.
        error: OpticsError,
    },
    /// The image size is invalid.
    #[error("{camera}: {error}")]
    Size {
        /// The camera.
        camera: String,
        /// What is wrong.
        error: SizeError,
    },
}
