//! Draws large triangles, and triangles that extend behind the camera, in double precision.

use oaktwin_camera::math::DVec3;
use oaktwin_simd::{Lanes, round_ties_even};

use super::frame::{FrameConstants, Grid, Projection};
use super::id::Id;
use super::job::Job;
use super::tile::{Rectangle, STRIDE, Tile};

/// A corner in the frame of a tile's grid: `(u, v, z)` as from [`Projection::on_tile`].
#[derive(Clone, Copy, Debug)]
struct Corner {
    at: DVec3,
    /// Its position on the grid, if it is on the grid.
    snapped: Option<[i32; 2]>,
}

impl Corner {
    #[inline(always)]
    fn new(grid: Grid, at: [f64; 3]) -> Self {
        let inverse_z = 1.0 / at[2];
        let (x, y) = (at[0] * inverse_z, at[1] * inverse_z);
        let is_on_grid = at[2] > 0.0 && x.abs() <= grid.limit && y.abs() <= grid.limit;
        Self {
            at: DVec3::from(at),
            snapped: is_on_grid.then(|| [round_ties_even(x), round_ties_even(y)]),
        }
    }

    /// Returns a point on the corner's ray, at the snapped position if there is one.
    fn direction(self) -> DVec3 {
        self.snapped
            .map_or(self.at, |[x, y]| DVec3::new(x.into(), y.into(), 1.0))
    }
}

/// `a x + b y + c` for pixels of a tile.
#[derive(Clone, Copy, Debug)]
struct Linear {
    a: f64,
    b: f64,
    c: f64,
}

impl Linear {
    /// Converts a homogeneous line in steps of the grid.
    fn from_line(line: DVec3, steps: f64) -> Self {
        Self {
            a: line.x * steps,
            b: line.y * steps,
            c: line.z,
        }
    }

    /// Evaluates the function. The two triangles at an edge get exactly opposite values.
    #[inline(always)]
    fn at(self, x: f64, y: f64) -> f64 {
        self.a * x + self.b * y + self.c
    }
}

/// Draws a triangle of a mesh onto a tile.
#[inline(always)]
pub(super) fn draw<L: Lanes, const IDS: bool>(
    job: &Job,
    tile: &mut Tile,
    onto_tile: &Projection,
    positions: [[f32; 3]; 3],
    id: Id,
) {
    let frame = job.frame;
    let corners = positions.map(|p| Corner::new(frame.grid, onto_tile.apply(p)));
    let Some(rectangle) = rectangle(frame, tile, &corners) else {
        return;
    };
    let Some(edges) = edges(frame.grid, &corners) else {
        return;
    };
    let [p0, p1, p2] = corners.map(|c| c.at);
    // The plane of the original vertices, n · p = d, so that 1/z = n · (x, y, 1) / d.
    let n = (p1 - p0).cross(p2 - p0);
    let plane = Linear::from_line(n / n.dot(p0), frame.grid.steps());
    if !(plane.a.is_finite() && plane.b.is_finite() && plane.c.is_finite()) {
        return;
    }
    // Pixels that are inside on the grid can be far off a plane that is seen edge-on.
    let inverse = corners.map(|c| 1.0 / c.at.z);
    let (low, high) = if corners.iter().all(|c| c.at.z > 0.0) {
        (
            inverse[0].min(inverse[1]).min(inverse[2]),
            inverse[0].max(inverse[1]).max(inverse[2]),
        )
    } else {
        (f64::NEG_INFINITY, f64::INFINITY)
    };
    let (farthest, nearest) = (1.0 / frame.far, 1.0 / frame.near);

    for y in rectangle.y[0]..=rectangle.y[1] {
        for x in (rectangle.x[0]..=rectangle.x[1]).step_by(8) {
            let mut row = [0.0f32; 8];
            for l in 0..8u8 {
                let (x, y) = (f64::from(x) + f64::from(l), f64::from(y));
                let is_inside =
                    (edges[0].at(x, y) >= 0.0) & (edges[1].at(x, y) >= 0.0) & (edges[2].at(x, y) >= 0.0);
                let w = plane.at(x, y);
                let w = if w < low { low } else { w };
                let w = if w > high { high } else { w };
                let is_seen = is_inside & (w >= farthest) & (w <= nearest);
                #[expect(clippy::cast_possible_truncation, reason = "depth is float32")]
                {
                    row[usize::from(l)] = if is_seen { w as f32 } else { 0.0 };
                }
            }
            #[expect(clippy::cast_sign_loss, reason = "a rectangle lies in the tile")]
            tile.put_row::<L, IDS>(job, y as usize * STRIDE + x as usize, L::load(&row), id);
        }
    }
}

