use super::blur::MOST_SIGMA_PX;
use crate::ParameterError;
use oaktwin_parameter::choice;

choice! {
    /// How many bits a recorded number has.
    Bits {
        /// 0 to 255, what an OAK's stereo takes.
        Eight = "8",
        /// 0 to 1023, what an OV9282 has.
        Ten = "10",
    }
}

impl Bits {
    /// How many.
    #[must_use]
    pub const fn count(self) -> u32 {
        match self {
            Self::Eight => 8,
            Self::Ten => 10,
        }
    }

    /// The largest number.
    #[must_use]
    pub const fn max(self) -> u16 {
        match self {
            Self::Eight => 255,
            Self::Ten => 1023,
        }
    }
}

/// An image sensor. The defaults are those of an OAK's mono camera, an OV9282.
///
/// [`Parameters::set`] and [`Parameters::get`] reach each by its name in [`NAMES`](super::NAMES).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// `autoExposure`: whether the images' mean decides.
    pub auto_exposure: bool,
    /// `exposureTarget`: the mean of the images that it aims at, as a share of the largest number. 0.35, an estimate.
    pub exposure_target: f64,
    /// `exposure`: time times gain where it does not decide; 1 makes white the largest number. 0.8.
    pub exposure: f64,
    /// `maxExposureTime`: the longest, in those in which white fills the numbers. 2, an estimate: 33 ms, `DepthAI`'s
    /// longest at 30 images a second, in the light of an office.
    pub max_exposure_time: f64,
    /// `maxGain`: 16, `DepthAI`'s ISO 1600 over its ISO 100.
    pub max_gain: f64,
    /// `fullWell`: electrons that are the largest number at a gain of 1. 6300, an estimate: a best signal to noise ratio
    /// of 38 dB, usual for pixels of 3 µm behind a global shutter.
    pub full_well_e: f64,
    /// `readNoise`: electrons. 2.5, an estimate: a dynamic range of 68 dB.
    pub read_noise_e: f64,
    /// `noise`: whether there is any.
    pub noise: bool,
    /// `lensBlur`: the standard deviation of what the lens makes of a point, px. 0.5, an estimate: the vendor's lens (2.35 mm,
    /// f/2.0, sharp from 19.6 cm on, so sharpest at 39 cm) makes a disk of 2 px of a point at 2.5 m, whose standard deviation
    /// is a quarter of that.
    pub lens_blur_px: f64,
    /// `vignetting`, 0 to 1: the share of cos⁴ falloff. 0, an estimate: what a device's lens and its correction leave is
    /// not published.
    pub vignetting: f64,
    /// `bits`: 8 or 10.
    pub bits: Bits,
}

impl Default for Parameters {
    fn default() -> Self {
        Self {
            auto_exposure: true,
            exposure_target: 0.35,
            exposure: 0.8,
            max_exposure_time: 2.0,
            max_gain: 16.0,
            full_well_e: 6300.0,
            read_noise_e: 2.5,
            noise: true,
            lens_blur_px: 0.5,
            vignetting: 0.0,
            bits: Bits::default(),
        }
    }
}

impl Parameters {
    /// Whether these make a sensor.
    ///
    /// # Errors
    /// One that is out of its range, or no number.
    pub fn check(&self) -> Result<(), ParameterError> {
        let ranges = [
            (
                "exposureTarget",
                self.exposure_target,
                0.001,
                0.95,
                "of the largest number",
            ),
            (
                "exposure",
                self.exposure,
                1e-6,
                1e6,
                "(1 makes white the largest number)",
            ),
            (
                "maxExposureTime",
                self.max_exposure_time,
                1e-6,
                1e6,
                "(2 is the default)",
            ),
            ("maxGain", self.max_gain, 1.0, 1000.0, "(16 is ISO 1600)"),
            ("fullWell", self.full_well_e, 10.0, 1e7, "electrons"),
            ("readNoise", self.read_noise_e, 0.0, 1e4, "electrons"),
            ("lensBlur", self.lens_blur_px, 0.0, MOST_SIGMA_PX, "px"),
            ("vignetting", self.vignetting, 0.0, 1.0, "(1 is all of cos⁴)"),
        ];
        for (name, value, low, high, unit) in ranges {
            let remedy = || format!("give {low} to {high} {unit}");
            if value.is_nan() {
                return Err(ParameterError::new(name, "it is no number", remedy()));
            }
            if !(low..=high).contains(&value) {
                let what = format!("{value} is out of range");
                return Err(ParameterError::new(name, what, remedy()));
            }
        }
        Ok(())
    }
}
