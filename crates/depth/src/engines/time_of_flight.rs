use std::borrow::Cow;
use std::sync::Arc;

use oaktwin_camera::{Intrinsics, Usd};
use oaktwin_image::annotation::Annotator;

use super::filters::run_on_metres;
use crate::filter::Chain;
use crate::random::Stream;
use crate::time_of_flight::{Parameters, TimeOfFlight};
use crate::{
    BatchEngine, Capture, Engine, EngineInput, EngineKind, Factory, Input, ParameterError, PresetConfig,
    Setup, Technology,
};

/// The phase model of a time-of-flight camera: [`crate::time_of_flight`].
pub static TIME_OF_FLIGHT: EngineKind = EngineKind {
    name: Cow::Borrowed("time-of-flight"),
    help: Cow::Borrowed("Time-of-flight phase model"),
    input: EngineInput::Depth,
    models: Some(Technology::TimeOfFlight),
    is_default: true,
    parameters: Parameters::names,
    factory: Factory::Function(|setup: &Setup| {
        let mut parameters = Parameters {
            principal_point_px: setup.principal_point_px,
            ..Parameters::new(setup.focal_length_px, setup.width_px)
        };
        if let Some(PresetConfig::TimeOfFlight(config)) = &setup.preset {
            config.apply_to(&mut parameters);
        }
        if let Some(seed) = setup.device_seed {
            parameters = parameters.of_device(seed);
        }
        for (name, value) in &setup.parameters {
            parameters.set(name, value)?;
        }
        Ok(Arc::new(TimeOfFlight::new(parameters)?))
    }),
};

impl Engine for TimeOfFlight {
    fn kind(&self) -> &EngineKind {
        &TIME_OF_FLIGHT
    }

    fn parameters(&self) -> Vec<(&'static str, String)> {
        self.parameters().by_name().collect()
    }

    fn outputs(&self) -> &'static [Annotator] {
        &[Annotator::DepthSensorReason, Annotator::DepthSensorConfidence]
    }

    fn nearest_m(&self, _width_px: u32) -> f64 {
        self.nearest_m()
    }

    fn ages_s(&self) -> Option<[f64; 2]> {
        Some(self.ages_s())
    }

    /// The pixels whose light a pixel receives, and their neighbours, which their normals depend on.
    fn support_px(&self) -> u32 {
        2
    }

    /// The crop has another principal point.
    fn crop(&self, _width_px: u32, crop: &Intrinsics) -> Result<Option<Arc<dyn Engine>>, ParameterError> {
        let centre = crop.principal_point::<Usd>();
        let parameters = Parameters {
            focal_length_px: crop.fx,
            width_px: crop.size.width,
            principal_point_px: Some([centre.x, centre.y]),
            ..*self.parameters()
        };
        Ok(Some(Arc::new(Self::new(parameters)?)))
    }

    fn capture(
        &self,
        input: &Input<'_>,
        random: &Stream,
        request: &[Annotator],
        filters: &mut Chain,
    ) -> Result<Capture, ParameterError> {
        let shot = input.shot(&TIME_OF_FLIGHT)?;
        let wants = |annotator| request.contains(&annotator);
        let (depth, confidence) = if wants(Annotator::DepthSensorConfidence) {
            let (depth, confidence) = self.sense_with_confidence(shot, random);
            (depth, Some(confidence))
        } else {
            (self.sense(shot, random), None)
        };
        let mut reasons = wants(Annotator::DepthSensorReason).then(|| self.reasons(shot, random));
        let filtered = run_on_metres(filters, &depth, shot.rgb(), |_| true, reasons.as_mut());
        let mut capture = Capture::new(depth, filtered);
        capture.add(Annotator::DepthSensorReason, reasons);
        capture.add(Annotator::DepthSensorConfidence, confidence);
        Ok(capture)
    }

    fn batches(&self) -> Option<&dyn BatchEngine> {
        Some(self)
    }
}
