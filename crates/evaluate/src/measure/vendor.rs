use oaktwin_image::ImageView;

use super::statistics::{mean, median_in_place, standard_deviation};
use super::{ImageRegion, is_valid};

/// The share of a region's valid pixels that is dropped at each end.
pub const TRIMMED: f64 = 0.05;

/// The results of the vendor's method; `None` if nothing was measured.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vendor {
    /// The mean over the captures of the region's median in metres.
    pub depth_m: Option<f64>,
    /// The standard deviation over the captures of the region's mean in metres; `None` for fewer than two captures.
    pub precision_m: Option<f64>,
    /// The number of captures with a valid pixel in the region.
    pub captures: u32,
}

impl Vendor {
    /// Returns the error as a share of the true distance, positive if too far.
    #[must_use]
    pub fn error(&self, truth_m: f64) -> Option<f64> {
        Some((self.depth_m? - truth_m) / truth_m)
    }
}

/// Measures the distance of the surface in a region as the vendor does. The same number of pixels is dropped at the top and at
/// the bottom, which affects the mean but not the median.
#[must_use]
pub fn vendor(captures: &[ImageView<'_, f32>], region: &ImageRegion) -> Vendor {
    let mut values: Vec<f32> = Vec::with_capacity(region.pixels());
    let (mut medians, mut means) = (Vec::new(), Vec::new());
    for capture in captures {
        values.clear();
        for row in region.rows_of(*capture) {
            values.extend(row.iter().copied().filter(|&z| is_valid(z)));
        }
        let kept = trimmed(&mut values);
        means.extend(mean(kept.iter().copied().map(f64::from)));
        medians.extend(median_in_place(kept));
    }
    Vendor {
        depth_m: mean(medians.iter().copied()),
        precision_m: standard_deviation(&means),
        #[expect(clippy::cast_possible_truncation, reason = "the number of images is small")]
        captures: medians.len() as u32,
    }
}

/// Returns the values without the smallest and the largest ones.
fn trimmed(values: &mut [f32]) -> &mut [f32] {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a twentieth of a length"
    )]
    let dropped = (values.len() as f64 * TRIMMED) as usize;
    if dropped == 0 {
        return values;
    }
    values.select_nth_unstable_by(dropped, f32::total_cmp);
    let above = &mut values[dropped..];
    let kept = above.len() - dropped;
    above.select_nth_unstable_by(kept, f32::total_cmp);
    &mut above[..kept]
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_image::Image;
    use proptest::prelude::*;

    fn all(width: u32, height: u32) -> ImageRegion {
        ImageRegion::centred(width, height, 1.0)
    }

    #[test]
    fn ignores_outliers_and_holes() {
        // 100 values: 4 outliers, 6 invalid, the rest from 2 m in steps of 1 mm.
        let mut pixels: Vec<f32> = (0..90u16).map(|i| 2.0 + f32::from(i) * 1e-3).collect();
        pixels.extend([
            90.0,
            80.0,
            0.01,
            0.02,
            0.0,
            -1.0,
            f32::NAN,
            f32::INFINITY,
            f32::NEG_INFINITY,
            0.0,
        ]);
        let image = Image::new(10, 10, pixels).unwrap();
        let measured = vendor(&[(&image).into()], &all(10, 10));
        assert!((measured.depth_m.unwrap() - 2.0445).abs() < 1e-6);
        assert!((measured.error(2.0).unwrap() - 0.02225).abs() < 1e-6);
        assert_eq!((measured.precision_m, measured.captures), (None, 1));
    }

    #[test]
    fn precision_is_the_deviation_over_time() {
        let images = [1.0f32, 1.25, 1.5].map(|z| Image::filled(4, 4, z));
        let views = images.each_ref().map(ImageView::from);
        let measured = vendor(&views, &all(4, 4));
        assert_eq!(
            measured,
            Vendor {
                depth_m: Some(1.25),
                precision_m: Some(0.25),
                captures: 3
            }
        );
    }

    #[test]
    fn returns_none_without_valid_pixels() {
        let image = Image::filled(4, 4, 0.0f32);
        assert_eq!(vendor(&[(&image).into()], &all(4, 4)), Vendor::default());
        assert_eq!(vendor(&[], &all(4, 4)).error(1.0), None);
        let image = Image::filled(0, 0, 0.0f32);
        assert_eq!(vendor(&[(&image).into()], &all(0, 0)), Vendor::default());
    }

    proptest! {
        #[test]
        fn trimming_equals_sorting_and_slicing(values in proptest::collection::vec(0.1f32..20.0, 1..200)) {
            let mut sorted = values.clone();
            sorted.sort_by(f32::total_cmp);
            let dropped = values.len() / 20;
            let mut kept = values.clone();
            let kept = trimmed(&mut kept);
            kept.sort_by(f32::total_cmp);
            prop_assert_eq!(&*kept, &sorted[dropped..sorted.len() - dropped]);
        }
    }
}
