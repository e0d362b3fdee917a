//! Digital twins of Luxonis OAK depth cameras: what the OAK that you own, or are choosing, would see and measure.
//!
//! | task | start with |
//! |---|---|
//! | the numbers of a model, each with its source | [`catalog::Catalog`] |
//! | one device, from its DepthAI calibration | [`unit::open`] |
//! | a USD asset for Isaac Sim | [`usd::asset`] |
//! | exact depth and colour of a USD, glTF, Collada, OBJ, STL or PLY scene | [`render::SceneFile`], [`render::Renderer`] |
//! | cameras of an OAK or a stage in a scene, with what their depth sensors report | [`render::Rig`] |
//! | what the depth sensor reports of exact depth | [`render::Rig::measure`], [`sensor::sensor`] |
//! | depth from a stereo pair, as the device matches it | [`stereo::Matcher`] |
//! | accuracy, placement, and parameters fitted to recordings | [`accuracy`], [`coverage`], [`fit`], [`latency`] |
//! | URDF, SDF, MJCF, Webots, Blender | [`robot`] |
//! | data sets from recipes (feature `generate`) | `generate` |
//!
//! # The first program
//! From the catalog to a twin, its rig, a shot and its pixels. The [guide] has a page for each task.
//!
//! ```no_run
//! use oaktwin::prelude::*;
//!
//! let scene = SceneFile::open("room.usda".as_ref(), &OpenOptions::default())?;
//! let renderer = Renderer::new(scene.scene);
//! let spec = RigSpec {
//!     annotators: vec![Annotator::DistanceToImagePlane, Annotator::DepthSensorDistance],
//!     ..RigSpec::default()
//! };
//! let (mut rig, findings) = Rig::new(&Catalog::builtin().twin("OAK4-D")?, &spec)?;
//! let world_from_body = look_at(DVec3::Z, DVec3::new(1.0, 0.0, 1.0), DVec3::Z)?;
//! let (shots, more) = rig.shoot(&renderer, Some(&world_from_body), 0)?;
//! for shot in &shots {
//!     let exact = shot.frame.distance_to_image_plane.as_ref();
//!     let measured = shot.frame.depth_sensor_distance.as_ref();
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Oddities of the input are returned as [findings](diagnostic::Finding), and are never printed. A panic of another library on a corrupt file
//! is returned as an error; a program that calls [`panics::hide_contained`] does not see it printed. Same input and seed, same bytes, on any
//! number of threads and every processor.
//!
//! The features are `compressed-gltf` (Draco, Basis Universal), `generate` and `textures` (BMP, TGA, WebP, HDR), together `full`; by default, none is
//! enabled. The other crates named `oaktwin-…` are parts of this one.

pub mod guide;
pub mod prelude;

pub use oaktwin_base::{diagnostic, interrupt, panics, parameter};
pub use oaktwin_calibration as calibration;
pub use oaktwin_calibration::population;
pub use oaktwin_camera as camera;
pub use oaktwin_catalog as catalog;
pub use oaktwin_dataset as dataset;
pub use oaktwin_depth as depth;
pub use oaktwin_evaluate::{accuracy, coverage, figure, fit, latency, measure};
pub use oaktwin_files as files;
pub use oaktwin_files::memory;
#[cfg(feature = "generate")]
pub use oaktwin_generate as generate;
pub use oaktwin_image as image;
pub use oaktwin_pipeline::{
    align, imu, pair, progress, recording, render, report, sense, sensor, stereo, unit,
};
pub use oaktwin_robot as robot;
pub use oaktwin_scene as scene;
pub use oaktwin_usd as usd;
