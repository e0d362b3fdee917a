use oaktwin_camera::{DriftedMatches, ImageSize, Intrinsics, OpenCv, PixelPoint, StereoDrift};
use oaktwin_image::{Image, ImageView};
use rayon::prelude::*;

/// The depth of a surface that a drifted pair sees beyond infinity, m: beyond all that can be measured.
const BEYOND_M: f64 = 1e6;

/// A stereo pair whose processor assumes another geometry than the cameras have, for engines that measure depth images: the pair
/// has drifted since its calibration, or its depth is computed with the baseline of its design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriftedPair {
    /// The drift.
    pub drift: StereoDrift,
    /// The calibrated intrinsics of the rectified images; images of another size are resized.
    pub intrinsics: Intrinsics,
    /// The calibrated baseline, m.
    pub baseline_m: f64,
    /// The baseline with which the processor converts disparity to depth, m.
    pub depth_baseline_m: f64,
}

impl DriftedPair {
    /// Returns what the pair sees in images of a size, and the factor by which its processor then scales depth.
    #[must_use]
    pub fn matches(&self, size: ImageSize) -> (DriftedMatches, f64) {
        let intrinsics = self.intrinsics.resized(size, true);
        let matches = self.drift.matches(&intrinsics, self.baseline_m);
        (matches, self.depth_baseline_m / self.baseline_m)
    }

    /// Returns the depth that the processor assigns to the true disparity of each pixel, metres. Values that are not finite and
    /// positive are unchanged. The shift of the left image by the drift of its focal length, a small part of a pixel, is neglected.
    pub(super) fn assumed_depth(&self, depth: ImageView<'_, f32>) -> Image<f32> {
        let (width, height) = (depth.width(), depth.height());
        let (matches, scale) = self.matches(ImageSize::new(width, height));
        let has_drifted = !self.drift.is_none();
        let mut assumed = Image::filled(width, height, 0.0);
        let rows = assumed.pixels_mut().par_chunks_exact_mut((width as usize).max(1));
        let rows = rows.zip(depth.pixels().par_chunks_exact((width as usize).max(1)));
        rows.enumerate().for_each(|(y, (assumed, depth))| {
            for (x, (assumed, &depth_m)) in assumed.iter_mut().zip(depth).enumerate() {
                let z = f64::from(depth_m);
                #[expect(clippy::cast_precision_loss, reason = "images are smaller than 2⁵² pixels")]
                let pixel = PixelPoint::<OpenCv>::new(x as f64, y as f64);
                let matched = if has_drifted {
                    matches.assumed_depth(pixel, z)
                } else {
                    z
                };
                let drifted = (scale * matched).min(BEYOND_M);
                *assumed = if z > 0.0 && z.is_finite() {
                    #[expect(clippy::cast_possible_truncation, reason = "depth is float32")]
                    let drifted = drifted as f32;
                    drifted
                } else {
                    depth_m
                };
            }
        });
        assumed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drifted(drift: &str) -> DriftedPair {
        let centre = PixelPoint::<OpenCv>::new(63.5, 39.5);
        DriftedPair {
            drift: StereoDrift::parse(drift).unwrap(),
            intrinsics: Intrinsics::new(ImageSize::new(128, 80), 80.0, 80.0, centre),
            baseline_m: 0.075,
            depth_baseline_m: 0.075,
        }
    }

    #[test]
    fn the_baseline_of_the_design_scales_depth() {
        let designed = DriftedPair {
            depth_baseline_m: 0.0765,
            ..drifted("")
        };
        let depth = Image::filled(128, 80, 2.0_f32);
        let assumed = designed.assumed_depth((&depth).into());
        assert!(assumed.pixels().iter().all(|z| (z - 2.04).abs() < 1e-6));
    }

    #[test]
    fn a_longer_baseline_makes_depth_too_small() {
        let depth = Image::filled(128, 80, 2.0);
        let assumed = drifted("baseline=750").assumed_depth((&depth).into());
        for z in assumed.pixels() {
            assert!((z - 2.0 / 1.01).abs() < 1e-5, "{z}");
        }
        // Twice the size, the same lens.
        let depth = Image::filled(256, 160, 2.0);
        let assumed = drifted("baseline=750").assumed_depth((&depth).into());
        assert!((assumed.pixels()[1234] - 2.0 / 1.01).abs() < 1e-5);
    }

    #[test]
    fn negative_disparity_is_beyond_range_and_missing_values_stay() {
        let mut depth = Image::filled(128, 80, 50.0);
        depth.pixels_mut()[0] = f32::INFINITY;
        depth.pixels_mut()[1] = 0.0;
        let assumed = drifted("yaw=-10").assumed_depth((&depth).into());
        assert_eq!(assumed.pixels()[..2], [f32::INFINITY, 0.0]);
        assert!(assumed.pixels()[5000] >= 0.9e6);
    }
}
