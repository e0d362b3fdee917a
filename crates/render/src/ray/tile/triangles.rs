use oaktwin_camera::math::DVec3;
use oaktwin_simd::{I32Lanes, Lanes};

use super::rays::{MAX_NEEDLE, TileRays};
use super::transform::TileTransform;
use crate::ray::corners::Corners;
use crate::ray::exact;
use crate::ray::vector::Vector;

/// The maximum ratio of the distances of a triangle's corner and of its plane for which single precision suffices.
const MAX_OBLIQUENESS: f32 = 16.0;

/// Up to eight triangles, set up for rays of one origin.
#[derive(Clone, Debug)]
pub(super) struct Triangles {
    /// The normals of the planes through the origin and each edge: a ray on the positive side of all three meets the triangle.
    pub(super) sides: [[[f32; 8]; 3]; 3],
    /// The plane: 1/z along a ray is its dot product with `(u, v, 1)`.
    pub(super) plane: [[f32; 8]; 3],
    /// The minimum and the maximum of 1/z.
    pub(super) min_inverse_z: [f32; 8],
    pub(super) max_inverse_z: [f32; 8],
    /// The range on the plane z = 1.
    pub(super) u: [[f32; 8]; 2],
    pub(super) v: [[f32; 8]; 2],
    /// The triangles that the tile may see, as bits.
    pub(super) seen: u32,
    /// The visible triangles that are so oblique that they need [`refine`](Self::refine).
    pub(super) vast: u32,
    /// For each side, the visible triangles that need [`refine_sides`](Self::refine_sides) because this edge points at the origin.
    pub(super) needles: [u32; 3],
    /// The triangles that are seen from the back as far as single precision knows.
    reversed: u32,
}

impl Triangles {
    pub(super) const NONE: Self = Self {
        sides: [[[0.0; 8]; 3]; 3],
        plane: [[0.0; 8]; 3],
        min_inverse_z: [0.0; 8],
        max_inverse_z: [0.0; 8],
        u: [[0.0; 8]; 2],
        v: [[0.0; 8]; 2],
        seen: 0,
        vast: 0,
        needles: [0; 3],
        reversed: 0,
    };

    /// Sets up triangles that the tile may see at 1/z of at least `min_inverse_z`.
    #[inline(always)]
    pub(super) fn set<L: Lanes>(
        &mut self,
        corners: Corners<L>,
        frame: &TileTransform,
        rays: &TileRays,
        min_inverse_z: f32,
    ) {
        let extent = &rays.all;
        let zero = L::splat(0.0);
        let one = L::splat(1.0);
        let a = frame.transform(corners[0]);
        let b = frame.transform(corners[1]);
        let c = frame.transform(corners[2]);
        let nearest = a.z.min(b.z).min(c.z);
        let farthest = a.z.max(b.z).max(c.z);
        // With a corner behind the origin, the triangle may be anywhere.
        let in_front = zero.lt(nearest);
        let (wa, wb, wc) = (one / a.z, one / b.z, one / c.z);
        let u = range(in_front, a.x * wa, b.x * wb, c.x * wc);
        let v = range(in_front, a.y * wa, b.y * wb, c.y * wc);
        let max_inverse_z = L::select(
            in_front,
            wa.max(wb).max(wc) * L::splat(1.0 + 1e-6),
            L::splat(f32::INFINITY),
        );

        // Seen from the back, all signs are reversed.
        let normal = (b - a).cross(c - a);
        let volume = a.dot(normal);
        let sign = volume.to_bits() & L::I32::splat(i32::MIN);
        // A triangle seen exactly edge-on is invisible.
        let seen = zero.lt(L::from_bits(volume.to_bits() ^ sign))
            & zero.lt(farthest)
            & L::splat(min_inverse_z).le(max_inverse_z)
            & u[0].le(L::splat(extent.u[1]))
            & L::splat(extent.u[0]).le(u[1])
            & v[0].le(L::splat(extent.v[1]))
            & L::splat(extent.v[0]).le(v[1]);
        self.seen = seen.signs();
        self.vast = 0;
        self.needles = [0; 3];
        if self.seen == 0 {
            return;
        }
        let most = volume * L::splat(MAX_OBLIQUENESS);
        let is_oblique = (most * most).lt(a.dot(a) * normal.dot(normal));
        let is_deep = farthest * L::splat(0.95) * max_inverse_z;
        self.vast = (seen & is_oblique & one.lt(is_deep)).signs();
        let sides = [a.side(b), b.side(c), c.side(a)];
        // Edges that point at the origin belong to triangles that are seen edge-on, or that cover little beside their depth.
        let is_edge_on = (most * most).lt(farthest * farthest * normal.dot(normal));
        let depths = (farthest * max_inverse_z - one) * L::splat(16.0 * MAX_NEEDLE) + L::splat(8e-6);
        let is_narrow = (u[1] - u[0] + (v[1] - v[0])).le(depths);
        let may_be_needle = is_edge_on | is_narrow | L::splat(f32::INFINITY).le(max_inverse_z);
        self.reversed = sign.signs();
        // The sides of needles get their signs in `refine_sides`.
        let mut sign = sign;
        if (seen & may_be_needle).signs() != 0 {
            let limit = L::splat(rays.needle);
            let needles = [
                seen & points_at_origin(sides[0], a, b, limit),
                seen & points_at_origin(sides[1], b, c, limit),
                seen & points_at_origin(sides[2], c, a, limit),
            ];
            self.needles = [needles[0].signs(), needles[1].signs(), needles[2].signs()];
            sign = sign & ((needles[0] | needles[1] | needles[2]) ^ L::I32::splat(-1));
        }
        sides[0].flip(sign).store(&mut self.sides[0]);
        sides[1].flip(sign).store(&mut self.sides[1]);
        sides[2].flip(sign).store(&mut self.sides[2]);
        (normal * (one / volume)).store(&mut self.plane);
        (L::splat(1.0 - 1e-6) / farthest).store(&mut self.min_inverse_z);
        max_inverse_z.store(&mut self.max_inverse_z);
        u[0].store(&mut self.u[0]);
        u[1].store(&mut self.u[1]);
        v[0].store(&mut self.v[0]);
        v[1].store(&mut self.v[1]);
    }

