//! Rotation vectors and their derivatives.

use oaktwin_camera::math::{DMat3, DQuat, DVec3};

/// Below this angle, series replace quotients that cancel.
const SMALL_ANGLE: f64 = 0.05;

/// Returns the matrix of the cross product with a vector.
fn skew(v: DVec3) -> DMat3 {
    DMat3::from_cols(
        DVec3::new(0.0, v.z, -v.y),
        DVec3::new(-v.z, 0.0, v.x),
        DVec3::new(v.y, -v.x, 0.0),
    )
}

/// Returns the rotation by a rotation vector.
pub(crate) fn exp(r: DVec3) -> DQuat {
    DQuat::from_scaled_axis(r)
}

/// Returns the rotation vector of a rotation; its length is at most π.
pub(crate) fn log(q: DQuat) -> DVec3 {
    let q = if q.w < 0.0 { -q } else { q };
    let v = DVec3::new(q.x, q.y, q.z);
    let sine = v.length();
    if sine < 1e-9 {
        return v * (2.0 / q.w);
    }
    v * (2.0 * sine.atan2(q.w) / sine)
}

/// The coefficients (1 - cos θ)/θ² and (θ - sin θ)/θ³, and their derivatives by θ divided by θ.
fn coefficients(angle: f64) -> [f64; 4] {
    let s = angle * angle;
    if angle < SMALL_ANGLE {
        return [
            0.5 - s / 24.0 + s * s / 720.0,
            1.0 / 6.0 - s / 120.0 + s * s / 5040.0,
            -1.0 / 12.0 + s / 180.0 - s * s / 6720.0,
            -1.0 / 60.0 + s / 1260.0 - s * s / 60_480.0,
        ];
    }
    let (sine, cosine) = angle.sin_cos();
    let c = s * angle;
    [
        (1.0 - cosine) / s,
        (angle - sine) / c,
        (angle * sine - 2.0 * (1.0 - cosine)) / (s * s),
        (3.0 * sine - 2.0 * angle - angle * cosine) / (s * c),
    ]
}

/// Returns the angular velocity in the rotating frame of a rotation vector `r` with the derivative `r_dot`.
pub(crate) fn angular_velocity(r: DVec3, r_dot: DVec3) -> DVec3 {
    let [a, b, ..] = coefficients(r.length());
    r_dot - a * r.cross(r_dot) + b * r.cross(r.cross(r_dot))
}

/// Returns the matrix of [`angular_velocity`], by which `r_dot` is multiplied.
pub(crate) fn velocity_from_derivative(r: DVec3) -> DMat3 {
    let [a, b, ..] = coefficients(r.length());
    let k = skew(r);
    DMat3::IDENTITY - k * a + k * k * b
}

/// Returns the part of the angular acceleration that does not depend on the second derivative of the rotation vector.
pub(crate) fn acceleration_of_first_order(r: DVec3, r_dot: DVec3) -> DVec3 {
    let [_, b, a_prime, b_prime] = coefficients(r.length());
    let along = r.dot(r_dot);
    let turn = r.cross(r_dot);
    // The derivatives of a and b by time are their derivatives by θ, times θ̇ = r·ṙ/θ.
    -a_prime * along * turn + b_prime * along * r.cross(turn) + b * r_dot.cross(turn)
}

/// Returns the angular acceleration in the rotating frame.
pub(crate) fn angular_acceleration(r: DVec3, r_dot: DVec3, r_ddot: DVec3) -> DVec3 {
    angular_velocity(r, r_ddot) + acceleration_of_first_order(r, r_dot)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The angular velocity of a path of rotation vectors, by differences of rotations.
    fn velocity_by_differences(path: impl Fn(f64) -> DVec3, t: f64) -> DVec3 {
        let h = 1e-4;
        log(exp(path(t - h)).inverse() * exp(path(t + h))) / (2.0 * h)
    }

    proptest! {
        #[test]
        fn derivatives_are_those_of_the_rotation(
            r in prop::array::uniform3(-1.5..1.5f64),
            v in prop::array::uniform3(-2.0..2.0f64),
            c in prop::array::uniform3(-3.0..3.0f64),
            scale in prop::sample::select(vec![1.0, 1e-2, 1e-4, 0.0]),
        ) {
            let (r, v, c) = (DVec3::from(r) * scale, DVec3::from(v), DVec3::from(c));
            let path = |t: f64| r + v * t + c * (0.5 * t * t);
            let velocity = |t: f64| angular_velocity(path(t), v + c * t);
            prop_assert!((velocity(0.0) - velocity_by_differences(path, 0.0)).length() < 1e-6);
            let h = 1e-4;
            let slope = (velocity(h) - velocity(-h)) / (2.0 * h);
            let found = angular_acceleration(r, v, c);
            prop_assert!((found - slope).length() < 1e-5, "{found} {slope}");
            prop_assert!((velocity_from_derivative(r) * v - angular_velocity(r, v)).length() < 1e-12);
        }

        #[test]
        fn logarithms_invert_exponentials(r in prop::array::uniform3(-1.8..1.8f64), scale in -12.0..0.0f64) {
            let r = DVec3::from(r) * 10f64.powf(scale);
            prop_assert!((log(exp(r)) - r).length() < 1e-15 + 1e-12 * r.length());
            prop_assert!((log(-exp(r)) - r).length() < 1e-15 + 1e-12 * r.length());
        }
    }

    /// The series and the quotients agree where they meet.
    #[test]
    fn coefficients_are_continuous() {
        let (below, above) = (
            coefficients(SMALL_ANGLE * (1.0 - 1e-12)),
            coefficients(SMALL_ANGLE),
        );
        for ((series, quotient), tolerance) in below.iter().zip(above).zip([1e-11, 1e-9, 1e-7, 1e-5]) {
            assert!((series - quotient).abs() < tolerance, "{series} {quotient}");
        }
    }
}
