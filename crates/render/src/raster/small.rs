//! Clusters of triangles, most of which are a few pixels: eight triangles at a time, in single precision.

use super::cluster::{Cluster, ClusteredMesh, LANES, MAX_TRIANGLES, MAX_VERTICES};
use super::draw::Job;
use super::frame::{Grid, Projection};
use super::lanes::{Lanes, Row};
use super::large;
use super::tile::{Id, ROW, STRIDE, Tile};

/// Triangles that extend less than so many pixels either way are small.
const SMALL: i32 = 8;

/// A cluster's vertices on a tile's grid, and what is found of its triangles.
#[derive(Debug)]
pub(super) struct Scratch {
    /// x and y in steps, 1/z.
    vertices: [Row; MAX_VERTICES],
    tiny: Kept,
    small: Kept,
    large: Kept,
}

/// For each byte the numbers of its bits that are set, from the lowest, as bytes.
const SET_BITS: [u64; 256] = {
    let mut table = [0; 256];
    let mut mask = 0;
    while mask < 256 {
        let (mut bit, mut count) = (0, 0);
        while bit < 8 {
            if mask >> bit & 1 == 1 {
                table[mask] |= bit << (8 * count);
                count += 1;
            }
            bit += 1;
        }
        mask += 1;
    }
    table
};

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

    /// Those of eight triangles whose bit is set.
    #[inline(always)]
    fn push(&mut self, first: usize, mask: u32) {
        // All eight bytes are written: what should not be there is written over next.
        if let Some(slots) = self.triangles[self.count % MAX_TRIANGLES..].first_chunk_mut::<LANES>() {
            let packed = SET_BITS[mask as usize % 256] + first as u64 * 0x0101_0101_0101_0101;
            *slots = packed.to_le_bytes();
        }
        self.count += mask.count_ones() as usize;
    }

    /// Eight at a time, and how many of them count.
    #[inline(always)]
    fn batches(&self) -> impl Iterator<Item = (&[u8; LANES], usize)> {
        (0..self.count)
            .step_by(LANES)
            .zip(self.triangles.as_chunks::<LANES>().0)
            .map(|(first, batch)| (batch, (self.count - first).min(LANES)))
    }
}

