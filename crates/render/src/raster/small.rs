//! Drawing of clusters whose triangles mostly cover a few pixels, eight at a time, in single precision.

use oaktwin_simd::{F64Lanes, I32Lanes, Lanes, PackedVertex};

use super::cluster::{Cluster, ClusteredMesh, LANES, MAX_TRIANGLES, MAX_VERTICES};
use super::frame::{Grid, Projection};
use super::id::Id;
use super::job::Job;
use super::large;
use super::list::TriangleList;
use super::tile::{ROW, STRIDE, Tile};

/// The extent in pixels below which triangles are small.
const SMALL: i32 = 8;

/// The vertices of a cluster on a tile's grid, and its triangles by size.
#[derive(Debug)]
pub(super) struct Scratch {
    /// x and y in steps, and 1/z.
    vertices: [PackedVertex; MAX_VERTICES],
    tiny: TriangleList,
    small: TriangleList,
    large: TriangleList,
}

impl Default for Scratch {
    fn default() -> Self {
        Self {
            vertices: [PackedVertex([0; 4]); MAX_VERTICES],
            tiny: TriangleList::EMPTY,
            small: TriangleList::EMPTY,
            large: TriangleList::EMPTY,
        }
    }
}

/// A cluster to draw.
#[derive(Clone, Copy, Debug)]
pub(super) struct Drawn<'a> {
    pub(super) mesh: &'a ClusteredMesh,
    pub(super) cluster: &'a Cluster,
    pub(super) onto_tile: &'a Projection,
    /// The index of its entry in the tile.
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

/// Prefetches the geometry of a cluster.
#[inline(always)]
pub(super) fn prefetch<L: Lanes>(mesh: &ClusteredMesh, cluster: &Cluster) {
    let first = cluster.first_vertex as usize;
    let vertices = first..first + usize::from(cluster.vertices);
    for axis in [&mesh.x, &mesh.y, &mesh.z] {
        for line in axis.get(vertices.clone()).unwrap_or_default().chunks(16) {
            L::prefetch(line);
        }
    }
    let first = cluster.first_triangle as usize;
    let triangles = first..first + usize::from(cluster.triangles);
    for line in mesh.corners.get(triangles).unwrap_or_default().chunks(16) {
        L::prefetch(line);
    }
}

/// Draws a cluster that lies between the near and the far plane and on the tile's grid.
#[inline(always)]
pub(super) fn draw<L: Lanes, const IDS: bool>(
    job: &Job,
    tile: &mut Tile,
    scratch: &mut Scratch,
    drawn: &Drawn,
) {
    transform::<L>(scratch, drawn);
    sort_out::<L>(job.frame.grid, tile, scratch, drawn);
    let corners = drawn.corners();
    for (kept, count) in scratch.tiny.batches() {
        let setup = TriangleSetup::<L>::new(job.frame.grid, scratch, corners, kept);
        setup.draw_tiny::<IDS>(job, tile, drawn, kept, count);
    }
    for (kept, count) in scratch.small.batches() {
        let setup = TriangleSetup::<L>::new(job.frame.grid, scratch, corners, kept);
        setup.draw_rows::<IDS>(job, tile, drawn, kept, count);
    }
    for triangle in &scratch.large.triangles[..scratch.large.count.min(MAX_TRIANGLES)] {
        let at = drawn.cluster.first_triangle as usize + usize::from(*triangle);
        if let Some(positions) = drawn.mesh.positions(drawn.cluster, at) {
            large::draw::<L, IDS>(job, tile, drawn.onto_tile, positions, drawn.id(*triangle));
        }
    }
}

/// Transforms the vertices and snaps them to the grid.
#[inline(always)]
fn transform<L: Lanes>(scratch: &mut Scratch, drawn: &Drawn) {
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
        splat_row(drawn.onto_tile.u),
        splat_row(drawn.onto_tile.v),
        splat_row(drawn.onto_tile.z),
    );
    let positions = (x.as_chunks::<LANES>().0.iter())
        .zip(y.as_chunks::<LANES>().0)
        .zip(z.as_chunks::<LANES>().0);
    let one = L::F64::splat(1.0);
    for (((x, y), z), out) in positions.zip(scratch.vertices.as_chunks_mut::<LANES>().0) {
        let at = [L::load(x).widen(), L::load(y).widen(), L::load(z).widen()];
        let inverse_z = one / apply(w, at);
        let x = apply(u, at) * inverse_z;
        let y = apply(v, at) * inverse_z;
        L::store_rows(L::round(x), L::round(y), L::narrow(inverse_z), out);
    }
}

