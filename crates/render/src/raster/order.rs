//! The spatial order of triangles.

use std::ops::Range;

use oaktwin_scene::Mesh;
use rayon::prelude::*;

use super::bounds::{Bounds, valid_corners};

/// Returns the triangle of a key, which is its lower half; the upper half is the position on the curve.
#[expect(clippy::cast_possible_truncation, reason = "takes the lower half")]
pub(super) fn triangle(key: u64) -> u32 {
    key as u32
}

/// Returns the valid triangles, sorted by the positions of their centroids on a Morton curve through the mesh's bounds.
pub(super) fn along_curve(mesh: &Mesh) -> Vec<u64> {
    #[expect(clippy::cast_possible_truncation, reason = "a mesh's indices are u32")]
    let mut keys: Vec<u64> = (0..mesh.triangles.len() as u32)
        .into_par_iter()
        .filter(|triangle| valid_corners(mesh, *triangle as usize).is_some())
        .map(u64::from)
        .collect();
    sort(mesh, &mut keys);
    keys
}

/// Splits sorted keys at the cells of the curve until no part has more than `limit` triangles.
pub(super) fn leaves(mesh: &Mesh, keys: &mut [u64], limit: usize) -> Vec<Range<usize>> {
    let mut leaves = Vec::with_capacity(keys.len() / limit * 2 + 1);
    // A cell that the curve does not divide further gets its own curve, up to four times.
    let mut rest = vec![(0..keys.len(), 4)];
    while let Some((range, depth)) = rest.pop() {
        let Some(piece) = keys.get_mut(range.clone()) else {
            continue;
        };
        let [first, .., last] = *piece else {
            leaves.push(range);
            continue;
        };
        if piece.len() <= limit {
            leaves.push(range);
            continue;
        }
        let differing = (first ^ last) >> 32;
        let (middle, depth) = if differing != 0 {
            let bit = 1 << (63 - (differing << 32).leading_zeros());
            (piece.partition_point(|key| key & bit == 0), depth)
        } else if depth > 0 {
            sort(mesh, piece);
            rest.push((range, depth - 1));
            continue;
        } else {
            (piece.len() / 2, 0)
        };
        let middle = range.start + middle;
        rest.push((middle..range.end, depth));
        rest.push((range.start..middle, depth));
    }
    leaves
}

fn sort(mesh: &Mesh, keys: &mut [u64]) {
    let bounds = keys
        .par_chunks(4096)
        .map(|keys| {
            keys.iter()
                .fold(Bounds::EMPTY, |bounds, key| bounds.include(centroid(mesh, *key)))
        })
        .reduce(|| Bounds::EMPTY, Bounds::union);
    let [x, y, z] = bounds.lower;
    let extent = (0..3)
        .map(|axis| bounds.upper[axis] - bounds.lower[axis])
        .fold(0.0, f32::max);
    // Cells are cubes so that a flat mesh is divided along its surface only.
    let scale = if extent > 0.0 { CELLS / extent } else { 0.0 };
    keys.par_iter_mut().for_each(|key| {
        let c = centroid(mesh, *key);
        let code =
            spread((c[0] - x) * scale) | spread((c[1] - y) * scale) << 1 | spread((c[2] - z) * scale) << 2;
        *key = code << 32 | u64::from(triangle(*key));
    });
    keys.par_sort_unstable();
}

const CELLS: f32 = 1024.0;

/// Spreads the bits of a cell's index along one axis, with two zeros between them. Overflow is clamped to the last cell.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "clamped by the cast itself"
)]
fn spread(cell: f32) -> u64 {
    let mut v = u64::from((cell as u32).min(1023));
    v = (v | v << 16) & 0x0300_00FF;
    v = (v | v << 8) & 0x0300_F00F;
    v = (v | v << 4) & 0x030C_30C3;
    (v | v << 2) & 0x0924_9249
}

/// Returns three quarters of the centroid, so that large coordinates stay finite.
fn centroid(mesh: &Mesh, key: u64) -> [f32; 3] {
    mesh.corners(triangle(key) as usize)
        .map_or([0.0; 3], |[a, b, c]| {
            std::array::from_fn(|i| a[i] / 4.0 + b[i] / 4.0 + c[i] / 4.0)
        })
}
