use oaktwin_camera::math::DVec3;

use crate::Attribute;

/// Triangles with shared vertices, in a frame and unit of their own.
///
/// Every index is below the number of positions and every position is finite: importers see to it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices.
    pub positions: Vec<[f32; 3]>,
    /// Three vertices each, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Unit normals; where there are none, each triangle is flat.
    pub normals: Option<Attribute<[f32; 3]>>,
    /// Texture coordinates, `(0, 0)` at the lower left of the image as in USD.
    pub uvs: Option<Attribute<[f32; 2]>>,
    /// Linear colours that replace a material's base colour where it has no texture, as USD's `displayColor`.
    pub colors: Option<Attribute<[f32; 3]>>,
    /// The materials of consecutive triangles, ordered, together all of them; empty where it has none.
    pub materials: Vec<MaterialSpan>,
    /// Whether the inside is meant to be seen. Depth sees both sides regardless, as Isaac Sim's does.
    pub double_sided: bool,
}

/// Consecutive triangles of one material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialSpan {
    /// The first triangle after it.
    pub end: u32,
    /// Into the scene's materials; `None` for none.
    pub material: Option<u32>,
}

impl Mesh {
    /// The positions of a triangle's corners; `None` where there is no such triangle.
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

    /// The normal of a triangle's plane, of unit length; zero where it has no area, or is none.
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

    /// The material of a triangle, into the scene's.
    #[must_use]
    #[inline]
    pub fn material(&self, triangle: u32) -> Option<u32> {
        let span = self.materials.partition_point(|span| span.end <= triangle);
        self.materials.get(span)?.material
    }
}
