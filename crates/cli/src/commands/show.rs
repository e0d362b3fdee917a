use std::fmt::Write;

use oaktwin::catalog::{Imu, Latency, Sensor, Source, Sourced, Sources};
use oaktwin::diagnostic;
use oaktwin::report::{CameraReport, DepthReport, DeviceReport};

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
    device_text(&mut out, report);
    if provenance {
        sources(&mut out, report.source, &report.sources);
        let _ = writeln!(out, "  body");
        sources(&mut out, report.body.source, &report.body.sources);
        if let Some(imu) = &report.imu {
            let _ = writeln!(out, "  imu");
            sources(&mut out, imu.source, &imu.sources);
        }
    }
    for camera in &report.cameras {
        camera_text(&mut out, camera, provenance);
    }
    for sensor in &report.depth_sensors {
        depth_text(&mut out, sensor, provenance);
    }
    accuracy_text(&mut out, report);
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

fn device_text(out: &mut String, report: &DeviceReport) {
    let mut line = |label: &str, value: String| field(out, label, &value);
    let platform = report.platform.as_ref();
    line(
        "generation",
        platform.map_or_else(
            || report.generation.clone(),
            |platform| format!("{}, {platform}", report.generation),
        ),
    );
    line("variant", report.variant.clone());
    line("values", report.origin.clone());
    let [width, height, depth] = report.body.dimensions_mm;
    line(
        "dimensions",
        format!(
            "{width} × {height} × {depth} mm{}, {} g{}",
            mark(&report.body, "dimensions_mm"),
            report.body.mass_g,
            mark(&report.body, "mass_g"),
        ),
    );
    if let (Some(baseline_mm), Some(nominal_mm)) = (report.baseline_mm, report.nominal_baseline_mm) {
        line(
            "baseline",
            match report.origin.as_str() {
                "nominal" => format!("{baseline_mm:.1} mm"),
                _ => format!("{baseline_mm:.3} mm (nominal {nominal_mm:.1} mm)"),
            },
        );
    }
    line(
        "IMU",
        report.imu.as_ref().map_or_else(
            || "none, or its pose is unknown; see the notes".to_owned(),
            |imu| {
                let place = triple(imu.position_mm);
                format!("{} at {place} mm{}", imu.model, mark(imu, "position_mm"))
            },
        ),
    );
    if let Some(imu) = &report.imu {
        line("IMU axes", imu_axes(imu));
    }
    for sensor in &report.sensors {
        line(&sensor.id, sensor_text(sensor));
    }
}

/// The axes of an inertial unit with their source, and the board file's if these differ.
fn imu_axes(imu: &Imu) -> String {
    let own = imu.axes().unwrap_or_else(|| {
        let rows = imu.rotation.map(|[a, b, c]| format!("({a:.4}, {b:.4}, {c:.4})"));
        format!("the rows {}", rows.join(", "))
    });
    let source = imu.source_of("rotation");
    let other = imu.board_file_axes().map_or_else(String::new, |axes| {
        format!("; board-file: {axes}, see the notes and --imu-frame")
    });
    format!("{own} ({source}){other}")
}

fn sensor_text(sensor: &Sensor) -> String {
    let manufacturer = sensor.manufacturer.as_ref();
    let format = sensor.optical_format.as_ref();
    let readout = sensor.readout_ms;
    format!(
        "{}{}, {}×{} used of {}×{}, {} µm{}{}{}",
        manufacturer.map_or_else(String::new, |name| format!("{name} ")),
        sensor.kind,
        sensor.used_resolution.0,
        sensor.used_resolution.1,
        sensor.native_resolution.0,
        sensor.native_resolution.1,
        sensor.pixel_size_um,
        mark(sensor, "pixel_size_um"),
        format.map_or_else(String::new, |format| format!(", {format}")),
        readout.map_or_else(String::new, |ms| format!(
            ", rows read in {ms} ms{}",
            mark(sensor, "readout_ms")
        )),
    )
}

fn accuracy_text(out: &mut String, report: &DeviceReport) {
    if report.accuracy.is_empty() {
        return;
    }
    let _ = writeln!(out, "\nAccuracy");
    for table in &report.accuracy {
        let bands: Vec<String> = table
            .bands
            .iter()
            .map(|band| {
                let range = format!("{}–{} m", band.from_m, band.to_m);
                let condition = band
                    .condition
                    .as_ref()
                    .map_or_else(String::new, |c| format!(" ({c})"));
                band.limit(" %").map_or_else(
                    || format!("{range} n/a{condition}"),
                    |limit| format!("{range} < {limit}{condition}"),
                )
            })
            .collect();
        field(out, table.source.as_str(), &bands.join(", "));
    }
}

