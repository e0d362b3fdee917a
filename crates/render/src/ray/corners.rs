use super::simd::Lanes;

/// The corners of up to eight triangles: corner, axis, triangle.
pub(crate) type Corners<L> = [[L; 3]; 3];

/// Of a leaf's triangles; lanes beyond the last repeat the first.
#[inline(always)]
#[allow(clippy::needless_range_loop, reason = "lanes of several arrays")]
pub(crate) fn corners<L: Lanes>(positions: &[[f32; 3]], triangles: &[[u32; 4]]) -> Corners<L> {
    let mut values = [[[0f32; 8]; 3]; 3];
    for lane in 0..8 {
        let triangle = triangles.get(lane).unwrap_or(&triangles[0]);
        for corner in 0..3 {
            let position = positions[triangle[corner] as usize];
            for axis in 0..3 {
                values[corner][axis][lane] = position[axis];
            }
        }
    }
    values.map(|corner| corner.map(|axis| L::load(&axis)))
}
