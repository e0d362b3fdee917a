use std::f64::consts::PI;

use glam::{DVec2, DVec3};

use super::monotone::{inverse, positive_on};
use super::{LensError, padded, polar, ray_at};
use crate::{ImageSize, Intrinsics, PixelPoint, Usd};

/// NVIDIA's f-theta lens, the attributes of `OmniLensDistortionFthetaAPI`: the angle from the optical axis is a
/// polynomial of the distance from the optical centre in pixels of the nominal image,
/// `θ = k0 + k1 r + k2 r² + k3 r³ + k4 r⁴`, in radians.
///
/// # Conventions
/// The schema documents no formula. `NVIDIA`'s DRIVE interface (`dwFThetaCameraConfig`) has such polynomials both from pixel
/// to angle and from angle to pixel. The schema's fallback values decide: k1 = 0.00245 for a nominal image of 1936 × 1216 is a
/// lens of 408 px/rad if the unit is rad/px, and impossible if it is px/rad. The optical centre is assumed to be in the
/// [`Usd`] pixel convention of Isaac Sim's renderer; the schema does not define it.
///
/// # Distorted points
/// The distorted point is `k1 · offset from the optical centre`, so that the lens's [`intrinsics`](Self::intrinsics),
/// `f = 1 / k1` about its optical centre, convert it to a pixel as for every [`LensModel`](crate::LensModel).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FTheta {
    pub(super) k: [f64; 5],
    /// `nominalWidth` × `nominalHeight`, the image in which radii are measured.
    pub nominal_size: ImageSize,
    /// `opticalCenter`, in pixels of the nominal image.
    pub optical_centre: PixelPoint<Usd>,
    /// The full field of view, rad (`maxFov` is in degrees). Rays at more than half of it from the axis are not visible.
    pub max_fov: f64,
}

impl FTheta {
    /// Creates a lens from k0 to k4 and the other attributes of the schema.
    ///
    /// # Errors
    /// Returns an error if there are more than 5 coefficients, one is not finite, or k1 is not positive.
    pub fn new(
        k: &[f64],
        nominal_size: ImageSize,
        optical_centre: PixelPoint<Usd>,
        max_fov: f64,
    ) -> Result<Self, LensError> {
        let k = padded("f-theta", k)?;
        if k[1] <= 0.0 {
            return Err(LensError::NoAngle { k1: k[1] });
        }
        Ok(Self {
            k,
            nominal_size,
            optical_centre,
            max_fov,
        })
    }

    /// Returns k0 to k4.
    #[must_use]
    pub const fn coefficients(&self) -> [f64; 5] {
        self.k
    }

    /// Returns the lens's intrinsics for an image of `size` with the same view as the nominal image.
    #[must_use]
    pub fn intrinsics(&self, size: ImageSize) -> Intrinsics {
        let sx = f64::from(size.width) / f64::from(self.nominal_size.width);
        let sy = f64::from(size.height) / f64::from(self.nominal_size.height);
        let centre = PixelPoint::<Usd>::new(self.optical_centre.x * sx, self.optical_centre.y * sy);
        Intrinsics::new(size, sx / self.k[1], sy / self.k[1], centre)
    }

    /// Returns the angle at a radius in pixels of the nominal image, and its derivative.
    #[must_use]
    pub fn angle_with_slope(&self, radius_px: f64) -> (f64, f64) {
        let ([k0, k1, k2, k3, k4], r) = (self.k, radius_px);
        (
            k0 + r * (k1 + r * (k2 + r * (k3 + r * k4))),
            k1 + r * (2.0 * k2 + r * (3.0 * k3 + r * 4.0 * k4)),
        )
    }

    /// Returns the radius of an angle in pixels of the nominal image, or `None` if the angle is outside the field of view or
    /// the polynomial does not reach it.
    #[must_use]
    pub fn radius_px(&self, angle: f64) -> Option<f64> {
        if angle.is_nan() || angle > self.half_fov() {
            return None;
        }
        let start = (angle - self.k[0]) / self.k[1];
        inverse(
            |radius| self.angle_with_slope(radius),
            |radius| self.is_monotone_at(radius),
            angle,
            start,
            1e9, // px, larger than any image
        )
    }

