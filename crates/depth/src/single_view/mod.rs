//! Isaac Sim's `DepthSensorDistance`: a depth image seen once becomes what a stereo pair would have measured.
//!
//! Depth becomes disparity, disparity is quantized and jittered, each sample moves along its row by its disparity, and
//! what lands nowhere, is too near, too far or without texture is no measurement. The depth that a sample carries is the
//! rendered one: only its place is wrong.
//!
//! # Steps
//! With z the depth, W the image's width, b `baselineMM`/1000, f `focalLengthPixel`, S `sensorSizePixel`, in single
//! precision:
//! 1. Depth that is not finite, not above 0, or outside `minDistance` to `maxDistance` is no sample.
//! 2. d = (b·f·W/S)/z, in pixels of the image.
//! 3. d above `maxDisparityPixel` is no sample.
//! 4. With a `noiseMean` q above 0, d' = q·round(d/q) + `noiseSigma`·N. N is standard normal, one for each square of
//!    `noiseDownscaleFactorPixel` k pixels, that of row ⌊y/k⌋ and column ⌊x/k⌋ of
//!    [`Plane::normals`](crate::random::Plane::normals), new in every frame. With 0, d' = d.
//! 5. A sample moves to x + round(d'), with a negative baseline to x − d'. Where several land the nearest stays; where
//!    none does is a hole: left of near things (right with a negative baseline), and at that border of the image.
//! 6. Confidence, where there is a picture: s = min(1, g·|∇(Y + n)|) of its luma Y by Sobel's kernels, the picture's
//!    border going on beyond it; n is [grain](Assumptions::grain_levels), new in every frame. Kept is s ≥ 1 − `confidenceThreshold`. What lacks confidence still hides what is behind it.
//! 7. Outliers: with a range r above 0 a pixel that is measured while no other up to r columns and rows away is, is
//!    removed; one that is not while all others are takes the measurement on its left, in the first column that on its
//!    right (in an image of one column it stays). Pixels outside the image are not looked at. All pixels are judged by
//!    the image before the step. Isaac Sim 5.x has r = 3; the switch of 6.x is r = 1.
//! 8. The outputs: [`Output`].
//!
//! # Assumptions
//! NVIDIA's documentation says what these steps do, not all of how. What it leaves open is an option of [`Assumptions`]:
//! * where reported depth comes from: carried along, or recomputed from d' ([`Depth`])
//! * the pixels that `maxDisparityPixel` counts ([`MaxDisparityUnit`]), and drop or clamp ([`MaxDisparity`])
//! * the range cut before or after samples move ([`RangeCut`])
//! * the side that samples move to ([`Direction`]), and rounding to pixels ([`TargetRounding`])
//! * which of several samples stays ([`Collision`])
//! * confidence where a sample comes from or lands ([`ConfidenceAt`]), its comparison ([`ConfidenceComparison`]), the
//!   gain g of Sobel's magnitude ([`Assumptions::sobel_gain`]), the [grain](Assumptions::grain_levels) of the picture
//!   and the weights of luma ([`Luma`])
//! * the rounding to steps ([`Quantizer`]) and the unit of `noiseSigma` ([`SigmaUnit`])
//! * colour and position where nothing was measured ([`Invalid`])
//! * the neighbours of outlier removal ([`OutlierNeighbourhood`])
//!
//! and, without an option: the noise is white; a hole that is filled takes the value beside it; `DepthSensorImager` is
//! luma of 0 to 1, as confidence is computed from; the pictures of [`OutputMode`] follow their titles.
//!
//! # Speed
//! Rows are sensed one after another in buffers that stay in the processor's caches: an image is read once, each output
//! written once. Tiles of rows run in parallel; the rows around a tile are computed again. The result has the same bytes
//! on any number of threads and with any instruction set.

mod assumptions;
mod confidence;
mod outliers;
mod plan;
mod sense;
mod tile;
mod view;
mod warp;

pub use assumptions::{
    Assumptions, Collision, ConfidenceAt, ConfidenceComparison, Depth, Direction, Invalid, Luma,
    MaxDisparity, MaxDisparityUnit, OutlierNeighbourhood, Quantizer, RangeCut, SigmaUnit, TargetRounding,
};
pub use oaktwin_parameter::nvidia::{Attributes as Parameters, MAX_OUTLIER_RANGE_PX, OutputMode};
pub use sense::{Output, Wanted};

use crate::batch::Batch;
use crate::random::Stream;
use crate::{BatchError, ParameterError, Shot};

/// The sensor, ready to look.
#[derive(Clone, Debug, PartialEq)]
pub struct SingleView {
    parameters: Parameters,
    assumptions: Assumptions,
}

impl SingleView {
    /// Of its parameters, and of what NVIDIA's documentation leaves open.
    ///
    /// # Errors
    /// A parameter or an assumption out of its range.
    pub fn new(parameters: Parameters, assumptions: Assumptions) -> Result<Self, ParameterError> {
        parameters.check()?;
        assumptions.check()?;
        Ok(Self {
            parameters,
            assumptions,
        })
    }

    /// Its parameters.
    #[must_use]
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// What it takes for granted.
    #[must_use]
    pub fn assumptions(&self) -> &Assumptions {
        &self.assumptions
    }

    /// What it reports of a shot: the outputs that are wanted.
    #[must_use]
    pub fn sense(&self, shot: &Shot<'_>, random: &Stream, wanted: Wanted) -> Output {
        sense::sense(self, shot, random, wanted)
    }

    /// The distances that it reports of a batch of images of one frame, `[count, height, width]` as `depth` and `out`
    /// are: those of [`SingleView::sense`] of shots without pictures, items numbered from `first_item`.
    ///
    /// # Errors
    /// `depth` or `out` has another length than the shape says.
    pub fn sense_batch(
        &self,
        depth: &[f32],
        shape: [usize; 3],
        frame: u64,
        first_item: u32,
        random: &Stream,
        out: &mut [f32],
    ) -> Result<(), BatchError> {
        let batch = Batch::new(depth, shape, frame, first_item)?;
        sense::batch(self, &batch, random, out)
    }
}

#[cfg(test)]
mod tests;
