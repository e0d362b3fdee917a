use std::borrow::Cow;
use std::sync::Arc;

use oaktwin_camera::Intrinsics;
use oaktwin_image::annotation::Annotator;

use super::filters::{are_of_depth, run_on_disparity, run_on_metres};
use crate::disparity::Subpixel;
use crate::filter::{Chain, Filter};
use crate::random::Stream;
use crate::stereo_noise::{self, Parameters, StereoNoise};
use crate::{
    BatchEngine, Capture, Engine, EngineInput, EngineKind, Factory, Input, ParameterError, PresetConfig,
    Setup, Technology,
};

/// The parametric stereo error model: [`crate::stereo_noise`].
pub static STEREO_NOISE: EngineKind = EngineKind {
    name: Cow::Borrowed("stereo-noise"),
    help: Cow::Borrowed("Parametric stereo error model"),
    input: EngineInput::Depth,
    models: Some(Technology::Stereo),
    is_default: true,
    parameters: Parameters::names,
    factory: Factory::Function(|setup: &Setup| {
        let mut parameters = Parameters::new(setup.platform, setup.stereo(), setup.width_px);
        if let Some(PresetConfig::Stereo(config)) = &setup.preset {
            config.apply_to(&mut parameters);
        }
        parameters.extended_disparity = setup.extended_disparity;
        if let Some(seed) = setup.device_seed {
            parameters = parameters.of_device(seed);
        }
        if ["bias", "pixelLocking", "jitter"]
            .into_iter()
            .any(|name| setup.sets(name))
        {
            parameters.close_range_factor = 1.0;
        }
        for (name, value) in &setup.parameters {
            parameters.set(name, value)?;
        }
        if setup.sets("width") {
            follow_width(&mut parameters, setup);
        }
        Ok(Arc::new(StereoNoise::new(parameters)?))
    }),
};

/// Changes what depends on the width of the matcher's mode, unless it is given by name.
fn follow_width(parameters: &mut Parameters, setup: &Setup) {
    let mut stereo = setup.stereo();
    stereo.focal_length_px *= f64::from(parameters.width_px) / f64::from(setup.width_px.max(1));
    let at_width = Parameters::new(setup.platform, stereo, parameters.width_px);
    if !setup.sets("focalLength") {
        parameters.stereo.focal_length_px = stereo.focal_length_px;
    }
    if !setup.sets("pixelLocking") {
        parameters.pixel_locking_px = at_width.pixel_locking_px;
    }
}

impl Engine for StereoNoise {
    fn kind(&self) -> &EngineKind {
        &STEREO_NOISE
    }

    fn parameters(&self) -> Vec<(&'static str, String)> {
        self.parameters().by_name().collect()
    }

    fn outputs(&self) -> &'static [Annotator] {
        &[Annotator::DepthSensorReason, Annotator::DepthSensorConfidence]
    }

    fn needs_rgb(&self, output: Annotator) -> bool {
        matches!(
            output,
            Annotator::DepthSensorPointCloudColor | Annotator::DepthSensorConfidence
        )
    }

    fn nearest_m(&self, _width_px: u32) -> f64 {
        let p = self.parameters();
        p.stereo.depth(f64::from(p.max_disparity_px()))
    }

    fn support_px(&self) -> u32 {
        let p = self.parameters();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates"
        )]
        let dilation = p.edge_dilation_px.ceil() as u32;
        dilation.saturating_add(p.window_px).min(1024)
    }

    fn disparity_times_depth(&self, _width_px: u32) -> f64 {
        self.parameters().stereo.disparity(1.0)
    }

    fn reach_px(&self, width_px: u32, distance_m: f64) -> f64 {
        let p = self.parameters();
        p.stereo.disparity(distance_m) * f64::from(width_px) / f64::from(p.width_px.max(1))
    }

    fn subpixel(&self) -> Option<Subpixel> {
        Some(self.parameters().subpixel)
    }

    fn needs_full_width(&self, width_px: u32) -> bool {
        self.parameters().width_px != width_px
    }

    fn is_parallel(&self, _width_px: u32, height_px: u32) -> bool {
        height_px as usize > stereo_noise::BAND
    }

    fn crop(&self, width_px: u32, crop: &Intrinsics) -> Result<Option<Arc<dyn Engine>>, ParameterError> {
        if width_px == crop.size.width {
            return Ok(None);
        }
        let mut parameters = *self.parameters();
        parameters.width_px = crop.size.width;
        Ok(Some(Arc::new(Self::new(parameters)?)))
    }

    fn capture(
        &self,
        input: &Input<'_>,
        random: &Stream,
        request: &[Annotator],
        filters: &mut Chain,
    ) -> Result<Capture, ParameterError> {
        let shot = input.shot(&STEREO_NOISE)?;
        let mut reasons = request
            .contains(&Annotator::DepthSensorReason)
            .then(|| self.reasons(shot, random));
        let depth = if are_of_depth(filters) {
            self.sense(shot, random)
        } else {
            let (disparity, p) = (self.disparity(shot, random), self.parameters());
            let max_px = p.max_disparity_px();
            let (filtered, scale) = run_on_disparity(
                filters,
                disparity,
                shot.rgb(),
                max_px,
                p.subpixel,
                reasons.as_mut(),
            );
            self.depth(&filtered, scale)
        };
        if let Some(reasons) = &mut reasons {
            reasons.after_depth(&depth.0);
        }
        let filtered = run_on_metres(filters, &depth, shot.rgb(), Filter::is_of_depth, reasons.as_mut());
        let mut capture = Capture::new(depth, filtered);
        capture.add(Annotator::DepthSensorReason, reasons);
        if request.contains(&Annotator::DepthSensorConfidence) {
            capture.add(Annotator::DepthSensorConfidence, self.confidence(shot));
        }
        Ok(capture)
    }

    fn batches(&self) -> Option<&dyn BatchEngine> {
        Some(self)
    }
}
