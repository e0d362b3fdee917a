use glam::{DVec2, DVec3};

use crate::{FTheta, ImageSize, Intrinsics, LensModel, OpenCv, PixelConvention, PixelPoint, Usd};

/// Intrinsics and a lens. The camera's frame has OpenCV's axes: x right, y down, z forward.
///
/// ```
/// use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, OpenCvFisheye, Usd, math::DVec3};
///
/// let intrinsics = Intrinsics::from_hfov(ImageSize::new(1280, 800), 77f64.to_radians());
/// let camera = Camera::new(intrinsics, LensModel::Pinhole);
/// let centre = camera.project(DVec3::new(0.0, 0.0, 2.0)).ok_or("behind")?;
/// assert_eq!(centre.to::<Usd>().x, 640.0);
///
/// let fisheye = Camera::new(intrinsics, LensModel::OpenCvFisheye(OpenCvFisheye::default()));
/// let sideways = DVec3::new(1.0, 0.0, 0.0);
/// assert!(camera.project(sideways).is_none());
/// let pixel = fisheye.project(sideways).ok_or("unseen")?;
/// assert!((fisheye.unproject(pixel).ok_or("unseen")? - sideways).length() < 1e-12);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Focal lengths and principal point.
    pub intrinsics: Intrinsics,
    /// The lens.
    pub lens: LensModel,
}

impl Camera {
    /// Creates a camera from its parts.
    #[must_use]
    pub const fn new(intrinsics: Intrinsics, lens: LensModel) -> Self {
        Self { intrinsics, lens }
    }

    /// Returns the horizontal and the vertical field of view through the principal point in radians: of the lens if it has
    /// no pinhole image (fisheye and f-theta), otherwise of the pinhole.
    #[must_use]
    pub fn field_of_view(&self) -> [f64; 2] {
        let own = &self.intrinsics;
        let pinhole = [own.hfov(), own.vfov()];
        if !matches!(self.lens, LensModel::OpenCvFisheye(_) | LensModel::FTheta(_)) {
            return pinhole;
        }
        let centre = own.principal_point::<Usd>();
        let (width, height) = (f64::from(own.size.width), f64::from(own.size.height));
        let angle = |x: f64, y: f64| {
            let ray = self.unproject(PixelPoint::<Usd>::new(x, y))?;
            Some(ray.x.hypot(ray.y).atan2(ray.z))
        };
        let horizontal = angle(0.0, centre.y).zip(angle(width, centre.y));
        let vertical = angle(centre.x, 0.0).zip(angle(centre.x, height));
        let sides = [horizontal, vertical].map(|sides| sides.map(|(first, last)| first + last));
        [sides[0].unwrap_or(pinhole[0]), sides[1].unwrap_or(pinhole[1])]
    }

    /// Creates a camera with an f-theta lens, which determines the intrinsics, for an image of `size`.
    #[must_use]
    pub fn from_ftheta(lens: FTheta, size: ImageSize) -> Self {
        Self::new(lens.intrinsics(size), LensModel::FTheta(lens))
    }

    /// Returns the pixel position of a point, which may be outside the image. `None` behind a pinhole and beyond the fold of
    /// the lens model.
    #[must_use]
    pub fn project(&self, point_in_camera: DVec3) -> Option<PixelPoint<OpenCv>> {
        let distorted = self.lens.project_ray(point_in_camera)?;
        Some(self.intrinsics.pixel_from_normalized(distorted))
    }

    /// Returns the unit ray of a pixel in the camera's frame, or `None` where the lens model has none.
    #[must_use]
    pub fn unproject<C: PixelConvention>(&self, pixel: PixelPoint<C>) -> Option<DVec3> {
        self.lens.unproject(self.intrinsics.normalized_from_pixel(pixel))
    }

