//! The inertial sensor of the model along the trajectory.

use std::ops::ControlFlow;

use oaktwin::catalog::Twin;
use oaktwin::diagnostic::Finding;
use oaktwin::files::{self, WrittenFile};
use oaktwin::imu::{self, ImuOptions, ImuSimulation};
use oaktwin::render::trajectory::TimedPose;
use oaktwin::scene::Up;
use serde::Serialize;

use crate::args::RenderArgs;
use crate::context::{Context, Result};
use crate::{destination, progress};

/// The file of the samples.
#[derive(Debug, Serialize)]
pub(super) struct ImuReport {
    #[serde(flatten)]
    pub(super) file: WrittenFile,
    pub(super) part: String,
    pub(super) rate_hz: f64,
    pub(super) samples: u64,
}

/// Returns the samples, if they are requested.
pub(super) fn simulation(
    context: &Context,
    args: &RenderArgs,
    twin: Option<&Twin>,
    path: &[TimedPose],
    up: Up,
) -> Result<Option<(ImuSimulation, Vec<Finding>)>> {
    if args.imu.imu.is_none() {
        return Ok(None);
    }
    let Some(file) = &args.trajectory else {
        return Err("--imu requires --trajectory, a file of timed poses".into());
    };
    let Some(twin) = twin else {
        return Err("--imu requires --model, whose inertial sensor is simulated".into());
    };
    let part = imu::inertial_part(&context.catalog, &twin.device, args.imu.imu_part.as_deref())?;
    let motion = imu::motion(path).map_err(|error| format!("{}: {error}", file.display()))?;
    let options = ImuOptions {
        rate_hz: args.imu.imu_rate,
        seed: args.sensor.options()?.seed,
    };
    let simulation = ImuSimulation::new(twin, part, motion, up, options);
    match simulation {
        Err(error) if error.is_of_trajectory => Err(format!("{}: {error}", file.display()).into()),
        simulation => Ok(Some(simulation?)),
    }
}

/// Writes the samples, if they are requested. Breaks if the program is interrupted.
pub(super) fn write(
    samples: Option<ImuSimulation>,
    args: &RenderArgs,
) -> Result<ControlFlow<(), Option<ImuReport>>> {
    let (Some(samples), Some(path)) = (samples, &args.imu.imu) else {
        return Ok(ControlFlow::Continue(None));
    };
    let inputs = [&args.trajectory, &args.unit.calibration];
    let inputs = inputs.into_iter().map(Option::as_deref);
    destination::spare_inputs(path, inputs.chain([Some(args.scene.as_path())]))?;
    if let (Some(output), Some(folder)) = (&args.output, path.parent())
        && folder.starts_with(output)
    {
        files::make_folder(folder)?;
    }
    let (part, rate_hz, count) = (
        samples.part().to_owned(),
        samples.rate_hz(),
        samples.sample_count(),
    );
    // The sequence's own stamps.
    let samples = match args.writer.as_str() {
        "euroc" => {
            let first_ns = samples.first_ns();
            samples.in_sequence(first_ns)
        }
        _ => samples,
    };
    let written = progress::watched(|watch| imu::write_euroc(samples, path, watch))?;
    Ok(match written {
        Some(file) => ControlFlow::Continue(Some(ImuReport {
            file,
            part,
            rate_hz,
            samples: count,
        })),
        None => ControlFlow::Break(()),
    })
}
