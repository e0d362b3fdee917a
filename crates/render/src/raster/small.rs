//! Clusters of triangles, most of which are a few pixels: eight triangles at a time, in single precision.

use super::cluster::{Cluster, ClusteredMesh, LANES, MAX_TRIANGLES, MAX_VERTICES};
use super::frame::{Frame, Grid, Projection, ROUND, round};
use super::large;
use super::tile::{Id, STRIDE, Tile};

/// Triangles that extend less than so many pixels either way are small.
const SMALL: u32 = 8;

/// A cluster's vertices on a tile's grid, and what is found of its triangles.
#[derive(Debug)]
pub(super) struct Scratch {
    x: [i32; MAX_VERTICES],
    y: [i32; MAX_VERTICES],
    inverse_z: [f32; MAX_VERTICES],
    tiny: Kept,
    small: Kept,
    large: Kept,
}

/// Triangles of a cluster.
#[derive(Debug)]
struct Kept {
    triangles: [u8; MAX_TRIANGLES + LANES],
    count: usize,
}

impl Kept {
    const NONE: Self = Self {
        triangles: [0; MAX_TRIANGLES + LANES],
        count: 0,
    };

    #[inline(always)]
    fn push(&mut self, triangle: u8) {
        if let Some(slot) = self.triangles.get_mut(self.count) {
            *slot = triangle;
            self.count += 1;
        }
    }
}

impl Default for Scratch {
    fn default() -> Self {
        Self {
            x: [0; MAX_VERTICES],
            y: [0; MAX_VERTICES],
            inverse_z: [0.0; MAX_VERTICES],
            tiny: Kept::NONE,
            small: Kept::NONE,
            large: Kept::NONE,
        }
    }
}

/// A cluster to draw.
#[derive(Clone, Copy, Debug)]
pub(super) struct Drawn<'a> {
    pub(super) mesh: &'a ClusteredMesh,
    pub(super) cluster: &'a Cluster,
    pub(super) onto_tile: &'a Projection,
    pub(super) instance: u32,
}

impl Drawn<'_> {
    #[inline(always)]
    fn id(&self, triangle: u8) -> Id {
        let at = self.cluster.first_triangle as usize + usize::from(triangle);
        Id::from(self.instance) << 32 | self.mesh.triangles.get(at).copied().map_or(0, Id::from)
    }

    #[inline(always)]
    fn corners(&self) -> &[u32] {
        let first = self.cluster.first_triangle as usize;
        let count = usize::from(self.cluster.triangles).next_multiple_of(LANES);
        self.mesh.corners.get(first..first + count).unwrap_or_default()
    }
}

/// Draws a cluster that lies between the near and the far plane, and on the tile's grid.
#[inline(always)]
pub(super) fn draw<const IDS: bool>(frame: &Frame, tile: &mut Tile, scratch: &mut Scratch, drawn: &Drawn) {
    transform(scratch, drawn);
    sort_out(frame.grid, tile, scratch, drawn);
    let corners = drawn.corners();
    for kept in scratch.tiny.triangles[..scratch.tiny.count].chunks(LANES) {
        let setup = Setup::new(frame.grid, scratch, corners, kept);
        setup.draw_tiny::<IDS>(tile, drawn, kept);
    }
    for kept in scratch.small.triangles[..scratch.small.count].chunks(LANES) {
        let setup = Setup::new(frame.grid, scratch, corners, kept);
        for (lane, triangle) in kept.iter().enumerate() {
            setup.draw_rows::<IDS>(tile, lane, if IDS { drawn.id(*triangle) } else { 0 });
        }
    }
    for triangle in &scratch.large.triangles[..scratch.large.count] {
        let at = drawn.cluster.first_triangle as usize + usize::from(*triangle);
        if let Some(positions) = drawn.mesh.positions(drawn.cluster, at) {
            large::draw::<IDS>(frame, tile, drawn.onto_tile, positions, drawn.id(*triangle));
        }
    }
}

