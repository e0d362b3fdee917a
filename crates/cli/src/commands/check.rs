use std::fmt::Write;

use oaktwin::diagnostic::{self, Level};
use oaktwin::usd::check::{
    CheckOptions, CheckReport, PinholeReport, ResolutionSource, UsdCameraReport, UsdDepthReport, check,
};

use crate::args::CheckArgs;
use crate::context::{Context, Exit, Result};
use crate::output;

pub(crate) fn run(context: &Context, args: &CheckArgs) -> Result<Exit> {
    let model = args
        .model
        .as_deref()
        .map(|name| context.device(name))
        .transpose()?;
    let model = model.map(|device| context.catalog.nominal(device));
    let report = check(
        &args.file,
        &CheckOptions {
            catalog: &context.catalog,
            model: model.as_ref(),
            limit: args.scene_limit,
        },
    )?;
    if args.json {
        output::print_json(&report)?;
    } else {
        output::print(&text(&report))?;
    }
    Ok(if report.worst() >= Some(Level::Warning) {
        Exit::Findings
    } else {
        Exit::Success
    })
}

fn text(report: &CheckReport) -> String {
    let mut out = format!("{}\n", report.file);
    for camera in &report.cameras {
        camera_text(&mut out, camera);
    }
    for sensor in &report.depth_sensors {
        depth_text(&mut out, sensor);
    }
    let findings = diagnostic::group(&report.findings);
    if !findings.is_empty() {
        let _ = writeln!(out);
    }
    for group in &findings {
        let _ = writeln!(out, "{group}");
    }
    let count = |level, name: &str| {
        let n = findings.iter().filter(|group| group.level() == level).count();
        format!("{n} {name}{}", if n == 1 { "" } else { "s" })
    };
    let _ = writeln!(
        out,
        "\n{}, {}, {}",
        count(Level::Error, "error"),
        count(Level::Warning, "warning"),
        count(Level::Note, "note")
    );
    out
}

fn camera_text(out: &mut String, camera: &UsdCameraReport) {
    let model = camera
        .model
        .as_ref()
        .map_or_else(String::new, |model| format!(", {model}"));
    let source = match &camera.resolution_from {
        ResolutionSource::Product(path) => format!("from {path}"),
        ResolutionSource::Catalog => "from the catalog".to_owned(),
        ResolutionSource::LensSchema => "from the lens schema".to_owned(),
        ResolutionSource::Apertures => "from the apertures".to_owned(),
    };
    let _ = writeln!(out, "\n{} ({} {source}{model})", camera.path, camera.resolution);
    let mut view = |label: &str, view: Option<&PinholeReport>| {
        let text = view.map_or_else(
            || "no valid pinhole".to_owned(),
            |v| {
                format!(
                    "fx {:.2}  fy {:.2}  cx {:.2}  cy {:.2} px   {:.2}° × {:.2}°",
                    v.fx, v.fy, v.cx, v.cy, v.hfov_deg, v.vfov_deg
                )
            },
        );
        let _ = writeln!(out, "  {label:<10}{text}");
    };
    view("Isaac Sim", camera.isaac.as_ref());
    view("OpenUSD", camera.openusd.as_ref());
    if let Some(lens) = &camera.lens {
        let intrinsics = lens.intrinsics.map_or_else(String::new, |[fx, fy, cx, cy]| {
            format!("fx {fx:.2}  fy {fy:.2}  cx {cx:.2}  cy {cy:.2} px (first pixel centre at 0)")
        });
        let _ = writeln!(out, "  {:<10}{intrinsics} {}", "lens", lens.schema);
    }
}

fn depth_text(out: &mut String, sensor: &UsdDepthReport) {
    let resolution = sensor
        .resolution
        .map_or_else(String::new, |size| format!(" ({size})"));
    let _ = writeln!(out, "\n{}{resolution}", sensor.path);
    let _ = writeln!(
        out,
        "  {:<10}{} of {}",
        "depth",
        sensor.schema,
        sensor.cameras.join(", ")
    );
    let _ = writeln!(
        out,
        "  {:<10}baseline {} mm, focal length {} px at width {}; {} to {} m, disparity up to {} px (from {:.3} m)",
        "",
        sensor.baseline_mm,
        sensor.focal_length_px,
        sensor.sensor_size_px,
        sensor.min_distance_m,
        sensor.max_distance_m,
        sensor.max_disparity_px,
        sensor.nearest_by_disparity_m
    );
}
