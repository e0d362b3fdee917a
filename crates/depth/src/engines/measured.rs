//! From what an engine measured to a capture, with its filters.

use oaktwin_camera::StereoGeometry;
use oaktwin_image::{Image, ImageView, ZDepth};

use super::filters::{are_of_depth, run_on_disparity, run_on_metres};
use crate::disparity::Subpixel;
use crate::filter::{Chain, Filter};
use crate::{Capture, FixedDisparity, Input};

/// The fixed point of disparities for filters, as on the device.
const SUBPIXEL: Subpixel = Subpixel::Bits5;

impl Capture {
    /// Runs the filters on a depth image that an engine measured, in metres with 0 where there is no value, and returns the capture.
    #[must_use]
    pub fn of_depth(depth: ZDepth, input: &Input<'_>, filters: &mut Chain) -> Self {
        let picture = picture(input, filters);
        let rgb = picture.as_ref().map(ImageView::from);
        let filtered = run_on_metres(filters, &depth, rgb, |_| true, None);
        Self::new(depth, filtered)
    }

    /// Runs the filters on the disparities that an engine measured, and returns the capture: filters of stereo on fixed-point
    /// disparity, as on the device, the others on depth. Disparities are in pixels of the left image, 0 where there is no value, and
    /// `max_px` at most; `stereo` is the geometry at the width of the image.
    #[must_use]
    pub fn of_disparity(
        disparity_px: &Image<f32>,
        stereo: StereoGeometry,
        max_px: u32,
        input: &Input<'_>,
        filters: &mut Chain,
    ) -> Self {
        let picture = picture(input, filters);
        let rgb = picture.as_ref().map(ImageView::from);
        let depth = if are_of_depth(filters) {
            // No filter requires fixed point, so nothing is rounded.
            disparity_px.map(|px| metres(stereo, f64::from(*px)))
        } else {
            let step_px = SUBPIXEL.step_px();
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "the cast saturates, and NaN becomes 0"
            )]
            let fixed = disparity_px.map(|px| (f64::from(*px) / step_px + 0.5) as u16);
            let (fixed, scale) = run_on_disparity(filters, fixed, rgb, max_px.max(1), SUBPIXEL, None);
            let disparity = FixedDisparity {
                fixed,
                step_px: step_px / scale,
                shift_px: 0,
            };
            disparity.to_px().map(|px| metres(stereo, f64::from(*px)))
        };
        let depth = ZDepth(depth);
        let filtered = run_on_metres(filters, &depth, rgb, Filter::is_of_depth, None);
        Self::new(depth, filtered)
    }
}

/// The colour image for filters that need one: the depth image's, or the left image of a pair.
fn picture(input: &Input<'_>, filters: &Chain) -> Option<Image<[u8; 4]>> {
    if !filters.filters().iter().any(Filter::needs_rgb) {
        return None;
    }
    match input {
        Input::Pair(pair) => Some(pair.left().picture()),
        Input::Depth(shot) => {
            let rgb = shot.rgb()?;
            Image::new(rgb.width(), rgb.height(), rgb.pixels().to_vec())
        }
    }
}

#[expect(clippy::cast_possible_truncation, reason = "depth is single precision")]
fn metres(stereo: StereoGeometry, disparity_px: f64) -> f32 {
    match disparity_px > 0.0 {
        true => stereo.depth(disparity_px) as f32,
        false => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::DepthShot;
    use crate::filter;

    const STEREO: StereoGeometry = StereoGeometry {
        focal_length_px: 400.0,
        baseline_m: 0.1,
    };

    fn captured(filters: &[&str]) -> Capture {
        let disparity = Image::new(3, 1, vec![20.0, 0.0, 10.01]).unwrap();
        let blank = Image::filled(3, 1, 1.0f32);
        let filters = filters.iter().map(|text| filter::parse(text).unwrap());
        let mut filters = Chain::new(filters.collect());
        let input = Input::Depth(DepthShot::new((&blank).into()));
        Capture::of_disparity(&disparity, STEREO, 95, &input, &mut filters)
    }

    #[test]
    fn disparities_become_depth() {
        assert_eq!(captured(&[]).distance.0.pixels(), [2.0, 0.0, 40.0f32 / 10.01]);
        // On millimetres, after the disparities.
        let near = captured(&["threshold:min=0,max=3000"]);
        assert_eq!(near.distance.0.pixels(), [2.0, 0.0, 0.0]);
        assert!(near.is_filtered());
    }

    #[test]
    fn filters_of_stereo_see_fixed_point() {
        let smoothed = captured(&["spatial"]).distance;
        let [near, _, far] = smoothed.0.pixels() else {
            panic!("{smoothed:?}")
        };
        // Rounded to 1/32 px, and then to a step of the range that filters see.
        assert!(
            (near - 2.0).abs() < 0.01 && (far - 40.0 / 10.01).abs() < 0.02,
            "{smoothed:?}"
        );
        assert_ne!(*far, 40.0f32 / 10.01);
    }
}
