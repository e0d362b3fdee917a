//! Families of lenses as functions of their coefficients.

use oaktwin_camera::math::DVec2;

/// Returns the distorted point of a point on the plane z = 1, and its derivative with respect to each coefficient.
pub(super) type Family<const N: usize> = fn(DVec2, &[f64; N]) -> (DVec2, [DVec2; N]);

/// OpenCV's tangential terms: the derivatives with respect to p1 and p2, in which the model is linear.
fn tangential(p: DVec2) -> [DVec2; 2] {
    let (u, mixed) = (p.length_squared(), 2.0 * p.x * p.y);
    [
        DVec2::new(mixed, u + 2.0 * p.y * p.y),
        DVec2::new(u + 2.0 * p.x * p.x, mixed),
    ]
}

/// k1 k2 p1 p2, Kalibr's `radtan`.
pub(super) fn radial_tangential(p: DVec2, [k1, k2, p1, p2]: &[f64; 4]) -> (DVec2, [DVec2; 4]) {
    let u = p.length_squared();
    let [t1, t2] = tangential(p);
    (
        p * (1.0 + u * (k1 + u * k2)) + *p1 * t1 + *p2 * t2,
        [p * u, p * u * u, t1, t2],
    )
}

/// k1 to k4 of OpenCV's fisheye, Kalibr's and ROS's `equidistant`.
pub(super) fn equidistant(p: DVec2, k: &[f64; 4]) -> (DVec2, [DVec2; 4]) {
    let (direction, angle) = (p.normalize_or_zero(), p.length().atan());
    let slopes = [3, 5, 7, 9].map(|n| direction * angle.powi(n));
    let terms = slopes.iter().zip(k).map(|(slope, k)| *slope * *k);
    (direction * angle + terms.sum::<DVec2>(), slopes)
}

/// k1 k2 p1 p2 k3 k4 k5 k6, ROS's `rational_polynomial`.
pub(super) fn rational(p: DVec2, [k1, k2, p1, p2, k3, k4, k5, k6]: &[f64; 8]) -> (DVec2, [DVec2; 8]) {
    let u = p.length_squared();
    let numerator = 1.0 + u * (k1 + u * (k2 + u * k3));
    let denominator = 1.0 + u * (k4 + u * (k5 + u * k6));
    let radial = numerator / denominator;
    let up = |power: i32| p * (u.powi(power) / denominator);
    let [t1, t2] = tangential(p);
    (
        p * radial + *p1 * t1 + *p2 * t2,
        [
            up(1),
            up(2),
            t1,
            t2,
            up(3),
            -radial * up(1),
            -radial * up(2),
            -radial * up(3),
        ],
    )
}
