/// Clamps barycentric coordinates to 0 to 1 with a sum of 1.
#[inline]
pub(crate) fn clamped([a, b, c]: [f64; 3]) -> [f64; 3] {
    let (a, b, c) = (a.clamp(0.0, 1.0), b.clamp(0.0, 1.0), c.clamp(0.0, 1.0));
    let sum = a + b + c;
    // Also false for NaN.
    if sum > 0.0 {
        [a / sum, b / sum, c / sum]
    } else {
        [1.0 / 3.0; 3]
    }
}
