//! A scene to render: triangles, where their instances stand, what they look like, what lights them.
//!
//! # Frames and units
//! The world's axes are the file's own ([`Scene::up`] says which is up) and are never turned; its unit is the metre,
//! whatever the file's was. A mesh keeps the file's numbers in single precision, and
//! [`Instance::world_from_mesh`], in double precision, brings them into the world.

mod attribute;
mod bounds;
mod footprint;
pub mod import;
mod light;
mod material;
mod mesh;
pub mod polygon;
pub mod shape;
mod turn;

use oaktwin_camera::math::{DAffine3, DVec3};

pub use attribute::Attribute;
pub use bounds::Bounds;
pub use light::{Light, LightKind};
pub use material::{ColorSpace, Material, Texture, TextureSource, TextureUse, Wrap};
pub use mesh::{MaterialSpan, Mesh};

/// Everything that is rendered.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Geometry, each shared by any number of instances.
    pub meshes: Vec<Mesh>,
    /// Where meshes stand. Sorted by traversal, so that ids made from the index are the same on every run.
    pub instances: Vec<Instance>,
    /// What surfaces look like.
    pub materials: Vec<Material>,
    /// Images that materials and lights refer to.
    pub textures: Vec<Texture>,
    /// What lights the scene; empty where the file has none.
    pub lights: Vec<Light>,
    /// Which of the world's axes points up.
    pub up: Up,
    /// How many metres one of the file's units is: for outputs that are defined in scene units.
    pub meters_per_unit: MetersPerUnit,
}

/// The file's unit in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetersPerUnit(pub f64);

impl Default for MetersPerUnit {
    fn default() -> Self {
        Self(1.0)
    }
}

/// The axis that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// The y axis, as in glTF and in USD without a word about it.
    Y,
    /// The z axis, as in Isaac Sim.
    #[default]
    Z,
}

impl Up {
    /// The unit vector that points up.
    #[must_use]
    pub fn direction(self) -> DVec3 {
        match self {
            Self::Y => DVec3::Y,
            Self::Z => DVec3::Z,
        }
    }
}

/// A mesh in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// Into [`Scene::meshes`].
    pub mesh: u32,
    /// The prim or node that it is: `/World/Table/Top`.
    pub path: String,
    /// From the mesh's frame into the world, metres. Always invertible: what is squashed flat is baked into a mesh of
    /// its own by the importer.
    pub world_from_mesh: DAffine3,
    /// The semantic labels: its own first, then its parent's, and so on.
    pub labels: Vec<Label>,
}

/// A semantic label.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The prim that carries it: the instance itself or one of its ancestors, of which it may be a part only.
    pub prim: String,
    /// What kind of label it is: `class`.
    pub taxonomy: String,
    /// The label: `chair`.
    pub name: String,
}
