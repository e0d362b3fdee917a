use glam::{DMat2, DMat3, DVec2};

use super::monotone::agrees;
use super::rational::{Rational, Smooth};
use super::{LensError, padded};

/// The greatest distance between a ray beside a cancelled pole and the ray of the model without the pole.
const WIDEST_POLE: f64 = 0.1;

/// OpenCV's pinhole distortion with its 14 coefficients: rational radial terms, tangential terms, thin prism, and a
/// tilted sensor.
///
/// With u = x² + y² and (x, y) on the plane z = 1 (OpenCV, "Camera Calibration and 3D Reconstruction"):
///
/// ```text
/// g  = (1 + k1 u + k2 u² + k3 u³) / (1 + k4 u + k5 u² + k6 u³)
/// x' = x g + 2 p1 x y + p2 (u + 2 x²) + s1 u + s2 u²
/// y' = y g + p1 (u + 2 y²) + 2 p2 x y + s3 u + s4 u²
/// (x″, y″, 1) ∝ T(τx, τy) (x', y', 1)
/// ```
///
/// Factory calibrations of OAK cameras have k1, k2, k4 and k5 of up to a few hundred that nearly cancel. In many of them g has a
/// pole inside the image, and a zero within 0.002 of it in r = √u, which cancels it everywhere else. [`undistort`](Self::undistort)
/// passes over such a pole, like OpenCV's iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenCvPinhole {
    coefficients: [f64; 14],
    radial: Rational,
    /// The radial factor without cancelled poles, if it has some.
    smooth: Option<Smooth>,
}

impl OpenCvPinhole {
    /// Creates a lens from k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 τx τy, in OpenCV's order.
    #[must_use]
    pub fn new(coefficients: [f64; 14]) -> Self {
        let [k1, k2, _, _, k3, k4, k5, k6, ..] = coefficients;
        let radial = Rational {
            n: [1.0, k1, k2, k3],
            d: [1.0, k4, k5, k6],
        };
        Self {
            coefficients,
            radial,
            smooth: radial.without_cancelled_poles(),
        }
    }

    /// Returns the coefficients in OpenCV's order.
    #[must_use]
    pub const fn coefficients(&self) -> &[f64; 14] {
        &self.coefficients
    }

    /// Returns the distorted radii of the poles that a zero cancels, in ascending order: circles about the principal point, without
    /// the sensor's tilt. Within a few pixels of them, rays are not the real lens's.
    #[must_use]
    pub fn cancelled_poles(&self) -> Vec<f64> {
        let distorted = |(r, smooth): (f64, Smooth)| r * smooth.radial.at(r * r).0;
        self.smooth
            .into_iter()
            .flat_map(|smooth| smooth.poles.map(|r| (r, smooth)))
            .filter(|(r, _)| r.is_finite())
            .map(distorted)
            .collect()
    }

    /// Creates a lens from OpenCV's 4, 5, 8, 12 or 14 coefficients, or any number up to 14, as in `DepthAI`; missing ones are
    /// 0.
    ///
    /// # Errors
    /// Returns an error if there are more than 14 coefficients or one is not finite.
    pub fn from_slice(coefficients: &[f64]) -> Result<Self, LensError> {
        Ok(Self::new(padded("OpenCV's pinhole distortion", coefficients)?))
    }

    /// Returns the distorted point of a point on the plane z = 1.
    #[must_use]
    pub fn distort(&self, normalized: DVec2) -> DVec2 {
        self.distort_with_jacobian(normalized).0
    }

    /// Returns the distorted point and its derivative, `[[∂x″/∂x, ∂x″/∂y], [∂y″/∂x, ∂y″/∂y]]`.
    #[must_use]
    pub fn distort_with_jacobian(&self, normalized: DVec2) -> (DVec2, DMat2) {
        let (flat, d_flat) = self.before_tilt(normalized, &self.radial);
        let Some(tilt) = self.tilt() else {
            return (flat, d_flat);
        };
        let h = tilt * flat.extend(1.0);
        let tilted = h.truncate() / h.z;
        let d_tilt = DMat2::from_cols(
            (tilt.x_axis.truncate() - tilted * tilt.x_axis.z) / h.z,
            (tilt.y_axis.truncate() - tilted * tilt.y_axis.z) / h.z,
        );
        (tilted, d_tilt * d_flat)
    }

