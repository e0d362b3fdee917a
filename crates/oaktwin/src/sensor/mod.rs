//! The sensor of a twin: from its catalog entry or calibration to a [`Sensor`] that turns ground truth into what the
//! device would report.

mod options;
mod parameters;

use oaktwin_depth::filter::Chain;
use oaktwin_depth::random::Stream;
use oaktwin_depth::single_view::{Assumptions, SingleView};
use oaktwin_depth::stereo_noise::StereoNoise;
pub use oaktwin_depth::{Capture, Engine, ParameterError, Sensor, Shot, single_view};

pub use options::{EngineKind, SensorOptions};
pub use parameters::{single_view_parameters, stereo_noise_parameters};

use crate::camera::Intrinsics;
use crate::catalog::{DepthKind, Twin, TwinDepthSensor};
use crate::diagnostic::{Finding, Level};

/// How much an image's focal length, at the width of the twin's, may differ from it and still be the twin's: the
/// rounding of single precision, in which USD holds its cameras.
const SAME_FOCAL_LENGTH: f64 = 1e-5;

/// The sensor of a twin; the findings are what about it is not as the twin says.
///
/// # Errors
/// An engine that the sensor cannot have; a parameter that does not exist or is out of its range.
pub fn sensor(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    let kind = options
        .engine
        .unwrap_or_else(|| EngineKind::default_for(sensor.spec.kind));
    match kind {
        EngineKind::SingleView => {
            let mut findings = Vec::new();
            let mut parameters = single_view_parameters(sensor, options.extended_disparity, options.isaac);
            if let Some(image) = own_focal_length(twin, sensor, options, &mut findings) {
                parameters.focal_length_px =
                    image.fx * parameters.sensor_size_px / f64::from(image.size.width);
            }
            let (sensor, more) = of_render_product(&sensor.spec.prim, parameters, options)?;
            findings.extend(more);
            Ok((sensor, findings))
        }
        EngineKind::StereoNoise => stereo_noise(twin, sensor, options),
    }
}

/// Isaac Sim's sensor of these parameters, those of a render product say, whose virtual camera has this name; of the
/// options the engine, the range of disparities and the image do not matter.
///
/// # Errors
/// A parameter that does not exist or is out of its range.
pub fn of_render_product(
    prim: &str,
    parameters: single_view::Parameters,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    refuse_unknown(options)?;
    let engine = Engine::SingleView(SingleView::new(parameters, Assumptions::default())?);
    let random = Stream::new(options.seed, prim);
    Ok((Sensor::new(engine, Chain::default(), random), Vec::new()))
}

fn stereo_noise(
    twin: &Twin,
    sensor: &TwinDepthSensor,
    options: &SensorOptions,
) -> Result<(Sensor, Vec<Finding>), ParameterError> {
    refuse_unknown(options)?;
    let parameters = stereo_noise_parameters(twin)
        .filter(|_| sensor.spec.kind == DepthKind::Stereo)
        .ok_or_else(|| ParameterError {
            name: "engine".to_owned(),
            what: format!("{} is no stereo sensor", sensor.spec.prim),
            remedy: "use single-view, or the stereo sensor".to_owned(),
        })?;
    let mut parameters = match options.device_seed {
        Some(seed) => parameters.of_device(seed),
        None => parameters,
    };
    parameters.extended_disparity = options.extended_disparity;
    let mut findings = Vec::new();
    if let Some(image) = own_focal_length(twin, sensor, options, &mut findings) {
        parameters.stereo.focal_length_px =
            image.fx * f64::from(parameters.width_px) / f64::from(image.size.width);
    }
    let engine = Engine::StereoNoise(StereoNoise::new(parameters)?);
    let random = Stream::new(options.seed, &sensor.spec.prim);
    Ok((Sensor::new(engine, Chain::default(), random), findings))
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

fn refuse_unknown(options: &SensorOptions) -> Result<(), ParameterError> {
    let unknown = options.parameters.iter().map(|(name, _)| name);
    let unknown = unknown.chain(&options.filters).chain(&options.preset).next();
    match unknown {
        Some(name) => Err(ParameterError {
            name: name.clone(),
            what: "is not known".to_owned(),
            remedy: "leave it out".to_owned(),
        }),
        None => Ok(()),
    }
}