    /// Whether the angle increases with the radius from 0 to this one.
    #[must_use]
    pub fn is_monotone_at(&self, radius_px: f64) -> bool {
        let [_, k1, k2, k3, k4] = self.k;
        positive_on(&[k1, 2.0 * k2, 3.0 * k3, 4.0 * k4], radius_px)
    }

    /// Returns the distorted point of a point in the camera's frame, or `None` outside the field of view.
    #[must_use]
    pub fn project_ray(&self, point_in_camera: DVec3) -> Option<DVec2> {
        let (angle, across) = polar(point_in_camera)?;
        Some(across * (self.radius_px(angle)? * self.k[1]))
    }

    /// Returns the unit ray of a distorted point, or `None` outside the field of view and beyond the fold.
    #[must_use]
    pub fn unproject(&self, distorted: DVec2) -> Option<DVec3> {
        let radius_px = distorted.length() / self.k[1];
        let (angle, _) = self.angle_with_slope(radius_px);
        let seen = (0.0..=self.half_fov()).contains(&angle) && self.is_monotone_at(radius_px);
        seen.then(|| ray_at(angle, distorted))
    }

    fn half_fov(&self) -> f64 {
        (self.max_fov / 2.0).min(PI)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Camera;
    use proptest::prelude::*;

    fn lens(k: &[f64]) -> FTheta {
        let centre = PixelPoint::new(970.942_44, 600.374_8);
        FTheta::new(k, ImageSize::new(1936, 1216), centre, 200f64.to_radians()).unwrap()
    }

    #[test]
    fn fallback_values_are_an_equidistant_lens() {
        let lens = lens(&[0.0, 0.00245]);
        let camera = Camera::from_ftheta(lens, lens.nominal_size);
        let angle = 80f64.to_radians();
        let pixel = camera.project(DVec3::new(angle.sin(), 0.0, angle.cos())).unwrap();
        let offset = pixel.to::<Usd>().xy() - lens.optical_centre.xy();
        assert!((offset - DVec2::new(angle / 0.00245, 0.0)).length() < 1e-9);
        // Half the field of view is 100°.
        let at = |deg: f64| DVec3::new(deg.to_radians().sin(), 0.0, deg.to_radians().cos());
        assert!(camera.project(at(99.9)).is_some());
        assert!(camera.project(at(100.1)).is_none());
        // In an image of half the size, the same ray is at the same relative position.
        let half = Camera::from_ftheta(lens, ImageSize::new(968, 608));
        let p = half.project(at(40.0)).unwrap().to::<Usd>();
        let q = camera.project(at(40.0)).unwrap().to::<Usd>();
        assert!((p.xy() * 2.0 - q.xy()).length() < 1e-9);
    }

    #[test]
    fn rejects_invalid_coefficients_and_folds() {
        let of = |k: &[f64]| FTheta::new(k, ImageSize::new(10, 10), PixelPoint::new(5.0, 5.0), 1.0);
        assert_eq!(of(&[1.0]), Err(LensError::NoAngle { k1: 0.0 }));
        assert!(of(&[0.0, f64::NAN]).is_err());
        // Folds at r = 500 with an angle of 0.25 rad.
        let lens = lens(&[0.0, 1e-3, -1e-6]);
        assert!(lens.radius_px(0.2499).unwrap() < 500.0);
        assert_eq!(lens.radius_px(0.2501), None);
        assert_eq!(lens.unproject(DVec2::new(0.501, 0.0)), None);
    }

    proptest! {
        #[test]
        fn round_trip(k2 in -4e-7..4e-7f64, k3 in -4e-10..4e-10f64, k4 in -2e-13..2e-13f64, angle in 0.0..1.74f64) {
            let lens = lens(&[0.0, 0.00245, k2, k3, k4]);
            let ray = ray_at(angle, DVec2::from_angle(0.7));
            let Some(distorted) = lens.project_ray(ray) else {
                return Ok(());
            };
            let back = lens.unproject(distorted).unwrap();
            prop_assert!((back - ray).length() < 1e-11);
        }
    }
}
