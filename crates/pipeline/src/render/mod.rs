//! From a scene file to ground truth and sensor outputs.
//!
//! A [`SceneFile`] has its own cameras ([`scene_cameras`]), or an OAK is placed in it ([`oak_cameras`]); both are
//! [`PlacedCamera`]s. A [`Renderer`] renders their views, and [`write_frames`] writes them.
//!
//! ```
//! use oaktwin_camera::math::DVec3;
//! use oaktwin_catalog::Catalog;
//! use oaktwin_pipeline::render::{Backend, OakOptions, Renderer, look_at, oak_cameras};
//! use oaktwin_scene::{Instance, Mesh, Scene};
//!
//! // A wall 3 m ahead; from a file it would be `SceneFile::open(path, &OpenOptions::default())?.scene`.
//! let wall = Mesh {
//!     positions: vec![[3.0, -9.0, -9.0], [3.0, 9.0, -9.0], [3.0, 0.0, 18.0]],
//!     triangles: vec![[0, 1, 2]],
//!     ..Mesh::default()
//! };
//! let mut scene = Scene { meshes: vec![wall], ..Scene::default() };
//! scene.instances.push(Instance {
//!     mesh: 0,
//!     path: "/Wall".to_owned(),
//!     world_from_mesh: Default::default(),
//!     labels: Vec::new(),
//!     material_offset: 0,
//! });
//!
//! let catalog = Catalog::builtin();
//! let twin = catalog.nominal(catalog.device("OAK4-D")?);
//! let world_from_body = look_at(DVec3::ZERO, DVec3::X, DVec3::Z)?;
//! let (cameras, _) = oak_cameras(&twin, &world_from_body, &OakOptions::default())?;
//!
//! let view = cameras[0].view(&cameras[0].world_from_mount);
//! let depth = Renderer::new(scene).depth(&view, Backend::Auto);
//! assert_eq!(depth.0.get(640, 400), Some(&3.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod animation;
mod annotators;
mod around;
mod camera;
mod carried;
mod depth_sensor;
mod frames;
mod names;
mod oak;
mod pair;
mod pose;
mod recorder;
mod rig;
mod save;
mod scene_camera;
mod scene_file;
mod shutter;
mod sweep;
pub mod trajectory;

pub use crate::limits::{MAX_PIXELS, SizeError, annotation_bytes, check_size, frame_bytes, record_bytes};
pub use animation::{Animation, MAX_FRAMES, TimeCodes, write_animation};
pub use annotators::{DEFAULT_ANNOTATORS, UnknownAnnotator, annotator};
pub use around::overview;
pub use camera::{CameraAttributes, CameraError, DepthSensorSource, PlacedCamera};
pub use carried::{Carried, write_carried};
pub use depth_sensor::{
    DepthSensorError, DepthSensorOptions, depth_sensors, scene_annotators, sense_frame, sensor_input,
};
pub use frames::{FramesError, Outputs, Written, write_frames};
pub use names::folder_names;
pub use oak::{OakOptions, check_lens, oak_cameras};
pub use oaktwin_render::{
    AnnotateOptions, Backend, Clip, Ray, Renderer, Transparent, View, Worlds, texture_pixels,
};
pub use oaktwin_usd::scene_file::ImageFiles;
pub use pair::put_pair;
pub use pose::{PoseError, look_at, pose};
pub use recorder::{FrameRecorder, record_annotators};
pub use rig::{PairUse, Rig, RigError, RigSpec, depth_sensor_of};
pub use save::{check_saved_name, save_usd, usd_files};
pub use scene_camera::{SceneCameraOptions, scene_cameras};
pub use scene_file::{AnimatedScene, OpenOptions, SceneChange, SceneFile, SceneFileError};
pub(crate) use shutter::exposed;
pub use shutter::{Moments, Passing, Shutter, Twist};
pub use sweep::{MAX_VALUES, Sweep, SweepAxis, SweepError, SweptSensors};

/// Sets the number of threads. Without effect after something was rendered.
pub fn use_threads(threads: usize) {
    // An error means that the threads already exist.
    let _ = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build_global();
}