    /// Returns the point on the plane z = 1 of a distorted point, or `None` beyond the fold. Newton's method converges to the
    /// model's rounding error (the distorted point is reached within 1e-12). Where a cancelled pole leaves no solution, it
    /// returns the ray of the model without the pole.
    #[must_use]
    pub fn undistort(&self, distorted: DVec2) -> Option<DVec2> {
        let target = self.untilt(distorted)?;
        let Some(smooth) = &self.smooth else {
            return self.solve(&self.radial, target);
        };
        let near = self.solve(&smooth.radial, target)?;
        Some(self.beside_poles(smooth, target, near).unwrap_or(near))
    }

    /// Returns the solution that OpenCV's iteration converges to, if it is near the solution of the model without cancelled poles.
    /// Close to a pole there are up to four solutions, two of which may attract the iteration.
    fn beside_poles(&self, smooth: &Smooth, target: DVec2, near: DVec2) -> Option<DVec2> {
        let r = near.length();
        let is_close = smooth
            .poles
            .into_iter()
            .any(|pole| (pole - r).abs() < WIDEST_POLE);
        let start = if is_close {
            self.iterate_as_opencv(target)
        } else {
            near
        };
        let (at, slope) = self.newton(&self.radial, target, start);
        (self.reaches(&self.radial, target, at)
            && slope.determinant() > 0.0
            && at.distance(near) < WIDEST_POLE)
            .then_some(at)
    }

    /// Returns the result of the fixed-point iteration of `cv2.undistortPointsIter`, which begins at the distorted point.
    fn iterate_as_opencv(&self, target: DVec2) -> DVec2 {
        let mut at = target;
        for _ in 0..300 {
            let (radial, _) = self.radial.at(at.length_squared());
            if radial.is_nan() || radial <= 0.0 {
                break;
            }
            let next = (target - (self.before_tilt(at, &self.radial).0 - at * radial)) / radial;
            let step = next.distance(at);
            at = next;
            if step < 1e-9 {
                break;
            }
        }
        at
    }

    /// Solves the model with another radial factor, which has no cancelled pole.
    fn solve(&self, radial: &Rational, target: DVec2) -> Option<DVec2> {
        let found = |at: DVec2| self.reaches(radial, target, at) && self.is_monotone_at(at);

        // From the distorted point, Newton's method takes three to six steps for moderate distortion.
        let (at, _) = self.newton(radial, target, target);
        if found(at) {
            return Some(at);
        }

        // It crossed a fold, or there is no solution: retry from the centre without leaving the valid region.
        let mut at = DVec2::ZERO;
        let mut residual = target.length();
        for _ in 0..200 {
            let (value, slope) = self.before_tilt(at, radial);
            let step = slope.inverse() * (value - target);
            let mut part = 1.0;
            loop {
                let next = at - part * step;
                let left = (self.before_tilt(next, radial).0 - target).length();
                if left < residual && self.is_monotone_at(next) {
                    (at, residual) = (next, left);
                    break;
                }
                part *= 0.5;
                // NaN, which is never smaller, ends here too.
                if part < 1e-12 {
                    return found(at).then_some(at);
                }
            }
        }
        found(at).then_some(at)
    }

    /// Returns where Newton's method ends, and the derivative before its last step.
    fn newton(&self, radial: &Rational, target: DVec2, start: DVec2) -> (DVec2, DMat2) {
        let mut at = start;
        let mut slope = DMat2::IDENTITY;
        for _ in 0..12 {
            let value;
            (value, slope) = self.before_tilt(at, radial);
            let step = slope.inverse() * (value - target);
            at -= step;
            if !step.is_finite() || step.length() <= 1e-13 * (1.0 + at.length()) {
                break;
            }
        }
        (at, slope)
    }

