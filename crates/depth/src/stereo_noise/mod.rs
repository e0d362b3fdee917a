//! What an OAK's stereo reports, from depth alone, for whoever has a depth image and nothing else.
//!
//! The image is the rectified left one. Disparities are in matcher pixels, those of the mode's full width S
//! ([`Parameters::width_px`]): d = f·b/z. What is measured in pixels of the image (shadows, borders, windows) is
//! converted by W/S, so that an image of any width W of the same field of view has the same depth error. Images are
//! taken as they are: there is no lens here, and no filter.
//!
//! # Steps
//! 1. **Geometry.** Depth becomes disparity; what is not finite and above 0 is no surface. Optionally the matching
//!    window makes near things wider ([`Parameters::edge_dilation_px`]): a pixel with something more than 1 px nearer
//!    within reach, rows and columns, takes the nearest such disparity. What the second imager does not see is lost
//!    ([`Parameters::occlusion`]): pixels whose place in the right image is covered by something at least one pixel of
//!    the image nearer, on the left of near things, and those that fall left of it, x < d·W/S. Where near things are
//!    widened, the left-right check also loses what the widened things cover in the right image, a band as wide on the
//!    far side of the shadow, if they are nearer by more than its threshold; without it, or with a widening of 0 (the
//!    default), it has no effect.
//! 2. **Systematic error.** d₁ = d + β − a·sin(2π(d + β)): the device's calibration bias, and pixel locking.
//! 3. **Random error.** d₂ = d₁ + σ·N: N has mean 0 and variance 1, is new in every frame, and is the sum over the
//!    matching window of independent numbers, so that neighbours share it. The numbers are random bytes; under windows
//!    smaller than 4×4 pixels of the image, normal numbers in steps of σ/1024: whole numbers, so that sums are exact and
//!    the same on every machine. N is normal but for its tails: none beyond 4.8 σ of a window of one pixel, 6.9 σ of
//!    4×4, more of others; of a sum of bytes the excess kurtosis is −0.075 or less away from 0.
//! 4. **Quantization** to 1, 1/8, 1/16 or 1/32 px, halves to even; what is not within the range of 95 px (190
//!    extended) above the shift is lost. A disparity that rounds to the shift is 0, and 0 is no measurement.
//! 5. **Losses**: too little texture, where the shot has a picture ([`Parameters::confidence_threshold`]; the measure is
//!    ours, see below); dropout; columns at the left border ([`Parameters::invalid_edge_px`]).
//! 6. **Depth** z = f·b/d in whole millimetres; beyond 65.535 m there is none.
//!
//! Between 5 and 6 belong the filters of [`crate::filter`]: [`StereoNoise::disparity`] and [`StereoNoise::depth`] are
//! the two halves of [`StereoNoise::sense`].
//!
//! # What is measured, and what is an estimate
//! * The form of the systematic error, and β ≈ −0.22 px, a ≈ 0.13 px at 800P (f 794 px), β ≈ 0, a ≈ 0.2 px at 480P
//!   (f 454 px), are fits to error curves that the vendor has published for one device each. Measured as the vendor does,
//!   this model has R² 0.966 of the error in % at 800P beyond 2.5 m, 0.88 at 480P. What another device has is an
//!   estimate.
//! * Estimates: the spread of β over devices ([`DEVICE_BIAS_SIGMA_PX`]), with which the median of many devices stays
//!   inside the accuracy that the vendor publishes; σ = 0.05 px over 7×7; no widening, no dropout; which side of 1 px
//!   is an edge; rounding to the nearest millimetre.
//! * Confidence, 0 to 255 (higher is surer, as in `DepthAI` 3; older versions count down from 255): the mean absolute
//!   difference of a pixel's luma and the next one's on its right, over the matching window, times 128. An estimate: the
//!   device's own is not published. The default threshold of 55 asks for 0.43 grey levels. A picture does not show what
//!   a dot projector adds: give none for a device that has its projector on, or a threshold of 0.
//! * In extended mode the near half, which the device matches in images of half the size, is as fine here as the rest.

mod batch;
mod dilation;
mod field;
mod parameters;
mod rows;
mod scale;
mod sense;
mod shadow;
#[cfg(test)]
mod tests;
mod texture;
mod window;

pub use crate::disparity::{DepthRounding, Subpixel};
pub use parameters::{DEVICE_BIAS_SIGMA_PX, Parameters};

use std::fmt;

use oaktwin_image::{Image, ZDepth};

use self::sense::Job;
use crate::disparity::DepthTable;
use crate::random::Stream;
use crate::{ParameterError, Shot};

/// The sensor, ready to look.
#[derive(Clone, PartialEq)]
pub struct StereoNoise {
    parameters: Parameters,
    table: DepthTable,
}

impl fmt::Debug for StereoNoise {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("StereoNoise")
            .field("parameters", &self.parameters)
            .finish_non_exhaustive()
    }
}

impl StereoNoise {
    /// Of its parameters.
    ///
    /// # Errors
    /// A parameter out of its range.
    pub fn new(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.check()?;
        let table = DepthTable::new(&parameters.fixed(), 1.0, parameters.max_fixed_disparity());
        Ok(Self { parameters, table })
    }

    /// Its parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// The disparity image that the matcher hands to the filters: units of 2⁻ⁿ matcher pixels with n bits of
    /// [`Subpixel`], without the [shift](Parameters::disparity_shift_px); 0 where nothing was measured.
    #[must_use]
    pub fn disparity(&self, shot: &Shot<'_>, random: &Stream) -> Image<u16> {
        self.image(shot, random, |fixed, out| out.copy_from_slice(fixed))
    }

    /// What it reports of a shot without filters: metres, whole millimetres, 0 where nothing was measured.
    #[must_use]
    pub fn sense(&self, shot: &Shot<'_>, random: &Stream) -> ZDepth {
        ZDepth(self.image(shot, random, |fixed, out| self.table.look_up(fixed, out)))
    }

    /// Depth from a disparity image, in which a unit of [`StereoNoise::disparity`] is `scale` units: metres, whole
    /// millimetres up to 65 535, 0 where nothing was measured.
    #[must_use]
    pub fn depth(&self, disparity: &Image<u16>, scale: f64) -> ZDepth {
        let last = disparity.pixels().iter().copied().max().unwrap_or(0);
        let rescaled;
        #[expect(clippy::float_cmp, reason = "the very number that callers write")]
        let table = if scale == 1.0 && u32::from(last) <= self.table.last() {
            &self.table
        } else {
            rescaled = DepthTable::new(&self.parameters.fixed(), scale, u32::from(last));
            &rescaled
        };
        let mut out = Image::filled(disparity.width(), disparity.height(), 0.0);
        table.look_up(disparity.pixels(), out.pixels_mut());
        ZDepth(out)
    }

    fn image<T: Copy + Default + Send>(
        &self,
        shot: &Shot<'_>,
        random: &Stream,
        finish: impl Fn(&[u16], &mut [T]) + Sync,
    ) -> Image<T> {
        let depth = shot.depth();
        let mut out = Image::filled(depth.width(), depth.height(), T::default());
        Job::new(self, shot, random).image(out.pixels_mut(), finish);
        out
    }
}
