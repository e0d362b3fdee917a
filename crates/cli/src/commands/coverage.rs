mod asked;
mod lights;
mod motion;
mod text;

use std::path::Path;

use oaktwin::coverage::{self, Coverage, MeasuringRig};
use oaktwin::files::{OutputFiles, WrittenFile};
use oaktwin::image::{Image, png};
use oaktwin::render::Renderer;
use serde::Serialize;

use crate::args::CoverageArgs;
use crate::context::{Context, Exit, Result};
use crate::output;

/// The result of the command.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a Path,
    #[serde(flatten)]
    coverage: &'a Coverage,
    files: &'a [WrittenFile],
}

pub(crate) fn run(context: &Context, args: &CoverageArgs) -> Result<Exit> {
    let region = asked::region(args)?;
    let sweep = coverage::Sweep::parse(args.height.as_deref(), args.tilt.as_deref())?;
    asked::check(args)?;
    args.threads.apply();
    if let Some(folder) = &args.report {
        return lights::run(context, args, &region, &sweep, folder);
    }
    if args.robot.robot().is_some() {
        return motion::run(context, args, &region, &sweep);
    }
    let models = asked::models(context, args, None)?;
    let mut scene = asked::scene(args)?;
    let mut findings = std::mem::take(&mut scene.findings);
    findings.extend(models.findings);
    let placements = asked::placements(args, &sweep, scene.scene.up)?;
    let rigs: Vec<MeasuringRig> = if args.model.is_empty() {
        let (rigs, more) = asked::own_rigs(args, &scene)?;
        findings.extend(more);
        rigs
    } else {
        models.rigs
    };
    let candidates = asked::candidates(args, &rigs, &placements);
    let mut files = args
        .output
        .as_deref()
        .map(OutputFiles::in_folder)
        .transpose()?
        .unwrap_or_default();
    files.protect([args.scene.as_path()].into_iter().chain(args.poses.as_deref()));
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
    if let Some(calibration) = &args.unit.calibration {
        output::say_findings(calibration, &models.calibration_findings);
    }
    output::say_findings(&args.scene, &findings);
    Ok(if measured.is_interrupted {
        Exit::Interrupted
    } else {
        Exit::Success
    })
}

fn report<'a>(args: &'a CoverageArgs, coverage: &'a Coverage, files: &'a [WrittenFile]) -> Report<'a> {
    Report {
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
