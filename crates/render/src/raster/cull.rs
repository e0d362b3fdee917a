//! Culling: the clusters in the view frustum and the pixels that they can touch.

use oaktwin_camera::math::DVec3;

use super::bounds::Bounds;
use super::cluster::{Cluster, ClusteredMesh};
use super::frame::{FrameConstants, Projection};
use super::large;
use super::visible::Visible;

/// The visibility of a cluster.
enum Visibility {
    Outside,
    Whole(Visible),
    /// The box contains the camera, extends beyond the grid or intersects a clipping plane.
    ByTriangle,
}

/// Whether a box lies outside the view frustum.
pub(super) fn is_outside(frame: &FrameConstants, projection: &Projection, bounds: &Bounds) -> bool {
    outside(frame, &corners(projection, bounds))
}

/// Adds a cluster, or its triangles, if it can be visible.
pub(super) fn add(
    frame: &FrameConstants,
    projection: &Projection,
    mesh: &ClusteredMesh,
    instance: u32,
    at: u32,
    visible: &mut Vec<Visible>,
) {
    let Some(cluster) = mesh.clusters.get(at as usize) else {
        return;
    };
    match visibility(frame, projection, cluster, instance, at) {
        Visibility::Outside => {}
        Visibility::Whole(whole) => visible.push(whole),
        Visibility::ByTriangle => {
            let first = cluster.first_triangle;
            for triangle in first..first + u32::from(cluster.triangles) {
                let Some(positions) = mesh.positions(cluster, triangle as usize) else {
                    continue;
                };
                let corners = positions.map(|p| DVec3::from(projection.apply(p)));
                let farthest = corners.iter().map(|p| p.z).fold(f64::INFINITY, f64::min);
                if farthest > frame.far {
                    continue;
                }
                let Some([u, v]) = large::extent(corners, frame.near) else {
                    continue;
                };
                if let Some((x, y)) = pixels(frame, u, v) {
                    visible.push(Visible {
                        instance,
                        cluster: at,
                        triangle: Some(triangle),
                        inverse_z: above(1.0 / farthest.max(frame.near)),
                        x,
                        y,
                    });
                }
            }
        }
    }
}

fn visibility(
    frame: &FrameConstants,
    projection: &Projection,
    cluster: &Cluster,
    instance: u32,
    at: u32,
) -> Visibility {
    let corners = corners(projection, &cluster.bounds);
    if outside(frame, &corners) {
        return Visibility::Outside;
    }
    let (nearest, farthest) = range(corners[2]);
    if !(nearest > frame.near && farthest < frame.far) {
        return Visibility::ByTriangle;
    }
    let mut u = [0.0; 8];
    let mut v = [0.0; 8];
    for k in 0..8 {
        let inverse_z = 1.0 / corners[2][k];
        u[k] = corners[0][k] * inverse_z;
        v[k] = corners[1][k] * inverse_z;
    }
    let (u, v) = (range(u), range(v));
    let limit = frame.grid.limit / frame.grid.steps() - 1.0;
    let on_grid = |(low, high): (f64, f64), side: u32| low >= f64::from(side) - limit && high <= limit;
    if !(on_grid(u, frame.width) && on_grid(v, frame.height)) {
        return Visibility::ByTriangle;
    }
    match pixels(frame, [u.0, u.1], [v.0, v.1]) {
        None => Visibility::Outside,
        Some((x, y)) => Visibility::Whole(Visible {
            instance,
            cluster: at,
            triangle: None,
            inverse_z: above(1.0 / nearest),
            x,
            y,
        }),
    }
}

/// Returns `u`, `v` and `z` of a box's corners.
fn corners(projection: &Projection, bounds: &Bounds) -> [[f64; 8]; 3] {
    let (lower, upper) = (bounds.lower.map(f64::from), bounds.upper.map(f64::from));
    [projection.u, projection.v, projection.z].map(|row| {
        let low: [f64; 3] = std::array::from_fn(|i| row[i] * lower[i]);
        let high: [f64; 3] = std::array::from_fn(|i| row[i] * upper[i]);
        std::array::from_fn(|k| {
            let pick = |i: usize| if k >> i & 1 == 0 { low[i] } else { high[i] };
            pick(0) + pick(1) + pick(2) + row[3]
        })
    })
}

/// Whether all corners lie outside one plane of the view frustum. NaN counts as outside.
fn outside(frame: &FrameConstants, [u, v, z]: &[[f64; 8]; 3]) -> bool {
    let (nearest, farthest) = range(*z);
    if !(farthest >= frame.near && nearest <= frame.far) {
        return true;
    }
    // The frustum is half a pixel larger on all sides.
    let side = |numbers: &[f64; 8], side: u32| {
        let mut before = true;
        let mut behind = true;
        for k in 0..8 {
            before &= numbers[k] < -0.5 * z[k];
            behind &= numbers[k] > (f64::from(side) - 0.5) * z[k];
        }
        before | behind
    };
    side(u, frame.width) || side(v, frame.height)
}

fn range(numbers: [f64; 8]) -> (f64, f64) {
    let mut range = (f64::INFINITY, f64::NEG_INFINITY);
    for n in numbers {
        range.0 = if n < range.0 { n } else { range.0 };
        range.1 = if n > range.1 { n } else { range.1 };
    }
    range
}

/// Returns the pixels whose centres lie within the bounds, with a margin because vertices are snapped to the grid.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped")]
fn pixels(frame: &FrameConstants, u: [f64; 2], v: [f64; 2]) -> Option<([u32; 2], [u32; 2])> {
    let axis = |[low, high]: [f64; 2], side: u32| {
        let low = (low - MARGIN).ceil().max(0.0);
        let high = (high + MARGIN).floor().min(f64::from(side) - 1.0);
        (low <= high).then_some([low as u32, high as u32])
    };
    Some((axis(u, frame.width)?, axis(v, frame.height)?))
}

/// More than the coarsest step of a grid that draws clusters, in pixels.
const MARGIN: f64 = 1.0 / 128.0;

/// Rounds up by more than the error of interpolation in single precision.
#[expect(clippy::cast_possible_truncation, reason = "rounded up")]
fn above(inverse_z: f64) -> f32 {
    (inverse_z * (1.0 + 1e-6)) as f32
}
