use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::StereoGeometry;
use oaktwin_depth::engines::is_calibration_error;
use oaktwin_depth::preset::Platform;
use oaktwin_depth::{EngineInput, EngineKind, ParameterError, Sensor};

use super::setup::GeometrySource;
use super::{STEREO_MATCHING, SensorOptions, create};

/// Creates the sensor of a rectified pair of this geometry at the width of its images; findings are reported at `place`. The engine is
/// `stereo-matching`, unless another one that matches pairs is chosen.
///
/// # Errors
/// Returns an error if a preset, filter or parameter is unknown or out of range, or if a calibration error is given: the
/// images contain the error of their own calibration.
pub fn stereo_matching(
    platform: Platform,
    stereo: StereoGeometry,
    width_px: u32,
    place: &str,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    let mut parameters = options.parameters.iter();
    if let Some((name, _)) = parameters.find(|(name, _)| is_calibration_error(name)) {
        return Err(ParameterError {
            name: name.clone(),
            what: "recorded pairs contain the error of their own calibration".to_owned(),
            remedy: "remove it".to_owned(),
        });
    }
    let source = GeometrySource::Pair {
        platform,
        stereo,
        width_px,
    };
    let plain = SensorOptions {
        name: Some(place.to_owned()),
        ..options.clone()
    };
    let chosen = options.engine.as_deref();
    let matcher = chosen.filter(|kind| kind.input == EngineInput::Pair);
    create(matcher.unwrap_or(&STEREO_MATCHING), &source, &plain, place)
}

/// The error of an engine that requires a pair where there is none.
pub(crate) fn needs_a_pair(engine: &EngineKind, reason: &str) -> ParameterError {
    ParameterError {
        name: "engine".to_owned(),
        what: format!("{engine} requires a stereo pair, but {reason}"),
        remedy: "render a model's pair, match existing pairs, or use stereo-noise".to_owned(),
    }
}