/// Returns the pixels of the tile whose centres can be inside; `None` if there are none.
#[inline(always)]
fn rectangle(frame: &FrameConstants, tile: &Tile, corners: &[Corner; 3]) -> Option<Rectangle> {
    let bits = frame.grid.bits;
    let range = if let [Some(a), Some(b), Some(c)] = corners.map(|c| c.snapped) {
        let axis = |i: usize| {
            let (low, high) = (a[i].min(b[i]).min(c[i]), a[i].max(b[i]).max(c[i]));
            // Rounded up: the limit of the grid leaves room.
            [(low + ((1 << bits) - 1)) >> bits, high >> bits]
        };
        [axis(0), axis(1)]
    } else {
        let extent = extent(corners.map(|c| c.at), frame.near)?;
        extent.map(|[low, high]| {
            // With a margin of a pixel because the corners are not on the grid.
            let pixel =
                |value: f64, limit: i32| (value / frame.grid.steps()).clamp(-2.0, f64::from(limit + 2));
            let limit = tile.width.max(tile.height);
            #[expect(clippy::cast_possible_truncation, reason = "clamped")]
            [pixel(low, limit).floor() as i32, pixel(high, limit).ceil() as i32]
        })
    };
    let x = [range[0][0].max(0), range[0][1].min(tile.width - 1)];
    let y = [range[1][0].max(0), range[1][1].min(tile.height - 1)];
    (x[0] <= x[1] && y[0] <= y[1]).then_some(Rectangle { x, y })
}

/// Returns the minimum and the maximum of `u/z` and `v/z` of the part beyond the near plane; `None` if there is none.
pub(super) fn extent(corners: [DVec3; 3], near: f64) -> Option<[[f64; 2]; 2]> {
    let mut extent = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    let mut include = |u: f64, v: f64, z: f64| {
        for (range, value) in extent.iter_mut().zip([u / z, v / z]) {
            *range = [range[0].min(value), range[1].max(value)];
        }
    };
    let [a, b, c] = corners;
    for (p, q) in [(a, b), (b, c), (c, a)] {
        if p.z >= near {
            include(p.x, p.y, p.z);
        }
        if (p.z >= near) != (q.z >= near) {
            let cut = p + (q - p) * ((near - p.z) / (q.z - p.z));
            include(cut.x, cut.y, near);
        }
    }
    extent.iter().all(|[low, high]| low <= high).then_some(extent)
}

/// Returns functions of a pixel that are positive or zero inside; `None` if the triangle is seen edge-on.
///
/// Each depends on its two vertices only, so that a pixel is never outside both triangles at an edge.
#[inline(always)]
fn edges(grid: Grid, corners: &[Corner; 3]) -> Option<[Linear; 3]> {
    let [a, b, c] = corners;
    let is_reversed = if let [Some(a), Some(b), Some(c)] = corners.map(|c| c.snapped) {
        let difference = |p: [i32; 2], i: usize| i64::from(p[i]) - i64::from(a[i]);
        let area = difference(b, 0) * difference(c, 1) - difference(b, 1) * difference(c, 0);
        if area == 0 {
            return None;
        }
        area < 0
    } else {
        let volume = a.direction().dot(b.direction().cross(c.direction()));
        if volume == 0.0 {
            return None;
        }
        volume < 0.0
    };
    let edge = |p: &Corner, q: &Corner| {
        let (p, q) = if is_reversed { (q, p) } else { (p, q) };
        if let (Some(p), Some(q)) = (p.snapped, q.snapped) {
            exact(p, q, grid.bits)
        } else {
            let (p, q) = (p.direction(), q.direction());
            Linear::from_line((p + q).cross(q - p), grid.steps())
        }
    };
    Some([edge(a, b), edge(b, c), edge(c, a)])
}

/// Returns the function of an edge on the grid. At a pixel it is a multiple of 2^bits plus a constant. Its sign does not change
/// when it is divided by 2^bits and the constant is rounded down, which double precision represents exactly.
#[inline(always)]
fn exact(p: [i32; 2], q: [i32; 2], bits: u32) -> Linear {
    let ([px, py], [qx, qy]) = (p.map(i64::from), q.map(i64::from));
    let number = |value: i64| {
        #[expect(clippy::cast_precision_loss, reason = "less than 2^53")]
        {
            value as f64
        }
    };
    Linear {
        a: number(py - qy),
        b: number(qx - px),
        c: number((px * qy - py * qx) >> bits),
    }
}