impl Default for Scratch {
    fn default() -> Self {
        Self {
            vertices: [Row([0; 4]); MAX_VERTICES],
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
    /// Its place in the tile's list.
    pub(super) entry: usize,
}

impl Drawn<'_> {
    #[inline(always)]
    fn id(&self, triangle: u8) -> Id {
        Id::new(self.entry, u32::from(triangle))
    }

    #[inline(always)]
    fn corners(&self) -> &[u32] {
        let first = self.cluster.first_triangle as usize;
        let count = usize::from(self.cluster.triangles).next_multiple_of(LANES);
        self.mesh.corners.get(first..first + count).unwrap_or_default()
    }
}

/// Asks for a cluster's geometry before it is needed.
#[inline(always)]
pub(super) fn prefetch<L: Lanes>(l: L, mesh: &ClusteredMesh, cluster: &Cluster) {
    let first = cluster.first_vertex as usize;
    let vertices = first..first + usize::from(cluster.vertices);
    for axis in [&mesh.x, &mesh.y, &mesh.z] {
        for line in axis.get(vertices.clone()).unwrap_or_default().chunks(16) {
            l.prefetch(line);
        }
    }
    let first = cluster.first_triangle as usize;
    let triangles = first..first + usize::from(cluster.triangles);
    for line in mesh.corners.get(triangles).unwrap_or_default().chunks(16) {
        l.prefetch(line);
    }
}

/// Draws a cluster that lies between the near and the far plane, and on the tile's grid.
#[inline(always)]
pub(super) fn draw<L: Lanes, const IDS: bool>(
    l: L,
    job: &Job,
    tile: &mut Tile,
    scratch: &mut Scratch,
    drawn: &Drawn,
) {
    transform(l, scratch, drawn);
    sort_out(l, job.frame.grid, tile, scratch, drawn);
    let corners = drawn.corners();
    for (kept, count) in scratch.tiny.batches() {
        let setup = Setup::new(l, job.frame.grid, scratch, corners, kept);
        setup.draw_tiny::<IDS>(l, job, tile, drawn, kept, count);
    }
    for (kept, count) in scratch.small.batches() {
        let setup = Setup::new(l, job.frame.grid, scratch, corners, kept);
        setup.draw_rows::<IDS>(l, job, tile, drawn, kept, count);
    }
    for triangle in &scratch.large.triangles[..scratch.large.count.min(MAX_TRIANGLES)] {
        let at = drawn.cluster.first_triangle as usize + usize::from(*triangle);
        if let Some(positions) = drawn.mesh.positions(drawn.cluster, at) {
            large::draw::<L, IDS>(l, job, tile, drawn.onto_tile, positions, drawn.id(*triangle));
        }
    }
}

/// Brings the vertices onto the grid.
#[inline(always)]
fn transform<L: Lanes>(l: L, scratch: &mut Scratch, drawn: &Drawn) {
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
    let (u, v, w) = (
        splat_row(l, drawn.onto_tile.u),
        splat_row(l, drawn.onto_tile.v),
        splat_row(l, drawn.onto_tile.z),
    );
    let positions = (x.as_chunks::<LANES>().0.iter())
        .zip(y.as_chunks::<LANES>().0)
        .zip(z.as_chunks::<LANES>().0);
    let one = l.splat_d(1.0);
    for (((x, y), z), out) in positions.zip(scratch.vertices.as_chunks_mut::<LANES>().0) {
        let at = [l.widen(x), l.widen(y), l.widen(z)];
        let inverse_z = l.div_d(one, apply(l, w, at));
        let x = l.mul_d(apply(l, u, at), inverse_z);
        let y = l.mul_d(apply(l, v, at), inverse_z);
        l.store_rows(l.round_d(x), l.round_d(y), l.narrow(inverse_z), out);
    }
}

#[inline(always)]
fn splat_row<L: Lanes>(l: L, [a, b, c, d]: [f64; 4]) -> [L::D; 4] {
    [l.splat_d(a), l.splat_d(b), l.splat_d(c), l.splat_d(d)]
}

/// In the order of [`Projection::apply`].
#[inline(always)]
fn apply<L: Lanes>(l: L, m: [L::D; 4], [x, y, z]: [L::D; 3]) -> L::D {
    let sum = l.add_d(l.mul_d(m[0], x), l.mul_d(m[1], y));
    l.add_d(l.add_d(sum, l.mul_d(m[2], z)), m[3])
}

/// The vertices of eight triangles: x, y and 1/z of each corner.
#[inline(always)]
fn gather<L: Lanes>(l: L, vertices: &[Row; MAX_VERTICES], corners: [u32; LANES]) -> [(L::I, L::I, L::F); 3] {
    let c = corners.map(u32::to_le_bytes);
    [
        corner(l, vertices, c, 0),
        corner(l, vertices, c, 1),
        corner(l, vertices, c, 2),
    ]
}

#[inline(always)]
fn corner<L: Lanes>(
    l: L,
    vertices: &[Row; MAX_VERTICES],
    corners: [[u8; 4]; LANES],
    k: usize,
) -> (L::I, L::I, L::F) {
    l.columns(corners.map(|corners| &vertices[usize::from(corners[k])]))
}

/// The first and the last pixel whose centre is not before the first or behind the last of three.
#[inline(always)]
fn pixels<L: Lanes>(l: L, bits: u32, a: L::I, b: L::I, c: L::I) -> Extent<L> {
    let below = l.splat_i((1 << bits) - 1);
    let low = l.min_i(l.min_i(a, b), c);
    let high = l.max_i(l.max_i(a, b), c);
    let first = l.max_i(l.shr_i(l.add_i(low, below), bits), l.splat_i(0));
    Extent {
        first,
        last: l.shr_i(high, bits),
        size: l.sub_i(high, low),
    }
}

/// Along one axis.
struct Extent<L: Lanes> {
    /// Not before the tile.
    first: L::I,
    last: L::I,
    /// In steps.
    size: L::I,
}

/// Drops triangles that no pixel's centre of the tile can be in, and tells the others apart by size.
#[inline(always)]
fn sort_out<L: Lanes>(l: L, grid: Grid, tile: &Tile, scratch: &mut Scratch, drawn: &Drawn) {
    let bits = grid.bits;
    // A difference of coordinates may be as large as 32 bits without a sign.
    let limit = l.splat_i(if grid.is_fine { (SMALL << bits) - 1 } else { -1 });
    let (right, bottom) = (l.splat_i(tile.width - 1), l.splat_i(tile.height - 1));
    let one = l.splat_i(1);
    (scratch.tiny.count, scratch.small.count, scratch.large.count) = (0, 0, 0);
    let total = usize::from(drawn.cluster.triangles);
    for (first, corners) in (0..total)
        .step_by(LANES)
        .zip(drawn.corners().as_chunks::<LANES>().0)
    {
        let [(x0, y0, _), (x1, y1, _), (x2, y2, _)] = gather(l, &scratch.vertices, *corners);
        let (x, y) = (pixels(l, bits, x0, x1, x2), pixels(l, bits, y0, y1, y2));
        let wide = l.sub_i(l.min_i(x.last, right), x.first);
        let high = l.sub_i(l.min_i(y.last, bottom), y.first);
        // Negative, each: without a pixel; not small; not tiny.
        let is_empty = l.or_i(wide, high);
        let is_large = l.or_i(
            l.or_i(x.size, y.size),
            l.or_i(l.sub_i(limit, x.size), l.sub_i(limit, y.size)),
        );
        let is_wide = l.or_i(l.sub_i(one, wide), l.sub_i(one, high));
        let there = 0xFF >> (LANES - (total - first).min(LANES));
        let kept = !l.signs(is_empty) & there;
        let large = l.signs(is_large) & kept;
        let small = l.signs(is_wide) & kept & !large;
        if large != 0 {
            scratch.large.push(first, large);
        }
        scratch.small.push(first, small);
        scratch.tiny.push(first, kept & !large & !small);
    }
}

/// Eight small triangles, ready to be drawn.
///
/// A pixel `(i, j)`, counted from the triangle's first, lies inside if `a i + b j + c` is positive or zero for all
/// edges; these are integers as in `large`, a pixel times a grid step each. Scaled, two of them are barycentric
/// coordinates, which 1/z is interpolated with.
struct Setup<L: Lanes> {
    a: [L::I; 3],
    b: [L::I; 3],
    c: [L::I; 3],
    inverse_z: L::F,
    /// What the constants' rounding down took away.
    rest: L::F,
    slope: [L::F; 2],
    x: L::I,
    y: L::I,
    last_y: L::I,
}

impl<L: Lanes> Setup<L> {
    #[inline(always)]
    fn new(l: L, grid: Grid, scratch: &Scratch, corners: &[u32], kept: &[u8; LANES]) -> Self {
        let corners = kept.map(|at| corners.get(usize::from(at)).copied().unwrap_or_default());
        let [(x0, y0, w0), (x1, y1, w1), (x2, y2, w2)] = gather(l, &scratch.vertices, corners);
        let bits = grid.bits;
        let (x, y) = (pixels(l, bits, x0, x1, x2), pixels(l, bits, y0, y1, y2));
        let (dx1, dy1) = (l.sub_i(x1, x0), l.sub_i(y1, y0));
        let (dx2, dy2) = (l.sub_i(x2, x0), l.sub_i(y2, y0));
        let (fx1, fy1) = (l.widen_i(dx1), l.widen_i(dy1));
        let (fx2, fy2) = (l.widen_i(dx2), l.widen_i(dy2));
        let fx = l.widen_i(l.sub_i(x0, l.shl_i(x.first, bits)));
        let fy = l.widen_i(l.sub_i(y0, l.shl_i(y.first, bits)));
        let pixel = l.splat_d(1.0 / grid.steps());
        let area = l.mul_d(cross(l, fx1, fy2, fx2, fy1), pixel);
        let signed_area = l.narrow(area);
        // All ones where the corners go round the other way.
        let reversed = l.shr_i(l.bits_f(signed_area), 31);
        let sign = l.mul_d(l.widen_i(l.or_i(reversed, l.splat_i(1))), pixel);
        let c1 = l.mul_d(cross(l, fx2, fy, fy2, fx), sign);
        let c2 = l.mul_d(cross(l, fy1, fx, fx1, fy), sign);
        let area = l.mul_d(area, l.mul_d(sign, l.splat_d(grid.steps())));
        let c0 = l.sub_d(l.sub_d(area, c1), c2);
        // Just less than half: a multiple of a step less this, rounded to the nearest, is rounded down.
        let half = l.splat_d(0.5 - 0.5 / grid.steps());
        let c0 = l.round_d(l.sub_d(c0, half));
        let (k1, k2) = (l.round_d(l.sub_d(c1, half)), l.round_d(l.sub_d(c2, half)));
        let rest1 = l.narrow(l.sub_d(c1, l.widen_i(k1)));
        let rest2 = l.narrow(l.sub_d(c2, l.widen_i(k2)));
        let straight = l.xor_i(reversed, l.splat_i(-1));
        let (a1, b1) = (flip(l, dy2, reversed), flip(l, dx2, straight));
        let (a2, b2) = (flip(l, dy1, straight), flip(l, dx1, reversed));
        let zero = l.splat_i(0);
        let (a0, b0) = (l.sub_i(zero, l.add_i(a1, a2)), l.sub_i(zero, l.add_i(b1, b2)));
        // Without an area a triangle has no inside: its neighbours have its edges' pixels.
        let magnitude = l.and_i(l.bits_f(signed_area), l.splat_i(i32::MAX));
        let is_flat = l.shr_i(l.sub_i(magnitude, l.splat_i(1)), 31);
        let never = l.and_i(is_flat, l.splat_i(-1 << 30));
        let c0 = l.or_i(l.and_i(c0, l.xor_i(is_flat, l.splat_i(-1))), never);
        let per_area = l.div_f(l.splat_f(1.0), l.narrow(area));
        let slope1 = l.mul_f(l.sub_f(w1, w0), per_area);
        let slope2 = l.mul_f(l.sub_f(w2, w0), per_area);
        Self {
            a: [a0, a1, a2],
            b: [b0, b1, b2],
            c: [c0, k1, k2],
            inverse_z: w0,
            rest: l.add_f(l.mul_f(rest1, slope1), l.mul_f(rest2, slope2)),
            slope: [slope1, slope2],
            x: x.first,
            y: y.first,
            last_y: y.last,
        }
    }

