use super::simd::Lanes;
use super::vector::Vector;

/// The corners of up to eight triangles.
pub(crate) type Corners<L> = [Vector<L>; 3];

/// Of a leaf's triangles; lanes beyond the last repeat the first.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "lanes of several arrays")]
pub(crate) fn corners<L: Lanes>(positions: &[[f32; 3]], triangles: &[[u32; 4]]) -> Corners<L> {
    let mut values = [[[0f32; 8]; 3]; 3];
    for lane in 0..8 {
        let triangle = &triangles[if lane < triangles.len() { lane } else { 0 }];
        for corner in 0..3 {
            let position = &positions[triangle[corner] as usize];
            for axis in 0..3 {
                values[corner][axis][lane] = position[axis];
            }
        }
    }
    [
        Vector::load(&values[0]),
        Vector::load(&values[1]),
        Vector::load(&values[2]),
    ]
}
