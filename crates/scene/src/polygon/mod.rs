//! Meshes of polygons, as OpenUSD, OBJ and PLY have them, and how they become triangles.
//!
//! The conventions are OpenUSD's: a face is a run of corners; it faces the viewer from whom its corners run
//! counter-clockwise, or clockwise if the mesh is left-handed.

mod attribute;
mod convert;
mod faces;
mod material;
mod normals;
mod primvar;
mod subdivision;
mod triangulate;
mod weld;

pub use primvar::{Interpolation, Primvar};
pub use subdivision::{BoundaryRule, Crease, FaceVaryingRule, Scheme, Subdivision};

/// A mesh of polygons as a file holds it. Nothing in it is trusted: [`PolygonMesh::into_mesh`] checks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolygonMesh {
    /// The points that faces share.
    pub points: Vec<[f32; 3]>,
    /// How many corners each face has.
    pub face_vertex_counts: Vec<i32>,
    /// The point of each corner, face by face.
    pub face_vertex_indices: Vec<i32>,
    /// Faces that are not there.
    pub holes: Vec<i32>,
    /// Whether the corners run clockwise seen from outside.
    pub left_handed: bool,
    /// Whether the inside is meant to be seen.
    pub double_sided: bool,
    /// Directions of the surface; they need not be of unit length.
    pub normals: Option<Primvar<[f32; 3]>>,
    /// Texture coordinates, `(0, 0)` at the lower left of the image.
    pub uvs: Option<Primvar<[f32; 2]>>,
    /// Linear colours.
    pub colors: Option<Primvar<[f32; 3]>>,
    /// Materials of some faces; a later one wins.
    pub face_materials: Vec<FaceMaterial>,
    /// The material of all other faces, into the scene's.
    pub material: Option<u32>,
    /// How it would be refined.
    pub subdivision: Subdivision,
}

/// Faces of one material, OpenUSD's `GeomSubset`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FaceMaterial {
    /// Which faces.
    pub faces: Vec<i32>,
    /// Into the scene's materials.
    pub material: u32,
}
