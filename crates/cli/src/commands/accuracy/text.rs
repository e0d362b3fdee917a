//! The report of `accuracy` as text.

use oaktwin::accuracy::{AccuracyReport, Devices};
use oaktwin::catalog::Source;

use super::{tables, verdict};
use crate::output;

pub(super) fn report(report: &AccuracyReport) -> String {
    let mut text = heading(report);
    match report.carries_depth {
        None => text += &output::number_table(&tables::distance_table(report, String::new())),
        Some(carries) => text += &tables::single_view(report, carries),
    }
    text += "\n";
    text += &verdict::text(report);
    if let Some(comparison) = &report.measured {
        text += &verdict::measured(comparison);
    }
    text
}

fn heading(report: &AccuracyReport) -> String {
    let devices = match report.devices {
        Devices::Population { count } => {
            format!("the median of {count} devices (seeds 0 to {})", count - 1)
        }
        Devices::Factory { count } => format!("the median of {count} devices of the factory population"),
        Devices::One { device_seed } => format!("the device of seed {device_seed}"),
        Devices::AsGiven => "one device".to_owned(),
    };
    let method = if report.protocol_deviations.is_empty() {
        "by the vendor's method".to_owned()
    } else {
        format!(
            "not by the vendor's method ({})",
            report.protocol_deviations.join("; ")
        )
    };
    let published = match &report.published {
        None => "Published accuracy: none for this sensor".to_owned(),
        Some(bands) => {
            let source = match bands.source {
                Source::VendorPage => "the vendor's page",
                Source::Estimate => "an estimate in the parameter sheet; nothing is published",
                other => other.as_str(),
            };
            let mut conditions: Vec<&str> = Vec::new();
            for condition in bands.bands.iter().filter_map(|band| band.condition.as_deref()) {
                if !conditions.contains(&condition) {
                    conditions.push(condition);
                }
            }
            let conditions = match &conditions[..] {
                [] => String::new(),
                some => format!("\n  Bands are {}; the strictest applies", some.join(" and ")),
            };
            format!("Published accuracy: {source} ({}){conditions}", bands.measure)
        }
    };
    format!(
        "{}, {}, {}: {devices}\n\
         {}x{} px, focal length {:.1} px, disparity times depth {:.2} px m\n\
         Region of {}x{} px, {} captures: {method}\n\
         {published}\n",
        report.model,
        report.sensor,
        report.engine,
        report.image_width_px,
        report.image_height_px,
        report.focal_length_px,
        report.disparity_times_depth_px_m,
        report.region_width_px,
        report.region_height_px,
        report.captures,
    )
}
