//! Converts the arguments of the command to options.

use std::path::PathBuf;

use oaktwin::camera::RigidTransform;
use oaktwin::depth::imager::ColorParameters;
use oaktwin::render::{self, PairUse, RigSpec, Sweep};
use oaktwin::scene::Up;
use oaktwin::sensor::{EngineInput, STEREO_NOISE, SensorOptions};

use super::wanted;
use crate::args::RenderArgs;
use crate::context::Result;
use crate::size;

/// The output folder, if there is one.
pub(super) fn output(args: &RenderArgs) -> Result<Option<PathBuf>> {
    if args.output.is_some() || args.record.is_none() {
        let folder = args.output.clone();
        return Ok(folder.or_else(|| Some(PathBuf::from("oaktwin-render"))));
    }
    let files = [
        ("--png16", args.outputs.png16),
        ("--exr", args.outputs.exr),
        ("--ply", args.outputs.ply),
        ("--preview", args.outputs.preview),
        ("--sweep", !args.sweep.is_empty()),
        ("--pair", args.writes_pair),
    ];
    match files.iter().find(|(_, is_given)| *is_given) {
        Some((option, _)) => {
            Err(format!("{option} writes files beside the recording; set an output folder with -o").into())
        }
        None => Ok(None),
    }
}

/// The cameras, their sensors and what is made of them.
pub(super) fn spec(args: &RenderArgs) -> Result<RigSpec> {
    let sensor = args.sensor.options()?;
    let sweep = sweep(args)?;
    reject_pair_options(args, &sensor, sweep.as_ref())?;
    Ok(RigSpec {
        cameras: args.camera.clone(),
        size: size::parse("--resolution", args.resolution.as_deref())?,
        projection: args.projection,
        annotators: wanted::annotators(args)?,
        is_sensor_optional: wanted::everything(args),
        are_outputs_optional: false,
        sensor,
        pair: args.pair.options(args.unit.lens)?,
        pair_use: match args.writes_pair {
            true => PairUse::Written,
            false => PairUse::Matched,
        },
        sweep,
        rgb_imager: rgb_imager(args)?,
        backend: args.backend,
        transparent: args.transparent,
        shutter: args.shutter.shutter(),
        camera_offsets_ms: args.shutter.camera_offsets_ms()?,
    })
}

/// The image sensor of colours, if there is one.
fn rgb_imager(args: &RenderArgs) -> Result<Option<ColorParameters>> {
    if args.rgb_imager.is_empty() {
        return Ok(None);
    }
    let mut parameters = ColorParameters::default();
    for (name, value) in args.rgb_imager.iter().flatten() {
        parameters
            .set(name, value)
            .map_err(|error| format!("--rgb-imager: {error}"))?;
    }
    Ok(Some(parameters))
}

/// Rejects options of the pair and its light without effect.
fn reject_pair_options(args: &RenderArgs, sensor: &SensorOptions, sweep: Option<&Sweep>) -> Result<()> {
    let given = args.pair.given().or(args.writes_pair.then_some("--pair"));
    let Some(option) = given else { return Ok(()) };
    if args.model.is_none() {
        return Err(format!("{option} requires --model, whose stereo pair it is about").into());
    }
    let swept = sweep.map(|sweep| sweep.options(sensor)).transpose();
    let swept = swept
        .map_err(|error| format!("--sweep: {error}"))?
        .unwrap_or_default();
    let engines = || {
        swept
            .iter()
            .chain([sensor])
            .map(|options| options.engine.as_deref())
    };
    let is_matched = engines().flatten().any(|kind| kind.input == EngineInput::Pair);
    // Without a name, the engine is stereo-noise.
    let has_dots = engines().any(|kind| kind.is_none_or(|kind| *kind == STEREO_NOISE));
    let error = if args.writes_pair || is_matched {
        return Ok(());
    } else if !args.pair.imager.is_empty() {
        "--imager requires --engine stereo-matching or --pair"
    } else if !has_dots {
        "--projector and --ambient require --engine stereo-matching or stereo-noise"
    } else if args.pair.projector.is_none() {
        "--ambient requires --projector, or --engine stereo-matching"
    } else {
        return Ok(());
    };
    Err(error.into())
}

/// The sweep, if there is one.
fn sweep(args: &RenderArgs) -> Result<Option<Sweep>> {
    if args.sweep.is_empty() {
        return Ok(None);
    }
    let sweep = Sweep::parse(args.sweep.iter().map(String::as_str));
    Ok(Some(sweep.map_err(|error| format!("--sweep: {error}"))?))
}

/// The pose of the body, without a trajectory.
pub(super) fn place(args: &RenderArgs, up: Up) -> Result<RigidTransform> {
    if let Some(pose) = args.place.pose()? {
        return Ok(pose);
    }
    match args.place.look_at(up)? {
        Some([eye, target, up]) => {
            render::look_at(eye, target, up).map_err(|error| format!("--look-at: {error}").into())
        }
        None => Ok(RigidTransform::IDENTITY),
    }
}
