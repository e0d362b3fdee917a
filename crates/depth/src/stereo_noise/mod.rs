//! What an OAK's stereo reports, from depth alone: occlusion, the disparity range, the bias of a device, pixel locking,
//! jitter, quantization.
//!
//! The image is the rectified left one. Disparities are in matcher pixels, those of the mode's full width
//! ([`Parameters::width_px`]): an image of any width of the same field of view has the same depth error.

mod names;
mod parameters;
mod sense;

pub use names::NAMES;
pub use parameters::{DEVICE_BIAS_SIGMA_PX, DepthRounding, Parameters, Subpixel};

use oaktwin_image::{Image, ZDepth};

use crate::random::Stream;
use crate::{ParameterError, Shot};

/// The sensor, ready to look.
#[derive(Clone, Debug, PartialEq)]
pub struct StereoNoise {
    parameters: Parameters,
}

impl StereoNoise {
    /// Of its parameters.
    ///
    /// # Errors
    /// A parameter out of its range.
    pub fn new(parameters: Parameters) -> Result<Self, ParameterError> {
        parameters.check()?;
        Ok(Self { parameters })
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
        sense::disparity(self, shot, random)
    }

    /// What it reports of a shot without filters: metres, whole millimetres, 0 where nothing was measured.
    #[must_use]
    pub fn sense(&self, shot: &Shot<'_>, random: &Stream) -> ZDepth {
        self.depth(&self.disparity(shot, random), 1.0)
    }

    /// Depth from a disparity image, in which a unit of [`StereoNoise::disparity`] is `scale` units: metres, whole
    /// millimetres up to 65 535, 0 where nothing was measured.
    #[must_use]
    pub fn depth(&self, disparity: &Image<u16>, scale: f64) -> ZDepth {
        let p = &self.parameters;
        let step = p.subpixel.step_px() / scale;
        let depth = disparity.map(|&fixed| {
            if fixed == 0 {
                return 0.0;
            }
            let d = f64::from(fixed) * step + f64::from(p.disparity_shift_px);
            let exact = p.stereo.depth(d) * 1000.0;
            let millimetres = match p.depth_rounding {
                DepthRounding::Nearest => exact.round(),
                DepthRounding::Truncate => exact.floor(),
            };
            if millimetres > f64::from(u16::MAX) {
                return 0.0;
            }
            #[expect(clippy::cast_possible_truncation, reason = "metres are single precision")]
            let metres = (millimetres / 1000.0) as f32;
            metres
        });
        ZDepth(depth)
    }
}
