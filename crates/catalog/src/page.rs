//! The manual's page of models.

use std::fmt::Write;

use crate::{Accuracy, Catalog, DepthKind, Device, Note, Role, Source, Sourced};

/// Returns the manual's page of the built-in models, which `cargo xtask schema` writes.
#[must_use]
pub fn models_page() -> String {
    let catalog = Catalog::builtin();
    let mut page = "# Models\n\nThe built-in models, as `oaktwin models` lists them. Estimates are in *italics*; `oaktwin show MODEL --provenance` prints the \
        source of every number.\n"
        .to_owned();
    for maker in catalog.makers() {
        let _ = write!(
            page,
            "\n## {maker}\n\n| model | platform | cameras | depth | baseline | published accuracy to | body, mm | mass | IMU |\n\
             |---|---|---|---|---|---|---|---|---|\n"
        );
        let devices = || {
            catalog
                .devices()
                .iter()
                .filter(|device| device.manufacturer == maker)
        };
        for device in devices() {
            page.push_str(&row(device));
        }
        page.push_str("\n### What is not known\n\n");
        for device in devices() {
            gaps(&mut page, device);
        }
    }
    page
}

/// Writes a value, in italics if it is an estimate.
fn cell(table: &impl Sourced, key: &str, value: &str) -> String {
    match table.source_of(key) {
        Source::Estimate => format!("*{value}*"),
        _ => value.to_owned(),
    }
}

fn row(device: &Device) -> String {
    let cameras = device.cameras.iter().filter(|camera| {
        // The right camera of a pair is like the left one.
        camera.role != Role::Right
    });
    let cameras: Vec<String> = cameras
        .map(|camera| {
            let hfov = cell(camera, "hfov_deg", &format!("{}°", camera.hfov_deg));
            let role = if camera.role == Role::Left {
                "stereo"
            } else {
                camera.role.as_str()
            };
            format!("{role} {} {hfov}", camera.sensor)
        })
        .collect();
    let sensors = &device.depth_sensors;
    let mut kinds: Vec<&str> = sensors.iter().map(|sensor| sensor.kind.as_str()).collect();
    kinds.dedup();
    let baselines = sensors.iter().filter(|sensor| sensor.kind == DepthKind::Stereo);
    let baselines: Vec<String> = baselines.map(|sensor| sensor.baseline_mm.to_string()).collect();
    let published = |table: &&Accuracy| table.source == Source::VendorPage;
    let ends = device
        .accuracy
        .iter()
        .filter(published)
        .flat_map(|table| &table.bands);
    let end = ends
        .filter(|band| band.limit("%").is_some())
        .map(|band| band.to_m)
        .reduce(f64::max);
    let body = &device.body;
    let [width, height, depth] = body.dimensions_mm;
    let cells = [
        device.name.clone(),
        device.generation.clone(),
        cameras.join(", "),
        kinds.join(", "),
        if baselines.is_empty() {
            String::new()
        } else {
            format!("{} mm", baselines.join(", "))
        },
        end.map_or_else(String::new, |end| format!("{end} m")),
        cell(body, "dimensions_mm", &format!("{width} × {height} × {depth}")),
        cell(body, "mass_g", &format!("{} g", body.mass_g)),
        device
            .imu
            .as_ref()
            .map_or_else(String::new, |imu| imu.model.clone()),
    ];
    format!("| {} |\n", cells.join(" | "))
}

/// The topics of notes about what is not known.
const GAPS: [&str; 9] = [
    "accuracy",
    "body",
    "depth",
    "fields-of-view",
    "imu",
    "projector",
    "range",
    "rgb",
    "rgb-field-of-view",
];

/// Writes the notes of the devices about what is not known, except for the parameter sheet's devices, whose notes are about conflicts.
fn gaps(page: &mut String, device: &Device) {
    if device.source == Source::Document {
        return;
    }
    let is_gap = |note: &&Note| GAPS.contains(&note.topic.as_str());
    let texts: Vec<&str> = device
        .notes
        .iter()
        .filter(is_gap)
        .map(|note| note.text.as_str())
        .collect();
    let _ = writeln!(page, "- **{}**: {}", device.name, texts.join(" "));
}
