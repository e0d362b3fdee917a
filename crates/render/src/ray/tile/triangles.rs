use super::frame::{Extent, Frame, into_tile};
use crate::ray::corners::Corners;
use crate::ray::simd::Lanes;
use crate::ray::vector::{add, cross, dot, sub};

/// Up to eight triangles made ready for rays of one origin.
#[derive(Clone, Debug)]
pub(super) struct Triangles {
    /// The normals of the planes through the origin and each side: a ray that is on the positive side of all three
    /// meets the triangle.
    pub(super) sides: [[[f32; 8]; 3]; 3],
    /// The plane: 1/z along a ray `(u, v, 1)` is the dot product.
    pub(super) plane: [[f32; 8]; 3],
    /// Between which 1/z lies.
    pub(super) least: [f32; 8],
    pub(super) greatest: [f32; 8],
    /// Where it is on the plane z = 1.
    pub(super) u: [[f32; 8]; 2],
    pub(super) v: [[f32; 8]; 2],
    /// Which of them the tile may see, a bit each.
    pub(super) seen: u32,
}

impl Triangles {
    /// Those that the tile may see at 1/z of at least `least`.
    #[inline(always)]
    pub(super) fn new<L: Lanes>(corners: Corners<L>, frame: &Frame, extent: &Extent, least: f32) -> Self {
        let zero = L::splat(0.0);
        let [a, b, c] = corners.map(|corner| into_tile(frame, corner));
        // Neighbours have the same two corners here in the other order, and get the same numbers with the other sign.
        let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(p, q)| cross(add(p, q), sub(q, p)));
        let normal = cross(sub(b, a), sub(c, a));
        let volume = dot(a, normal);
        // From the back all signs are the other ones.
        let sign = volume.and(L::splat(-0.0));
        let turned = |v: [L; 3]| v.map(|x| x.xor(sign));
        let per_volume = L::splat(1.0).div(volume);

        let nearest = a[2].min(b[2]).min(c[2]);
        let farthest = a[2].max(b[2]).max(c[2]);
        // Where a corner is behind, the triangle may be anywhere.
        let in_front = zero.lt(nearest);
        let [wa, wb, wc] = [a, b, c].map(|p| L::splat(1.0).div(p[2]));
        let infinite = L::splat(f32::INFINITY);
        let minus_infinite = L::splat(f32::NEG_INFINITY);
        let range = |axis: usize| {
            let [p, q, r] = [a[axis].mul(wa), b[axis].mul(wb), c[axis].mul(wc)];
            let (low, high) = (p.min(q).min(r), p.max(q).max(r));
            // Rounding, in this and in the sides.
            let slack = high.max(zero.sub(low)).mul(L::splat(1e-6));
            [
                in_front.select(low.sub(slack), minus_infinite),
                in_front.select(high.add(slack), infinite),
            ]
        };
        let (u, v) = (range(0), range(1));
        let least_w = L::splat(1.0 - 1e-6).div(farthest);
        let greatest_w = in_front.select(L::splat(1.0 + 1e-6).div(nearest), infinite);
        let mut seen = zero.lt(farthest).and(L::splat(least).le(greatest_w));
        for (range, [low, high]) in [(u, extent.u), (v, extent.v)] {
            seen = seen
                .and(range[0].le(L::splat(high)))
                .and(L::splat(low).le(range[1]));
        }
        // Seen exactly from the side, it is nothing.
        let seen = seen.signs() & (volume.lt(zero).signs() | zero.lt(volume).signs());
        Self {
            sides: [ab, bc, ca].map(|side| turned(side).map(L::values)),
            plane: normal.map(|x| x.mul(per_volume).values()),
            least: least_w.values(),
            greatest: greatest_w.values(),
            u: u.map(L::values),
            v: v.map(L::values),
            seen,
        }
    }
}
