//! A scene to render: triangle meshes, their instances, materials and lights.
//!
//! # Frames and units
//! The world keeps the file's axes ([`Scene::up`] is the up axis); its unit is the metre,
//! whatever the file's unit is. A mesh keeps the file's numbers in single precision, and
//! [`Instance::world_from_mesh`], in double precision, transforms them to the world.

mod attribute;
mod bounds;
mod footprint;
pub mod import;
mod infrared;
mod light;
mod material;
mod mesh;
mod placement;
pub mod polygon;
pub mod shape;
mod turn;

use oaktwin_base::parameter::choice;
use oaktwin_camera::math::{DAffine3, DVec3};

pub use attribute::MeshAttribute;
pub use bounds::Bounds;
pub use infrared::InfraredError;
pub use light::{Light, LightKind};
pub use material::{
    ColorSpace, DEFAULT_INDEX, Material, Opacity, Texture, TextureMask, TextureSource, TextureUse,
    Transmission, Wrap,
};
pub use mesh::{MaterialSpan, Mesh};

/// A scene: meshes, instances, materials and lights.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// The geometry; a mesh may have any number of instances.
    pub meshes: Vec<Mesh>,
    /// The instances of meshes, in order of traversal, so that ids derived from the index are the same on every run.
    pub instances: Vec<Instance>,
    /// The materials.
    pub materials: Vec<Material>,
    /// The images that materials and lights refer to.
    pub textures: Vec<Texture>,
    /// The lights; empty if the file defines none.
    pub lights: Vec<Light>,
    /// The up axis of the world.
    pub up: Up,
    /// The metres per unit of the file, for outputs that are defined in scene units.
    pub meters_per_unit: MetersPerUnit,
    /// The labels of instances that the scene may have at other times, so that the ids of labels do not depend on what it shows now.
    pub possible_labels: Vec<Vec<Label>>,
    /// The fine texture of surfaces without a texture of their own; by default they are perfectly even.
    pub micro_texture: Option<MicroTexture>,
}

/// The fine variation of albedo that painted, wooden, plastic and woven surfaces have, by which stereo cameras match them.
///
/// A sum of octaves of noise in the surface's own frame, in metres: it moves with the surface and does not depend on the view, beyond
/// the filtering of what is finer than a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MicroTexture {
    /// The maximum variation of the albedo by one octave, relative to the albedo.
    pub contrast: f32,
    /// The seed of the noise.
    pub seed: u32,
}

impl MicroTexture {
    /// Returns the texture of ordinary surfaces: each octave from 0.5 mm to 0.13 m varies the albedo by at most 2 %, by 1 to 2 %
    /// in all. An estimate.
    #[must_use]
    pub const fn ordinary(seed: u32) -> Self {
        Self { contrast: 0.02, seed }
    }
}

/// The metres per unit of the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetersPerUnit(pub f64);

impl Default for MetersPerUnit {
    fn default() -> Self {
        Self(1.0)
    }
}

choice! {
    /// The up axis.
    Up {
        /// The z axis, as in Isaac Sim.
        Z = "z",
        /// The y axis, as in glTF and as USD's default.
        Y = "y",
    }
}

impl Up {
    /// Returns the unit vector that points up.
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
    /// An index into [`Scene::meshes`].
    pub mesh: u32,
    /// The path of its prim or node: `/World/Table/Top`.
    pub path: String,
    /// The transform from the mesh's frame to the world, metres. Always invertible: the importer bakes a mesh with a
    /// singular transform into a new mesh.
    pub world_from_mesh: DAffine3,
    /// The semantic labels: its own first, then its parent's, and so on.
    pub labels: Vec<Label>,
    /// Added to the mesh's indices of materials, so that instances of one mesh can look different. 0 in every file.
    pub material_offset: u32,
}

impl Instance {
    /// Whether the instance is a prim or one of its descendants; the empty path is the root.
    #[must_use]
    pub fn is_below(&self, prim: &str) -> bool {
        let rest = self.path.strip_prefix(prim.trim_end_matches('/'));
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('/'))
    }

    /// Returns the index of a material of the mesh in the scene.
    #[must_use]
    #[inline]
    pub fn material(&self, of_mesh: Option<u32>) -> Option<u32> {
        of_mesh?.checked_add(self.material_offset)
    }
}

/// A semantic label.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The prim with the label: the instance itself or one of its ancestors.
    pub prim: String,
    /// The taxonomy, such as `class`.
    pub taxonomy: String,
    /// The label, such as `chair`.
    pub name: String,
}
