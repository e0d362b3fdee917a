//! The outputs that the arguments ask for.

use oaktwin::diagnostic::{Finding, Level};
use oaktwin::image::annotation::Annotator;
use oaktwin::render;

use crate::args::RenderArgs;
use crate::context::Result;

/// The annotators that are named, and those that additional files require.
pub(super) fn annotators(args: &RenderArgs) -> Result<Vec<Annotator>> {
    let mut chosen = Vec::new();
    if args.outputs.annotators.is_empty() {
        chosen.extend(render::DEFAULT_ANNOTATORS);
    }
    if senses(args) {
        chosen.push(Annotator::DepthSensorDistance);
    }
    for name in &args.outputs.annotators {
        match name.trim() {
            "all" => chosen.extend(Annotator::all()),
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

/// Whether sensor outputs are implied by other options. A sweep has its own sheet.
fn senses(args: &RenderArgs) -> bool {
    let is_set = args.outputs.annotators.is_empty() && args.sweep.is_empty() && given(args).is_some();
    is_set || args.writes_pair
}

/// The first option of the depth sensor that was given. The seed may belong to another sensor.
fn given(args: &RenderArgs) -> Option<String> {
    match args.imu.imu.is_some() || !args.rgb_imager.is_empty() {
        true => args.sensor.given_but_seed(),
        false => args.sensor.given(),
    }
}

/// A warning about an option without effect.
pub(super) fn unused(args: &RenderArgs, annotators: &[Annotator]) -> Option<Finding> {
    if !args.rgb_imager.is_empty() && !annotators.contains(&Annotator::Rgb) {
        return Some(Finding::new(
            "imager-unused",
            Level::Warning,
            "--rgb-imager",
            "has no effect: rgb is not among the annotators",
            "add rgb to --annotators",
        ));
    }
    let option = given(args).filter(|_| args.sweep.is_empty())?;
    let is_used = annotators.iter().any(|one| one.is_depth_sensor());
    (!is_used).then(|| {
        Finding::new(
            "sensor-unused",
            Level::Warning,
            option,
            "has no effect: none of the annotators is a sensor output",
            "add depth_sensor_distance to --annotators",
        )
    })
}

/// Whether sensor outputs are optional, because none is named.
pub(super) fn everything(args: &RenderArgs) -> bool {
    if senses(args) {
        return false;
    }
    let named = args
        .outputs
        .annotators
        .iter()
        .filter_map(|name| render::annotator(name.trim()).ok());
    !named.into_iter().any(Annotator::is_depth_sensor)
}
