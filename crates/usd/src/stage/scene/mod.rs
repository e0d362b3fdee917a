//! Converts composed prims to a [`Scene`].

mod blend;
mod builder;
mod camera;
mod context;
mod findings;
mod instancer;
mod light;
mod material;
mod mesh;
mod primvar;
mod shape;
mod skin;

use oaktwin_base::diagnostic::Finding;
use oaktwin_scene::Scene;

pub(super) use builder::{Builder, Children, is_invertible};
pub(super) use camera::{pose, rigid};
pub(super) use context::Context;
pub(super) use findings::Findings;

use super::{RenderProduct, SceneCamera, SceneLimit, StageMetadata};

/// Options for reading a stage as a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SceneOptions {
    /// The time code of values, interpolated between samples as in OpenUSD. With `None`, values are the defaults, or the
    /// first sample if there is no default.
    pub time: Option<f64>,
    /// The subdivision level of meshes; 0 keeps the control cages, as in Isaac Sim.
    pub subdivide: u32,
    /// The factor on the limits of what the stage may compose.
    pub limit: SceneLimit,
    /// Whether meshes without a texture keep their texture coordinates (`primvars:st`), for materials that are given to them later.
    pub texture_coordinates: bool,
}

/// A stage, ready to be rendered.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StageScene {
    /// The geometry, materials and lights.
    pub scene: Scene,
    /// All active, defined `Camera` prims, including those inside instances, in traversal order.
    pub cameras: Vec<SceneCamera>,
    /// All active, defined `RenderProduct` prims, in traversal order.
    pub products: Vec<RenderProduct>,
    /// The root layer's metadata.
    pub metadata: StageMetadata,
    /// Missing, invalid and unsupported prims.
    pub findings: Vec<Finding>,
}
