//! Intrinsics at another resolution, by the rule of DepthAI's `CalibrationHandler::getCameraIntrinsics`.
//!
//! The library scales cx and cy without a half-pixel shift. So does this module, because twins are compared with the numbers
//! of the device's own software.

use crate::{ImageSize, Intrinsics, OpenCv, PixelPoint};

impl ImageSize {
    /// Returns this size scaled to a width, with a proportional height rounded down: `DepthAI`'s rule for a height of −1.
    /// `None` if this size is empty or the result is too large.
    #[must_use]
    pub fn scaled_to_width(self, width: u32) -> Option<Self> {
        Some(Self::new(width, proportional(self.height, width, self.width)?))
    }

    /// Returns this size scaled to a height, with a proportional width rounded down: `DepthAI`'s rule for a width of −1.
    /// `None` if this size is empty or the result is too large.
    #[must_use]
    pub fn scaled_to_height(self, height: u32) -> Option<Self> {
        Some(Self::new(proportional(self.width, height, self.height)?, height))
    }
}

fn proportional(length: u32, to: u32, from: u32) -> Option<u32> {
    let scaled = (u64::from(length) * u64::from(to)).checked_div(u64::from(from))?;
    u32::try_from(scaled).ok()
}

impl Intrinsics {
    /// Returns the intrinsics at another image size, as `DepthAI` computes them.
    ///
    /// With `keep_aspect_ratio` (`DepthAI`'s default), the image is scaled to cover `size` and cropped equally on both sides.
    /// However, a wide calibration (aspect above 1.5 and up to 1.778) at a requested aspect of 4:3 or narrower (up to 1.34) is
    /// treated as a crop of a taller sensor: the image grows above and below instead. Otherwise each axis is scaled on its own.
    ///
    /// ```
    /// use oaktwin_camera::{ImageSize, Intrinsics, OpenCv, PixelPoint};
    ///
    /// let at_800p = Intrinsics::new(ImageSize::new(1280, 800), 794.0, 794.0, PixelPoint::<OpenCv>::new(645.0, 412.0));
    /// let at_720p = at_800p.resized(ImageSize::new(1280, 720), true);
    /// assert_eq!(at_720p.principal_point::<OpenCv>(), PixelPoint::new(645.0, 372.0));
    /// ```
    #[must_use]
    pub fn resized(&self, size: ImageSize, keep_aspect_ratio: bool) -> Self {
        let (from_w, from_h) = (f64::from(self.size.width), f64::from(self.size.height));
        let (w, h) = (f64::from(size.width), f64::from(size.height));
        let c = self.principal_point::<OpenCv>();
        if !keep_aspect_ratio {
            let (sx, sy) = (w / from_w, h / from_h);
            let centre = PixelPoint::<OpenCv>::new(c.x * sx, c.y * sy);
            return Self::new(size, self.fx * sx, self.fy * sy, centre);
        }
        let grows = w / h <= 1.34 && from_w / from_h <= 1.778 && from_w / from_h > 1.5;
        let scale = if grows {
            (w / from_w).min(h / from_h)
        } else {
            (w / from_w).max(h / from_h)
        };
        // The second term is 0, up to rounding, for the axis that determined the scale.
        let centre = PixelPoint::<OpenCv>::new(
            c.x * scale + (w - from_w * scale) / 2.0,
            c.y * scale + (h - from_h * scale) / 2.0,
        );
        Self::new(size, self.fx * scale, self.fy * scale, centre)
    }

    /// Returns the intrinsics at another image size, like [`resized`](Self::resized), but with a centred principal point
    /// staying in the centre: pixels are areas, so that the first pixel's centre is half a pixel from the border at any size. This is
    /// how images are resized, for example by `cv2.resize`.
    #[must_use]
    pub fn resized_about_centre(&self, size: ImageSize, keep_aspect_ratio: bool) -> Self {
        let resized = self.resized(size, keep_aspect_ratio);
        let shift = |scale: f64| (scale - 1.0) / 2.0;
        let c = resized.principal_point::<OpenCv>();
        let centre = PixelPoint::<OpenCv>::new(
            c.x + shift(resized.fx / self.fx),
            c.y + shift(resized.fy / self.fy),
        );
        Self::new(size, resized.fx, resized.fy, centre)
    }

