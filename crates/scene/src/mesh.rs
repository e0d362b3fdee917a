use oaktwin_camera::math::DVec3;

use crate::MeshAttribute;

/// A triangle mesh with shared vertices, in its own frame and unit.
///
/// Every index is less than the number of positions and every position is finite: importers ensure it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The positions of the vertices.
    pub positions: Vec<[f32; 3]>,
    /// The three vertices of each triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Unit normals; without them, triangles are shaded flat.
    pub normals: Option<MeshAttribute<[f32; 3]>>,
    /// Texture coordinates, `(0, 0)` at the lower left of the image as in USD.
    pub uvs: Option<MeshAttribute<[f32; 2]>>,
    /// Linear colours that replace the base colour of materials without a texture, like USD's `displayColor`.
    pub colors: Option<MeshAttribute<[f32; 3]>>,
    /// The materials of consecutive triangles, in order, covering all of them; empty if the mesh has none.
    pub materials: Vec<MaterialSpan>,
    /// Whether the inside is visible. Depth contains both sides regardless, as in Isaac Sim.
    pub double_sided: bool,
}

/// Consecutive triangles with the same material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialSpan {
    /// The index after the last triangle's.
    pub end: u32,
    /// An index into the scene's materials, if it has one.
    pub material: Option<u32>,
}

impl Mesh {
    /// Returns the positions of a triangle's corners; `None` if the triangle does not exist.
    #[must_use]
    #[inline]
    pub fn corners(&self, triangle: usize) -> Option<[[f32; 3]; 3]> {
        let [a, b, c] = *self.triangles.get(triangle)?;
        Some([
            *self.positions.get(a as usize)?,
            *self.positions.get(b as usize)?,
            *self.positions.get(c as usize)?,
        ])
    }

    /// Returns the unit normal of a triangle's plane; zero if it has no area or does not exist.
    #[must_use]
    pub fn flat_normal(&self, triangle: usize) -> [f32; 3] {
        let Some(corners) = self.corners(triangle) else {
            return [0.0; 3];
        };
        let [a, b, c] = corners.map(|p| DVec3::from(p.map(f64::from)));
        let normal = (b - a).cross(c - a).normalize_or_zero();
        #[allow(clippy::cast_possible_truncation, reason = "a unit vector")]
        let narrow = normal.to_array().map(|x| x as f32);
        narrow
    }

    /// Returns the material of a triangle, as an index into the scene's.
    #[must_use]
    #[inline]
    pub fn material(&self, triangle: u32) -> Option<u32> {
        let span = self.materials.partition_point(|span| span.end <= triangle);
        self.materials.get(span)?.material
    }
}
