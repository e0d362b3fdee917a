//! From composed prims to a [`Scene`].

mod binding;
mod builder;
mod camera;
mod context;
mod findings;
mod instancer;
mod light;
mod material;
mod mesh;
mod own;
mod primvar;
mod shape;

use oaktwin_diagnostic::Finding;
use oaktwin_scene::Scene;

pub(super) use builder::{Builder, Children};
pub(super) use camera::pose;
pub(super) use context::Context;
pub(super) use findings::Findings;
pub(super) use own::Own;

use super::{RenderProduct, SceneCamera, StageMetadata};

/// How a stage is to be read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SceneOptions {
    /// The time code at which values are taken, between samples interpolated as OpenUSD does. `None` takes default
    /// values, and the first sample of what has no default value.
    pub time: Option<f64>,
    /// How often subdivision meshes are refined; 0 leaves their control cages, as Isaac Sim does.
    pub subdivide: u32,
}

/// A stage as it is rendered.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StageScene {
    /// What is seen, what it looks like and what lights it.
    pub scene: Scene,
    /// Every active, defined `Camera`, those inside instances too, in the order of traversal.
    pub cameras: Vec<SceneCamera>,
    /// Every `RenderProduct`, likewise.
    pub products: Vec<RenderProduct>,
    /// What the root layer says about the whole.
    pub metadata: StageMetadata,
    /// What is missing or was left out.
    pub findings: Vec<Finding>,
}
