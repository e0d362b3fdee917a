/// Two independent standard normal numbers of two random words (Box and Muller 1958).
#[must_use]
pub fn standard_normal(a: u32, b: u32) -> [f64; 2] {
    // Above 0, so that its logarithm is finite.
    let radius = (-2.0 * ((f64::from(a) + 0.5) * 2f64.powi(-32)).ln()).sqrt();
    let (sine, cosine) = (f64::from(b) * 2f64.powi(-32) * std::f64::consts::TAU).sin_cos();
    [radius * cosine, radius * sine]
}
