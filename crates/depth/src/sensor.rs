mod batch;
mod drifted;

use std::sync::Arc;

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Camera, RigidTransform};
use oaktwin_image::annotation::Annotator;

use crate::filter::{Chain, Filter};
use crate::random::Stream;
use crate::{Capture, Engine, Input, ParameterError};

pub use drifted::DriftedPair;

/// An engine with its filters, which measures one input after the other.
///
/// Stereo filters run on fixed-point disparity, all others on millimetres. Decimation keeps its place in the chain, and
/// the filters after it work on the smaller image; its values stay disparities of the matcher's full width, hence the same
/// depths. Filters that need brightness read the colour image where the pixel was.
///
/// A [temporal filter](crate::filter::Temporal) remembers each pixel's last value and in which of the last 8 frames it had
/// one, so frames must be given in order and each camera requires its own `Sensor`. Without one, the output depends on
/// the input alone. An input of another size resets the filters.
#[derive(Clone, Debug)]
pub struct Sensor {
    engine: Arc<dyn Engine>,
    filters: Chain,
    random: Stream,
    drifted: Option<DriftedPair>,
}

impl Sensor {
    /// Creates a sensor from an engine and filters, with the random numbers of a camera.
    #[must_use]
    pub fn new(engine: Arc<dyn Engine>, filters: Chain, random: Stream) -> Self {
        Self {
            engine,
            filters,
            random,
            drifted: None,
        }
    }

    /// Returns the sensor with a pair that has drifted since its calibration. Engines that match images are unaffected: their
    /// images show the drift.
    #[must_use]
    pub fn with_drift(self, drifted: Option<DriftedPair>) -> Self {
        Self { drifted, ..self }
    }

    /// The pair that has drifted since its calibration, if it has.
    #[must_use]
    pub const fn drifted(&self) -> Option<&DriftedPair> {
        self.drifted.as_ref()
    }

    /// The engine.
    #[must_use]
    pub fn engine(&self) -> &Arc<dyn Engine> {
        &self.engine
    }

    /// The filters and their state.
    #[must_use]
    pub fn filters(&self) -> &Chain {
        &self.filters
    }

    /// Returns the sensor with other filters, or with the same ones and another memory.
    #[must_use]
    pub fn with_filters(&self, filters: Chain) -> Self {
        Self {
            engine: Arc::clone(&self.engine),
            filters,
            random: self.random,
            drifted: self.drifted,
        }
    }

    /// Returns the sensor with the random numbers of an episode, in which frames count from 0 again, and without a memory of earlier
    /// frames. Episode 0 has the random numbers of this sensor.
    #[must_use]
    pub fn in_episode(&self, number: u64) -> Self {
        let mut fresh = self.clone();
        fresh.filters.reset();
        fresh.random = self.random.episode(number);
        fresh
    }

    /// Returns the filters and their memory.
    #[must_use]
    pub fn into_filters(self) -> Chain {
        self.filters
    }

    /// Whether the output depends on earlier frames.
    #[must_use]
    pub fn remembers(&self) -> bool {
        let is_temporal = |filter: &Filter| matches!(filter, Filter::Temporal(_));
        self.filters.filters().iter().any(is_temporal)
    }

    /// Whether images of this size are measured on several threads; otherwise no thread pool is required.
    #[must_use]
    pub fn is_parallel(&self, width_px: u32, height_px: u32) -> bool {
        !self.filters.is_empty() || self.drifted.is_some() || self.engine.is_parallel(width_px, height_px)
    }

    /// Forgets all earlier frames.
    pub fn reset(&mut self) {
        self.filters.reset();
    }

    /// Returns the camera that the outputs are images of, for inputs of a camera: [decimation](crate::filter::Decimation)
    /// makes its image smaller, and Isaac Sim's sensor [moves](Engine::lateral_shift_m) it.
    #[must_use]
    pub fn output_camera(&self, input: &Camera) -> OutputCamera {
        OutputCamera {
            camera: Camera::new(self.filters.intrinsics(&input.intrinsics), input.lens),
            shift_m: self.engine.lateral_shift_m(&input.intrinsics),
        }
    }

    /// Measures the next input. Of the outputs besides the distance, those in `request` are made if the input suffices;
    /// of the filters, only decimation affects them.
    ///
    /// # Errors
    /// Returns an error if the engine requires another kind of input.
    pub fn capture<'a>(
        &mut self,
        input: impl Into<Input<'a>>,
        request: &[Annotator],
    ) -> Result<Capture, ParameterError> {
        let input = input.into();
        let assumed;
        let input = match (&self.drifted, input) {
            (Some(drifted), Input::Depth(shot)) => {
                assumed = drifted.assumed_depth(shot.depth());
                Input::Depth(shot.with_depth((&assumed).into()))
            }
            (_, input) => input,
        };
        let mut capture = self
            .engine
            .capture(&input, &self.random, request, &mut self.filters)?;
        capture.follow(&self.filters);
        Ok(capture)
    }
}

/// The camera that a sensor's outputs are images of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputCamera {
    /// The intrinsics and the lens.
    pub camera: Camera,
    /// The distance in metres by which it lies to the left of the camera of the input.
    pub shift_m: f64,
}

impl OutputCamera {
    /// Returns the transform from this camera's frame to the frame of the input's camera, metres.
    #[must_use]
    pub fn input_from_output(&self) -> RigidTransform {
        RigidTransform::new(DMat3::IDENTITY, DVec3::new(-self.shift_m, 0.0, 0.0))
    }
}

impl PartialEq for Sensor {
    fn eq(&self, other: &Self) -> bool {
        *self.engine == *other.engine
            && self.filters == other.filters
            && self.random == other.random
            && self.drifted == other.drifted
    }
}

#[cfg(test)]
mod tests;
