//! The sensor of a twin, a render product or a stereo pair: an engine with its filters, made from options.

mod choose;
mod drift;
mod frame;
mod latency;
mod matching;
mod median;
mod option;
mod options;
mod options_file;
mod parameter_file;
mod parameters;
mod preset;
mod setup;
#[cfg(test)]
mod tests;

pub use oaktwin_base::parameter::Scalar;
pub use oaktwin_depth::engines::{
    ENGINES, SINGLE_VIEW, STEREO_MATCHING, STEREO_NOISE, TIME_OF_FLIGHT, calibration_error_px,
};
pub use oaktwin_depth::{
    Capture, CaptureLayer, DepthShot, Engine, EngineInput, EngineKind, EngineRef, Factory, FixedDisparity,
    Input, OutputCamera, ParameterError, Sensor, Setup, Technology, single_view,
};

pub use choose::{depth_sensor, stereo_cameras};
pub(crate) use frame::{capture, frame, sensor_view};
pub use latency::latency;
pub(crate) use matching::needs_a_pair;
pub use matching::stereo_matching;
pub use option::{OptionValue, SENSOR_OPTIONS, SensorOption, assignment};
pub(crate) use options::models;
pub use options::{Illumination, SensorOptions, default_engine};
pub use parameter_file::ParameterFile;
pub use parameters::{single_view_parameters, stereo_noise_parameters, time_of_flight_parameters};

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_catalog::{Source, Twin, TwinDepthSensor};
use oaktwin_depth::PresetConfig;
use oaktwin_depth::filter::{self, Chain};
use oaktwin_depth::preset::Platform;
use oaktwin_depth::random::Stream;

use setup::GeometrySource;

/// Creates the depth sensor of a twin. The findings report where it deviates from the twin.
///
/// Values override each other in this order: the twin's own parameters, the focal length of the images, the preset, the
/// extended disparity range, the bias of the unit, then parameters by name.
///
/// # Errors
/// Returns an error if the engine does not suit the sensor, or if a preset, filter or parameter is unknown or out of range.
pub fn sensor(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    let kind = &options.engine_for(sensor.spec.kind);
    let source = GeometrySource::twin(twin, sensor, options);
    let (made, mut findings) = create(kind, &source, options, &sensor.spec.prim)?;
    findings.extend(foreign_processing(twin, kind, &sensor.spec.prim));
    Ok((made, findings))
}

/// Returns a note if an engine models the processing of OAKs, and the device is of another maker.
pub(crate) fn foreign_processing(twin: &Twin, kind: &EngineKind, place: &str) -> Option<Finding> {
    // Engines of other crates model what they like.
    let is_ours = ENGINES.contains(&kind);
    let what = match kind.models.filter(|_| is_ours)? {
        Technology::Stereo => "the stereo matcher of an OAK with RVC2",
        Technology::TimeOfFlight => "the time-of-flight sensor of the OAK-D ToF",
    };
    let device = &twin.device;
    let is_foreign = twin.platform().is_none() && device.source != Source::User;
    is_foreign.then(|| {
        Finding::new(
            "foreign-processing",
            Level::Note,
            place,
            format!(
                "{} models {what}; the processing of {} is not published",
                kind.name, device.manufacturer
            ),
            "",
        )
    })
}

/// Creates the sensor of a render product with NVIDIA's attributes, whose virtual camera has this name. The default engine
/// is Isaac Sim's; others have, at the width of the simulated sensor, its focal length and baseline. The findings report
/// options without effect.
///
/// # Errors
/// Returns an error if a filter or parameter is unknown or out of range.
pub fn of_render_product(
    prim: &str,
    attributes: single_view::Parameters,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    let kind = options.engine.as_deref().unwrap_or(&SINGLE_VIEW);
    if kind.input == EngineInput::Pair {
        return Err(needs_a_pair(kind, "a render product has one camera"));
    }
    let ignored = [
        (options.preset.is_some(), "preset"),
        (
            options.extended_disparity && kind.models != Some(Technology::Stereo),
            "extended disparity range",
        ),
        (
            options.device_seed.is_some() && kind.models.is_none(),
            "device seed",
        ),
    ];
    let ignored = ignored.iter().filter(|(given, _)| *given).map(|(_, what)| {
        Finding::new(
            "ignored",
            Level::Warning,
            prim,
            format!("a render product has no {what}; the option is ignored"),
            "set its parameters by name",
        )
    });
    let mut findings: Vec<Finding> = ignored.collect();
    let (sensor, more) = create(kind, &GeometrySource::Product(&attributes), options, prim)?;
    findings.extend(more);
    Ok((sensor, findings))
}

/// Creates a sensor; `place` is where findings are reported, and by default the camera's name.
fn create(
    kind: &EngineKind,
    source: &GeometrySource<'_>,
    options: &SensorOptions,
    place: &str,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    let mut findings = Vec::new();
    let mut setup = setup::setup(kind, source, options, &mut findings)?;
    let drifted = drift::pair(kind, source, options, &setup, place, &mut findings)?;
    if let Some(pair) = &drifted {
        drift::add_loss(pair, &mut setup);
    }
    if let Some(preset) = &setup.preset {
        findings.push(preset::finding(preset, options, kind, place));
    }
    let engine = kind.create(&setup)?;
    let names: Vec<&str> = setup.parameters.iter().map(|(name, _)| name.as_str()).collect();
    findings.extend(engine.without_effect(place, &names));
    let mut filters = if options.filters.is_empty() {
        setup
            .preset
            .as_ref()
            .map(PresetConfig::filters)
            .unwrap_or_default()
    } else {
        let filters = options.filters.iter().map(|text| filter::parse(text));
        filters.collect::<Result<_, _>>()?
    };
    if source.platform(&setup) == Some(Platform::Rvc2) {
        findings.extend(median::switch_off(&mut filters, engine.as_ref(), place));
    }
    let name = options.name.as_deref().unwrap_or(place);
    let random = Stream::new(options.seed, name);
    let sensor = Sensor::new(engine, Chain::new(filters), random).with_drift(drifted);
    Ok((sensor, findings))
}
