//! The rays through the region: each is longer than the axis by a factor.

use oaktwin_depth::time_of_flight::Parameters;

/// Places along each half of a side.
const PLACES: u32 = 4;

/// The lengths of rays through the middle `region`, a share of the image's sides, at depth 1: of a quarter of it, as the
/// principal point is near the middle. The sides are taken to be as 4 to 3.
pub(super) fn rays(p: &Parameters, region: f64) -> Vec<f64> {
    let half_width = 0.5 * f64::from(p.width_px) / p.focal_length_px * region.min(1.0);
    let along = |i: u32, half: f64| (f64::from(i) + 0.5) / f64::from(PLACES) * half;
    let places = (0..PLACES).flat_map(|y| (0..PLACES).map(move |x| (x, y)));
    places
        .map(|(x, y)| {
            let (u, v) = (along(x, half_width), along(y, 0.75 * half_width));
            (1.0 + u * u + v * v).sqrt()
        })
        .collect()
}

/// The mean over rays.
pub(super) fn mean(rays: &[f64], of: impl Fn(f64) -> f64) -> f64 {
    rays.iter().map(|&ray| of(ray)).sum::<f64>() / rays.len() as f64
}
