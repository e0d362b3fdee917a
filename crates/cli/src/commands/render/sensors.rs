//! The depth sensors of the cameras that are rendered.

use oaktwin::camera::ImageSize;
use oaktwin::diagnostic::{Finding, Level};
use oaktwin::image::annotation::Annotator;
use oaktwin::pair::{PairCameras, PairOptions};
use oaktwin::render::{self, DepthSensorOptions, PlacedCamera, SweptSensors};
use oaktwin::sensor::{EngineInput, Sensor};

use super::{Oak, request};
use crate::args::RenderArgs;
use crate::context::Result;

/// The depth sensors of the cameras and of a sweep.
#[derive(Default)]
pub(super) struct Sensors {
    pub(super) own: Vec<Option<Sensor>>,
    pub(super) swept: Option<SweptSensors>,
    pub(super) findings: Vec<Finding>,
}

impl Sensors {
    /// Creates the sensors that the annotators or a sweep require.
    pub(super) fn new(
        args: &RenderArgs,
        annotators: &[Annotator],
        cameras: &[PlacedCamera],
        oak: Option<&Oak>,
    ) -> Result<Self> {
        let sweep = request::sweep(args)?;
        if !annotators.iter().any(|one| one.is_depth_sensor()) && sweep.is_none() {
            return Ok(Self::default());
        }
        let sensor = args.sensor.options()?;
        let options = DepthSensorOptions {
            twin: oak.map(|oak| &oak.twin),
            sensor: &sensor,
        };
        let in_file = |error| format!("{}: {error}", args.scene.display());
        let (own, mut findings) = render::depth_sensors(cameras, &options).map_err(in_file)?;
        if sweep.is_some() || !request::everything(args) {
            findings.extend(without_sensor(args, oak, cameras, &own)?);
        }
        let swept = sweep
            .map(|sweep| SweptSensors::new(sweep, cameras, &options))
            .transpose()
            .map_err(in_file)?;
        Ok(Self { own, swept, findings })
    }
}

/// The stereo pair for stereo-matching, which also becomes the camera of its depth sensors.
pub(super) fn pair(
    args: &RenderArgs,
    cameras: &mut [PlacedCamera],
    oak: Option<&Oak>,
    size: Option<ImageSize>,
) -> Result<Option<(PairCameras, Vec<Finding>)>> {
    let options = args.sensor.options()?;
    let sweep = request::sweep(args)?;
    let is_swept = sweep.as_ref().map(|sweep| sweep.options(&options)).transpose();
    let all = is_swept
        .map_err(|error| format!("--sweep: {error}"))?
        .unwrap_or_default();
    let mut engines = all.iter().chain([&options]).map(|options| options.engine);
    if !engines.any(|engine| engine.is_some_and(|kind| kind.input == EngineInput::Pair)) {
        let given = args.writes_pair.then_some("--pair");
        return match args.pair.given().or(given) {
            Some(option) => Err(format!("{option} requires --engine stereo-matching").into()),
            None => Ok(None),
        };
    }
    let Some(oak) = oak else {
        return Err(
            "--engine stereo-matching requires the stereo pair of an OAK; place one in the scene with --model, or use stereo-noise"
                .into(),
        );
    };
    let bias_px = options.calibration_error_px()?;
    for swept in &all {
        if swept.calibration_error_px()?.to_bits() != bias_px.to_bits() {
            return Err(
                "--sweep bias: not supported with stereo-matching, which renders the pair once; run with each --param bias="
                    .into(),
            );
        }
    }
    let pair = PairOptions {
        size,
        ..args.pair.options(args.unit.lens)?.of_sensor(&options)?
    };
    Ok(Some(render::put_pair(&oak.twin, cameras, &pair)?))
}

/// Notes about cameras without a depth sensor; an error if none has one.
fn without_sensor(
    args: &RenderArgs,
    oak: Option<&Oak>,
    cameras: &[PlacedCamera],
    sensors: &[Option<Sensor>],
) -> Result<Vec<Finding>> {
    let both = cameras.iter().zip(sensors);
    let without = both
        .filter(|(_, sensor)| sensor.is_none())
        .map(|(camera, _)| camera);
    if let (true, Some(first)) = (sensors.iter().all(Option::is_none), cameras.first()) {
        let remedy = match oak.map(|oak| &oak.twin) {
            Some(twin) if twin.depth_sensors.is_empty() => {
                format!("choose a model with one: {}", twin.device.models_with_depth(None))
            }
            Some(_) => "choose --camera depth".to_owned(),
            None => {
                "choose a render product with OmniSensorDepthSensorSingleViewAPI, or place an OAK in the scene with --model"
                    .to_owned()
            }
        };
        let more = if cameras.len() > 1 {
            " and the other cameras have"
        } else {
            " has"
        };
        return Err(format!(
            "{}: {}{more} no depth sensor, which depth_sensor_* and --sweep require; {remedy}",
            args.scene.display(),
            first.path
        )
        .into());
    }
    Ok(without
        .map(|camera| {
            Finding::new(
                "no-depth-sensor",
                Level::Note,
                &camera.path,
                "has no depth sensor; its sensor outputs are skipped",
                "",
            )
        })
        .collect())
}