fn camera_text(out: &mut String, camera: &CameraReport, provenance: bool) {
    let usd = &camera.usd;
    let camera_mark = |key| mark_key(camera.source, &camera.sources, key);
    let _ = writeln!(out, "\n{} ({}, {})", camera.prim, camera.sensor, camera.size);
    for line in &camera.calculation {
        let _ = writeln!(out, "  {line}");
    }
    let c = camera.principal_point_usd;
    let o = camera.principal_point_opencv;
    field(
        out,
        "principal point",
        &format!("({:.2}, {:.2}) px; OpenCV ({:.2}, {:.2})", c.x, c.y, o.x, o.y),
    );
    let [h, v, d] = camera.fov_deg;
    field(
        out,
        "field of view",
        &format!(
            "{h:.2}° × {v:.2}°, diagonal {d:.2}°{}{}",
            camera_mark("hfov_deg"),
            usd.max_fov_deg
                .map_or_else(String::new, |max| format!(" (maxFOV {max}°)"))
        ),
    );
    let (a, b) = (usd.aperture_offsets_openusd, usd.aperture_offsets_document);
    field(
        out,
        "aperture offsets",
        &format!(
            "OpenUSD ({:.4}, {:.4}) mm, sheet's formula ({:.4}, {:.4}) mm",
            a.horizontal, a.vertical, b.horizontal, b.vertical
        ),
    );
    field(
        out,
        "USD",
        &format!(
            "focusDistance {}, fStop {}, {}, stereoRole {}, clippingRange ({}, {}), {}",
            usd.focus_distance,
            usd.f_stop,
            usd.projection,
            usd.stereo_role,
            usd.clipping_range.0,
            usd.clipping_range.1,
            usd.camera_projection_type,
        ),
    );
    field(
        out,
        "pose",
        &format!(
            "{} mm{}, yaw {:.2}°, pitch {:.2}°",
            triple(camera.position_mm),
            camera_mark("position_mm"),
            camera.yaw_pitch_deg[0] + 0.0,
            camera.yaw_pitch_deg[1] + 0.0
        ),
    );
    let coefficients: Vec<String> = camera.distortion.iter().map(|c| format!("{c:.6}")).collect();
    field(
        out,
        "lens",
        &format!("{} {}", camera.lens, coefficients.join(" ")),
    );
    if let Some(legacy) = &camera.legacy_distortion {
        let all = legacy.poly_k.iter().chain(&legacy.p).chain(&legacy.s);
        let all: Vec<String> = all.map(f64::to_string).collect();
        field(
            out,
            "polyK, p, s",
            &format!("{} (no effect on a pinhole)", all.join(" ")),
        );
    }
    if provenance {
        sources(out, camera.source, &camera.sources);
    }
}

fn depth_text(out: &mut String, sensor: &DepthReport, provenance: bool) {
    let _ = writeln!(out, "\n{} ({:?})", sensor.prim, sensor.kind);
    for attribute in &sensor.attributes {
        field(
            out,
            attribute.name,
            &format!("{:<8} {}", attribute.value, attribute.meaning),
        );
    }
    let extended = sensor
        .extended_min_z_m
        .map_or_else(String::new, |z| format!(" (extended {z:.3} m)"));
    field(
        out,
        "MinZ",
        &format!("{:.3} m from the disparity range{extended}", sensor.min_z_m),
    );
    field(
        out,
        "MaxZ",
        &format!("{:.1} m at one pixel of disparity", sensor.max_z_m),
    );
    field(
        out,
        "ideal range",
        &format!(
            "{}–{} m{}",
            sensor.ideal_range_m.0,
            sensor.ideal_range_m.1,
            mark_key(sensor.source, &sensor.sources, "ideal_range_m")
        ),
    );
    if let Some(latency) = &sensor.latency {
        latency_text(out, latency, provenance);
    }
    for at in &sensor.at {
        let step = |s: Option<f64>| s.map_or_else(|| "n/a".to_owned(), |s| format!("{:.1} mm", s * 1e3));
        field(
            out,
            &format!("at {} m", at.z_m),
            &format!(
                "disparity {:.3} px; depth step {} per px, {} per 1/32 px",
                at.disparity_px,
                step(at.step_px_m),
                step(at.step_subpixel_m)
            ),
        );
    }
    if provenance {
        sources(out, sensor.source, &sensor.sources);
    }
}

fn latency_text(out: &mut String, latency: &Latency, provenance: bool) {
    let range = |(low, high): (f64, f64)| match low < high {
        true => format!("{low:.1}–{high:.1} ms"),
        false => format!("{low:.1} ms"),
    };
    let stages: Vec<String> = latency
        .stages
        .iter()
        .map(|stage| format!("{} {}{}", stage.stage, range(stage.ms), mark_source(stage.source)))
        .collect();
    let text = format!(
        "{} from mid-exposure to the host over {}, {}: {}",
        range(latency.ms),
        latency.connection,
        latency.mode,
        stages.join(", ")
    );
    field(out, "latency", &text);
    if provenance {
        for stage in &latency.stages {
            field(
                out,
                "",
                &format!("{}: {} ({})", stage.stage, stage.source.as_str(), stage.from),
            );
        }
    }
}

fn field(out: &mut String, label: &str, value: &str) {
    let _ = writeln!(out, "  {label:<26}{}", value.trim_end());
}

/// Marks estimates, also without `--provenance`.
fn mark(table: &impl Sourced, key: &str) -> &'static str {
    mark_source(table.source_of(key))
}

/// Marks estimates of a table whose sources are known.
fn mark_key(source: Source, others: &Sources, key: &str) -> &'static str {
    mark_source(others.get(key).copied().unwrap_or(source))
}

fn mark_source(source: Source) -> &'static str {
    match source {
        Source::Estimate => " (estimate)",
        _ => "",
    }
}

fn sources(out: &mut String, source: Source, others: &Sources) {
    let mut text = source.as_str().to_owned();
    for (key, source) in others {
        let _ = write!(text, "; {key}: {}", source.as_str());
    }
    field(out, "source", &text);
}

fn triple([x, y, z]: [f64; 3]) -> String {
    // Adding 0 changes −0 to 0.
    format!("({:.2}, {:.2}, {:.2})", x + 0.0, y + 0.0, z + 0.0)
}
