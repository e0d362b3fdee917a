use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::monotone::{inverse, positive_on};
use super::{LensError, padded, polar, ray_at};

/// OpenCV's fisheye model: `θd = θ (1 + k1 θ² + k2 θ⁴ + k3 θ⁶ + k4 θ⁸)` for a ray at the angle θ from the optical
/// axis; θd is the distorted radius. With all coefficients 0, it is the ideal equidistant lens.
///
/// Angles up to π are supported, so that lenses of more than 180° are covered. OpenCV's functions, which use the plane z = 1,
/// end at 90° from the axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OpenCvFisheye {
    /// k1 to k4.
    pub k: [f64; 4],
}

impl OpenCvFisheye {
    /// Creates a lens from up to 4 coefficients; missing ones are 0.
    ///
    /// # Errors
    /// Returns an error if there are more than 4 coefficients or one is not finite.
    pub fn from_slice(k: &[f64]) -> Result<Self, LensError> {
        Ok(Self {
            k: padded("OpenCV's fisheye distortion", k)?,
        })
    }

    /// Returns the distorted radius θd of an angle, and its derivative.
    #[must_use]
    pub fn radius_with_slope(&self, angle: f64) -> (f64, f64) {
        let [k1, k2, k3, k4] = self.k;
        let u = angle * angle;
        (
            angle * (1.0 + u * (k1 + u * (k2 + u * (k3 + u * k4)))),
            1.0 + u * (3.0 * k1 + u * (5.0 * k2 + u * (7.0 * k3 + u * 9.0 * k4))),
        )
    }

    /// Returns the angle of a distorted radius, or `None` if the model does not reach it before its fold or π.
    #[must_use]
    pub fn angle(&self, radius: f64) -> Option<f64> {
        inverse(
            |angle| self.radius_with_slope(angle),
            |angle| self.is_monotone_at(angle),
            radius,
            radius,
            PI,
        )
    }

    /// Whether the radius increases with the angle from 0 to this one.
    #[must_use]
    pub fn is_monotone_at(&self, angle: f64) -> bool {
        let [k1, k2, k3, k4] = self.k;
        angle <= PI && positive_on(&[1.0, 3.0 * k1, 5.0 * k2, 7.0 * k3, 9.0 * k4], angle * angle)
    }

    /// Returns the distorted point of a point on the plane z = 1.
    #[must_use]
    pub fn distort(&self, normalized: DVec2) -> DVec2 {
        let (radius, _) = self.radius_with_slope(normalized.length().atan());
        normalized.normalize_or_zero() * radius
    }

    /// Returns the distorted point of a point in the camera's frame, or `None` beyond the fold and at the optical centre.
    #[must_use]
    pub fn project_ray(&self, point_in_camera: DVec3) -> Option<DVec2> {
        let (angle, across) = polar(point_in_camera)?;
        self.is_monotone_at(angle)
            .then(|| across * self.radius_with_slope(angle).0)
    }

    /// Returns the unit ray of a distorted point.
    #[must_use]
    pub fn unproject(&self, distorted: DVec2) -> Option<DVec3> {
        Some(ray_at(self.angle(distorted.length())?, distorted))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn equidistant_lenses_see_backward() {
        let lens = OpenCvFisheye::default();
        let angle = 110f64.to_radians();
        let point = DVec3::new(0.0, angle.sin(), angle.cos());
        let distorted = lens.project_ray(point).unwrap();
        assert!((distorted - DVec2::new(0.0, angle)).length() < 1e-15);
        assert!((lens.unproject(distorted).unwrap() - point).length() < 1e-15);
        assert_eq!(lens.unproject(DVec2::new(3.2, 0.0)), None);
        assert_eq!(lens.project_ray(DVec3::ZERO), None);
        assert_eq!(lens.unproject(DVec2::ZERO), Some(DVec3::Z));
    }

    #[test]
    fn has_no_inverse_beyond_the_fold() {
        // The maximum of θ − 0.1 θ³ is at θ² = 1/0.3.
        let lens = OpenCvFisheye::from_slice(&[-0.1]).unwrap();
        let fold = (1.0f64 / 0.3).sqrt();
        let (max, _) = lens.radius_with_slope(fold);
        assert!(lens.angle(max - 1e-6).unwrap() < fold);
        assert_eq!(lens.angle(max + 1e-6), None);
        assert_eq!(
            lens.project_ray(DVec3::new((fold + 1e-6).sin(), 0.0, (fold + 1e-6).cos())),
            None
        );
        assert!(OpenCvFisheye::from_slice(&[0.0; 5]).is_err());
    }

    proptest! {
        #[test]
        fn round_trip(k in prop::array::uniform4(-0.05..0.05f64), angle in 0.0..2.5f64, turn in -3.1..3.1f64) {
            let lens = OpenCvFisheye { k };
            prop_assume!(lens.is_monotone_at(angle) && lens.radius_with_slope(angle).1 > 0.01);
            let ray = ray_at(angle, DVec2::from_angle(turn));
            let back = lens.unproject(lens.project_ray(ray).unwrap()).unwrap();
            prop_assert!((back - ray).length() < 1e-11, "{back} {ray}");
            if angle < 1.5 {
                let distorted = lens.distort(ray.truncate() / ray.z);
                prop_assert!((distorted - lens.project_ray(ray).unwrap()).length() < 1e-12);
            }
        }
    }
}
