use std::borrow::Cow;
use std::sync::Arc;

use oaktwin_camera::Intrinsics;
use oaktwin_image::annotation::Annotator;

use super::filters::run_on_metres;
use crate::filter::Chain;
use crate::random::Stream;
use crate::single_view::{Assumptions, Direction, OutputMode, Parameters, SingleView, Wanted};
use crate::{BatchEngine, Capture, Engine, EngineInput, EngineKind, Factory, Input, ParameterError, Setup};

/// Isaac Sim's `DepthSensorDistance`: [`crate::single_view`].
pub static SINGLE_VIEW: EngineKind = EngineKind {
    name: Cow::Borrowed("single-view"),
    help: Cow::Borrowed("Isaac Sim's DepthSensorDistance"),
    input: EngineInput::Depth,
    models: None,
    is_default: false,
    parameters: || {
        let alias = vec!["outlierRemovalRange"];
        [Parameters::names(), alias, Assumptions::names()].concat()
    },
    factory: Factory::Function(|setup: &Setup| {
        let (mut parameters, mut assumptions) = (setup.attributes, Assumptions::default());
        for (name, value) in &setup.parameters {
            if Assumptions::names().contains(&name.as_str()) {
                assumptions.set(name, value)?;
            } else {
                parameters.set(name, value)?;
            }
        }
        Ok(Arc::new(SingleView::new(parameters, assumptions)?))
    }),
};

impl Engine for SingleView {
    fn kind(&self) -> &EngineKind {
        &SINGLE_VIEW
    }

    fn parameters(&self) -> Vec<(&'static str, String)> {
        let mut parameters: Vec<_> = self.parameters().by_name().collect();
        parameters.sort_unstable();
        parameters
    }

    fn assumptions(&self) -> Vec<(&'static str, String)> {
        self.assumptions().by_name().collect()
    }

    fn outputs(&self) -> &'static [Annotator] {
        &[
            Annotator::DepthSensorPointCloudPosition,
            Annotator::DepthSensorPointCloudColor,
            Annotator::DepthSensorImager,
            Annotator::DepthSensorOutputVisualization,
            Annotator::DepthSensorReason,
            Annotator::DepthSensorConfidence,
        ]
    }

    fn needs_rgb(&self, output: Annotator) -> bool {
        match output {
            Annotator::DepthSensorImager
            | Annotator::DepthSensorPointCloudColor
            | Annotator::DepthSensorConfidence => true,
            Annotator::DepthSensorOutputVisualization => {
                self.parameters().rgb_depth_output_mode == OutputMode::Color
            }
            _ => false,
        }
    }

    fn nearest_m(&self, width_px: u32) -> f64 {
        let p = self.parameters();
        let by_disparity = self.disparity_times_depth(width_px) / p.max_disparity_px;
        p.min_distance_m.max(by_disparity)
    }

    fn support_px(&self) -> u32 {
        self.parameters().outlier_removal_range_px
    }

    fn disparity_times_depth(&self, width_px: u32) -> f64 {
        self.parameters().disparity_times_depth(width_px).abs()
    }

    fn reach_px(&self, width_px: u32, distance_m: f64) -> f64 {
        self.parameters().disparity_times_depth(width_px) / distance_m
    }

    /// The sensor moves what the camera renders to where its left imager sees it.
    fn lateral_shift_m(&self, camera: &Intrinsics) -> f64 {
        let moved = self.parameters().disparity_times_depth(camera.size.width);
        let sign = match self.assumptions().direction {
            Direction::Right => 1.0,
            Direction::Left => -1.0,
        };
        sign * moved / camera.fx
    }

    fn crop(&self, width_px: u32, crop: &Intrinsics) -> Result<Option<Arc<dyn Engine>>, ParameterError> {
        if width_px == crop.size.width {
            return Ok(None);
        }
        let mut parameters = *self.parameters();
        parameters.sensor_size_px *= f64::from(crop.size.width) / f64::from(width_px);
        Ok(Some(Arc::new(Self::new(parameters, *self.assumptions())?)))
    }

    fn capture(
        &self,
        input: &Input<'_>,
        random: &Stream,
        request: &[Annotator],
        filters: &mut Chain,
    ) -> Result<Capture, ParameterError> {
        let shot = input.shot(&SINGLE_VIEW)?;
        let wants = |annotator| request.contains(&annotator);
        let wanted = Wanted {
            positions: wants(Annotator::DepthSensorPointCloudPosition),
            colors: wants(Annotator::DepthSensorPointCloudColor),
            imager: wants(Annotator::DepthSensorImager),
            view: wants(Annotator::DepthSensorOutputVisualization),
            reasons: wants(Annotator::DepthSensorReason),
            confidence: wants(Annotator::DepthSensorConfidence),
        };
        let mut output = self.sense(shot, random, wanted);
        let reasons = output.reasons.as_mut();
        let filtered = run_on_metres(filters, &output.distance, shot.rgb(), |_| true, reasons);
        let mut capture = Capture::new(output.distance, filtered);
        capture.add(Annotator::DepthSensorPointCloudPosition, output.positions);
        capture.add(Annotator::DepthSensorPointCloudColor, output.colors);
        capture.add(Annotator::DepthSensorImager, output.imager);
        capture.add(Annotator::DepthSensorOutputVisualization, output.view);
        capture.add(Annotator::DepthSensorReason, output.reasons);
        capture.add(Annotator::DepthSensorConfidence, output.confidence);
        Ok(capture)
    }

    fn batches(&self) -> Option<&dyn BatchEngine> {
        Some(self)
    }
}