/// Brings the vertices onto the grid.
#[inline(always)]
fn transform(scratch: &mut Scratch, drawn: &Drawn) {
    let first = drawn.cluster.first_vertex as usize;
    let count = usize::from(drawn.cluster.vertices).next_multiple_of(LANES);
    let range = first..first + count;
    let mesh = drawn.mesh;
    let (Some(x), Some(y), Some(z)) = (
        mesh.x.get(range.clone()),
        mesh.y.get(range.clone()),
        mesh.z.get(range),
    ) else {
        return;
    };
    let (x, y, z) = (
        x.as_chunks::<LANES>().0,
        y.as_chunks::<LANES>().0,
        z.as_chunks::<LANES>().0,
    );
    let out_x = scratch.x.as_chunks_mut::<LANES>().0;
    let out_y = scratch.y.as_chunks_mut::<LANES>().0;
    let out_w = scratch.inverse_z.as_chunks_mut::<LANES>().0;
    for (((((x, y), z), out_x), out_y), out_w) in x.iter().zip(y).zip(z).zip(out_x).zip(out_y).zip(out_w) {
        for l in 0..LANES {
            let [u, v, z] = drawn.onto_tile.apply([x[l], y[l], z[l]]);
            let inverse_z = 1.0 / z;
            out_x[l] = round(u * inverse_z);
            out_y[l] = round(v * inverse_z);
            #[expect(clippy::cast_possible_truncation, reason = "depth is float32")]
            {
                out_w[l] = inverse_z as f32;
            }
        }
    }
}

/// The three corners' numbers among the vertices, of each lane.
#[inline(always)]
fn unpack(corners: u32) -> [usize; 3] {
    let [a, b, c, _] = corners.to_le_bytes();
    [a, b, c].map(usize::from)
}

/// Drops triangles that no pixel's centre of the tile can be in, and tells the others apart by size.
#[inline(always)]
fn sort_out(grid: Grid, tile: &Tile, scratch: &mut Scratch, drawn: &Drawn) {
    let bits = grid.bits;
    let below = (1i32 << bits) - 1;
    let limit = if grid.is_fine { SMALL << bits } else { 0 };
    let (right, bottom) = (tile.width - 1, tile.height - 1);
    (scratch.tiny.count, scratch.small.count, scratch.large.count) = (0, 0, 0);
    let total = usize::from(drawn.cluster.triangles);
    for (batch, corners) in drawn.corners().as_chunks::<LANES>().0.iter().enumerate() {
        let mut kind = [0u8; LANES];
        let (mut low_x, mut high_x, mut low_y, mut high_y) =
            ([0i32; LANES], [0i32; LANES], [0i32; LANES], [0i32; LANES]);
        for l in 0..LANES {
            let [a, b, c] = unpack(corners[l]);
            let (x0, x1, x2) = (scratch.x[a], scratch.x[b], scratch.x[c]);
            let (y0, y1, y2) = (scratch.y[a], scratch.y[b], scratch.y[c]);
            low_x[l] = x0.min(x1).min(x2);
            high_x[l] = x0.max(x1).max(x2);
            low_y[l] = y0.min(y1).min(y2);
            high_y[l] = y0.max(y1).max(y2);
        }
        for l in 0..LANES {
            let (first_x, last_x) = (
                ((low_x[l] + below) >> bits).max(0),
                (high_x[l] >> bits).min(right),
            );
            let (first_y, last_y) = (
                ((low_y[l] + below) >> bits).max(0),
                (high_y[l] >> bits).min(bottom),
            );
            let (wide, high) = (last_x - first_x, last_y - first_y);
            let extent = high_x[l]
                .wrapping_sub(low_x[l])
                .max(high_y[l].wrapping_sub(low_y[l]));
            let is_small = extent.cast_unsigned() < limit;
            let is_tiny = is_small & (wide <= 1) & (high <= 1);
            let is_kept = (wide >= 0) & (high >= 0);
            kind[l] = u8::from(is_kept) * (3 - u8::from(is_small) - u8::from(is_tiny));
        }
        for (l, kind) in kind.iter().enumerate() {
            let triangle = batch * LANES + l;
            if triangle >= total {
                break;
            }
            #[expect(clippy::cast_possible_truncation, reason = "less than MAX_TRIANGLES")]
            match kind {
                0 => {}
                1 => scratch.tiny.push(triangle as u8),
                2 => scratch.small.push(triangle as u8),
                _ => scratch.large.push(triangle as u8),
            }
        }
    }
}

