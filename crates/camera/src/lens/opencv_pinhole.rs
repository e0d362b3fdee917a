use glam::{DMat2, DMat3, DVec2};

use super::monotone::{agrees, positive_on};
use super::{LensError, padded};

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
/// Factory calibrations of OAK cameras have k1, k2, k4 and k5 of up to a few hundred that nearly cancel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OpenCvPinhole {
    /// k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 τx τy, in OpenCV's order.
    pub coefficients: [f64; 14],
}

impl OpenCvPinhole {
    /// Creates a lens from OpenCV's 4, 5, 8, 12 or 14 coefficients, or any number up to 14, as in `DepthAI`; missing ones are
    /// 0.
    ///
    /// # Errors
    /// Returns an error if there are more than 14 coefficients or one is not finite.
    pub fn from_slice(coefficients: &[f64]) -> Result<Self, LensError> {
        Ok(Self {
            coefficients: padded("OpenCV's pinhole distortion", coefficients)?,
        })
    }

    /// Returns the distorted point of a point on the plane z = 1.
    #[must_use]
    pub fn distort(&self, normalized: DVec2) -> DVec2 {
        self.distort_with_jacobian(normalized).0
    }

    /// Returns the distorted point and its derivative, `[[∂x″/∂x, ∂x″/∂y], [∂y″/∂x, ∂y″/∂y]]`.
    #[must_use]
    pub fn distort_with_jacobian(&self, normalized: DVec2) -> (DVec2, DMat2) {
        let (flat, d_flat) = self.before_tilt(normalized);
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
    /// model's rounding error (the distorted point is reached within 1e-12).
    #[must_use]
    pub fn undistort(&self, distorted: DVec2) -> Option<DVec2> {
        let target = self.untilt(distorted)?;
        let found = |at: DVec2| {
            let (value, _) = self.before_tilt(at);
            agrees(value.x, target.x) && agrees(value.y, target.y) && self.is_monotone_at(at)
        };

        // Newton's method from the distorted point takes three to six steps for moderate distortion.
        let mut at = target;
        for _ in 0..12 {
            let (value, slope) = self.before_tilt(at);
            let step = slope.inverse() * (value - target);
            at -= step;
            if !step.is_finite() || step.length() <= 1e-13 * (1.0 + at.length()) {
                break;
            }
        }
        if found(at) {
            return Some(at);
        }

        // It crossed a fold, or there is no solution: retry from the centre without leaving the valid region.
        let mut at = DVec2::ZERO;
        let mut residual = target.length();
        for _ in 0..200 {
            let (value, slope) = self.before_tilt(at);
            let step = slope.inverse() * (value - target);
            let mut part = 1.0;
            loop {
                let next = at - part * step;
                let left = (self.before_tilt(next).0 - target).length();
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

    /// Whether the model is injective from the axis to this point of the plane z = 1: the radial term increases all the way,
    /// and the map preserves the orientation at the point.
    #[must_use]
    pub fn is_monotone_at(&self, normalized: DVec2) -> bool {
        let [n, d] = self.rational();
        let end = normalized.length_squared();
        // d(r g)/dr = Σ nᵢ dⱼ (1 + 2i − 2j) u^(i+j) / D²
        let mut slope = [0.0; 7];
        for (i, ni) in (0u8..).zip(n) {
            for (j, dj) in (0u8..).zip(d) {
                slope[usize::from(i + j)] += ni * dj * (1.0 + 2.0 * (f64::from(i) - f64::from(j)));
            }
        }
        positive_on(&d, end)
            && positive_on(&slope, end)
            && self.before_tilt(normalized).1.determinant() > 0.0
            && self
                .tilt()
                .is_none_or(|tilt| (tilt * self.before_tilt(normalized).0.extend(1.0)).z > 0.0)
    }

    /// Returns the lens without the sensor's tilt, for formats that have no τx and τy.
    #[must_use]
    pub fn without_tilt(&self) -> Self {
        let mut coefficients = self.coefficients;
        coefficients[12..].fill(0.0);
        Self { coefficients }
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

    /// Returns the coefficients of the radial factor's numerator and denominator, in ascending powers of r².
    fn rational(&self) -> [[f64; 4]; 2] {
        let [k1, k2, _, _, k3, k4, k5, k6, ..] = self.coefficients;
        [[1.0, k1, k2, k3], [1.0, k4, k5, k6]]
    }

    fn before_tilt(&self, normalized: DVec2) -> (DVec2, DMat2) {
        let [_, _, p1, p2, _, _, _, _, s1, s2, s3, s4, ..] = self.coefficients;
        let DVec2 { x, y } = normalized;
        let u = x * x + y * y;
        let [(n, dn), (d, dd)] = self.rational().map(|[c0, c1, c2, c3]| {
            (
                c0 + u * (c1 + u * (c2 + u * c3)),
                c1 + u * (2.0 * c2 + u * 3.0 * c3),
            )
        });
        let radial = n / d;
        let d_radial = (dn - radial * dd) / d; // with respect to u
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

    #[test]
    fn accepts_up_to_14_coefficients() {
        for length in 0..=14 {
            let lens = OpenCvPinhole::from_slice(&vec![0.25; length]).unwrap();
            assert_eq!(lens.coefficients.iter().filter(|&&k| k == 0.25).count(), length);
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
                OpenCvPinhole { coefficients }
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
