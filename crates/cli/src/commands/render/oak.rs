//! The OAK that is placed in the scene, and what it rules out.

use oaktwin::catalog::Twin;
use oaktwin::diagnostic::Finding;
use oaktwin::render::Rig;
use oaktwin::render::trajectory::TimedPose;
use oaktwin::usd::asset::LensChoice;

use crate::args::RenderArgs;
use crate::context::{Context, Result};

/// Returns the OAK in the scene with the findings of its calibration, if there is one.
pub(super) fn of(context: &Context, args: &RenderArgs) -> Result<Option<(Twin, Vec<Finding>)>> {
    let Some(model) = &args.model else {
        let needs = |option: &str| Err(format!("{option} requires --model").into());
        return match &args.unit {
            unit if unit.calibration.is_some() => needs("--calibration"),
            unit if unit.lens == LensChoice::Fisheye => needs("--lens"),
            _ => Ok(None),
        };
    };
    if args.place.is_none() && args.trajectory.is_none() && args.mount.is_none() {
        return Err(format!(
            "--model {model} requires a pose: --look-at EYE TARGET, --pose, --trajectory or --mount"
        )
        .into());
    }
    Ok(Some(context.twin_with_axes(model, &args.unit, &args.imu.axes)?))
}

/// Rejects a trajectory of several cameras.
pub(super) fn alone(rig: &Rig, path: &[TimedPose]) -> Result<()> {
    match (rig.cameras(), path) {
        ([first, second, more @ ..], [_, ..]) => Err(format!(
            "--trajectory moves one camera, but there are {} ({}, {}{}); choose one with --camera",
            rig.cameras().len(),
            first.path,
            second.path,
            if more.is_empty() { "" } else { ", …" }
        )
        .into()),
        _ => Ok(()),
    }
}
