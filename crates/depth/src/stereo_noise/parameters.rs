use oaktwin_camera::StereoGeometry;

use crate::ParameterError;
use crate::random::{Stage, Stream, standard_normal};

/// What a stereo camera measures with, and how wrong it is. Disparities are in matcher pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Focal length in matcher pixels, and the baseline.
    pub stereo: StereoGeometry,
    /// The width of the images that the matcher works on, px: 1280 at 800P, 640 at 480P and 400P.
    pub width_px: u32,
    /// The step of disparity.
    pub subpixel: Subpixel,
    /// Whether disparities up to 190 px are found, instead of 95.
    pub extended_disparity: bool,
    /// Where the range of disparities begins, px.
    pub disparity_shift_px: u32,
    /// β: the error of this device's calibration, px. Below 0 it reports too far.
    pub bias_px: f64,
    /// a: the amplitude of pixel locking, px.
    pub pixel_locking_px: f64,
    /// σ: the standard deviation of a pixel over time, px.
    pub jitter_px: f64,
    /// The side of the matching window over which the jitter is correlated, px of the matcher; odd.
    pub window_px: u32,
}

/// The fractional bits of a disparity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Subpixel {
    /// Whole pixels.
    Off,
    /// Eighths.
    Bits3,
    /// Sixteenths.
    Bits4,
    /// Thirty-seconds.
    #[default]
    Bits5,
}

impl Subpixel {
    /// How many bits.
    #[must_use]
    pub const fn bits(self) -> u32 {
        match self {
            Self::Off => 0,
            Self::Bits3 => 3,
            Self::Bits4 => 4,
            Self::Bits5 => 5,
        }
    }

    /// The step, px.
    #[must_use]
    pub fn step_px(self) -> f64 {
        1.0 / f64::from(1u32 << self.bits())
    }
}

/// The spread of devices' calibration bias, px: an estimate, with which the median of 200 devices stays inside the
/// vendor's published accuracy.
pub const DEVICE_BIAS_SIGMA_PX: f64 = 0.15;

impl Parameters {
    /// The defaults of a pair: 5 subpixel bits, no bias, pixel locking as fitted to the vendor's measured curves (0.13 px
    /// at 1280 px, 0.2 px at 640), a jitter of 0.05 px over 7×7 pixels (an estimate).
    #[must_use]
    pub fn new(stereo: StereoGeometry, width_px: u32) -> Self {
        Self {
            stereo,
            width_px,
            subpixel: Subpixel::default(),
            extended_disparity: false,
            disparity_shift_px: 0,
            bias_px: 0.0,
            pixel_locking_px: if width_px > 640 { 0.13 } else { 0.2 },
            jitter_px: 0.05,
            window_px: 7,
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

    /// The largest disparity that is found, px: 95 or, extended, 190, and the shift.
    #[must_use]
    pub fn max_disparity_px(&self) -> u32 {
        (if self.extended_disparity { 190 } else { 95 }) + self.disparity_shift_px
    }

    pub(super) fn check(&self) -> Result<(), ParameterError> {
        let positive = [
            ("focal length", self.stereo.focal_length_px),
            ("baseline", self.stereo.baseline_m),
        ];
        for (name, value) in positive {
            if !(value.is_finite() && value > 0.0) {
                return Err(ParameterError::new(
                    name,
                    format!("{value} is not above 0"),
                    "give a positive number",
                ));
            }
        }
        Ok(())
    }
}
