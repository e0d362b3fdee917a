//! From what was typed to what is meant.

use std::path::PathBuf;

use oaktwin::camera::RigidTransform;
use oaktwin::camera::math::DVec3;
use oaktwin::diagnostic::{Finding, Level};
use oaktwin::image::annotation::Annotator;
use oaktwin::render::{self, OpenOptions, Sweep};
use oaktwin::scene::Up;

use crate::args::RenderArgs;
use crate::context::Result;

/// The folder, where one is to be written.
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
        ("--pair", args.pair.pair),
    ];
    match files.iter().find(|(_, is_asked)| *is_asked) {
        Some((option, _)) => Err(format!(
            "{option} writes files, which --record has no place for: name a folder with -o"
        )
        .into()),
        None => Ok(None),
    }
}

/// What is rendered where nobody says what.
const USUAL: [Annotator; 3] = [
    Annotator::Rgb,
    Annotator::DistanceToImagePlane,
    Annotator::CameraParams,
];

/// Those that are named, and those that a file beside them is made from.
pub(super) fn annotators(args: &RenderArgs) -> Result<Vec<Annotator>> {
    let mut chosen = Vec::new();
    if args.outputs.annotators.is_empty() {
        chosen.extend(USUAL);
    }
    if senses(args) {
        chosen.push(Annotator::DepthSensorDistance);
    }
    for name in &args.outputs.annotators {
        match name.trim() {
            "all" => chosen.extend(Annotator::ALL),
            name => chosen.push(render::annotator(name)?),
        }
    }
    let is_depth = |annotator: &Annotator| {
        matches!(
            annotator,
            Annotator::DistanceToImagePlane | Annotator::DistanceToCamera | Annotator::DepthSensorDistance
        )
    };
    if (args.outputs.png16 || args.outputs.exr || args.outputs.preview) && !chosen.iter().any(is_depth) {
        chosen.push(Annotator::DistanceToImagePlane);
    }
    if args.record.is_some() {
        chosen = render::record_annotators(&chosen);
    }
    if args.outputs.ply && !chosen.contains(&Annotator::DepthSensorPointCloudPosition) {
        chosen.push(Annotator::Pointcloud);
    }
    chosen.sort_unstable();
    chosen.dedup();
    Ok(chosen)
}

/// Whether what a sensor reports is wanted although nobody named it. A sweep has a sheet of its own.
fn senses(args: &RenderArgs) -> bool {
    let is_set = args.outputs.annotators.is_empty() && args.sweep.is_empty() && args.sensor.given().is_some();
    is_set || args.pair.pair
}

/// An option of the depth sensor of which nothing comes.
pub(super) fn unused(args: &RenderArgs, annotators: &[Annotator]) -> Option<Finding> {
    let option = args.sensor.given().filter(|_| args.sweep.is_empty())?;
    let is_used = annotators.iter().any(|one| one.is_of_depth_sensor());
    (!is_used).then(|| {
        Finding::new(
            "sensor-unused",
            Level::Warning,
            option,
            "changes nothing: none of the annotators is what a depth sensor reports",
            "add depth_sensor_distance to --annotators",
        )
    })
}

/// Whether a depth sensor's annotators are wanted only where there is a sensor: nobody named one.
pub(super) fn everything(args: &RenderArgs) -> bool {
    if senses(args) {
        return false;
    }
    let named = args
        .outputs
        .annotators
        .iter()
        .filter_map(|name| render::annotator(name.trim()).ok());
    !named.into_iter().any(Annotator::is_of_depth_sensor)
}

/// The values that are tried; `None` where nobody asked for it.
pub(super) fn sweep(args: &RenderArgs) -> Result<Option<Sweep>> {
    if args.sweep.is_empty() {
        return Ok(None);
    }
    let sweep = Sweep::parse(args.sweep.iter().map(String::as_str));
    Ok(Some(sweep.map_err(|error| format!("--sweep: {error}"))?))
}

pub(super) fn open_options(args: &RenderArgs) -> Result<OpenOptions> {
    if let Some(time) = args.time.filter(|time| !time.is_finite()) {
        return Err(format!("--time {time} is no time; give a finite number").into());
    }
    if let Some(scale) = args.scale.filter(|scale| !(scale.is_finite() && *scale > 0.0)) {
        return Err(format!("--scale {scale} is no scale; give a positive number").into());
    }
    Ok(OpenOptions {
        time: args.time,
        subdivide: args.subdivide,
        up: args.up.map(Into::into),
        scale: args.scale,
    })
}

/// Where the body stands; the poses of a trajectory come later.
pub(super) fn place(args: &RenderArgs, up: Up) -> Result<RigidTransform> {
    if let Some(numbers) = &args.pose {
        let numbers: [f64; 7] = numbers[..].try_into().map_err(|_| "--pose takes 7 numbers")?;
        return Ok(render::pose(numbers).map_err(|error| format!("--pose: {error}"))?);
    }
    let Some(numbers) = &args.look_at else {
        return Ok(RigidTransform::IDENTITY);
    };
    let (points, rest) = numbers.as_chunks::<3>();
    let (eye, target, up) = match (points, rest) {
        ([eye, target], []) => (eye, target, up.direction()),
        ([eye, target, up], []) => (eye, target, DVec3::from(*up)),
        _ => {
            let count = numbers.len();
            return Err(format!("--look-at has {count} numbers: EYE, TARGET and UP are three each").into());
        }
    };
    render::look_at(DVec3::from(*eye), DVec3::from(*target), up)
        .map_err(|error| format!("--look-at: {error}").into())
}
