//! Isaac Sim's `DepthSensorDistance`: a depth image seen once becomes what a stereo pair would have measured.
//!
//! Depth becomes disparity, disparity is quantized and jittered, each sample moves along its row by its disparity, and
//! what lands nowhere, is too near, too far or without texture is no measurement. The depth that a sample carries is the
//! rendered one: only its place is wrong.

mod assumptions;
mod parameters;
mod sense;

pub use assumptions::Assumptions;
pub use parameters::{OutputMode, Parameters};
pub use sense::{Output, Wanted};

use crate::random::Stream;
use crate::{ParameterError, Shot};

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
    /// A parameter out of its range.
    pub fn new(parameters: Parameters, assumptions: Assumptions) -> Result<Self, ParameterError> {
        parameters.check()?;
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
}
