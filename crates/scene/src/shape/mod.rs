//! OpenUSD's shapes as triangle meshes: centred on the origin, in the unit of their sizes, with normals and texture
//! coordinates, counter-clockwise seen from outside.
//!
//! Round shapes have [`AROUND`] vertices per circle and a quarter of that from a pole to the equator. All vertices are
//! on the true surface, which lies at most `(1 − cos(π / AROUND)) · radius`, 0.03 % of the radius, outside the edges
//! (twice that outside the middle of a sphere's triangles). A size that is not positive and finite gives a mesh without
//! triangles.

mod flat;
mod lathe;

use crate::Mesh;
pub use flat::{cube, plane};
use lathe::{Lathe, Outline};

/// The number of vertices per circle.
pub const AROUND: u32 = 128;

/// The axis of a shape.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Axis {
    /// The x axis.
    X,
    /// The y axis.
    Y,
    /// The z axis.
    #[default]
    Z,
}

impl Axis {
    /// Rotates coordinates of a shape along z to this axis.
    fn turn(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::X => [z, x, y],
            Self::Y => [y, z, x],
            Self::Z => [x, y, z],
        }
    }
}

/// Creates a sphere; texture coordinates are longitude and latitude.
#[must_use]
pub fn sphere(radius: f64) -> Mesh {
    let mut outline = Outline::default();
    outline.arc(-1, 1, radius, 0.0, [0.0, 1.0]);
    Lathe::new(Axis::Z, &[radius]).surface(&outline).mesh()
}

/// Creates a closed cylinder of the given height along `axis`.
#[must_use]
pub fn cylinder(radius: f64, height: f64, axis: Axis) -> Mesh {
    let half = height / 2.0;
    let mut wall = Outline::default();
    wall.line([radius, -half], [radius, half], [0.0, 1.0]);
    Lathe::new(axis, &[radius, height])
        .disk(radius, -half)
        .surface(&wall)
        .disk(radius, half)
        .mesh()
}

/// Creates a closed cone of the given height along `axis`, with its tip on the positive side.
#[must_use]
pub fn cone(radius: f64, height: f64, axis: Axis) -> Mesh {
    let half = height / 2.0;
    let mut wall = Outline::default();
    wall.line([radius, -half], [0.0, half], [0.0, 1.0]);
    Lathe::new(axis, &[radius, height])
        .disk(radius, -half)
        .surface(&wall)
        .mesh()
}

/// Creates a cylinder of the given height along `axis`, with a hemisphere beyond each end.
#[must_use]
pub fn capsule(radius: f64, height: f64, axis: Axis) -> Mesh {
    let half = height / 2.0;
    // The second texture coordinate is proportional to the length along the outline.
    let quarter = std::f64::consts::FRAC_PI_2 * radius;
    let end = quarter / (2.0 * quarter + height);
    let mut outline = Outline::default();
    outline.arc(-1, 0, radius, -half, [0.0, end]);
    outline.line([radius, -half], [radius, half], [end, 1.0 - end]);
    outline.arc(0, 1, radius, half, [1.0 - end, 1.0]);
    Lathe::new(axis, &[radius, height]).surface(&outline).mesh()
}

/// Whether all sizes are positive and finite in single precision.
fn are_sizes(sizes: &[f64]) -> bool {
    let range = f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX);
    sizes.iter().all(|size| range.contains(size))
}

#[allow(clippy::cast_possible_truncation, reason = "meshes store single precision")]
fn narrow<const N: usize>(value: [f64; N]) -> [f32; N] {
    value.map(|x| x as f32)
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation)]
mod tests;
