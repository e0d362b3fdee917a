mod camera;
mod depth;
mod device;
mod field;

use std::fmt::Write;

use oaktwin::diagnostic;
use oaktwin::report::DeviceReport;

use crate::args::ShowArgs;
use crate::context::{Context, Exit, Result};
use crate::output;

pub(crate) fn run(context: &Context, args: &ShowArgs) -> Result<Exit> {
    let (twin, findings) = context.twin_with_axes(&args.model, &args.unit, &args.axes)?;
    let report = DeviceReport::new(&context.catalog, &twin, args.unit.lens, findings);
    if args.json {
        output::print_json(&report)?;
    } else {
        output::print(&text(&report, args.provenance))?;
    }
    Ok(Exit::Success)
}

/// Formats the report: the device, then its cameras, depth sensors, accuracy and notes.
fn text(report: &DeviceReport, provenance: bool) -> String {
    let mut out = format!("{} ({})\n", report.name, report.id);
    device::text(&mut out, report);
    if provenance {
        field::sources(&mut out, report.source, &report.sources);
        let _ = writeln!(out, "  body");
        field::sources(&mut out, report.body.source, &report.body.sources);
        if let Some(imu) = &report.imu {
            let _ = writeln!(out, "  imu");
            field::sources(&mut out, imu.source, &imu.sources);
        }
    }
    for camera in &report.cameras {
        camera::text(&mut out, camera, provenance);
    }
    for sensor in &report.depth_sensors {
        depth::text(&mut out, sensor, provenance);
    }
    device::accuracy(&mut out, report);
    if provenance && !report.evidence.is_empty() {
        let _ = writeln!(out, "\nOther evidence");
        for evidence in &report.evidence {
            let _ = writeln!(
                out,
                "  {}: {} ({}: {})",
                evidence.about,
                evidence.value,
                evidence.source.as_str(),
                evidence.from
            );
        }
    }
    if !report.notes.is_empty() {
        let _ = writeln!(out, "\nNotes");
        for note in &report.notes {
            let _ = writeln!(out, "  [{}] {}", note.topic, note.text);
        }
    }
    if !report.findings.is_empty() {
        let _ = writeln!(out, "\nCalibration");
        for group in diagnostic::group(&report.findings) {
            let _ = writeln!(out, "  {group}");
        }
    }
    out
}