    /// All eight at each of two by two pixels.
    #[inline(always)]
    fn draw_tiny<const IDS: bool>(
        &self,
        l: L,
        job: &Job,
        tile: &mut Tile,
        drawn: &Drawn,
        kept: &[u8; LANES],
        count: usize,
    ) {
        let mut mask = 0u32;
        let mut found = [[0f32; LANES]; 4];
        let mut edges = self.c;
        for (corner, found) in [0, 1, 3, 2].into_iter().zip(&mut found) {
            // Right, down, left.
            match corner {
                0 => {}
                1 => edges = add(l, edges, self.a),
                3 => edges = add(l, edges, self.b),
                _ => edges = sub(l, edges, self.a),
            }
            let outside = l.signs(l.or_i(l.or_i(edges[0], edges[1]), edges[2]));
            mask |= (outside ^ 0xFF) << (corner * LANES);
            let inverse_z = interpolate(l, edges, self.inverse_z, self.slope, self.rest);
            *found = l.store_f(inverse_z);
        }
        found.swap(2, 3);
        let at = l.store_i(l.add_i(l.mul_i(self.y, l.splat_i(ROW)), self.x));
        mask &= (0xFF >> (LANES - count)) * 0x0101_0101;
        while mask != 0 {
            let bit = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            let (corner, lane) = (bit / LANES, bit % LANES);
            #[expect(clippy::cast_sign_loss, reason = "in the tile")]
            let at = at[lane] as usize + (corner & 1) + (corner >> 1) * STRIDE;
            let id = if IDS { drawn.id(kept[lane]) } else { Id::NONE };
            tile.put::<IDS>(job, at, found[corner][lane], id);
        }
    }