#[inline(always)]
fn splat_row<D: F64Lanes>([a, b, c, d]: [f64; 4]) -> [D; 4] {
    [D::splat(a), D::splat(b), D::splat(c), D::splat(d)]
}

/// Computes in the same order as [`Projection::apply`].
#[inline(always)]
fn apply<D: F64Lanes>(m: [D; 4], [x, y, z]: [D; 3]) -> D {
    let sum = m[0] * x + m[1] * y;
    sum + m[2] * z + m[3]
}

/// Returns x, y and 1/z of the corners of eight triangles.
#[inline(always)]
fn gather<L: Lanes>(
    vertices: &[PackedVertex; MAX_VERTICES],
    corners: [u32; LANES],
) -> [(L::I32, L::I32, L); 3] {
    let c = corners.map(u32::to_le_bytes);
    [
        corner::<L>(vertices, c, 0),
        corner::<L>(vertices, c, 1),
        corner::<L>(vertices, c, 2),
    ]
}

#[inline(always)]
fn corner<L: Lanes>(
    vertices: &[PackedVertex; MAX_VERTICES],
    corners: [[u8; 4]; LANES],
    k: usize,
) -> (L::I32, L::I32, L) {
    L::load_rows(corners.map(|corners| &vertices[usize::from(corners[k])]))
}

/// Returns the pixels whose centres lie between the minimum and the maximum of three coordinates.
#[inline(always)]
fn pixels<I: I32Lanes>(bits: u32, a: I, b: I, c: I) -> Extent<I> {
    let below = I::splat((1 << bits) - 1);
    let low = a.min(b).min(c);
    let high = a.max(b).max(c);
    let first = (low + below).shift_right(bits).max(I::splat(0));
    Extent {
        first,
        last: high.shift_right(bits),
        size: high - low,
    }
}

/// The extent of triangles along one axis.
struct Extent<I> {
    /// The first pixel, not before the tile.
    first: I,
    last: I,
    /// The size in steps.
    size: I,
}

/// Drops triangles that contain no pixel centre of the tile and sorts the others by size.
#[inline(always)]
fn sort_out<L: Lanes>(grid: Grid, tile: &Tile, scratch: &mut Scratch, drawn: &Drawn) {
    let bits = grid.bits;
    // A difference of coordinates may need 32 bits without a sign.
    let limit = L::I32::splat(if grid.is_fine { (SMALL << bits) - 1 } else { -1 });
    let (right, bottom) = (L::I32::splat(tile.width - 1), L::I32::splat(tile.height - 1));
    let one = L::I32::splat(1);
    (scratch.tiny.count, scratch.small.count, scratch.large.count) = (0, 0, 0);
    let total = usize::from(drawn.cluster.triangles);
    for (first, corners) in (0..total)
        .step_by(LANES)
        .zip(drawn.corners().as_chunks::<LANES>().0)
    {
        let [(x0, y0, _), (x1, y1, _), (x2, y2, _)] = gather::<L>(&scratch.vertices, *corners);
        let (x, y) = (pixels(bits, x0, x1, x2), pixels(bits, y0, y1, y2));
        let wide = x.last.min(right) - x.first;
        let high = y.last.min(bottom) - y.first;
        // Negative where a triangle is empty; not small; not tiny.
        let is_empty = wide | high;
        let is_large = x.size | y.size | (limit - x.size) | (limit - y.size);
        let is_wide = (one - wide) | (one - high);
        let there = 0xFF >> (LANES - (total - first).min(LANES));
        let kept = !is_empty.signs() & there;
        let large = is_large.signs() & kept;
        let small = is_wide.signs() & kept & !large;
        if large != 0 {
            scratch.large.push(first, large);
        }
        scratch.small.push(first, small);
        scratch.tiny.push(first, kept & !large & !small);
    }
}