    fn reaches(&self, radial: &Rational, target: DVec2, at: DVec2) -> bool {
        let (value, _) = self.before_tilt(at, radial);
        agrees(value.x, target.x) && agrees(value.y, target.y)
    }

    /// Whether the model is injective from the axis to this point of the plane z = 1, but for cancelled poles: the radial term
    /// increases all the way, and the map preserves the orientation at the point.
    #[must_use]
    pub fn is_monotone_at(&self, normalized: DVec2) -> bool {
        let radial = self.smooth.as_ref().map_or(&self.radial, |smooth| &smooth.radial);
        let (flat, slope) = self.before_tilt(normalized, radial);
        radial.increases_to(normalized.length_squared())
            && slope.determinant() > 0.0
            && self.tilt().is_none_or(|tilt| (tilt * flat.extend(1.0)).z > 0.0)
    }

    /// Returns the lens without the sensor's tilt, for formats that have no τx and τy.
    #[must_use]
    pub fn without_tilt(&self) -> Self {
        let mut coefficients = self.coefficients;
        coefficients[12..].fill(0.0);
        Self {
            coefficients,
            ..*self
        }
    }

    /// Returns the position of a distorted point on an untilted sensor, or `None` on and beyond the tilted plane's horizon.
    #[must_use]
    pub fn untilt(&self, distorted: DVec2) -> Option<DVec2> {
        let Some(tilt) = self.tilt() else {
            return distorted.is_finite().then_some(distorted);
        };
        let h = tilt.inverse() * distorted.extend(1.0);
        let flat = h.truncate() / h.z;
        (h.z > 0.0 && flat.is_finite()).then_some(flat)
    }

    /// Returns the homography of the tilted sensor, or `None` if there is no tilt.
    fn tilt(&self) -> Option<DMat3> {
        let [.., tau_x, tau_y] = self.coefficients;
        if tau_x == 0.0 && tau_y == 0.0 {
            return None;
        }
        // OpenCV's angles are left-handed.
        let rotation = DMat3::from_rotation_y(-tau_y) * DMat3::from_rotation_x(-tau_x);
        let axis = rotation.row(2).z;
        let project = DMat3::from_cols_array_2d(&[
            [axis, 0.0, 0.0],
            [0.0, axis, 0.0],
            [-rotation.row(0).z, -rotation.row(1).z, 1.0],
        ]);
        Some(project * rotation)
    }

