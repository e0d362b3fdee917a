use oaktwin_base::parameter::choice;

use crate::{ImageSize, Intrinsics, OpenCv, PixelPoint, Usd};

choice! {
    /// The conversion of a principal point to the aperture offsets of a USD camera.
    ///
    /// With OpenUSD's sign, the offset moves the window, so `h = −(cx − W/2)·p` and `v = +(cy − H/2)·p`, with cx and cy in the
    /// [`Usd`] convention; `GfCamera` projects with these. The formula of Luxonis' parameter sheet is `h = +(cx − W/2)·p` and
    /// `v = +(cy − H/2)·p`, with cx and cy in the [`OpenCv`] convention of calibration files.
    ApertureOffsets {
        /// OpenUSD's sign convention.
        OpenUsd = "openusd" | "usd",
        /// The parameter sheet's formula.
        Document = "document",
        /// No offsets.
        Zero = "zero",
    }
}

/// The optical attributes of a `UsdGeomCamera` in millimetres, as in camera vendors' assets for Isaac Sim. The projection
/// depends on their ratios only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UsdOptics {
    /// `focalLength`.
    pub focal_length_mm: f64,
    /// `horizontalAperture`.
    pub horizontal_aperture_mm: f64,
    /// `verticalAperture`.
    pub vertical_aperture_mm: f64,
    /// `horizontalApertureOffset`.
    pub horizontal_aperture_offset_mm: f64,
    /// `verticalApertureOffset`.
    pub vertical_aperture_offset_mm: f64,
}

impl UsdOptics {
    /// Converts intrinsics and a pixel size: `focalLength = p (fx + fy)/2`, `aperture = p · size`.
    #[must_use]
    pub fn from_intrinsics(intrinsics: &Intrinsics, pixel_size_um: f64, offsets: ApertureOffsets) -> Self {
        let mm_per_px = |px: f64| pixel_size_um * px * 1e-3;
        let (width, height) = (
            f64::from(intrinsics.size.width),
            f64::from(intrinsics.size.height),
        );
        let (h, v) = match offsets {
            ApertureOffsets::OpenUsd => {
                let c = intrinsics.principal_point::<Usd>();
                (width / 2.0 - c.x, c.y - height / 2.0)
            }
            ApertureOffsets::Document => {
                let c = intrinsics.principal_point::<OpenCv>();
                (c.x - width / 2.0, c.y - height / 2.0)
            }
            ApertureOffsets::Zero => (0.0, 0.0),
        };
        Self {
            focal_length_mm: mm_per_px(intrinsics.mean_focal_length()),
            horizontal_aperture_mm: mm_per_px(width),
            vertical_aperture_mm: mm_per_px(height),
            horizontal_aperture_offset_mm: mm_per_px(h),
            vertical_aperture_offset_mm: mm_per_px(v),
        }
    }

    /// Returns the intrinsics by OpenUSD's definition for an image of `size`: each axis is scaled by its own aperture, and
    /// the offsets move the principal point.
    #[must_use]
    pub fn openusd_intrinsics(&self, size: ImageSize) -> Intrinsics {
        let (width, height) = (f64::from(size.width), f64::from(size.height));
        let px_per_mm_x = width / self.horizontal_aperture_mm;
        let px_per_mm_y = height / self.vertical_aperture_mm;
        Intrinsics::new(
            size,
            self.focal_length_mm * px_per_mm_x,
            self.focal_length_mm * px_per_mm_y,
            PixelPoint::<Usd>::new(
                width / 2.0 - self.horizontal_aperture_offset_mm * px_per_mm_x,
                height / 2.0 + self.vertical_aperture_offset_mm * px_per_mm_y,
            ),
        )
    }

    /// Returns the intrinsics of Isaac Sim's renderer: `fx = fy = W·f/aperture`, centred. It ignores the vertical aperture
    /// and the offsets (RTX up to Isaac Sim 6.0).
    #[must_use]
    pub fn isaac_intrinsics(&self, size: ImageSize) -> Intrinsics {
        let fx = f64::from(size.width) * self.focal_length_mm / self.horizontal_aperture_mm;
        let centre = PixelPoint::<Usd>::new(f64::from(size.width) / 2.0, f64::from(size.height) / 2.0);
        Intrinsics::new(size, fx, fx, centre)
    }

    /// Returns the horizontal field of view, `2 atan(aperture / (2 f))`.
    #[must_use]
    pub fn hfov(&self) -> f64 {
        2.0 * (self.horizontal_aperture_mm / (2.0 * self.focal_length_mm)).atan()
    }
}

/// Converts millimetres to tenths of a stage unit, in which OpenUSD defines `focalLength`, the apertures and their offsets.
///
/// Vendors' assets for Isaac Sim use millimetres instead. That matters only where the numbers are combined with others, as
/// for depth of field.
#[must_use]
pub fn tenths_of_stage_unit(mm: f64, meters_per_unit: f64) -> f64 {
    mm * 1e-3 / meters_per_unit * 10.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn openusd_offsets_preserve_the_principal_point(
            f in 200.0..3000.0f64, cx in 500.0..780.0f64, cy in 300.0..500.0f64, pixel_size_um in 0.5..10.0f64,
        ) {
            let size = ImageSize::new(1280, 800);
            let camera = Intrinsics::new(size, f, f, PixelPoint::<OpenCv>::new(cx, cy));
            let optics = UsdOptics::from_intrinsics(&camera, pixel_size_um, ApertureOffsets::OpenUsd);
            let back = optics.openusd_intrinsics(size);
            prop_assert!((back.fx - f).abs() < 1e-9 && (back.fy - f).abs() < 1e-9);
            let (a, b) = (back.principal_point::<Usd>(), camera.principal_point::<Usd>());
            prop_assert!((a.x - b.x).abs() < 1e-9 && (a.y - b.y).abs() < 1e-9);
        }
    }

    #[test]
    fn document_and_openusd_differ_in_sign_and_half_a_pixel() {
        let camera = Intrinsics::new(
            ImageSize::new(1280, 800),
            800.0,
            800.0,
            PixelPoint::<OpenCv>::new(650.0, 410.0),
        );
        let of = |offsets| {
            let o = UsdOptics::from_intrinsics(&camera, 3.0, offsets);
            (o.horizontal_aperture_offset_mm, o.vertical_aperture_offset_mm)
        };
        let near = |a: (f64, f64), b: (f64, f64)| (a.0 - b.0).abs() < 1e-12 && (a.1 - b.1).abs() < 1e-12;
        assert!(near(of(ApertureOffsets::OpenUsd), (-0.0315, 0.0315)));
        assert!(near(of(ApertureOffsets::Document), (0.030, 0.030)));
        assert!(near(of(ApertureOffsets::Zero), (0.0, 0.0)));
    }

    #[test]
    fn millimetres_in_tenths_of_a_metre() {
        assert!((tenths_of_stage_unit(2.4138, 1.0) - 0.024_138).abs() < 1e-12);
        assert!((tenths_of_stage_unit(2.4138, 0.01) - 2.4138).abs() < 1e-12);
    }
}