/// Eight small triangles, ready to be drawn.
///
/// A pixel `(i, j)`, relative to the triangle's first pixel, lies inside if `a i + b j + c` is positive or zero for all edges. These
/// are integers as in `large`, in units of a pixel times a grid step. Two of them, scaled, are the barycentric coordinates with
/// which 1/z is interpolated.
struct TriangleSetup<L: Lanes> {
    a: [L::I32; 3],
    b: [L::I32; 3],
    c: [L::I32; 3],
    inverse_z: L,
    /// The correction for rounding down the constants.
    rest: L,
    slope: [L; 2],
    x: L::I32,
    y: L::I32,
    last_y: L::I32,
}

impl<L: Lanes> TriangleSetup<L> {
    #[inline(always)]
    fn new(grid: Grid, scratch: &Scratch, corners: &[u32], kept: &[u8; LANES]) -> Self {
        let corners = kept.map(|at| corners.get(usize::from(at)).copied().unwrap_or_default());
        let [(x0, y0, w0), (x1, y1, w1), (x2, y2, w2)] = gather::<L>(&scratch.vertices, corners);
        let bits = grid.bits;
        let (x, y) = (pixels(bits, x0, x1, x2), pixels(bits, y0, y1, y2));
        let (dx1, dy1) = (x1 - x0, y1 - y0);
        let (dx2, dy2) = (x2 - x0, y2 - y0);
        let (fx1, fy1) = (L::widen_i32(dx1), L::widen_i32(dy1));
        let (fx2, fy2) = (L::widen_i32(dx2), L::widen_i32(dy2));
        let fx = L::widen_i32(x0 - x.first.shift_left(bits));
        let fy = L::widen_i32(y0 - y.first.shift_left(bits));
        let pixel = L::F64::splat(1.0 / grid.steps());
        let area = cross(fx1, fy2, fx2, fy1) * pixel;
        let signed_area = L::narrow(area);
        // The mask of triangles with reversed winding.
        let reversed = signed_area.to_bits().shift_right(31);
        let sign = L::widen_i32(reversed | L::I32::splat(1)) * pixel;
        let c1 = cross(fx2, fy, fy2, fx) * sign;
        let c2 = cross(fy1, fx, fx1, fy) * sign;
        let area = area * (sign * L::F64::splat(grid.steps()));
        let c0 = area - c1 - c2;
        // Slightly less than half: subtracting it before rounding to nearest rounds multiples of a step down.
        let half = L::F64::splat(0.5 - 0.5 / grid.steps());
        let c0 = L::round(c0 - half);
        let (k1, k2) = (L::round(c1 - half), L::round(c2 - half));
        let rest1 = L::narrow(c1 - L::widen_i32(k1));
        let rest2 = L::narrow(c2 - L::widen_i32(k2));
        let straight = reversed ^ L::I32::splat(-1);
        let (a1, b1) = (flip(dy2, reversed), flip(dx2, straight));
        let (a2, b2) = (flip(dy1, straight), flip(dx1, reversed));
        let zero = L::I32::splat(0);
        let (a0, b0) = (zero - (a1 + a2), zero - (b1 + b2));
        // A triangle without area has no inside; pixels on its edges belong to its neighbours.
        let magnitude = signed_area.to_bits() & L::I32::splat(i32::MAX);
        let is_flat = (magnitude - L::I32::splat(1)).shift_right(31);
        let never = is_flat & L::I32::splat(-1 << 30);
        let c0 = (c0 & (is_flat ^ L::I32::splat(-1))) | never;
        let per_area = L::splat(1.0) / L::narrow(area);
        let slope1 = (w1 - w0) * per_area;
        let slope2 = (w2 - w0) * per_area;
        Self {
            a: [a0, a1, a2],
            b: [b0, b1, b2],
            c: [c0, k1, k2],
            inverse_z: w0,
            rest: rest1 * slope1 + rest2 * slope2,
            slope: [slope1, slope2],
            x: x.first,
            y: y.first,
            last_y: y.last,
        }
    }

