//! The report of `coverage` by day and by night.

use std::path::Path;

use oaktwin::coverage::{self, InLight, InLights, LIGHTS, MeasuringRig, PlacementSweep, Region};
use oaktwin::diagnostic::add_new;
use oaktwin::files::OutputFiles;
use oaktwin::image::png;
use oaktwin::render::Renderer;

use super::rigs::{self, Models};
use super::{asked, finish, text};
use crate::args::CoverageArgs;
use crate::context::{Context, Exit, Result};
use crate::output;

pub(super) fn run(
    context: &Context,
    args: &CoverageArgs,
    region: &Region,
    sweep: &PlacementSweep,
    folder: &Path,
) -> Result<Exit> {
    let mut scene = asked::scene(args)?;
    let mut findings = std::mem::take(&mut scene.findings);
    let placements = asked::placements(args, sweep, scene.scene.up)?;
    let mut files = OutputFiles::in_folder(folder)?;
    files.protect([args.scene.as_path()].into_iter().chain(args.poses.as_deref()));
    let of_light = |(_, ambient): (&str, f64)| rigs::of_models(context, args, Some(ambient));
    let models: Vec<Models> = LIGHTS.into_iter().map(of_light).collect::<Result<_>>()?;
    let renderer = Renderer::new(scene.scene);
    let mut lights = Vec::new();
    for ((name, ambient), models) in LIGHTS.into_iter().zip(&models) {
        models.rigs.iter().try_for_each(MeasuringRig::check_memory)?;
        let candidates = coverage::candidates(&models.rigs, &placements);
        let coverage = asked::measure(args, &renderer, region, &candidates)?;
        if coverage.is_interrupted {
            output::say("interrupted: no report is written");
            return Ok(Exit::Interrupted);
        }
        // Both lights have mostly the same.
        add_new(
            &mut findings,
            models.findings.iter().chain(&coverage.findings).cloned(),
        );
        lights.push(InLight {
            name,
            ambient,
            coverage,
        });
    }
    let report = InLights {
        scene: args.scene.display().to_string(),
        tolerance_mm: args.tolerance,
        lights,
    };
    for candidate in report.best() {
        for (light, models) in models.iter().enumerate() {
            let shares = &report.lights[light].coverage.candidates[candidate].shares;
            let candidates = coverage::candidates(&models.rigs, &placements);
            let picture = coverage::picture(&renderer, region, &candidates[candidate], shares)?;
            files.write(
                Path::new(&picture_name(candidate, light)),
                &png::encode(&picture)?,
            )?;
        }
    }
    files.write(Path::new("report.csv"), report.to_csv().as_bytes())?;
    files.write(Path::new("report.html"), report.to_html(picture_name).as_bytes())?;
    for in_light in &report.lights {
        output::print(&format!(
            "By {}\n{}\n",
            in_light.name,
            text::report(&in_light.coverage, &[])
        ))?;
    }
    output::print(&text::written(files.files()))?;
    let calibration_findings = models
        .first()
        .map_or(&[][..], |models| &models.calibration_findings);
    let of_files = [
        (args.unit.calibration.as_deref(), calibration_findings),
        (Some(args.scene.as_path()), &findings),
    ];
    Ok(finish(&of_files, false))
}

/// The name of the picture of a candidate in a light.
fn picture_name(candidate: usize, light: usize) -> String {
    let name = LIGHTS.get(light).map_or("", |(name, _)| name);
    format!("candidate_{candidate}_{name}.png")
}
