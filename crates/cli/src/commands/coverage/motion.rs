//! `coverage` over the postures of a robot.

use std::path::Path;

use oaktwin::coverage::{self, Carrier, MeasuringRig, MotionCoverage, PlacementSweep, Region};
use oaktwin::files::WrittenFile;
use oaktwin::image::png;
use oaktwin::render::Renderer;
use oaktwin::scene::Up;
use serde::Serialize;

use super::{asked, finish, motion_text, rigs};
use crate::args::{CoverageArgs, OpenedRobot};
use crate::context::{Context, Exit, Result};
use crate::{output, progress};

/// The result of the command.
#[derive(Serialize)]
struct MotionCoverageReport<'a> {
    scene: &'a Path,
    robot: Option<&'a Path>,
    mount: Option<&'a str>,
    #[serde(flatten)]
    coverage: &'a MotionCoverage,
    files: &'a [WrittenFile],
}

pub(super) fn run(
    context: &Context,
    args: &CoverageArgs,
    region: &Region,
    sweep: &PlacementSweep,
) -> Result<Exit> {
    let models = rigs::of_models(context, args, None)?;
    let mut scene = asked::scene(args)?;
    let mut findings = std::mem::take(&mut scene.findings);
    findings.extend(models.findings);
    let robot = args.robot.open(&mut scene.scene, args.mount.as_deref())?;
    let OpenedRobot {
        placed,
        link,
        positions,
        findings: robot_findings,
    } = robot.ok_or("--robot is missing")?;
    // In the frame of a link, z is up, whatever the scene's up axis is.
    let up = if link.is_some() { Up::Z } else { scene.scene.up };
    let placements = asked::placements(args, sweep, up)?;
    let rigs = rigs::of(args, models.rigs, &scene, &mut findings)?;
    let mounts = asked::candidates(args, &rigs, &placements);
    let mut files = asked::output_files(args)?;
    rigs.iter().try_for_each(MeasuringRig::check_memory)?;
    let mut renderer = Renderer::new(scene.scene);
    let carrier = Carrier {
        robot: &placed,
        link,
        postures: &positions.positions,
    };
    let options = asked::options(args);
    let measured = progress::watched(|watch| {
        coverage::measure_motion(&mut renderer, region, &carrier, &mounts, &options, watch)
    })?;
    if args.output.is_some()
        && let Some(&best) = measured.ranking.first()
    {
        let (mount, best) = (&mounts[best], &measured.mounts[best]);
        files.write(Path::new("coverage.csv"), measured.to_csv().as_bytes())?;
        let json = serde_json::to_string_pretty(&report(args, &measured, &[]))? + "\n";
        files.write(Path::new("coverage.json"), json.as_bytes())?;
        let picture = carrier.picture(&mut renderer, region, mount, best)?;
        files.write(Path::new("coverage.png"), &png::encode(&picture)?)?;
        let own = carrier.own_robot_picture(&mut renderer, mount, best);
        files.write(Path::new("own_robot.png"), &png::encode(&own)?)?;
    }
    findings.extend(measured.findings.iter().cloned());
    if measured.is_interrupted {
        let complete: usize = measured.mounts.iter().map(|mount| mount.postures.len()).sum();
        let wanted = mounts.len() * positions.positions.len();
        output::say(&format!(
            "interrupted: {complete} of {wanted} measurements are complete"
        ));
    }
    if args.json {
        output::print_json(&report(args, &measured, files.files()))?;
    } else {
        output::print(&motion_text::report(&measured, files.files()))?;
    }
    let of_files = [
        (
            args.unit.calibration.as_deref(),
            models.calibration_findings.as_slice(),
        ),
        (args.robot.robot(), &robot_findings),
        (Some(args.scene.as_path()), &findings),
    ];
    Ok(finish(&of_files, measured.is_interrupted))
}

fn report<'a>(
    args: &'a CoverageArgs,
    coverage: &'a MotionCoverage,
    files: &'a [WrittenFile],
) -> MotionCoverageReport<'a> {
    MotionCoverageReport {
        scene: &args.scene,
        robot: args.robot.robot(),
        mount: args.mount.as_deref(),
        coverage,
        files,
    }
}
