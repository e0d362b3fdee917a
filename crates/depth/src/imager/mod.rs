//! An image sensor: light in, recorded images out.
//!
//! Light is linear and relative: 1 is the light of a white diffuse surface under the scene's typical illumination. At an
//! exposure of 1 it has the largest value.
//!
//! # Steps
//! 1. **Blur** of the lens: a normal point spread function. It is applied to pixels, so it does not remove aliasing.
//! 2. **Exposure**: a time and a gain, either fixed or such that the images' mean reaches a target, as in a camera's automatic
//!    exposure ([`Imager::expose`]); above the maximum time only the gain increases, and with it the noise.
//! 3. **Vignetting**, an option: light falls off by cos⁴ of the angle from the optical axis.
//! 4. **Noise**: λ electrons become λ + √(λ + r²)·N with N standard normal: shot noise, whose variance is λ, and read
//!    noise of r electrons. The normal distribution approximates the Poisson distribution with the same mean and variance.
//! 5. **Quantization**: the full well, divided by the gain, is the largest value; values are rounded to 8 or 10 bits and
//!    clamped at 0.
//!
//! The response is linear, without gamma and black level, which matching does not depend on.

mod blur;
mod color;
mod demosaic;
mod expose;
mod mosaic;
mod parameters;
mod recorded;
mod rows;
#[cfg(test)]
mod tests;

pub use color::{ColorImager, ColorParameters, Photosites};
pub use parameters::{Bits, Parameters};
pub use recorded::Recorded;

use oaktwin_camera::Intrinsics;
use oaktwin_image::{Image, ImageView};

use self::rows::{Number, Rows};
use crate::ParameterError;
use crate::random::RandomPlane;

/// An exposure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    /// The exposure time, as a multiple of the one at which white has the largest value.
    pub time: f64,
    /// The gain, at least 1.
    pub gain: f64,
}

impl Exposure {
    /// Time times gain: the value of white as a share of the largest value.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.time * self.gain
    }
}

/// An image sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Imager {
    parameters: Parameters,
}

impl Imager {
    /// Creates an image sensor from its parameters.
    ///
    /// # Errors
    /// Returns an error if a parameter is out of range.
    pub fn new(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.check()?;
        Ok(Self { parameters })
    }

    /// Returns the sensor for images with `scale` times as many pixels along an axis, in which the lens's blur is larger.
    #[must_use]
    pub fn scaled(mut self, scale: f64) -> Self {
        let sigma = self.parameters.lens_blur_px * scale;
        self.parameters.lens_blur_px = sigma.clamp(0.0, blur::MAX_SIGMA_PX);
        self
    }

    /// The parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Returns the image that the sensor records of linear `light`; NaN and negative values are dark. `intrinsics` are
    /// the image's, for vignetting. `random` must be the image's own stream: of its camera,
    /// [`NoiseStage::Exposure`](crate::random::NoiseStage::Exposure) and frame.
    #[must_use]
    pub fn record(
        &self,
        light: ImageView<'_, f32>,
        intrinsics: &Intrinsics,
        exposure: Exposure,
        random: &RandomPlane,
    ) -> Recorded {
        match self.parameters.bits {
            Bits::Eight => Recorded::Eight(self.numbers(light, intrinsics, exposure, random)),
            Bits::Ten => Recorded::Ten(self.numbers(light, intrinsics, exposure, random)),
        }
    }

    fn numbers<N: Number>(
        &self,
        light: ImageView<'_, f32>,
        intrinsics: &Intrinsics,
        exposure: Exposure,
        random: &RandomPlane,
    ) -> Image<N> {
        let mut out = Image::filled(light.width(), light.height(), N::default());
        Rows::new(&self.parameters, intrinsics, exposure, random).record(light, out.pixels_mut());
        out
    }
}
