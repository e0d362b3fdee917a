use oaktwin_camera::StereoGeometry;

use crate::ParameterError;
use crate::disparity::{DepthRounding, Fixed, Subpixel};
use crate::random::{Stage, Stream, standard_normal};

/// What a stereo camera measures with, and how wrong it is. Lengths in pixels are in matcher pixels, those of an image
/// [`width_px`](Self::width_px) wide, whatever the width of the images it looks at.
///
/// [`Parameters::set`] and [`Parameters::get`] reach each by its name in [`NAMES`](super::NAMES).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// `focalLength`, matcher px, and `baseline`, m.
    pub stereo: StereoGeometry,
    /// `width`: of the images that the matcher works on, px: 1280 at 800P, 640 at 480P and 400P.
    pub width_px: u32,
    /// `subpixelFractionalBits`, `subpixel`: the step of disparity.
    pub subpixel: Subpixel,
    /// `extendedDisparity`: whether the search goes twice as far, for what is near.
    pub extended_disparity: bool,
    /// `disparityShift`: where the search begins, px.
    pub disparity_shift_px: u32,
    /// `occlusion`: whether what the second imager does not see is lost: shadows on the left of near things, and a band
    /// at the left border.
    pub occlusion: bool,
    /// `leftRightCheck`: whether the two directions of matching must agree. Where the matching window makes near things
    /// wider ([`edge_dilation_px`](Self::edge_dilation_px)) they do not, beside the shadow.
    pub left_right_check: bool,
    /// `leftRightCheckThreshold`: by how much they may differ, px.
    pub left_right_check_threshold_px: u32,
    /// `confidenceThreshold`, 0 to 255: what has less texture is lost, where there is a picture. 0 keeps all.
    pub confidence_threshold: u8,
    /// `numInvalidateEdgePixels`: columns at the left border that are lost, px.
    pub invalid_edge_px: u32,
    /// `edgeDilation`: by how much the matching window makes near things wider on every side, px.
    pub edge_dilation_px: f64,
    /// `dropout`: the fraction of pixels, 0 to 1, that are lost at random.
    pub dropout: f64,
    /// `bias`, β: the error of this device's calibration, px. Below 0 it reports too far.
    pub bias_px: f64,
    /// `pixelLocking`, a: the amplitude of the error that repeats with every pixel of disparity, px.
    pub pixel_locking_px: f64,
    /// `jitter`, σ: the standard deviation of a pixel over time, px.
    pub jitter_px: f64,
    /// `window`: the side of the matching window, over which jitter is correlated and texture is looked for, px; odd.
    pub window_px: u32,
    /// `depthRounding`: how depth becomes whole millimetres.
    pub depth_rounding: DepthRounding,
}

/// The spread of devices' calibration bias, px: an estimate, with which the median of 200 devices stays inside the
/// vendor's published accuracy.
pub const DEVICE_BIAS_SIGMA_PX: f64 = 0.15;

impl Parameters {
    /// The defaults of a pair. `DepthAI`'s where it has the parameter: 5 subpixel bits, the standard range, the left-right
    /// check within 10 px, a confidence of 55. No bias, pixel locking as fitted to the vendor's measured curves (0.13 px
    /// at 1280 px, 0.2 px at 640); estimates are the jitter of 0.05 px, its window of 7×7, and neither wider edges nor
    /// dropout.
    #[must_use]
    pub fn new(stereo: StereoGeometry, width_px: u32) -> Self {
        Self {
            stereo,
            width_px,
            subpixel: Subpixel::default(),
            extended_disparity: false,
            disparity_shift_px: 0,
            occlusion: true,
            left_right_check: true,
            left_right_check_threshold_px: 10,
            confidence_threshold: 55,
            invalid_edge_px: 0,
            edge_dilation_px: 0.0,
            dropout: 0.0,
            bias_px: 0.0,
            pixel_locking_px: if width_px > 640 { 0.13 } else { 0.2 },
            jitter_px: 0.05,
            window_px: 7,
            depth_rounding: DepthRounding::default(),
        }
    }

    /// With the bias of one device of many.
    #[must_use]
    pub fn of_device(mut self, device_seed: u64) -> Self {
        let plane = Stream::new(device_seed, "").plane(Stage::DeviceBias, 0, 0);
        let [a, b, ..] = plane.words(0, 0);
        self.bias_px = DEVICE_BIAS_SIGMA_PX * standard_normal(a, b)[0];
        self
    }

    /// The largest disparity that is found, px: 95 and the shift; extended, twice that.
    #[must_use]
    pub fn max_disparity_px(&self) -> u32 {
        let standard = 95 + self.disparity_shift_px;
        if self.extended_disparity {
            2 * standard
        } else {
            standard
        }
    }

