//! The lengths of the rays through the region, relative to the optical axis.

use oaktwin_depth::time_of_flight::Parameters;

/// The number of rays along each half of a side.
const PLACES: u32 = 4;

/// Returns the lengths at depth 1 of rays through the central `region`, a share of the image's sides, of one quarter,
/// because the principal point is near the centre. The aspect ratio is taken to be 4:3.
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

/// Returns the mean over the rays.
pub(super) fn mean(rays: &[f64], of: impl Fn(f64) -> f64) -> f64 {
    rays.iter().map(|&ray| of(ray)).sum::<f64>() / rays.len() as f64
}