    /// Returns the intrinsics of a part of the image: `size` pixels from `top_left`, which may be outside the image.
    #[must_use]
    pub fn cropped(&self, top_left: PixelPoint<OpenCv>, size: ImageSize) -> Self {
        let c = self.principal_point::<OpenCv>();
        let centre = PixelPoint::<OpenCv>::new(c.x - top_left.x, c.y - top_left.y);
        Self::new(size, self.fx, self.fy, centre)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(from: Intrinsics, size: [u32; 2], keep: bool, expected: [f64; 4], tolerance: f64) {
        let got = from.resized(ImageSize::new(size[0], size[1]), keep);
        let c = got.principal_point::<OpenCv>();
        for (got, expected) in [got.fx, got.fy, c.x, c.y].into_iter().zip(expected) {
            assert!(
                (got - expected).abs() <= tolerance.max(3e-7 * expected.abs()),
                "{from:?} to {size:?} (keep {keep}): {got} is not {expected}"
            );
        }
    }

    #[test]
    fn a_centred_principal_point_stays_in_the_centre() {
        let centred = Intrinsics::from_hfov(ImageSize::new(1280, 800), 1.2);
        for (width, height, keep) in [
            (640, 400, true),
            (320, 300, true),
            (100, 900, false),
            (640, 480, true),
        ] {
            let size = ImageSize::new(width, height);
            let c = centred
                .resized_about_centre(size, keep)
                .principal_point::<OpenCv>();
            let middle = (f64::from(width - 1) / 2.0, f64::from(height - 1) / 2.0);
            assert!(
                (c.x - middle.0).abs() < 1e-9 && (c.y - middle.1).abs() < 1e-9,
                "{c:?}"
            );
        }
    }

    #[test]
    fn agrees_with_depthai() {
        // depthai 3.12.0 on two cameras of one OAK-D Pro, to three decimals.
        let mono = Intrinsics::from_opencv_matrix(
            ImageSize::new(1280, 800),
            [[793.984, 0.0, 645.297], [0.0, 793.984, 411.839], [0.0, 0.0, 1.0]],
        );
        for (size, f, cx, cy) in [
            ([640, 400], 396.992, 322.648, 205.920),
            ([1280, 720], 793.984, 645.297, 371.839),
            ([640, 480], 396.992, 322.648, 245.920),
            ([300, 300], 186.090, 151.241, 152.775),
            ([1920, 1080], 1190.976, 967.945, 557.759),
        ] {
            check(mono, size, true, [f, f, cx, cy], 1.1e-3);
        }
        let colour = Intrinsics::from_opencv_matrix(
            ImageSize::new(3840, 2160),
            [
                [3100.659, 0.0, 1952.053],
                [0.0, 3100.659, 1100.305],
                [0.0, 0.0, 1.0],
            ],
        );
        for (size, f, cx, cy) in [
            ([4056, 3040], 3275.071, 2061.856, 1541.447),
            ([1920, 1080], 3100.659 / 2.0, 1952.053 / 2.0, 1100.305 / 2.0),
            ([640, 480], 516.777, 325.342, 243.384),
        ] {
            check(colour, size, true, [f, f, cx, cy], 1.1e-3);
        }
    }

    #[test]
    #[ignore = "needs OAKTWIN_TEST_DATA"]
    fn agrees_with_depthai_for_real_exports() {
        let data = std::env::var_os("OAKTWIN_TEST_DATA").expect("OAKTWIN_TEST_DATA names the test data");
        let path = std::path::Path::new(&data).join("data/depthai-golden/calibration_handler.json");
        let golden: serde_json::Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
        let number = |v: &serde_json::Value| v.as_f64().unwrap();
        let pixels = |v: &serde_json::Value| u32::try_from(v.as_u64().unwrap()).unwrap();
        let mut answers = 0;
        for file in golden["files"].as_object().unwrap().values() {
            for camera in file["cams"].as_object().unwrap().values() {
                let k = [0, 1, 2].map(|i| [0, 1, 2].map(|j| number(&camera["K"][i][j])));
                let from = Intrinsics::from_opencv_matrix(
                    ImageSize::new(pixels(&camera["w"]), pixels(&camera["h"])),
                    k,
                );
                for answer in camera["resize"].as_array().unwrap() {
                    let size = [pixels(&answer[0]), pixels(&answer[1])];
                    let expected = [0, 1, 2, 3].map(|i| number(&answer[3][i]));
                    // float32 arithmetic in the library: a few units of its last place at the size of the image.
                    check(from, size, answer[2].as_bool().unwrap(), expected, 5e-4);
                    answers += 1;
                }
            }
        }
        assert!(answers >= 500, "only {answers} answers");
    }

    #[test]
    fn rounds_proportional_sides_down() {
        let size = ImageSize::new(4056, 3040);
        assert_eq!(size.scaled_to_width(640), Some(ImageSize::new(640, 479)));
        assert_eq!(size.scaled_to_height(480), Some(ImageSize::new(640, 480)));
        assert_eq!(ImageSize::new(0, 5).scaled_to_width(3), None);
        assert_eq!(ImageSize::new(1, u32::MAX).scaled_to_width(2), None);
    }

    #[test]
    fn crop_moves_the_principal_point() {
        let camera = Intrinsics::from_hfov(ImageSize::new(1280, 800), 1.3);
        let crop = camera.cropped(PixelPoint::new(100.0, 40.0), ImageSize::new(640, 400));
        assert_eq!(crop.principal_point::<OpenCv>(), PixelPoint::new(539.5, 359.5));
        assert_eq!((crop.fx, crop.size), (camera.fx, ImageSize::new(640, 400)));
    }
}
