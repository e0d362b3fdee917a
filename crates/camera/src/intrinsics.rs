use glam::{DMat3, DVec2};

use crate::{ImageSize, OpenCv, PixelConvention, PixelPoint, Usd};

/// The intrinsic parameters of a camera: focal lengths and principal point in pixels of an image of `size`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intrinsics {
    /// The size of the image.
    pub size: ImageSize,
    /// Horizontal focal length, px.
    pub fx: f64,
    /// Vertical focal length, px.
    pub fy: f64,
    principal_point: PixelPoint<OpenCv>,
}

impl Intrinsics {
    /// Creates intrinsics from focal lengths in pixels and the principal point in either convention.
    #[must_use]
    pub fn new<C: PixelConvention>(
        size: ImageSize,
        fx: f64,
        fy: f64,
        principal_point: PixelPoint<C>,
    ) -> Self {
        Self {
            size,
            fx,
            fy,
            principal_point: principal_point.to(),
        }
    }

    /// Creates the intrinsics of an ideal camera from its horizontal field of view: square pixels, centred,
    /// `fx = width / (2 tan(hfov / 2))`.
    #[must_use]
    pub fn from_hfov(size: ImageSize, hfov: f64) -> Self {
        let fx = f64::from(size.width) / (2.0 * (hfov / 2.0).tan());
        let centre = PixelPoint::<Usd>::new(f64::from(size.width) / 2.0, f64::from(size.height) / 2.0);
        Self::new(size, fx, fx, centre)
    }

    /// Creates intrinsics from the rows of OpenCV's camera matrix, `[[fx, 0, cx], [0, fy, cy], [0, 0, 1]]`.
    #[must_use]
    pub fn from_opencv_matrix(size: ImageSize, k: [[f64; 3]; 3]) -> Self {
        Self::new(
            size,
            k[0][0],
            k[1][1],
            PixelPoint::<OpenCv>::new(k[0][2], k[1][2]),
        )
    }

    /// Returns the rows of OpenCV's camera matrix.
    #[must_use]
    pub fn opencv_matrix(&self) -> [[f64; 3]; 3] {
        let c = self.principal_point;
        [[self.fx, 0.0, c.x], [0.0, self.fy, c.y], [0.0, 0.0, 1.0]]
    }

    /// Returns OpenCV's camera matrix: pixel = K · (x/z, y/z, 1).
    #[must_use]
    pub fn matrix(&self) -> DMat3 {
        DMat3::from_cols_array_2d(&self.opencv_matrix()).transpose()
    }

    /// Returns the principal point in the convention `C`.
    #[must_use]
    pub fn principal_point<C: PixelConvention>(&self) -> PixelPoint<C> {
        self.principal_point.to()
    }

    /// Returns the mean focal length `(fx + fy) / 2`, px.
    #[must_use]
    pub fn mean_focal_length(&self) -> f64 {
        f64::midpoint(self.fx, self.fy)
    }

    /// Whether the directions of all pixels, (x, y, 1), have finite lengths in single precision.
    #[must_use]
    pub fn has_finite_rays(&self) -> bool {
        let c = self.principal_point::<Usd>();
        let reach =
            |end: u32, centre: f64, focal: f64| centre.abs().max((f64::from(end) - centre).abs()) / focal;
        let (x, y) = (
            reach(self.size.width, c.x, self.fx),
            reach(self.size.height, c.y, self.fy),
        );
        x * x + y * y < f64::from(f32::MAX)
    }

    /// Returns the horizontal field of view of the ideal pinhole, `2 atan(width / (2 fx))`; the principal point is ignored.
    #[must_use]
    pub fn hfov(&self) -> f64 {
        fov(f64::from(self.size.width) / self.fx)
    }

    /// Returns the vertical field of view, `2 atan(height / (2 fy))`.
    #[must_use]
    pub fn vfov(&self) -> f64 {
        fov(f64::from(self.size.height) / self.fy)
    }

    /// Returns the diagonal field of view, from corner to corner through the centre.
    #[must_use]
    pub fn dfov(&self) -> f64 {
        fov((f64::from(self.size.width) / self.fx).hypot(f64::from(self.size.height) / self.fy))
    }

    /// Returns the pixel of a point on the plane z = 1.
    #[must_use]
    pub fn pixel_from_normalized(&self, normalized: DVec2) -> PixelPoint<OpenCv> {
        let c = self.principal_point;
        PixelPoint::new(self.fx * normalized.x + c.x, self.fy * normalized.y + c.y)
    }

    /// Returns the point on the plane z = 1 of a pixel of an ideal pinhole.
    #[must_use]
    #[inline]
    pub fn normalized_from_pixel<C: PixelConvention>(&self, pixel: PixelPoint<C>) -> DVec2 {
        let p = pixel.to::<OpenCv>();
        let c = self.principal_point;
        DVec2::new((p.x - c.x) / self.fx, (p.y - c.y) / self.fy)
    }
}

fn fov(extent_over_focal: f64) -> f64 {
    2.0 * (extent_over_focal / 2.0).atan()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn hfov_round_trips(hfov_deg in 1.0..179.0f64, width in 1u32..10_000, height in 1u32..10_000) {
            let camera = Intrinsics::from_hfov(ImageSize::new(width, height), hfov_deg.to_radians());
            prop_assert!((camera.hfov().to_degrees() - hfov_deg).abs() < 1e-9);
            prop_assert!(camera.dfov() >= camera.hfov().max(camera.vfov()));
        }
    }

    #[test]
    fn matrices_are_row_major() {
        let k = [[800.0, 0.0, 640.0], [0.0, 801.0, 400.0], [0.0, 0.0, 1.0]];
        let camera = Intrinsics::from_opencv_matrix(ImageSize::new(1280, 800), k);
        assert_eq!(camera.opencv_matrix(), k);
        assert_eq!(camera.principal_point::<Usd>(), PixelPoint::new(640.5, 400.5));
        let p = camera.matrix() * glam::DVec3::new(0.5, -0.25, 1.0);
        assert_eq!(
            camera.pixel_from_normalized(DVec2::new(0.5, -0.25)),
            PixelPoint::new(p.x, p.y)
        );
    }

    #[test]
    fn rays_overflow_for_short_focal_lengths_only() {
        let size = ImageSize::new(24, 16);
        let centre = PixelPoint::<Usd>::new(12.0, 8.0);
        let is_finite = |fx, fy, centre| Intrinsics::new(size, fx, fy, centre).has_finite_rays();
        assert!(is_finite(20.0, 20.0, centre));
        assert!(is_finite(1e-17, 1e30, centre));
        assert!(!is_finite(1e-19, 20.0, centre));
        assert!(!is_finite(20.0, 1e-300, centre));
        assert!(!is_finite(20.0, 20.0, PixelPoint::<Usd>::new(1e300, 8.0)));
    }
}