/// Eight small triangles, ready to be drawn.
///
/// A pixel `(i, j)`, counted from the triangle's first, lies inside if `a i + b j + c` is positive or zero for all
/// edges; these are integers as in `large`, a pixel times a grid step each. Scaled, two of them are barycentric
/// coordinates, which 1/z is interpolated with.
#[derive(Debug)]
struct Setup {
    a: [[i32; LANES]; 3],
    b: [[i32; LANES]; 3],
    c: [[i32; LANES]; 3],
    inverse_z: [f32; LANES],
    /// What the constants' rounding down took away.
    rest: [f32; LANES],
    slope: [[f32; LANES]; 2],
    x: [i32; LANES],
    y: [i32; LANES],
    last_y: [i32; LANES],
}

impl Setup {
    #[inline(always)]
    fn new(grid: Grid, scratch: &Scratch, corners: &[u32], kept: &[u8]) -> Self {
        let mut x = [[0i32; LANES]; 3];
        let mut y = [[0i32; LANES]; 3];
        let mut w = [[0f32; LANES]; 3];
        for (l, triangle) in kept.iter().enumerate().take(LANES) {
            let corners = unpack(corners.get(usize::from(*triangle)).copied().unwrap_or_default());
            for (k, vertex) in corners.into_iter().enumerate() {
                x[k][l] = scratch.x[vertex];
                y[k][l] = scratch.y[vertex];
                w[k][l] = scratch.inverse_z[vertex];
            }
        }
        let zero = [0i32; LANES];
        let mut setup = Self {
            a: [zero; 3],
            b: [zero; 3],
            c: [zero; 3],
            inverse_z: w[0],
            rest: [0.0; LANES],
            slope: [[0.0; LANES]; 2],
            x: zero,
            y: zero,
            last_y: zero,
        };
        let bits = grid.bits;
        let below = (1i32 << bits) - 1;
        let pixels = 1.0 / grid.steps();
        // Just less than half: a multiple of a step less this, rounded to the nearest, is rounded down.
        let half = 0.5 - 0.5 * pixels;
        for l in 0..LANES {
            let (x0, x1, x2) = (x[0][l], x[1][l], x[2][l]);
            let (y0, y1, y2) = (y[0][l], y[1][l], y[2][l]);
            let first_x = ((x0.min(x1).min(x2) + below) >> bits).max(0);
            let first_y = ((y0.min(y1).min(y2) + below) >> bits).max(0);
            setup.x[l] = first_x;
            setup.y[l] = first_y;
            setup.last_y[l] = y0.max(y1).max(y2) >> bits;
            let (dx1, dy1) = (x1 - x0, y1 - y0);
            let (dx2, dy2) = (x2 - x0, y2 - y0);
            let (fx, fy) = (
                f64::from(x0 - (first_x << bits)),
                f64::from(y0 - (first_y << bits)),
            );
            let (fx1, fy1) = (f64::from(dx1), f64::from(dy1));
            let (fx2, fy2) = (f64::from(dx2), f64::from(dy2));
            // All exact: products of numbers of at most bits + 3 bits.
            let area = fx1 * fy2 - fx2 * fy1;
            let sign = if area < 0.0 { -1.0 } else { 1.0 };
            let mask = if area < 0.0 { -1 } else { 0 };
            let area = area * sign;
            let c1 = (fx2 * fy - fy2 * fx) * sign;
            let c2 = (fy1 * fx - fx1 * fy) * sign;
            let c0 = area - c1 - c2;
            let rounded = [c0, c1, c2].map(|c| (c * pixels - half) + ROUND);
            let a1 = (dy2 ^ mask) - mask;
            let b1 = (dx2 ^ !mask) - !mask;
            let a2 = (dy1 ^ !mask) - !mask;
            let b2 = (dx1 ^ mask) - mask;
            setup.a[0][l] = -(a1 + a2);
            setup.b[0][l] = -(b1 + b2);
            setup.a[1][l] = a1;
            setup.b[1][l] = b1;
            setup.a[2][l] = a2;
            setup.b[2][l] = b2;
            #[expect(clippy::cast_possible_truncation, reason = "the lowest bits are the integer")]
            let rounded_down = rounded.map(|r| r.to_bits() as i32);
            // Without an area it is between its neighbours' pixels.
            setup.c[0][l] = if area > 0.0 { rounded_down[0] } else { -1 << 30 };
            setup.c[1][l] = rounded_down[1];
            setup.c[2][l] = rounded_down[2];
            #[expect(clippy::cast_possible_truncation, reason = "depth is float32")]
            let (inverse_area, r1, r2) = (
                1.0 / ((area * pixels) as f32),
                (c1 * pixels - (rounded[1] - ROUND)) as f32,
                (c2 * pixels - (rounded[2] - ROUND)) as f32,
            );
            let slope1 = (w[1][l] - w[0][l]) * inverse_area;
            let slope2 = (w[2][l] - w[0][l]) * inverse_area;
            setup.slope[0][l] = slope1;
            setup.slope[1][l] = slope2;
            setup.rest[l] = r1 * slope1 + r2 * slope2;
        }
        setup
    }