    /// One by one, row by row.
    #[inline(always)]
    fn draw_rows<const IDS: bool>(
        &self,
        l: L,
        job: &Job,
        tile: &mut Tile,
        drawn: &Drawn,
        kept: &[u8; LANES],
        count: usize,
    ) {
        let columns = l.load_i(&[0, 1, 2, 3, 4, 5, 6, 7]);
        let (a, b, c) = (store(l, self.a), store(l, self.b), store(l, self.c));
        let slope = [l.store_f(self.slope[0]), l.store_f(self.slope[1])];
        let (inverse_z, rest) = (l.store_f(self.inverse_z), l.store_f(self.rest));
        let last = l.store_i(l.sub_i(l.min_i(self.last_y, l.splat_i(tile.height - 1)), self.y));
        let at = l.store_i(l.add_i(l.mul_i(self.y, l.splat_i(ROW)), self.x));
        for lane in 0..count.min(LANES) {
            let across = splat(l, a, lane);
            let across = [
                l.mul_i(across[0], columns),
                l.mul_i(across[1], columns),
                l.mul_i(across[2], columns),
            ];
            let mut edges = add(l, splat(l, c, lane), across);
            let down = splat(l, b, lane);
            let slope = [l.splat_f(slope[0][lane]), l.splat_f(slope[1][lane])];
            let (inverse_z, rest) = (l.splat_f(inverse_z[lane]), l.splat_f(rest[lane]));
            let id = if IDS { drawn.id(kept[lane]) } else { Id::NONE };
            #[expect(clippy::cast_sign_loss, reason = "in the tile")]
            let mut at = at[lane] as usize;
            for _ in 0..=last[lane] {
                let outside = l.or_i(l.or_i(edges[0], edges[1]), edges[2]);
                let w = interpolate(l, edges, inverse_z, slope, rest);
                tile.put_row::<L, IDS>(l, job, at, l.zero_where_negative(outside, w), id);
                edges = add(l, edges, down);
                at += STRIDE;
            }
        }
    }
}

#[inline(always)]
fn interpolate<L: Lanes>(l: L, edges: [L::I; 3], inverse_z: L::F, slope: [L::F; 2], rest: L::F) -> L::F {
    let second = l.add_f(l.mul_f(l.float_i(edges[2]), slope[1]), rest);
    l.add_f(inverse_z, l.add_f(l.mul_f(l.float_i(edges[1]), slope[0]), second))
}

/// `a b - c d`.
#[inline(always)]
fn cross<L: Lanes>(l: L, a: L::D, b: L::D, c: L::D, d: L::D) -> L::D {
    l.sub_d(l.mul_d(a, b), l.mul_d(c, d))
}

/// The negative where the mask is all ones.
#[inline(always)]
fn flip<L: Lanes>(l: L, a: L::I, mask: L::I) -> L::I {
    l.sub_i(l.xor_i(a, mask), mask)
}

#[inline(always)]
fn add<L: Lanes>(l: L, a: [L::I; 3], b: [L::I; 3]) -> [L::I; 3] {
    [l.add_i(a[0], b[0]), l.add_i(a[1], b[1]), l.add_i(a[2], b[2])]
}

#[inline(always)]
fn sub<L: Lanes>(l: L, a: [L::I; 3], b: [L::I; 3]) -> [L::I; 3] {
    [l.sub_i(a[0], b[0]), l.sub_i(a[1], b[1]), l.sub_i(a[2], b[2])]
}

#[inline(always)]
fn store<L: Lanes>(l: L, a: [L::I; 3]) -> [[i32; LANES]; 3] {
    [l.store_i(a[0]), l.store_i(a[1]), l.store_i(a[2])]
}

#[inline(always)]
fn splat<L: Lanes>(l: L, of: [[i32; LANES]; 3], lane: usize) -> [L::I; 3] {
    [
        l.splat_i(of[0][lane]),
        l.splat_i(of[1][lane]),
        l.splat_i(of[2][lane]),
    ]
}