    /// The largest value of [`StereoNoise::disparity`](super::StereoNoise::disparity): the range that is searched, in
    /// steps.
    #[must_use]
    pub fn max_fixed_disparity(&self) -> u32 {
        (self.max_disparity_px() - self.disparity_shift_px) << self.subpixel.bits()
    }

    /// What its disparity images count in.
    pub(crate) fn fixed(&self) -> Fixed {
        Fixed {
            stereo: self.stereo,
            subpixel: self.subpixel,
            shift_px: self.disparity_shift_px,
            rounding: self.depth_rounding,
        }
    }

    /// Whether these make a sensor.
    ///
    /// # Errors
    /// One that is out of its range, or no number.
    pub fn check(&self) -> Result<(), ParameterError> {
        let shift = f64::from(self.disparity_shift_px);
        let edge = f64::from(self.invalid_edge_px);
        let threshold = f64::from(self.left_right_check_threshold_px);
        let window = f64::from(self.window_px);
        let ranges = [
            ("focalLength", self.stereo.focal_length_px, 1.0, 1e5, "px"),
            (
                "baseline",
                self.stereo.baseline_m,
                1e-4,
                2.0,
                "m: 75 mm are 0.075",
            ),
            ("width", f64::from(self.width_px), 1.0, 16384.0, "px"),
            ("disparityShift", shift, 0.0, 1024.0, "px"),
            ("leftRightCheckThreshold", threshold, 0.0, 128.0, "px"),
            ("numInvalidateEdgePixels", edge, 0.0, 16384.0, "px"),
            ("edgeDilation", self.edge_dilation_px, 0.0, 32.0, "px"),
            ("dropout", self.dropout, 0.0, 1.0, "the fraction of pixels"),
            ("bias", self.bias_px, -10.0, 10.0, "px"),
            ("pixelLocking", self.pixel_locking_px, 0.0, 1.0, "px"),
            ("jitter", self.jitter_px, 0.0, 10.0, "px"),
            ("window", window, 1.0, 63.0, "px"),
        ];
        for (name, value, low, high, unit) in ranges {
            if value.is_nan() {
                let remedy = format!("give {low} to {high} {unit}");
                return Err(ParameterError::new(name, "it is no number", remedy));
            }
            if !(low..=high).contains(&value) {
                return Err(ParameterError::new(
                    name,
                    format!("{value} is out of range"),
                    format!("give {low} to {high} {unit}"),
                ));
            }
        }
        if self.window_px.is_multiple_of(2) {
            return Err(ParameterError::new(
                "window",
                format!("{} has no middle", self.window_px),
                format!("give an odd number: {}", self.window_px + 1),
            ));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parameters() -> Parameters {
        let stereo = StereoGeometry {
            focal_length_px: 800.0,
            baseline_m: 0.075,
        };
        Parameters::new(stereo, 1280)
    }

    #[test]
    fn the_range_of_disparities() {
        let mut p = parameters();
        assert_eq!((p.max_disparity_px(), p.max_fixed_disparity()), (95, 3040));
        p.disparity_shift_px = 10;
        assert_eq!((p.max_disparity_px(), p.max_fixed_disparity()), (105, 3040));
        p.extended_disparity = true;
        assert_eq!((p.max_disparity_px(), p.max_fixed_disparity()), (210, 6400));
        p.disparity_shift_px = 1024;
        assert!(p.check().is_ok() && p.max_fixed_disparity() < 1 << 16);
    }

    #[test]
    fn what_makes_no_sensor() {
        let wrong = |change: fn(&mut Parameters)| {
            let mut p = parameters();
            change(&mut p);
            p.check().unwrap_err().to_string()
        };
        assert!(parameters().check().is_ok());
        assert_eq!(
            wrong(|p| p.stereo.focal_length_px = 0.0),
            "focalLength: 0 is out of range; give 1 to 100000 px"
        );
        assert_eq!(
            wrong(|p| p.stereo.baseline_m = 75.0),
            "baseline: 75 is out of range; give 0.0001 to 2 m: 75 mm are 0.075"
        );
        assert_eq!(
            wrong(|p| p.jitter_px = f64::NAN),
            "jitter: it is no number; give 0 to 10 px"
        );
        assert_eq!(
            wrong(|p| p.bias_px = f64::NEG_INFINITY),
            "bias: -inf is out of range; give -10 to 10 px"
        );
        assert_eq!(
            wrong(|p| p.window_px = 6),
            "window: 6 has no middle; give an odd number: 7"
        );
        assert!(wrong(|p| p.stereo.baseline_m = -0.075).starts_with("baseline: -0.075 is out of range"));
        assert!(wrong(|p| p.dropout = 1.01).starts_with("dropout: 1.01 is out of range"));
        assert!(wrong(|p| p.width_px = 0).starts_with("width: 0 is out of range"));
        assert!(wrong(|p| p.left_right_check_threshold_px = 129).starts_with("leftRightCheckThreshold"));
    }
}