    fn before_tilt(&self, normalized: DVec2, radial: &Rational) -> (DVec2, DMat2) {
        let [_, _, p1, p2, _, _, _, _, s1, s2, s3, s4, ..] = self.coefficients;
        let DVec2 { x, y } = normalized;
        let u = x * x + y * y;
        let (radial, d_radial) = radial.at(u); // the derivative is with respect to u
        let (prism_x, prism_y) = (2.0 * (s1 + 2.0 * s2 * u), 2.0 * (s3 + 2.0 * s4 * u));
        let value = DVec2::new(
            x * radial + 2.0 * p1 * x * y + p2 * (u + 2.0 * x * x) + u * (s1 + s2 * u),
            y * radial + p1 * (u + 2.0 * y * y) + 2.0 * p2 * x * y + u * (s3 + s4 * u),
        );
        let mixed = 2.0 * (x * y * d_radial + p1 * x + p2 * y);
        let jacobian = DMat2::from_cols_array(&[
            radial + 2.0 * x * x * d_radial + 2.0 * p1 * y + 6.0 * p2 * x + prism_x * x,
            mixed + prism_y * x,
            mixed + prism_x * y,
            radial + 2.0 * y * y * d_radial + 6.0 * p1 * y + 2.0 * p2 * x + prism_y * y,
        ]);
        (value, jacobian)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// A radial factor of 1 − 0.05 u, times (1 − u/zero²) / (1 − u/pole²).
    fn with_pole(zero: f64, pole: f64) -> OpenCvPinhole {
        let (a, b) = (-1.0 / (zero * zero), -1.0 / (pole * pole));
        let mut coefficients = [0.0; 14];
        coefficients[..6].copy_from_slice(&[a - 0.05, -0.05 * a, 1e-4, -2e-4, 0.0, b]);
        OpenCvPinhole::new(coefficients)
    }

    #[test]
    fn passes_over_a_cancelled_pole() {
        let lens = with_pole(0.7003, 0.7);
        let poles = lens.cancelled_poles();
        assert!(
            poles.len() == 1 && (poles[0] - 0.7 * (1.0 - 0.05 * 0.49)).abs() < 1e-3,
            "{poles:?}"
        );
        for step in 1..=200 {
            // A ray is off its distorted point only where the model has no other.
            let ray = DVec2::new(0.006, 0.001) * f64::from(step);
            let distorted = lens.distort(ray);
            if (ray.length() - 0.7).abs() > 0.05 {
                let back = lens.undistort(distorted).unwrap();
                assert!(back.distance(ray) < 1e-9, "{ray} {back}");
            }
        }
    }

    #[test]
    fn gives_a_ray_on_the_pole_itself() {
        for (zero, pole) in [(0.7003, 0.7), (0.6997, 0.7)] {
            let lens = with_pole(zero, pole);
            for ray in [DVec2::new(0.7, 0.0), DVec2::new(0.42, 0.56)] {
                let smooth = OpenCvPinhole::from_slice(&[-0.05, 0.0, 1e-4, -2e-4]).unwrap();
                let back = lens.undistort(smooth.distort(ray)).unwrap();
                assert!(back.distance(ray) < 0.1, "{back}");
            }
        }
    }

    #[test]
    fn a_pole_that_nothing_cancels_ends_the_image() {
        let lens = with_pole(0.9, 0.7);
        assert!(lens.cancelled_poles().is_empty());
        assert!(lens.is_monotone_at(DVec2::new(0.69, 0.0)) && !lens.is_monotone_at(DVec2::new(0.71, 0.0)));
    }

    #[test]
    fn accepts_up_to_14_coefficients() {
        for length in 0..=14 {
            let lens = OpenCvPinhole::from_slice(&vec![0.25; length]).unwrap();
            assert_eq!(lens.coefficients().iter().filter(|&&k| k == 0.25).count(), length);
        }
        let error = OpenCvPinhole::from_slice(&[0.0; 15]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "OpenCV's pinhole distortion: 15 coefficients, the model has at most 14; drop the surplus"
        );
        let error = OpenCvPinhole::from_slice(&[0.0, f64::NAN]).unwrap_err();
        assert!(error.to_string().contains("coefficient 1 is NaN"), "{error}");
    }

    #[test]
    fn has_no_inverse_beyond_the_fold() {
        // The maximum of x (1 − 0.3 x²) is 0.7027 at x = 1.0541.
        let lens = OpenCvPinhole::from_slice(&[-0.3]).unwrap();
        let fold = (1.0f64 / 0.9).sqrt();
        let max = lens.distort(DVec2::new(fold, 0.0)).x;
        let near = lens.undistort(DVec2::new(max - 1e-6, 0.0)).unwrap();
        assert!(near.x < fold && near.x > fold - 2e-3);
        assert_eq!(lens.undistort(DVec2::new(max + 1e-6, 0.0)), None);
        assert_eq!(lens.undistort(DVec2::new(50.0, 0.0)), None);
        assert!(!lens.is_monotone_at(DVec2::new(fold + 1e-9, 0.0)));
        assert_eq!(lens.undistort(DVec2::NAN), None);
        assert_eq!(lens.undistort(DVec2::splat(f64::INFINITY)), None);
    }

    #[test]
    fn undistorts_beyond_a_pole_of_newtons_method() {
        // The denominator is 0 at r² = 0.5. Strong pincushion distortion moves the start, the distorted point, beyond it.
        let lens = OpenCvPinhole::from_slice(&[0.0, 0.0, 0.0, 0.0, 0.0, -2.0]).unwrap();
        let point = DVec2::new(0.6, 0.3);
        let distorted = lens.distort(point);
        assert!(distorted.length_squared() > 0.5);
        assert!((lens.undistort(distorted).unwrap() - point).length() < 1e-12);
    }

    /// Coefficients like a factory calibration's: the numerator is the denominator times a small radial term, so that
    /// both are large and nearly cancel.
    fn factory() -> impl Strategy<Value = OpenCvPinhole> {
        (
            -12.0..26.0f64,
            0.0..1.0f64,
            prop::array::uniform3(-0.15..0.15f64),
            prop::array::uniform2(-2e-3..2e-3f64),
            prop::array::uniform4(-2e-3..2e-3f64),
            prop::array::uniform2(-0.03..0.03f64),
        )
            .prop_map(|(k4, shape, gentle, p, s, tau)| {
                // If k5 is above k4²/4, the denominator has no root for positive r².
                let k5 = if k4 < 0.0 {
                    k4 * k4 * (0.3 + shape)
                } else {
                    40.0 * shape
                };
                let k6 = 60.0 * shape;
                let (g1, g2) = (gentle[0], 0.3 * gentle[1]);
                let coefficients = [
                    k4 + g1,
                    k5 + k4 * g1 + g2,
                    p[0],
                    p[1],
                    k6 + k5 * g1 + k4 * g2,
                    k4,
                    k5,
                    k6,
                    s[0],
                    s[1],
                    s[2],
                    s[3],
                    tau[0],
                    tau[1],
                ];
                OpenCvPinhole::new(coefficients)
            })
    }

    proptest! {
        #[test]
        fn undistort_inverts_distort(lens in factory(), x in -0.9..0.9f64, y in -0.6..0.6f64) {
            let point = DVec2::new(x, y);
            prop_assume!(lens.is_monotone_at(point));
            let (distorted, jacobian) = lens.distort_with_jacobian(point);
            prop_assume!(jacobian.determinant() > 0.05);
            let back = lens.undistort(distorted);
            prop_assert!(back.is_some_and(|back| (back - point).length() < 1e-11), "{back:?} for {point}");
        }

        #[test]
        fn undistort_returns_only_inverses(lens in factory(), x in -30.0..30.0f64, y in -30.0..30.0f64) {
            let distorted = DVec2::new(x, y);
            if let Some(point) = lens.undistort(distorted) {
                prop_assert!((lens.distort(point) - distorted).length() < 1e-9 * (1.0 + distorted.length()));
                prop_assert!(lens.is_monotone_at(point));
            }
        }

        #[test]
        fn jacobian_is_the_derivative(lens in factory(), x in -0.7..0.7f64, y in -0.5..0.5f64) {
            let point = DVec2::new(x, y);
            let (_, jacobian) = lens.distort_with_jacobian(point);
            let h = 1e-5;
            for (axis, column) in [(DVec2::X, jacobian.x_axis), (DVec2::Y, jacobian.y_axis)] {
                let difference = (lens.distort(point + h * axis) - lens.distort(point - h * axis)) / (2.0 * h);
                prop_assert!((difference - column).length() < 1e-6 * (1.0 + column.length()), "{difference} {column}");
            }
        }

        #[test]
        fn untilt_inverts_the_tilt(lens in factory(), x in -0.7..0.7f64, y in -0.5..0.5f64) {
            let point = DVec2::new(x, y);
            let untilted = lens.untilt(lens.distort(point)).unwrap();
            prop_assert!((untilted - lens.without_tilt().distort(point)).length() < 1e-13);
        }
    }
}