    /// All eight at each of two by two pixels.
    #[inline(always)]
    fn draw_tiny<const IDS: bool>(&self, tile: &mut Tile, drawn: &Drawn, kept: &[u8]) {
        let mut mask = 0u32;
        let mut found = [[0f32; LANES]; 4];
        for (corner, found) in found.iter_mut().enumerate() {
            let is_right = if corner & 1 == 1 { -1 } else { 0 };
            let is_down = if corner & 2 == 2 { -1 } else { 0 };
            let mut outside = [0i32; LANES];
            for l in 0..LANES {
                let e = |k: usize| self.c[k][l] + (self.a[k][l] & is_right) + (self.b[k][l] & is_down);
                let (e0, e1, e2) = (e(0), e(1), e(2));
                outside[l] = e0 | e1 | e2;
                found[l] = self.interpolate(l, e1, e2);
            }
            for (l, outside) in outside.iter().enumerate() {
                mask |= u32::from(*outside >= 0) << (corner * LANES + l);
            }
        }
        #[expect(clippy::cast_sign_loss, reason = "in the tile")]
        let at: [usize; LANES] = std::array::from_fn(|l| self.y[l] as usize * STRIDE + self.x[l] as usize);
        let valid = 0xFFu32 >> (LANES - kept.len().min(LANES));
        mask &= valid * 0x0101_0101;
        while mask != 0 {
            let bit = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            let (corner, lane) = (bit / LANES, bit % LANES);
            let at = at[lane] + (corner & 1) + (corner >> 1) * STRIDE;
            let id = if IDS {
                drawn.id(kept.get(lane).copied().unwrap_or_default())
            } else {
                0
            };
            tile.put::<IDS>(at, found[corner][lane], id);
        }
    }

    #[inline(always)]
    fn interpolate(&self, lane: usize, e1: i32, e2: i32) -> f32 {
        #[expect(
            clippy::cast_precision_loss,
            reason = "where it counts, they have less than 24 bits"
        )]
        let (e1, e2) = (e1 as f32, e2 as f32);
        self.inverse_z[lane] + (e1 * self.slope[0][lane] + (e2 * self.slope[1][lane] + self.rest[lane]))
    }

    /// One of them, row by row.
    #[inline(always)]
    fn draw_rows<const IDS: bool>(&self, tile: &mut Tile, lane: usize, id: Id) {
        const COLUMNS: [i32; LANES] = [0, 1, 2, 3, 4, 5, 6, 7];
        let lane = lane % LANES;
        let start = |k: usize| COLUMNS.map(|i| self.c[k][lane] + self.a[k][lane] * i);
        let (mut e0, mut e1, mut e2) = (start(0), start(1), start(2));
        let last = self.last_y[lane].min(tile.height - 1);
        #[expect(clippy::cast_sign_loss, reason = "in the tile")]
        let mut at = self.y[lane] as usize * STRIDE + self.x[lane] as usize;
        for _ in self.y[lane]..=last {
            let mut row = [0f32; LANES];
            for l in 0..LANES {
                let w = self.interpolate(lane, e1[l], e2[l]);
                row[l] = if e0[l] | e1[l] | e2[l] >= 0 { w } else { 0.0 };
            }
            tile.put_row::<IDS>(at, row, id);
            for l in 0..LANES {
                e0[l] += self.b[0][lane];
                e1[l] += self.b[1][lane];
                e2[l] += self.b[2][lane];
            }
            at += STRIDE;
        }
    }
}
