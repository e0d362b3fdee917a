use std::borrow::Cow;
use std::sync::Arc;

use oaktwin_base::diagnostic::{Finding, Level, fold_name};
use oaktwin_camera::Intrinsics;
use oaktwin_image::ImageView;
use oaktwin_image::annotation::Annotator;

use super::filters::{run_on_disparity, run_on_metres};
use crate::disparity::Subpixel;
use crate::filter::{Chain, Filter};
use crate::random::Stream;
use crate::stereo_matching::{Parameters, StereoMatching, inspect, platform_of};
use crate::{
    Capture, Engine, EngineInput, EngineKind, Factory, FixedDisparity, Input, ParameterError, PresetConfig,
    Setup, Technology, stereo_noise,
};

/// The stereo matcher: [`crate::stereo_matching`].
pub static STEREO_MATCHING: EngineKind = EngineKind {
    name: Cow::Borrowed("stereo-matching"),
    help: Cow::Borrowed("Stereo matching of a rectified pair, as on the device"),
    input: EngineInput::Pair,
    models: Some(Technology::Stereo),
    is_default: false,
    parameters: || [Parameters::names(), vec![CALIBRATION_ERROR]].concat(),
    factory: Factory::Function(|setup: &Setup| {
        let mut parameters = Parameters::new(setup.platform, setup.stereo(), setup.width_px);
        if let Some(PresetConfig::Stereo(config)) = &setup.preset {
            config.apply_to_matching(&mut parameters);
        }
        parameters.extended_disparity |= setup.extended_disparity;
        calibration_error_px(setup)?;
        for (name, value) in &setup.parameters {
            if !is_calibration_error(name) {
                parameters.set(name, value)?;
            }
        }
        Ok(Arc::new(StereoMatching::new(parameters)?))
    }),
};

/// The parameter that belongs to the pair and not to its matcher.
const CALIBRATION_ERROR: &str = "bias";

/// Paths of the matcher cross the whole image; a pixel farther away than this changes a disparity by about a tenth of a
/// pixel at most, px.
const PATHS_PX: u32 = 128;

/// Whether a parameter of the matcher belongs to the pair: its calibration error, px of disparity.
#[must_use]
pub fn is_calibration_error(name: &str) -> bool {
    fold_name(name) == fold_name(CALIBRATION_ERROR)
}

/// Returns the error of the disparities of a unit's pair in pixels of the mode's full width: the parameter `bias`, else
/// the bias drawn from the device seed as for [`stereo_noise`](crate::stereo_noise), else 0.
///
/// # Errors
/// Returns an error if the bias is out of range.
pub fn calibration_error_px(setup: &Setup) -> Result<f64, ParameterError> {
    let mut parameters = stereo_noise::Parameters::new(setup.platform, setup.stereo(), setup.width_px);
    if let Some(seed) = setup.device_seed {
        parameters = parameters.of_device(seed);
    }
    for (name, value) in &setup.parameters {
        if is_calibration_error(name) {
            parameters.set(CALIBRATION_ERROR, value)?;
        }
    }
    Ok(parameters.bias_px)
}

impl Engine for StereoMatching {
    fn kind(&self) -> &EngineKind {
        &STEREO_MATCHING
    }

    fn parameters(&self) -> Vec<(&'static str, String)> {
        self.parameters().by_name().collect()
    }

    fn outputs(&self) -> &'static [Annotator] {
        &[
            Annotator::Disparity,
            Annotator::Confidence,
            Annotator::DepthSensorReason,
            Annotator::DepthSensorConfidence,
        ]
    }

    fn nearest_m(&self, _width_px: u32) -> f64 {
        let p = self.parameters();
        p.stereo.depth(f64::from(p.max_disparity_px()))
    }

    fn support_px(&self) -> u32 {
        PATHS_PX
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

    fn baseline_m(&self) -> Option<f64> {
        Some(self.parameters().stereo.baseline_m)
    }

    fn needs_full_width(&self, width_px: u32) -> bool {
        self.parameters().width_px != width_px
    }

    fn crop(&self, width_px: u32, crop: &Intrinsics) -> Result<Option<Arc<dyn Engine>>, ParameterError> {
        if width_px == crop.size.width {
            return Ok(None);
        }
        let mut parameters = *self.parameters();
        parameters.kernel_mask = parameters.mask_at(width_px as usize);
        parameters.width_px = crop.size.width;
        Ok(Some(Arc::new(Self::new(parameters)?)))
    }

    fn inspect(&self, input: &Input<'_>) -> Vec<Finding> {
        let pair = input.pair(&STEREO_MATCHING);
        pair.map_or_else(|_| Vec::new(), |pair| inspect(pair, self.parameters()))
    }

    fn without_effect(&self, place: &str, names: &[&str]) -> Option<Finding> {
        let own = self.parameters().platform;
        let is_of_other = |name: &&str| platform_of(name).is_some_and(|platform| platform != own);
        let names: Vec<&str> = names.iter().copied().filter(is_of_other).collect();
        (!names.is_empty()).then(|| {
            Finding::new(
                "other-platform",
                Level::Warning,
                place,
                format!(
                    "{} has no effect on {}",
                    names.join(", "),
                    own.name().to_uppercase()
                ),
                "leave it out, or set the parameter platform",
            )
        })
    }

    /// The colour image of filters is the left image.
    fn capture(
        &self,
        input: &Input<'_>,
        _random: &Stream,
        request: &[Annotator],
        filters: &mut Chain,
    ) -> Result<Capture, ParameterError> {
        let (pair, p) = (input.pair(&STEREO_MATCHING)?, self.parameters());
        let wants = |annotator| request.contains(&annotator);
        let (matched, mut reasons) = match wants(Annotator::DepthSensorReason) {
            true => {
                let (matched, reasons) = self.explained(pair);
                (matched, Some(reasons))
            }
            false => (self.disparity(pair), None),
        };
        let needs_rgb = filters.filters().iter().any(Filter::needs_rgb);
        let rgb = needs_rgb.then(|| pair.left().picture());
        let rgb = rgb.as_ref().map(ImageView::from);
        let max_px = p.max_disparity_px();
        let (disparity, scale) = run_on_disparity(
            filters,
            matched.disparity,
            rgb,
            max_px,
            p.subpixel,
            reasons.as_mut(),
        );
        let depth = self.depth(&disparity, scale, pair.width());
        if let Some(reasons) = &mut reasons {
            reasons.after_depth(&depth.0);
        }
        let filtered = run_on_metres(filters, &depth, rgb, Filter::is_of_depth, reasons.as_mut());
        let mut capture = Capture::new(depth, filtered);
        let disparity = wants(Annotator::Disparity).then(|| FixedDisparity {
            fixed: disparity,
            step_px: p.subpixel.step_px() / scale,
            shift_px: p.disparity_shift_px,
        });
        capture.add(Annotator::Disparity, disparity);
        let levels =
            wants(Annotator::DepthSensorConfidence).then(|| matched.confidence.map(|byte| u16::from(*byte)));
        capture.add(Annotator::DepthSensorConfidence, levels);
        let confidence = wants(Annotator::Confidence).then_some(matched.confidence);
        capture.add(Annotator::Confidence, confidence);
        capture.add(Annotator::DepthSensorReason, reasons);
        Ok(capture)
    }
}