    /// Recomputes the sides of a needle that point at the origin in double precision. Hides it if not even that knows their
    /// directions.
    #[allow(clippy::cast_possible_truncation, reason = "rounds once, at the end")]
    pub(super) fn refine_sides(&mut self, lane: usize, corners: [[f32; 3]; 3], frame: &TileTransform) {
        let [a, b, c] = corners.map(|p| frame.transform_exactly(DVec3::from(p.map(f64::from))));
        let is_reversed = a.dot((b - a).cross(c - a)) < 0.0;
        for (edge, (p, q)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            // The triangle at the other side of the edge decides alike, so that no ray passes between them.
            if self.needles[edge] >> lane & 1 == 1 {
                let Some(side) = exact::side(p, q) else {
                    self.seen &= !(1 << lane);
                    return;
                };
                for (axis, value) in side.to_array().into_iter().enumerate() {
                    self.sides[edge][axis][lane] = value as f32;
                }
            }
            if is_reversed {
                for values in &mut self.sides[edge] {
                    values[lane] = -values[lane];
                }
            }
        }
    }

    /// Recomputes the plane of an oblique triangle in double precision, and from which side it is seen: with the origin almost in the
    /// triangle, single precision does not know it, and would let rays meet what is behind them.
    #[allow(clippy::cast_possible_truncation, reason = "rounds once, at the end")]
    pub(super) fn refine(&mut self, lane: usize, corners: [[f32; 3]; 3], frame: &TileTransform) {
        let [a, b, c] = corners.map(|p| frame.transform_exactly(DVec3::from(p.map(f64::from))));
        let normal = (b - a).cross(c - a);
        let volume = a.dot(normal);
        let plane = normal / volume;
        if !plane.is_finite() {
            return;
        }
        let is_needle = self.needles.iter().any(|needles| needles >> lane & 1 == 1);
        if !is_needle && (volume < 0.0) != (self.reversed >> lane & 1 == 1) {
            self.reversed ^= 1 << lane;
            for values in self.sides.iter_mut().flatten() {
                values[lane] = -values[lane];
            }
        }
        for (axis, value) in plane.to_array().into_iter().enumerate() {
            self.plane[axis][lane] = value as f32;
        }
        let nearest = a.z.min(b.z).min(c.z);
        if nearest > 0.0 {
            self.max_inverse_z[lane] = (1.0 / nearest * (1.0 + 1e-6)) as f32;
        } else {
            self.max_inverse_z[lane] = f32::INFINITY;
        }
        self.min_inverse_z[lane] = ((1.0 - 1e-6) / a.z.max(b.z).max(c.z)) as f32;
    }
}

/// Whether the normal `side` of the plane through the origin and an edge is so short that single precision does not know its
/// direction.
#[inline(always)]
fn points_at_origin<L: Lanes>(side: Vector<L>, p: Vector<L>, q: Vector<L>, limit: L) -> L::I32 {
    let edge = q - p;
    side.dot(side).lt((p.dot(p) + q.dot(q)) * edge.dot(edge) * limit)
}

/// Returns the range of three values with a margin for rounding; an infinite range where `known` is not set.
#[inline(always)]
fn range<L: Lanes>(known: L::I32, p: L, q: L, r: L) -> [L; 2] {
    let (low, high) = (p.min(q).min(r), p.max(q).max(r));
    let slack = high.max(L::splat(0.0) - low) * L::splat(1e-6);
    [
        L::select(known, low - slack, L::splat(f32::NEG_INFINITY)),
        L::select(known, high + slack, L::splat(f32::INFINITY)),
    ]
}
