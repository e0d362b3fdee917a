//! Isaac Sim's `DepthSensorDistance`: a depth image seen once becomes what a stereo pair would have measured.
//!
//! Depth becomes disparity, disparity is quantized and jittered, each sample moves along its row by its disparity, and
//! what lands nowhere, is too near, too far or without texture is no measurement. The depth that a sample carries is the
//! rendered one: only its place is wrong.

mod assumptions;
mod confidence;
mod outliers;
mod parameters;
mod plan;
mod sense;
mod tile;
mod view;
mod warp;

pub use assumptions::{
    Assumptions, Collision, ConfidenceAt, ConfidenceComparison, Depth, Direction, Invalid, Luma,
    MaxDisparity, MaxDisparityUnit, OutlierNeighbourhood, Quantizer, RangeCut, SigmaUnit, TargetRounding,
};
pub use parameters::{MAX_OUTLIER_RANGE_PX, OutputMode, Parameters};
pub use sense::{Output, Wanted};

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
        sense::batch(self, depth, shape, [frame, u64::from(first_item)], random, out)
    }
}
