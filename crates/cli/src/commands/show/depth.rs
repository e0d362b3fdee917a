//! What `show` says about a depth sensor.

use std::fmt::Write;

use oaktwin::catalog::Latency;
use oaktwin::report::DepthReport;

use super::field::{field, mark_key, mark_source, sources};

pub(super) fn text(out: &mut String, sensor: &DepthReport, provenance: bool) {
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
