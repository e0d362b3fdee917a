//! A camera that frames are rendered for, whatever it comes from.

use oaktwin_render::{Clip, View};

use crate::limits::SizeError;
use oaktwin_camera::{Camera, RigidTransform, UsdOptics};
use oaktwin_diagnostic::Message;
use oaktwin_usd::depth_sensor::DepthSensor;
use oaktwin_usd::optics::OpticsError;

/// A camera in a scene: what it sees, and where it stands unless a path of poses moves it.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedCamera {
    /// What messages call it: a prim's path, or a model and its camera's prim.
    pub path: String,
    /// Its folder, where several cameras have one each: see [`folder_names`](super::folder_names).
    pub folder: String,
    /// Intrinsics and lens.
    pub camera: Camera,
    /// What is seen of the depth.
    pub clip: Clip,
    /// From the camera's optical frame to the frame that poses move, metres: the body of an OAK; nothing lies between
    /// for a camera of the scene's own.
    pub mount_from_camera: RigidTransform,
    /// Where that stands in the world, metres.
    pub world_from_mount: RigidTransform,
    /// What the camera's prim says, or would say.
    pub attributes: CameraAttributes,
    /// The depth sensor whose camera it is.
    pub depth_sensor: Option<DepthSensorSource>,
}

/// Where a depth sensor's parameters are.
#[derive(Clone, Debug, PartialEq)]
pub enum DepthSensorSource {
    /// In the twin: the name of the sensor's prim.
    Twin(String),
    /// In the stage.
    Stage {
        /// The name of the camera's prim.
        camera: String,
        /// What the stage says.
        sensor: Box<DepthSensor>,
    },
}

/// The attributes of a camera prim that renderers pass on without using them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraAttributes {
    /// Focal length and apertures, in the numbers of the prim; millimetres for an OAK of ours.
    pub optics: UsdOptics,
    /// `focusDistance`.
    pub focus_distance: f64,
    /// `fStop`.
    pub f_stop: f64,
}

impl PlacedCamera {
    /// What it sees from where its mount stands.
    #[must_use]
    pub fn view(&self, world_from_mount: &RigidTransform) -> View {
        View {
            camera: self.camera,
            world_from_camera: *world_from_mount * self.mount_from_camera,
            clip: self.clip,
        }
    }
}

/// Why there is no camera to render.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CameraError {
    /// A name that is no camera's.
    #[error("{place}: there is no camera `{name}`; {}", hint(nearest, known))]
    Unknown {
        /// The file or the model.
        place: String,
        /// The name.
        name: String,
        /// The nearest valid ones, best first.
        nearest: Vec<String>,
        /// Some of all.
        known: Vec<String>,
    },
    /// A name that several cameras have.
    #[error("{place}: `{name}` is the name of {}; give a whole path", paths.join(" and "))]
    Ambiguous {
        /// The file.
        place: String,
        /// The name.
        name: String,
        /// The cameras.
        paths: Vec<String>,
    },
    /// The scene has none.
    #[error("{file}: the scene has no camera; {remedy}")]
    NoCamera {
        /// The file.
        file: String,
        /// An OAK and a pose from which much of the scene is seen.
        remedy: Message,
    },
    /// Its attributes make no camera.
    #[error("{file}: {error}")]
    Optics {
        /// The file.
        file: String,
        /// What is wrong.
        error: OpticsError,
    },
    /// Its image cannot be.
    #[error("{camera}: {error}")]
    Size {
        /// The camera.
        camera: String,
        /// What is wrong.
        error: SizeError,
    },
}

fn hint(nearest: &[String], known: &[String]) -> String {
    match nearest {
        [] => format!("there are {}", known.join(", ")),
        near => format!("did you mean {}?", near.join(" or ")),
    }
}
