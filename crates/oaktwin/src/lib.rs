//! Digital twins of Luxonis OAK depth cameras: what the OAK that you own, or are choosing, would see and measure.
//!
//! | task | start with |
//! |---|---|
//! | the numbers of a model, each with its source | [`catalog::Catalog`] |
//! | one device, from its DepthAI calibration | [`unit::open`] |
//! | a USD asset for Isaac Sim | [`usd::asset`] |
//! | exact depth and colour of a USD, glTF, OBJ, STL or PLY scene | [`render::SceneFile`], [`render::Renderer`] |
//! | what the depth sensor reports of exact depth | [`sensor::sensor`] |
//! | depth from a stereo pair, as the device matches it | [`stereo::Matcher`] |
//! | accuracy, placement, and parameters fitted to recordings | [`accuracy`], [`coverage`], [`fit`] |
//! | URDF, SDF, MJCF, Webots, Blender | [`robot`] |
//! | data sets from recipes (feature `generate`) | `generate` |
//!
//! # A model and its asset
//! A [`Twin`](catalog::Twin) is a device with all cameras resolved: intrinsics, lens and pose. It is nominal, or one unit's.
//!
//! ```
//! use oaktwin::camera::math::DVec3;
//! use oaktwin::catalog::{Catalog, Role};
//! use oaktwin::usd::asset::{AssetOptions, asset};
//!
//! let catalog = Catalog::builtin();
//! let twin = catalog.nominal(catalog.device("OAK-D Pro PoE")?);
//!
//! let left = twin.camera(Role::Left).ok_or("no left camera")?;
//! assert_eq!(left.intrinsics.fx.round(), 805.0);
//! // Positions are in metres in the body frame: x forward, y left, z up.
//! assert_eq!(left.body_from_camera.translation, DVec3::new(0.0, 0.0375, 0.0));
//!
//! let usd = asset(&twin, &AssetOptions::default())?;
//! assert!(usd.text().starts_with("#usda 1.0"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What its depth sensor reports
//! Exact depth along the optical axis in, what the camera would have measured out: in metres, 0 where it has no value.
//!
//! ```
//! use oaktwin::catalog::Catalog;
//! use oaktwin::image::Image;
//! use oaktwin::sensor::{SensorOptions, Shot, depth_sensor, sensor};
//!
//! let catalog = Catalog::builtin();
//! let twin = catalog.nominal(catalog.device("OAK4-D")?);
//! let (mut sensor, findings) = sensor(&twin, depth_sensor(&twin, None)?, &SensorOptions::default())?;
//! assert!(findings.is_empty());
//!
//! let wall = Image::filled(1280, 800, 2.0);
//! let capture = sensor.capture(Shot::new((&wall).into()), &[])?;
//! let measured = capture.distance.0.get(640, 400).ok_or("outside the image")?;
//! assert!((measured - 2.0).abs() < 0.1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Exact depth of a scene
//! The examples `render_scene`, `stereo_pair` and `own_unit` of this crate are whole programs.
//!
//! ```no_run
//! use oaktwin::camera::math::DVec3;
//! use oaktwin::catalog::Catalog;
//! use oaktwin::render::{Backend, OakOptions, OpenOptions, Renderer, SceneFile, look_at, oak_cameras};
//!
//! let scene = SceneFile::open("room.usda".as_ref(), &OpenOptions::default())?;
//! let twin = Catalog::builtin().nominal(Catalog::builtin().device("OAK4-D")?);
//! let world_from_body = look_at(DVec3::Z, DVec3::new(1.0, 0.0, 1.0), DVec3::Z)?;
//! let (cameras, _findings) = oak_cameras(&twin, &world_from_body, &OakOptions::default())?;
//! let renderer = Renderer::new(scene.scene);
//! for camera in &cameras {
//!     let depth = renderer.depth(&camera.view(&camera.world_from_mount), Backend::Auto);
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Oddities of the input are returned as [findings](diagnostic::Finding), and are never printed. Same input and seed, same bytes, on any
//! number of threads and every processor.
//!
//! The features are `compressed-gltf` (Draco, Basis Universal), `generate` and `textures` (BMP, TGA, WebP, HDR), together `full`; by default, none is
//! enabled. The other crates named `oaktwin-…` are parts of this one.

pub use oaktwin_base::{diagnostic, parameter};
pub use oaktwin_calibration as calibration;
pub use oaktwin_calibration::population;
pub use oaktwin_camera as camera;
pub use oaktwin_catalog as catalog;
pub use oaktwin_dataset as dataset;
pub use oaktwin_depth as depth;
pub use oaktwin_evaluate::{accuracy, coverage, figure, fit, measure};
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
