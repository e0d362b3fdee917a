mod asked;
mod lights;
mod motion;
mod motion_text;
mod rigs;
mod text;

use std::path::Path;

use oaktwin::coverage::{self, Coverage, MeasuringRig};
use oaktwin::diagnostic::Finding;
use oaktwin::files::{OutputFiles, WrittenFile};
use oaktwin::image::{Image, png};
use oaktwin::render::Renderer;
use serde::Serialize;

use crate::args::CoverageArgs;
use crate::context::{Context, Exit, Result};
use crate::output;

/// The result of the command.
#[derive(Serialize)]
struct CoverageReport<'a> {
    scene: &'a Path,
    #[serde(flatten)]
    coverage: &'a Coverage,
    files: &'a [WrittenFile],
}

pub(crate) fn run(context: &Context, args: &CoverageArgs) -> Result<Exit> {
    let region = asked::region(args)?;
    let sweep = coverage::PlacementSweep::parse(args.height.as_deref(), args.tilt.as_deref())?;
    asked::check(args)?;
    args.threads.apply();
    if let Some(folder) = &args.report {
        return lights::run(context, args, &region, &sweep, folder);
    }
    if args.robot.robot().is_some() {
        return motion::run(context, args, &region, &sweep);
    }
    let models = rigs::of_models(context, args, None)?;
    let mut scene = asked::scene(args)?;
    let mut findings = std::mem::take(&mut scene.findings);
    findings.extend(models.findings);
    let placements = asked::placements(args, &sweep, scene.scene.up)?;
    let rigs = rigs::of(args, models.rigs, &scene, &mut findings)?;
    let candidates = asked::candidates(args, &rigs, &placements);
    let mut files = asked::output_files(args)?;
    rigs.iter().try_for_each(MeasuringRig::check_memory)?;
    let renderer = Renderer::new(scene.scene);
    let measured = asked::measure(args, &renderer, &region, &candidates)?;
    if args.output.is_some()
        && let Some(&best) = measured.ranking.first()
    {
        let shares = &measured.candidates[best].shares;
        let picture = coverage::picture(&renderer, &region, &candidates[best], shares)?;
        write(args, &measured, &picture, &mut files)?;
    }
    findings.extend(measured.findings.iter().cloned());
    if measured.is_interrupted {
        output::say(&format!(
            "interrupted: {} of {} candidates are complete",
            measured.candidates.len(),
            candidates.len()
        ));
    }
    if args.json {
        output::print_json(&report(args, &measured, files.files()))?;
    } else {
        output::print(&text::report(&measured, files.files()))?;
    }
    let of_files = [
        (
            args.unit.calibration.as_deref(),
            models.calibration_findings.as_slice(),
        ),
        (Some(args.scene.as_path()), &findings),
    ];
    Ok(finish(&of_files, measured.is_interrupted))
}

/// Prints the findings about each file, and returns the exit status of the command.
fn finish(of_files: &[(Option<&Path>, &[Finding])], is_interrupted: bool) -> Exit {
    for (file, findings) in of_files {
        if let Some(file) = file {
            output::say_findings(file, findings);
        }
    }
    match is_interrupted {
        true => Exit::Interrupted,
        false => Exit::Success,
    }
}

fn report<'a>(
    args: &'a CoverageArgs,
    coverage: &'a Coverage,
    files: &'a [WrittenFile],
) -> CoverageReport<'a> {
    CoverageReport {
        scene: &args.scene,
        coverage,
        files,
    }
}

/// Writes the files of a folder.
fn write(
    args: &CoverageArgs,
    coverage: &Coverage,
    picture: &Image<[u8; 3]>,
    files: &mut OutputFiles,
) -> Result<()> {
    files.write(Path::new("coverage.csv"), coverage.to_csv().as_bytes())?;
    let json = serde_json::to_string_pretty(&report(args, coverage, &[]))? + "\n";
    files.write(Path::new("coverage.json"), json.as_bytes())?;
    files.write(Path::new("coverage.png"), &png::encode(picture)?)?;
    Ok(())
}
