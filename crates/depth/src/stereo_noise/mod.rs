//! A parametric model of the depth error of an OAK stereo pair, from a depth image alone.
//!
//! The image is the rectified left one. Disparities are in matcher pixels, pixels of the mode's full width S
//! ([`Parameters::width_px`]): d = f·b/z. Quantities in pixels of the image (shadows, borders, windows) are
//! converted by W/S, so that images of any width W with the same field of view have the same depth error. There is no lens
//! and no filter here.
//!
//! # Steps
//! 1. **Geometry.** Depth is converted to disparity; values that are not finite and positive mean no surface. Optionally the
//!    matching window widens near objects ([`Parameters::edge_dilation_px`]): a pixel with something more than 1 px nearer
//!    within reach, in rows and columns, takes the nearest such disparity. Pixels that the second imager does not see are
//!    invalid ([`Parameters::occlusion`]): those whose position in the right image is covered by something at least one
//!    image pixel nearer, on the left of near objects, and those left of the right image, x < d·W/S. Where near objects
//!    are widened, the left-right check also invalidates what they cover in the right image, a band of the same width on the
//!    far side of the shadow, if they are nearer by more than its threshold; without the check, or with a widening of 0
//!    (the default), this has no effect.
//! 2. **Systematic error.** d₁ = d + β − a·sin(2π(d + β)): the device's calibration bias, and pixel locking.
//! 3. **Random error.** d₂ = d₁ + σ·N: N has mean 0 and variance 1, is new in every frame, and is the sum over the
//!    matching window of independent numbers, so that it is correlated between neighbours. The numbers are random bytes; under windows
//!    smaller than 4×4 pixels of the image, normal numbers in steps of σ/1024: integers, so that sums are exact and
//!    the same on every machine. N is normal except for its tails: none beyond 4.8 σ of a window of one pixel, 6.9 σ of
//!    4×4, more of others; of a sum of bytes the excess kurtosis is −0.075 or less away from 0.
//! 4. **Quantization** to 1, 1/8, 1/16 or 1/32 px, halves to even; disparities outside the range of 95 px (190
//!    extended) above the shift are invalid. A disparity that rounds to the shift is 0, and 0 is invalid.
//! 5. **Invalidation**: too little texture, if the shot has a colour image ([`Parameters::confidence_threshold`]; the measure
//!    is this project's, see below); dropout; columns at the left border ([`Parameters::invalid_edge_px`]).
//! 6. **Depth** z = f·b/d in whole millimetres; beyond 65.535 m depth is invalid.
//!
//! The filters of [`crate::filter`] run between 5 and 6: [`StereoNoise::disparity`] and [`StereoNoise::depth`] are
//! the two halves of [`StereoNoise::sense`].
//!
//! # Measurements and estimates
//! * The form of the systematic error, and β ≈ −0.22 px, a ≈ 0.13 px at 800P (f 794 px), β ≈ 0, a ≈ 0.2 px at 480P
//!   (f 454 px), are fits to error curves that the vendor has published for one unit each. Measured by the vendor's
//!   method, this model has R² 0.966 of the error in % at 800P beyond 2.5 m, 0.88 at 480P. The values of other models are
//!   estimates.
//! * Estimates: the spread of β over units ([`DEVICE_BIAS_SIGMA_PX`]), with which the median of many units stays within
//!   the accuracy that the vendor publishes; σ = 0.05 px over 7×7; no widening, no dropout; the threshold of 1 px at
//!   edges; rounding to the nearest millimetre.
//! * Confidence, 0 to 255 (255 = highest, as in `DepthAI` 3; older versions count down from 255): the mean absolute
//!   difference between the luma of pixels 4 matcher pixels apart, over the matching window, times 72. An estimate: the
//!   device's own is not published. The default threshold of 55 requires 0.76 grey levels. A colour image does not
//!   show a dot projector's pattern; [`Parameters::dot_contrast`] adds its texture, which fades with the square of the distance. In
//!   little light ([`Parameters::ambient`]), noise hides texture.
//! * In extended mode the device matches near objects in images of half the size; here they have the same resolution.

mod batch;
mod confidence;
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

pub(crate) use self::sense::BAND;
pub use crate::disparity::{DepthRounding, Subpixel};
pub use parameters::{DEVICE_BIAS_SIGMA_PX, Parameters};

use std::fmt;

use oaktwin_image::{Image, ZDepth};

use self::sense::Job;
use crate::disparity::DepthTable;
use crate::random::Stream;
use crate::reason::ReasonCodes;
use crate::{DepthShot, ParameterError};

/// The engine, with checked parameters.
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
    /// Creates the engine from its parameters.
    ///
    /// # Errors
    /// Returns an error if a parameter is out of range.
    pub fn new(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.check()?;
        let table = DepthTable::new(&parameters.fixed(), 1.0, parameters.max_fixed_disparity());
        Ok(Self { parameters, table })
    }

    /// The parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Measures a shot as the disparity image before filters: units of 2⁻ⁿ matcher pixels with n bits of
    /// [`Subpixel`], without the [shift](Parameters::disparity_shift_px); 0 where nothing was measured.
    #[must_use]
    pub fn disparity(&self, shot: &DepthShot<'_>, random: &Stream) -> Image<u16> {
        self.image(shot, random, |fixed, _, out| out.copy_from_slice(fixed))
    }

    /// Measures a shot without filters: metres, whole millimetres, 0 where nothing was measured.
    #[must_use]
    pub fn sense(&self, shot: &DepthShot<'_>, random: &Stream) -> ZDepth {
        ZDepth(self.image(shot, random, |fixed, _, out| self.table.look_up(fixed, out)))
    }

    /// Returns the confidence of each pixel, 0 to 255; `None` without a colour image.
    pub(crate) fn confidence(&self, shot: &DepthShot<'_>) -> Option<Image<u16>> {
        confidence::confidence(&self.parameters, shot)
    }

    /// Returns why pixels of [`StereoNoise::disparity`] have no value.
    pub(crate) fn reasons(&self, shot: &DepthShot<'_>, random: &Stream) -> ReasonCodes {
        let depth = shot.depth();
        let mut codes = Image::filled(depth.width(), depth.height(), 0);
        let job = Job::new(self, shot, random).with_reasons();
        job.image(codes.pixels_mut(), |_, reasons, out| out.copy_from_slice(reasons));
        ReasonCodes(codes)
    }

    /// Converts a disparity image to depth, where a unit of [`StereoNoise::disparity`] is `scale` units: metres, whole
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
        shot: &DepthShot<'_>,
        random: &Stream,
        finish: impl Fn(&[u16], &[u8], &mut [T]) + Sync,
    ) -> Image<T> {
        let depth = shot.depth();
        let mut out = Image::filled(depth.width(), depth.height(), T::default());
        Job::new(self, shot, random).image(out.pixels_mut(), finish);
        out
    }
}
