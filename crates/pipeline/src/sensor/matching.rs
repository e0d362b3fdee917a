//! The matcher of a stereo pair: of a twin, or of any.

use oaktwin_depth::preset::Platform;
use oaktwin_depth::random::Stream;
use oaktwin_depth::stereo_matching::{Parameters, StereoMatching, platform_of};
use oaktwin_depth::{Engine, ParameterError, Sensor, stereo_noise};

use super::configure::{self, CALIBRATION_ERROR, Preset};
use super::{EngineKind, SensorOptions, stereo_matching_parameters};
use oaktwin_camera::{Intrinsics, StereoGeometry};
use oaktwin_catalog::{DepthKind, Twin, TwinDepthSensor};
use oaktwin_diagnostic::{Finding, Level, fold_name};

/// The sensor of a rectified pair whose images are `width_px` wide and have this focal length and baseline; `place` is what
/// the findings call it. The images' own calibration error is in them: there is no other.
///
/// # Errors
/// A preset, filter or parameter that does not exist or is out of its range.
pub fn stereo_matching(
    platform: Platform,
    stereo: StereoGeometry,
    width_px: u32,
    place: &str,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    if let Some((name, _)) = options
        .parameters
        .iter()
        .find(|(name, _)| is_calibration_error(name))
    {
        return Err(ParameterError {
            name: name.clone(),
            what: "a pair that was taken has the error of its own calibration".to_owned(),
            remedy: "leave it out".to_owned(),
        });
    }
    let preset = options.preset.as_deref();
    let preset = preset.map(|name| Preset::of_stereo(platform, name)).transpose()?;
    let mut findings: Vec<Finding> = preset
        .iter()
        .map(|preset| preset.finding(options, EngineKind::StereoMatching, place))
        .collect();
    let parameters = Parameters::new(platform, stereo, width_px);
    let engine = configured(parameters, preset.as_ref(), options)?;
    findings.extend(without_effect(&engine, options, place));
    let filters = configure::chain(options, preset.as_ref())?;
    Ok((
        Sensor::new(engine, filters, Stream::new(options.seed, place)),
        findings,
    ))
}

/// By how much disparities of the options' device are too large, px of the mode's full width: the parameter `bias`, else
/// what the seed of a device draws, as for [`stereo_noise`]; else 0.
///
/// # Errors
/// A bias that is out of its range.
pub fn calibration_error_px(options: &SensorOptions) -> Result<f64, ParameterError> {
    // Of its other parameters nothing is asked.
    let any = StereoGeometry {
        focal_length_px: 800.0,
        baseline_m: 0.075,
    };
    let mut parameters = stereo_noise::Parameters::new(any, 1280);
    if let Some(seed) = options.device_seed {
        parameters = parameters.of_device(seed);
    }
    for (name, value) in &options.parameters {
        if is_calibration_error(name) {
            parameters.set(CALIBRATION_ERROR, value)?;
        }
    }
    Ok(parameters.bias_px)
}

fn is_calibration_error(name: &str) -> bool {
    fold_name(name) == fold_name(CALIBRATION_ERROR)
}

/// The engine of a twin.
pub(super) fn of_twin(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    own: Option<Intrinsics>,
    preset: Option<&Preset>,
    options: &SensorOptions,
) -> Result<Engine, ParameterError> {
    // A device of a processor that is not known is taken for the most usual one.
    let platform = platform(twin).unwrap_or(Platform::Rvc2);
    let mut parameters = stereo_matching_parameters(twin, platform)
        .filter(|_| sensor.spec.kind == DepthKind::Stereo)
        .ok_or_else(|| ParameterError {
            name: "engine".to_owned(),
            what: format!("{} is no stereo sensor", sensor.spec.prim),
            remedy: "use single-view, or the stereo sensor".to_owned(),
        })?;
    if let Some(image) = own {
        parameters.stereo.focal_length_px =
            image.fx * f64::from(parameters.width_px) / f64::from(image.size.width);
    }
    calibration_error_px(options)?;
    configured(parameters, preset, options)
}

fn configured(
    mut parameters: Parameters,
    preset: Option<&Preset>,
    options: &SensorOptions,
) -> Result<Engine, ParameterError> {
    if let Some(Preset::Stereo(config)) = preset {
        config.apply_to_matching(&mut parameters);
    }
    parameters.extended_disparity |= options.extended_disparity;
    configure::set_stereo_matching(&mut parameters, options)?;
    Ok(Engine::StereoMatching(StereoMatching::new(parameters)?))
}

/// Parameters that are another processor's than the engine's.
pub(super) fn without_effect(engine: &Engine, options: &SensorOptions, place: &str) -> Option<Finding> {
    let Engine::StereoMatching(engine) = engine else {
        return None;
    };
    let own = engine.parameters().platform;
    let is_of_other = |name: &&str| platform_of(name).is_some_and(|platform| platform != own);
    let given = options.parameters.iter().map(|(name, _)| name.as_str());
    let names: Vec<&str> = given.filter(is_of_other).collect();
    (!names.is_empty()).then(|| {
        Finding::new(
            "other-platform",
            Level::Warning,
            place,
            format!("on {} {} has no effect", own.name(), names.join(", ")),
            "leave it out, or set the parameter platform",
        )
    })
}

/// The processor of a twin's device; `None` where it is not known.
#[must_use]
pub fn platform(twin: &Twin) -> Option<Platform> {
    configure::platform(twin).ok()
}

/// That depth alone is no pair.
pub(crate) fn needs_a_pair(what: &str) -> ParameterError {
    ParameterError {
        name: "engine".to_owned(),
        what: format!("stereo-matching needs a pair of images, and {what}"),
        remedy: "render a model's pair, match existing pairs, or use stereo-noise".to_owned(),
    }
}
