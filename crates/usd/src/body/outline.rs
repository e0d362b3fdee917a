use std::f64::consts::FRAC_PI_2;

use oaktwin_camera::math::DVec2;

/// The number of points per quadrant of a convex outline.
pub(super) const FINE: usize = 6;
/// The number of points per quadrant for connectors.
pub(super) const MEDIUM: usize = 4;
/// The number of points per quadrant for small parts.
pub(super) const COARSE: usize = 2;

/// A counter-clockwise convex polygon of `4 × quadrant` points, symmetric about both axes, that starts in the first
/// quadrant. Outlines of equal length are lofted into each other point by point.
pub(super) type Outline = Vec<DVec2>;

/// Returns a rectangle with rounded corners. The radius is limited to what fits.
pub(super) fn rounded_rectangle(centre: DVec2, half: DVec2, radius: f64, quadrant: usize) -> Outline {
    let radius = radius
        .min(0.999 * half.min_element())
        .max(0.02 * half.min_element());
    let signs = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    let mut points = Vec::with_capacity(4 * quadrant);
    let mut start = 0.0;
    for (sign_u, sign_v) in signs {
        let corner = centre + DVec2::new(sign_u, sign_v) * (half - radius);
        for step in 0..quadrant {
            let angle = start + FRAC_PI_2 * fraction(step, quadrant - 1);
            points.push(corner + radius * DVec2::from_angle(angle));
        }
        start += FRAC_PI_2;
    }
    points
}

/// Returns a regular polygon whose vertices avoid the axes, so that it matches [`rounded_rectangle`] point by point.
pub(super) fn circle(centre: DVec2, radius: f64, quadrant: usize) -> Outline {
    (0..4 * quadrant)
        .map(|step| {
            let angle = FRAC_PI_2 * (fraction(step, quadrant) + 0.5 * fraction(1, quadrant));
            centre + radius * DVec2::from_angle(angle)
        })
        .collect()
}

/// Interpolates from `a` (0) to `b` (1), point by point.
pub(super) fn blend(a: &[DVec2], b: &[DVec2], share: f64) -> Outline {
    a.iter().zip(b).map(|(&a, &b)| a.lerp(b, share)).collect()
}

/// Returns `part / whole` of two small counts.
pub(super) fn fraction(part: usize, whole: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "both are counts of a few dozen")]
    let (part, whole) = (part as f64, whole as f64);
    part / whole
}
