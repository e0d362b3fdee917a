//! What `show` says about a camera.

use std::fmt::Write;

use oaktwin::report::CameraReport;

use super::field::{field, mark_key, sources, triple};

pub(super) fn text(out: &mut String, camera: &CameraReport, provenance: bool) {
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
