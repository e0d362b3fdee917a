//! A calibration as text.

use std::fmt::Write;
use std::path::Path;

use oaktwin::calibration::{CalibrationSummary, CameraSummary};
use oaktwin::catalog::Device;
use oaktwin::diagnostic;

pub(super) fn summary(file: &Path, summary: &CalibrationSummary, device: Option<&Device>) -> String {
    let board = &summary.board;
    let mut out = format!(
        "{}: DepthAI calibration, version {}\n",
        file.display(),
        summary.version
    );
    let model = device.map_or_else(|| "not in the catalog".to_owned(), |d| d.name.clone());
    field(
        &mut out,
        "product",
        &format!("{} (model: {model})", named(&board.product_name)),
    );
    field(
        &mut out,
        "board",
        &format!("{} {}", named(&board.board_name), board.board_rev),
    );
    for camera in &summary.cameras {
        camera_lines(&mut out, camera);
    }
    let _ = writeln!(
        out,
        "\nExtrinsics (origin of the first camera in the frame of the second: x right, y down, z forward)"
    );
    for pair in summary.pairs.iter().filter(|pair| pair.from < pair.to) {
        let label = format!("{} in {}", pair.from, pair.to);
        let Some(rows) = &pair.to_from_from_cm else {
            field(&mut out, &label, "not connected");
            continue;
        };
        let spec = pair
            .spec_baseline_cm
            .map_or_else(String::new, |b| format!(" (design {b:.3} cm)"));
        let angle_deg = ((rows[0][0] + rows[1][1] + rows[2][2] - 1.0) / 2.0)
            .clamp(-1.0, 1.0)
            .acos()
            .to_degrees();
        field(
            &mut out,
            &label,
            &format!(
                "({:.3}, {:.3}, {:.3}) cm, rotated {angle_deg:.2}°, distance {:.3} cm{spec}",
                rows[0][3],
                rows[1][3],
                rows[2][3],
                pair.baseline_cm.unwrap_or_default()
            ),
        );
    }
    for imu in &summary.imu {
        let t = imu.camera_from_imu_cm;
        field(
            &mut out,
            &format!("IMU in {}", imu.camera),
            &format!(
                "({:.3}, {:.3}, {:.3}) cm; {}, within {:.2}°",
                t[0][3], t[1][3], t[2][3], imu.axes, imu.axes_deviation_deg
            ),
        );
        let [right, down, forward, _] = t.map(|[a, b, c, _]| format!("[{a:.6}, {b:.6}, {c:.6}]"));
        field(&mut out, "  rotation", &format!("[{right}, {down}, {forward}]"));
    }
    if !summary.findings.is_empty() {
        let _ = writeln!(out, "\nFindings");
        for group in diagnostic::group(&summary.findings) {
            let _ = writeln!(out, "  {group}");
        }
    }
    out
}

fn camera_lines(out: &mut String, camera: &CameraSummary) {
    let k = &camera.camera_matrix;
    let _ = writeln!(
        out,
        "\n{} {:?} {}x{}",
        camera.socket, camera.model, camera.width, camera.height
    );
    field(out, "fx, fy", &format!("{:.3}, {:.3} px", k[0][0], k[1][1]));
    field(
        out,
        "cx, cy",
        &format!("{:.3}, {:.3} px (first pixel centre at 0)", k[0][2], k[1][2]),
    );
    field(
        out,
        "field of view",
        &format!(
            "{:.2}° × {:.2}° as a pinhole; by design {:.1}° with distortion",
            camera.hfov_deg, camera.vfov_deg, camera.spec_hfov_deg
        ),
    );
    let coefficients: Vec<String> = camera.distortion.iter().map(|c| format!("{c:.6}")).collect();
    field(out, "distortion", &coefficients.join(" "));
    match camera.extrinsics_to {
        Some(to) => field(out, "extrinsics", &format!("to {to}")),
        None => field(out, "extrinsics", "root"),
    }
}

fn named(text: &str) -> &str {
    if text.is_empty() { "unnamed" } else { text }
}

fn field(out: &mut String, label: &str, value: &str) {
    let _ = writeln!(out, "  {label:<16}{}", value.trim_end());
}
