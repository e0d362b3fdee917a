//! What `show` says about a device.

use std::fmt::Write;

use oaktwin::catalog::{Imu, Sensor, Sourced};
use oaktwin::report::DeviceReport;

use super::field::{field, mark, triple};

pub(super) fn text(out: &mut String, report: &DeviceReport) {
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

pub(super) fn accuracy(out: &mut String, report: &DeviceReport) {
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
