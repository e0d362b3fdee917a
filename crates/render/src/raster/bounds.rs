use oaktwin_scene::Mesh;

/// An axis-aligned box in the mesh frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) lower: [f32; 3],
    pub(super) upper: [f32; 3],
}

impl Bounds {
    pub(super) const EMPTY: Self = Self {
        lower: [f32::INFINITY; 3],
        upper: [f32::NEG_INFINITY; 3],
    };

    /// Includes a point; NaN coordinates are ignored.
    pub(super) fn include(mut self, point: [f32; 3]) -> Self {
        for ((lower, upper), p) in self.lower.iter_mut().zip(&mut self.upper).zip(point) {
            *lower = if p < *lower { p } else { *lower };
            *upper = if p > *upper { p } else { *upper };
        }
        self
    }

    pub(super) fn union(self, other: Self) -> Self {
        self.include(other.lower).include(other.upper)
    }
}

/// Returns the corners of a triangle if its indices are in range and its coordinates finite.
pub(super) fn valid_corners(mesh: &Mesh, triangle: usize) -> Option<[[f32; 3]; 3]> {
    let corners = mesh.corners(triangle)?;
    corners.iter().flatten().all(|c| c.is_finite()).then_some(corners)
}
