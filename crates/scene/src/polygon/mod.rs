//! Polygon meshes, as in OpenUSD, OBJ and PLY, and their conversion to triangles.
//!
//! The conventions are OpenUSD's: a face is a sequence of corners, counter-clockwise seen from its front,
//! or clockwise if the mesh is left-handed.

mod attribute;
mod convert;
mod faces;
mod material;
mod normals;
mod primvar;
mod subdivision;
mod triangulate;
mod value;
mod weld;

pub use primvar::{Interpolation, Primvar};
pub use subdivision::{BoundaryRule, Crease, FaceVaryingRule, Scheme, Subdivision};

/// A polygon mesh as stored in a file. Its contents are not trusted: [`PolygonMesh::into_mesh`] validates them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolygonMesh {
    /// The points that faces share.
    pub points: Vec<[f32; 3]>,
    /// The number of corners of each face.
    pub face_vertex_counts: Vec<i32>,
    /// The point of each corner, face by face.
    pub face_vertex_indices: Vec<i32>,
    /// The indices of faces that are holes.
    pub holes: Vec<i32>,
    /// Whether the corners run clockwise seen from outside.
    pub left_handed: bool,
    /// Whether the inside is visible.
    pub double_sided: bool,
    /// Normals; they need not have unit length.
    pub normals: Option<Primvar<[f32; 3]>>,
    /// Texture coordinates, `(0, 0)` at the lower left of the image.
    pub uvs: Option<Primvar<[f32; 2]>>,
    /// Linear colours.
    pub colors: Option<Primvar<[f32; 3]>>,
    /// The materials of subsets of faces; a later subset takes precedence.
    pub face_materials: Vec<FaceMaterial>,
    /// The material of all other faces, an index into the scene's materials.
    pub material: Option<u32>,
    /// The subdivision scheme and its options.
    pub subdivision: Subdivision,
}

/// The faces with one material, OpenUSD's `GeomSubset`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FaceMaterial {
    /// The indices of the faces.
    pub faces: Vec<i32>,
    /// An index into the scene's materials.
    pub material: u32,
}
