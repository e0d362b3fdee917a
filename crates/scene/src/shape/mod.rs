//! OpenUSD's shapes as triangles: centred on the origin, in the unit of their sizes, with normals and texture
//! coordinates, seen from outside counter-clockwise.
//!
//! Round ones have [`AROUND`] corners on the circle and a quarter of that from a pole to the equator. All corners are
//! on the true surface, which lies at most `(1 − cos(π / AROUND)) · radius`, 0.03 % of the radius, outside the edges
//! (twice that outside the middle of a ball's triangles). A size that is not positive and finite gives a mesh without
//! triangles.

mod flat;
mod lathe;

use crate::Mesh;
pub use flat::{cube, plane};
use lathe::{Outline, Turned};

/// How many corners a circle has.
pub const AROUND: u32 = 128;

/// The axis that a shape stands along.
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
    /// Of coordinates in a shape that stands along z; a rotation, so what is outside stays outside.
    fn turn(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match self {
            Self::X => [z, x, y],
            Self::Y => [y, z, x],
            Self::Z => [x, y, z],
        }
    }
}

/// A ball; texture coordinates are longitude and latitude.
#[must_use]
pub fn sphere(radius: f64) -> Mesh {
    let mut outline = Outline::default();
    outline.arc(-1, 1, radius, 0.0, [0.0, 1.0]);
    Turned::new(Axis::Z, &[radius]).surface(&outline).mesh()
}

/// A closed cylinder, `height` along `axis`.
#[must_use]
pub fn cylinder(radius: f64, height: f64, axis: Axis) -> Mesh {
    let half = height / 2.0;
    let mut wall = Outline::default();
    wall.line([radius, -half], [radius, half], [0.0, 1.0]);
    Turned::new(axis, &[radius, height])
        .disk(radius, -half)
        .surface(&wall)
        .disk(radius, half)
        .mesh()
}

/// A closed cone, `height` along `axis` with its tip on the positive side.
#[must_use]
pub fn cone(radius: f64, height: f64, axis: Axis) -> Mesh {
    let half = height / 2.0;
    let mut wall = Outline::default();
    wall.line([radius, -half], [0.0, half], [0.0, 1.0]);
    Turned::new(axis, &[radius, height])
        .disk(radius, -half)
        .surface(&wall)
        .mesh()
}

/// A cylinder, `height` along `axis`, with half a ball beyond each end.
#[must_use]
pub fn capsule(radius: f64, height: f64, axis: Axis) -> Mesh {
    let half = height / 2.0;
    // Texture coordinates go up as far as the way along the outline.
    let quarter = std::f64::consts::FRAC_PI_2 * radius;
    let end = quarter / (2.0 * quarter + height);
    let mut outline = Outline::default();
    outline.arc(-1, 0, radius, -half, [0.0, end]);
    outline.line([radius, -half], [radius, half], [end, 1.0 - end]);
    outline.arc(0, 1, radius, half, [1.0 - end, 1.0]);
    Turned::new(axis, &[radius, height]).surface(&outline).mesh()
}

/// Whether all are sizes that single precision has.
fn are_sizes(sizes: &[f64]) -> bool {
    let range = f64::from(f32::MIN_POSITIVE)..=f64::from(f32::MAX);
    sizes.iter().all(|size| range.contains(size))
}

#[allow(
    clippy::cast_possible_truncation,
    reason = "single precision is what meshes have"
)]
fn narrow<const N: usize>(value: [f64; N]) -> [f32; N] {
    value.map(|x| x as f32)
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation)]
mod tests;
