//! The sensor of a twin: from its catalog entry or calibration to a [`Sensor`] that turns ground truth into what the
//! device would report.

mod configure;
mod matching;
mod options;
mod parameter_file;
mod parameters;

use oaktwin_depth::random::Stream;
use oaktwin_depth::single_view::{Assumptions, SingleView};
use oaktwin_depth::stereo_noise::{self, StereoNoise};
use oaktwin_depth::time_of_flight::{self, TimeOfFlight};
pub use oaktwin_depth::{Capture, Engine, FixedDisparity, ParameterError, Sensor, Shot, single_view};

use configure::Preset;
pub(crate) use matching::needs_a_pair;
pub use matching::{calibration_error_px, platform, stereo_matching};
pub use options::{EngineKind, SensorOptions};
pub use parameter_file::ParameterFile;
pub use parameters::{
    single_view_parameters, stereo_matching_parameters, stereo_noise_parameters, time_of_flight_parameters,
};

use oaktwin_camera::{Intrinsics, StereoGeometry};
use oaktwin_catalog::{DepthKind, Twin, TwinDepthSensor};
use oaktwin_diagnostic::{Finding, Level};

/// How much an image's focal length, at the width of the twin's, may differ from it and still be the twin's: the
/// rounding of single precision, in which USD holds its cameras.
const SAME_FOCAL_LENGTH: f64 = 1e-5;

/// The sensor of a twin; the findings are what about it is not as the twin says.
///
/// The order is: the twin's own parameters, the images' focal length, the preset, the range of disparities, the device's
/// bias, then what is named.
///
/// # Errors
/// An engine that the sensor cannot have; a preset, filter or parameter that does not exist or is out of its range.
pub fn sensor(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    let kind = options
        .engine
        .unwrap_or_else(|| EngineKind::default_for(sensor.spec.kind));
    let mut findings = Vec::new();
    let own = own_focal_length(twin, sensor, options, &mut findings);
    let preset = Preset::of(twin, sensor.spec.kind, options)?;
    if let Some(preset) = &preset {
        findings.push(preset.finding(options, kind, &sensor.spec.prim));
    }
    let is_extended = options.extended_disparity
        || matches!(&preset, Some(Preset::Stereo(config)) if config.extended_disparity);
    let engine = match kind {
        EngineKind::SingleView => {
            let mut parameters = single_view_parameters(sensor, is_extended, options.isaac);
            if let Some(image) = own {
                parameters.focal_length_px =
                    image.fx * parameters.sensor_size_px / f64::from(image.size.width);
            }
            single_view(parameters, options)?
        }
        EngineKind::StereoNoise => {
            let mut parameters = stereo_noise_parameters(twin)
                .filter(|_| sensor.spec.kind == DepthKind::Stereo)
                .ok_or_else(|| ParameterError {
                    name: "engine".to_owned(),
                    what: format!("{} is no stereo sensor", sensor.spec.prim),
                    remedy: "use time-of-flight, single-view, or the stereo sensor".to_owned(),
                })?;
            if let Some(image) = own {
                parameters.stereo.focal_length_px =
                    image.fx * f64::from(parameters.width_px) / f64::from(image.size.width);
            }
            if let Some(Preset::Stereo(config)) = &preset {
                config.apply_to(&mut parameters);
            }
            parameters.extended_disparity = is_extended;
            if let Some(seed) = options.device_seed {
                parameters = parameters.of_device(seed);
            }
            configure::set_stereo_noise(&mut parameters, options)?;
            Engine::StereoNoise(StereoNoise::new(parameters)?)
        }
        EngineKind::StereoMatching => matching::of_twin(twin, sensor, own, preset.as_ref(), options)?,
        EngineKind::TimeOfFlight => {
            let camera = twin
                .camera(sensor.spec.camera)
                .filter(|_| sensor.spec.kind == DepthKind::Tof)
                .ok_or_else(|| ParameterError {
                    name: "engine".to_owned(),
                    what: format!("{} is no time-of-flight sensor", sensor.spec.prim),
                    remedy: "use stereo-noise, single-view, or the time-of-flight sensor".to_owned(),
                })?;
            let mut image = options.image.unwrap_or(camera.intrinsics);
            if own.is_none() {
                // The twin's, however images that were read say it.
                let scale = f64::from(image.size.width) / f64::from(camera.intrinsics.size.width);
                image.fx = camera.intrinsics.fx * scale;
            }
            let mut parameters = time_of_flight_parameters(image);
            if let Some(Preset::TimeOfFlight(config)) = &preset {
                config.apply_to(&mut parameters);
            }
            if let Some(seed) = options.device_seed {
                parameters = parameters.of_device(seed);
            }
            configure::set_time_of_flight(&mut parameters, options)?;
            Engine::TimeOfFlight(TimeOfFlight::new(parameters)?)
        }
    };
    findings.extend(matching::without_effect(&engine, options, &sensor.spec.prim));
    let filters = configure::chain(options, preset.as_ref())?;
    let name = options.name.as_deref().unwrap_or(&sensor.spec.prim);
    Ok((
        Sensor::new(engine, filters, Stream::new(options.seed, name)),
        findings,
    ))
}

