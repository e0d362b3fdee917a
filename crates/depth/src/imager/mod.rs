//! What an image sensor records of the light that falls on it: images in, images out.
//!
//! Light is linear and relative: 1 is what a white diffuse surface in the scene's typical light sends. At an exposure of 1
//! that fills the range of the numbers.
//!
//! # Steps
//! 1. **Blur** of the lens: the light of a point falls on the pixels around it too, as a normal distribution. It is made of
//!    the pixels' light, so it does not take away what a picture is aliased by.
//! 2. **Exposure**: a time and a gain. A fixed one, or one that gives the images' mean a target, as a camera's own
//!    control does ([`Imager::expose`]); beyond the longest time only the gain grows, and with it the noise.
//! 3. **Vignetting**, an option: light falls off by cos⁴ of the angle from the optical axis.
//! 4. **Noise**: λ electrons become λ + √(λ + r²)·N with N standard normal: shot noise, whose variance is λ, and read
//!    noise of r electrons. The normal distribution stands for Poisson's, whose mean and variance it has.
//! 5. **Numbers**: the full well, divided by the gain, is the largest number; nearest, 8 or 10 bits, none below 0.
//!
//! The response is linear, without gamma and black level: a pair is matched by what a pixel's neighbours are like.

mod blur;
mod expose;
mod parameters;
mod recorded;
mod rows;
#[cfg(test)]
mod tests;

pub use parameters::{Bits, Parameters};
pub use recorded::Recorded;

use oaktwin_camera::Intrinsics;
use oaktwin_image::{Image, ImageView};

use self::rows::{Number, Rows};
use crate::ParameterError;
use crate::random::Plane;

/// How long and how strongly light is collected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    /// The time, in those in which white fills the range of the numbers.
    pub time: f64,
    /// The gain, 1 or more.
    pub gain: f64,
}

impl Exposure {
    /// Both together: the share of the range that white fills.
    #[must_use]
    pub fn total(&self) -> f64 {
        self.time * self.gain
    }
}

/// An image sensor, ready to record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Imager {
    parameters: Parameters,
}

impl Imager {
    /// Of its parameters.
    ///
    /// # Errors
    /// A parameter out of its range.
    pub fn new(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.check()?;
        Ok(Self { parameters })
    }

    /// For images of which a pixel is `1 / scale` of those that the lens's blur counts in.
    #[must_use]
    pub fn scaled(mut self, scale: f64) -> Self {
        let sigma = self.parameters.lens_blur_px * scale;
        self.parameters.lens_blur_px = sigma.clamp(0.0, blur::MAX_SIGMA_PX);
        self
    }

    /// Its parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// What is recorded of `light`, linear; what is no number or below 0 is dark. `intrinsics` are those of the image,
    /// for vignetting. `random` is the image's own: of its camera, [`Stage::Exposure`](crate::random::Stage::Exposure)
    /// and frame.
    #[must_use]
    pub fn record(
        &self,
        light: ImageView<'_, f32>,
        intrinsics: &Intrinsics,
        exposure: Exposure,
        random: &Plane,
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
        random: &Plane,
    ) -> Image<N> {
        let mut out = Image::filled(light.width(), light.height(), N::default());
        Rows::new(&self.parameters, intrinsics, exposure, random).record(light, out.pixels_mut());
        out
    }
}
