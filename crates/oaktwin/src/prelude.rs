//! The types of most programs: from the catalog to a twin, its rig, a shot and its files, and an engine of one's own.
//!
//! ```
//! use oaktwin::prelude::*;
//! ```

pub use oaktwin_base::diagnostic::{Finding, Level};
pub use oaktwin_camera::math::DVec3;
pub use oaktwin_camera::{Camera, ImageSize, Intrinsics, RigidTransform, StereoGeometry};
pub use oaktwin_catalog::{Catalog, Role, Twin};
pub use oaktwin_dataset::Shot;
pub use oaktwin_depth::filter::Chain;
pub use oaktwin_depth::random::Stream;
pub use oaktwin_depth::{
    Capture, Engine, EngineInput, EngineKind, EngineRef, Factory, Input, ParameterError, Setup, Technology,
};
pub use oaktwin_files::OutputFiles;
pub use oaktwin_image::annotation::{Annotator, Frame};
pub use oaktwin_image::{Image, ZDepth};
pub use oaktwin_pipeline::pair::PairOptions;
pub use oaktwin_pipeline::render::{
    OpenOptions, Outputs, PairUse, Renderer, Rig, RigSpec, SceneFile, look_at, write_frames,
};
pub use oaktwin_pipeline::sensor::{
    SINGLE_VIEW, STEREO_MATCHING, STEREO_NOISE, SensorOptions, TIME_OF_FLIGHT,
};
