use oaktwin_simd::Lanes;

use super::vector::Vector;

/// The corners of up to eight triangles.
pub(crate) type Corners<L> = [Vector<L>; 3];

/// Loads the corners of a leaf's triangles; lanes beyond the last repeat the first.
#[inline(always)]
pub(crate) fn corners<L: Lanes>(positions: &[[f32; 3]], triangles: &[[u32; 4]]) -> Corners<L> {
    let mut indices = [[0; 8]; 3];
    for lane in 0..8 {
        let [a, b, c, _] = triangles[if lane < triangles.len() { lane } else { 0 }];
        indices[0][lane] = a;
        indices[1][lane] = b;
        indices[2][lane] = c;
    }
    let [a, b, c] = indices;
    [
        corner(L::gather(positions, a)),
        corner(L::gather(positions, b)),
        corner(L::gather(positions, c)),
    ]
}

#[inline(always)]
fn corner<L: Lanes>([x, y, z]: [L; 3]) -> Vector<L> {
    Vector { x, y, z }
}