    /// Draws all eight triangles at each of two by two pixels.
    #[inline(always)]
    fn draw_tiny<const IDS: bool>(
        &self,
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
            // The order is right, down, left.
            match corner {
                0 => {}
                1 => edges = add(edges, self.a),
                3 => edges = add(edges, self.b),
                _ => edges = sub(edges, self.a),
            }
            let outside = (edges[0] | edges[1] | edges[2]).signs();
            mask |= (outside ^ 0xFF) << (corner * LANES);
            let inverse_z = interpolate::<L>(edges, self.inverse_z, self.slope, self.rest);
            *found = inverse_z.to_array();
        }
        found.swap(2, 3);
        let at = (self.y * L::I32::splat(ROW) + self.x).to_array();
        mask &= (0xFF >> (LANES - count)) * 0x0101_0101;
        while mask != 0 {
            let bit = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            let (corner, lane) = (bit / LANES, bit % LANES);
            #[expect(clippy::cast_sign_loss, reason = "within the tile")]
            let at = at[lane] as usize + (corner & 1) + (corner >> 1) * STRIDE;
            let id = if IDS { drawn.id(kept[lane]) } else { Id::NONE };
            tile.put::<IDS>(job, at, found[corner][lane], id);
        }
    }

    /// Draws the triangles one by one, row by row.
    #[inline(always)]
    fn draw_rows<const IDS: bool>(
        &self,
        job: &Job,
        tile: &mut Tile,
        drawn: &Drawn,
        kept: &[u8; LANES],
        count: usize,
    ) {
        let columns = L::I32::load(&[0, 1, 2, 3, 4, 5, 6, 7]);
        let (a, b, c) = (store(self.a), store(self.b), store(self.c));
        let slope = [self.slope[0].to_array(), self.slope[1].to_array()];
        let (inverse_z, rest) = (self.inverse_z.to_array(), self.rest.to_array());
        let last = (self.last_y.min(L::I32::splat(tile.height - 1)) - self.y).to_array();
        let at = (self.y * L::I32::splat(ROW) + self.x).to_array();
        for lane in 0..count.min(LANES) {
            let across = splat::<L::I32>(a, lane);
            let across = [across[0] * columns, across[1] * columns, across[2] * columns];
            let mut edges = add(splat(c, lane), across);
            let down = splat(b, lane);
            let slope = [L::splat(slope[0][lane]), L::splat(slope[1][lane])];
            let (inverse_z, rest) = (L::splat(inverse_z[lane]), L::splat(rest[lane]));
            let id = if IDS { drawn.id(kept[lane]) } else { Id::NONE };
            #[expect(clippy::cast_sign_loss, reason = "within the tile")]
            let mut at = at[lane] as usize;
            for _ in 0..=last[lane] {
                let outside = edges[0] | edges[1] | edges[2];
                let w = interpolate::<L>(edges, inverse_z, slope, rest);
                tile.put_row::<L, IDS>(job, at, L::select(outside, L::splat(0.0), w), id);
                edges = add(edges, down);
                at += STRIDE;
            }
        }
    }
}

#[inline(always)]
fn interpolate<L: Lanes>(edges: [L::I32; 3], inverse_z: L, slope: [L; 2], rest: L) -> L {
    let second = L::from_i32(edges[2]) * slope[1] + rest;
    inverse_z + (L::from_i32(edges[1]) * slope[0] + second)
}

/// `a b - c d`.
#[inline(always)]
fn cross<D: F64Lanes>(a: D, b: D, c: D, d: D) -> D {
    a * b - c * d
}

/// Negates where the mask is set.
#[inline(always)]
fn flip<I: I32Lanes>(a: I, mask: I) -> I {
    (a ^ mask) - mask
}

#[inline(always)]
fn add<I: I32Lanes>(a: [I; 3], b: [I; 3]) -> [I; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline(always)]
fn sub<I: I32Lanes>(a: [I; 3], b: [I; 3]) -> [I; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

#[inline(always)]
fn store<I: I32Lanes>(a: [I; 3]) -> [[i32; LANES]; 3] {
    [a[0].to_array(), a[1].to_array(), a[2].to_array()]
}

#[inline(always)]
fn splat<I: I32Lanes>(of: [[i32; LANES]; 3], lane: usize) -> [I; 3] {
    [
        I::splat(of[0][lane]),
        I::splat(of[1][lane]),
        I::splat(of[2][lane]),
    ]
}