/// The sensor of these parameters, those of a render product say, whose virtual camera has this name: Isaac Sim's, unless
/// the options name another engine, which then has, on an image as wide as the simulated sensor, their focal length, and
/// if of stereo their baseline. The findings say which of the options a render product has no use for.
///
/// # Errors
/// A filter or parameter that does not exist or is out of its range.
pub fn of_render_product(
    prim: &str,
    parameters: single_view::Parameters,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    let kind = options.engine.unwrap_or(EngineKind::SingleView);
    let is_stereo = kind == EngineKind::StereoNoise;
    let has_devices = kind != EngineKind::SingleView;
    let engine = match kind {
        EngineKind::SingleView => single_view(parameters, options)?,
        EngineKind::StereoNoise => stereo_noise(&parameters, options)?,
        EngineKind::TimeOfFlight => time_of_flight(&parameters, options)?,
        EngineKind::StereoMatching => return Err(needs_a_pair("a render product has one camera")),
    };
    let filters = configure::chain(options, None)?;
    let name = options.name.as_deref().unwrap_or(prim);
    let ignored = [
        (options.preset.is_some(), "preset"),
        (
            options.extended_disparity && !is_stereo,
            "extended range of disparities",
        ),
        (options.device_seed.is_some() && !has_devices, "seed of a device"),
    ];
    let findings = ignored.iter().filter(|(given, _)| *given).map(|(_, what)| {
        Finding::new(
            "ignored",
            Level::Warning,
            prim,
            format!("a render product has no {what}: it is left out"),
            "set its parameters by name",
        )
    });
    let findings = findings.collect();
    Ok((
        Sensor::new(engine, filters, Stream::new(options.seed, name)),
        findings,
    ))
}

/// The stereo pair that a render product's parameters describe.
fn stereo_noise(
    product: &single_view::Parameters,
    options: &SensorOptions,
) -> Result<Engine, ParameterError> {
    product.check()?;
    let stereo = StereoGeometry {
        focal_length_px: product.focal_length_px,
        baseline_m: product.baseline_mm.abs() / 1000.0,
    };
    let mut parameters = stereo_noise::Parameters::new(stereo, width_px(product));
    parameters.extended_disparity = options.extended_disparity;
    if let Some(seed) = options.device_seed {
        parameters = parameters.of_device(seed);
    }
    configure::set_stereo_noise(&mut parameters, options)?;
    Ok(Engine::StereoNoise(StereoNoise::new(parameters)?))
}

/// The time-of-flight camera that a render product's parameters describe.
fn time_of_flight(
    product: &single_view::Parameters,
    options: &SensorOptions,
) -> Result<Engine, ParameterError> {
    product.check()?;
    let mut parameters = time_of_flight::Parameters::new(product.focal_length_px, width_px(product));
    if let Some(seed) = options.device_seed {
        parameters = parameters.of_device(seed);
    }
    configure::set_time_of_flight(&mut parameters, options)?;
    Ok(Engine::TimeOfFlight(TimeOfFlight::new(parameters)?))
}

/// How wide the simulated sensor is.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the cast saturates, and widths out of range are refused"
)]
fn width_px(product: &single_view::Parameters) -> u32 {
    product.sensor_size_px.round() as u32
}

fn single_view(
    mut parameters: single_view::Parameters,
    options: &SensorOptions,
) -> Result<Engine, ParameterError> {
    let mut assumptions = Assumptions::default();
    configure::set_single_view(&mut parameters, &mut assumptions, options)?;
    Ok(Engine::SingleView(SingleView::new(parameters, assumptions)?))
}

/// The images' intrinsics where their field of view is not that of the sensor's camera: said.
fn own_focal_length(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    options: &SensorOptions,
    findings: &mut Vec<Finding>,
) -> Option<Intrinsics> {
    let image = options.image?;
    let own = twin.camera(sensor.spec.camera)?.intrinsics;
    let at_own_width = image.fx * f64::from(own.size.width) / f64::from(image.size.width);
    // Written so that what is no number is not the same.
    if (at_own_width - own.fx).abs() <= SAME_FOCAL_LENGTH * own.fx {
        return None;
    }
    findings.push(Finding::new(
        "own-focal-length",
        Level::Note,
        &sensor.spec.prim,
        format!(
            "the images' focal length is {at_own_width:.2} px at a width of {} px, the model's {:.2} px: the images' is used",
            own.size.width, own.fx
        ),
        "",
    ));
    Some(image)
}

#[cfg(test)]
mod tests;