    /// Returns the largest error in pixels of ignoring the sensor's tilt τx, τy (see
    /// [`OpenCvPinhole::without_tilt`](crate::OpenCvPinhole::without_tilt)).
    ///
    /// It is evaluated at each pixel of the image's border and on a grid of 64 × 64 inside. 0 without a tilt; infinite if the
    /// tilted plane's horizon crosses the image.
    #[must_use]
    pub fn largest_tilt_error_px(&self) -> f64 {
        let LensModel::OpenCvPinhole(lens) = self.lens else {
            return 0.0;
        };
        let (right, bottom) = (
            f64::from(self.intrinsics.size.width) - 1.0,
            f64::from(self.intrinsics.size.height) - 1.0,
        );
        let error = |x: f64, y: f64| {
            let distorted = self
                .intrinsics
                .normalized_from_pixel(PixelPoint::<OpenCv>::new(x, y));
            let focal = DVec2::new(self.intrinsics.fx, self.intrinsics.fy);
            lens.untilt(distorted).map_or(f64::INFINITY, |untilted| {
                (focal * (distorted - untilted)).length()
            })
        };
        let columns = (0..self.intrinsics.size.width)
            .map(f64::from)
            .flat_map(|x| [(x, 0.0), (x, bottom)]);
        let rows = (0..self.intrinsics.size.height)
            .map(f64::from)
            .flat_map(|y| [(0.0, y), (right, y)]);
        let inside = (0..64u8).flat_map(|i| {
            (0..64u8).map(move |j| (right * f64::from(i) / 63.0, bottom * f64::from(j) / 63.0))
        });
        columns
            .chain(rows)
            .chain(inside)
            .map(|(x, y)| error(x, y))
            .fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{OpenCvFisheye, OpenCvPinhole};
    use proptest::prelude::*;

    fn intrinsics() -> Intrinsics {
        Intrinsics::new(
            ImageSize::new(1280, 800),
            794.0,
            795.0,
            PixelPoint::<OpenCv>::new(645.3, 411.8),
        )
    }

    #[test]
    fn tilt_error_is_the_largest_difference_of_projections() {
        let mut coefficients = [0.0; 14];
        coefficients[0] = -0.05;
        coefficients[12] = -0.0248;
        coefficients[13] = -0.0058;
        let tilted = OpenCvPinhole::new(coefficients);
        let camera = Camera::new(intrinsics(), LensModel::OpenCvPinhole(tilted));
        let flat = Camera::new(intrinsics(), LensModel::OpenCvPinhole(tilted.without_tilt()));
        let mut worst = 0f64;
        for x in 0..=128u32 {
            for y in 0..=80u32 {
                let pixel =
                    PixelPoint::<OpenCv>::new(f64::from((x * 10).min(1279)), f64::from((y * 10).min(799)));
                let ray = camera.unproject(pixel).unwrap();
                worst = worst.max((flat.project(ray).unwrap().xy() - pixel.xy()).length());
            }
        }
        let largest = camera.largest_tilt_error_px();
        assert!(worst > 1.0 && (largest - worst).abs() < 1e-9, "{largest} {worst}");
        assert_eq!(flat.largest_tilt_error_px(), 0.0);
        assert_eq!(
            Camera::new(intrinsics(), LensModel::Pinhole).largest_tilt_error_px(),
            0.0
        );
    }

    proptest! {
        #[test]
        fn project_inverts_unproject(x in -100.0..1400.0f64, y in -100.0..900.0f64) {
            for lens in [
                LensModel::Pinhole,
                LensModel::OpenCvPinhole(OpenCvPinhole::from_slice(&[-0.05, 0.02, 1e-3, -1e-3, 0.01]).unwrap()),
                LensModel::OpenCvFisheye(OpenCvFisheye { k: [-0.023, -0.0012, 0.002, -0.0024] }),
            ] {
                let camera = Camera::new(intrinsics(), lens);
                let pixel = PixelPoint::<OpenCv>::new(x, y);
                let ray = camera.unproject(pixel).unwrap();
                prop_assert!((ray.length() - 1.0).abs() < 1e-14);
                let back = camera.project(ray * 3.0).unwrap();
                prop_assert!((back.xy() - pixel.xy()).length() < 1e-9, "{lens:?}");
            }
        }
    }
}
