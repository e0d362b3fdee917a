//! `coverage` over the postures of a robot.

use std::fmt::Write;
use std::path::Path;

use oaktwin::catalog::Table;
use oaktwin::coverage::{
    self, CandidateCoverage, Carrier, MeasuringRig, MotionCoverage, MountCoverage, Region, Sweep,
};
use oaktwin::files::{OutputFiles, WrittenFile};
use oaktwin::image::png;
use oaktwin::render::Renderer;
use oaktwin::scene::Up;
use serde::Serialize;

use super::asked;
use super::text::{hiding, losses, millimetres, percent, region as region_text};
use crate::args::{CoverageArgs, OpenedRobot};
use crate::context::{Context, Exit, Result};
use crate::{output, progress};

/// The maximum number of mounts, or postures, in a table.
const MAX_ROWS: usize = 20;

/// The maximum number of links in a row.
const MAX_LINKS: usize = 3;

/// The result of the command.
#[derive(Serialize)]
struct Report<'a> {
    scene: &'a Path,
    robot: Option<&'a Path>,
    mount: Option<&'a str>,
    #[serde(flatten)]
    coverage: &'a MotionCoverage,
    files: &'a [WrittenFile],
}

pub(super) fn run(context: &Context, args: &CoverageArgs, region: &Region, sweep: &Sweep) -> Result<Exit> {
    let models = asked::models(context, args, None)?;
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
    let rigs: Vec<MeasuringRig> = if args.model.is_empty() {
        let (rigs, more) = asked::own_rigs(args, &scene)?;
        findings.extend(more);
        rigs
    } else {
        models.rigs
    };
    let mounts = asked::candidates(args, &rigs, &placements);
    let folder = args.output.as_deref().map(OutputFiles::in_folder).transpose()?;
    let mut files = folder.unwrap_or_default();
    let inputs = [args.scene.as_path()].into_iter().chain(args.poses.as_deref());
    files.protect(inputs.chain(args.robot.files()));
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
        files.write(Path::new("coverage.csv"), measured.to_csv().as_bytes())?;
        let json = serde_json::to_string_pretty(&report(args, &measured, &[]))? + "\n";
        files.write(Path::new("coverage.json"), json.as_bytes())?;
        let picture = carrier.picture(&mut renderer, region, &mounts[best], &measured.mounts[best])?;
        files.write(Path::new("coverage.png"), &png::encode(&picture)?)?;
        let own = carrier.own_robot_picture(&mut renderer, &mounts[best], &measured.mounts[best]);
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
        output::print(&text(&measured, files.files()))?;
    }
    if let Some(calibration) = &args.unit.calibration {
        output::say_findings(calibration, &models.calibration_findings);
    }
    if let Some(file) = args.robot.robot() {
        output::say_findings(file, &robot_findings);
    }
    output::say_findings(&args.scene, &findings);
    Ok(if measured.is_interrupted {
        Exit::Interrupted
    } else {
        Exit::Success
    })
}

fn report<'a>(args: &'a CoverageArgs, coverage: &'a MotionCoverage, files: &'a [WrittenFile]) -> Report<'a> {
    Report {
        scene: &args.scene,
        robot: args.robot.robot(),
        mount: args.mount.as_deref(),
        coverage,
        files,
    }
}

fn text(coverage: &MotionCoverage, files: &[WrittenFile]) -> String {
    let mut text = region_text(&coverage.region);
    if let Some(&best) = coverage.ranking.first() {
        let _ = writeln!(text, "\nOver the whole motion");
        text += &output::number_table(&mounts(coverage));
        let hidden = coverage.ranking.len().saturating_sub(MAX_ROWS);
        if hidden > 0 {
            let _ = writeln!(text, "{hidden} more are in the CSV file and in the JSON output.");
        }
        let best = &coverage.mounts[best];
        if best.postures.len() > 1 {
            let _ = writeln!(text, "\nPostures of #1");
            text += &output::number_table(&postures(best));
            text += &remarks(best);
        }
    }
    for file in files {
        let _ = writeln!(text, "Written: {}", file.path.display());
    }
    text
}

fn mounts(coverage: &MotionCoverage) -> Table {
    let header = [
        "Rank",
        "Model",
        "Measured",
        "Seen",
        "Median error",
        "95 %",
        "Own robot",
        "Pose",
        "Lost",
    ];
    let row = |(rank, &index): (usize, &usize)| {
        let mount = &coverage.mounts[index];
        let shares = &mount.together;
        vec![
            rank.to_string(),
            mount.model.clone(),
            percent(shares.measured),
            percent(shares.seen),
            millimetres(shares.median_absolute_error_mm),
            millimetres(shares.p95_absolute_error_mm),
            percent(mount.own_robot),
            mount.name.clone(),
            losses(shares),
        ]
    };
    Table {
        title: String::new(),
        header: header.map(str::to_owned).to_vec(),
        rows: (1..).zip(&coverage.ranking).take(MAX_ROWS).map(row).collect(),
    }
}

fn postures(mount: &MountCoverage) -> Table {
    let header = [
        "Posture",
        "Measured",
        "Seen",
        "Median error",
        "Own robot",
        "Links in view",
        "Lost",
    ];
    let row = |(number, posture): (usize, &CandidateCoverage)| {
        let shares = &posture.shares;
        let own = posture.own_robot.clone().unwrap_or_default();
        let links = own.links.iter().take(MAX_LINKS);
        let links: Vec<String> = links
            .map(|(link, share)| format!("{link} {}", percent(*share)))
            .collect();
        vec![
            number.to_string(),
            percent(shares.measured),
            percent(shares.seen),
            millimetres(shares.median_absolute_error_mm),
            percent(own.share),
            links.join(", "),
            losses(shares),
        ]
    };
    Table {
        title: String::new(),
        header: header.map(str::to_owned).to_vec(),
        rows: mount
            .postures
            .iter()
            .enumerate()
            .take(MAX_ROWS)
            .map(row)
            .collect(),
    }
}

/// What the table of the postures does not contain.
fn remarks(mount: &MountCoverage) -> String {
    let mut text = "\n".to_owned();
    let hidden = mount.postures.len().saturating_sub(MAX_ROWS);
    if hidden > 0 {
        let _ = writeln!(
            text,
            "{hidden} more postures are in the CSV file and in the JSON output."
        );
    }
    if mount.selection.len() > 1 {
        let chosen = (mount.selection.iter())
            .map(|selected| format!("{} {}", selected.candidate, percent(selected.measured)));
        let _ = writeln!(
            text,
            "Best combination of postures, measured so far after each: {}",
            chosen.collect::<Vec<_>>().join(", ")
        );
    }
    let worst = (mount.postures.iter()).max_by(|a, b| {
        let hides = |one: &CandidateCoverage| one.occluders.iter().map(|hiding| hiding.share).sum::<f64>();
        hides(a).total_cmp(&hides(b))
    });
    if let Some(worst) = worst.filter(|worst| !worst.occluders.is_empty()) {
        let _ = writeln!(
            text,
            "Most is hidden in {}: by {}",
            worst.name,
            hiding(&worst.occluders)
        );
    }
    text
}
