use oaktwin::catalog::{DepthKind, Device, Role, TextTable};
use serde::Serialize;

use crate::args::ModelsArgs;
use crate::context::{Context, Exit, Result};
use crate::output;

#[derive(Serialize)]
struct Model<'a> {
    id: &'a str,
    name: &'a str,
    manufacturer: &'a str,
    generation: &'a str,
    cameras: Vec<ModelCamera<'a>>,
    depth_sensors: Vec<&'a str>,
    depth_kinds: Vec<DepthKind>,
    stereo_baseline_mm: Option<f64>,
    aliases: &'a [String],
}

#[derive(Serialize)]
struct ModelCamera<'a> {
    role: Role,
    prim: &'a str,
    sensor: &'a str,
    hfov_deg: f64,
}

pub(crate) fn run(context: &Context, args: &ModelsArgs) -> Result<Exit> {
    let chosen = context.catalog.chosen(args.maker.as_deref(), args.depth);
    let devices = chosen.map_err(|error| format!("--maker: {error}"))?;
    if args.json {
        output::print_json(&devices.iter().map(|device| model(device)).collect::<Vec<_>>())?;
    } else {
        let tables = devices
            .chunk_by(|a, b| a.manufacturer == b.manufacturer)
            .map(table);
        let tables: Vec<String> = tables.map(|table| output::text_table(&table)).collect();
        output::print(&tables.join("\n"))?;
    }
    Ok(Exit::Success)
}

fn model(device: &Device) -> Model<'_> {
    let sensors = || device.depth_sensors.iter();
    let mut depth_kinds: Vec<DepthKind> = sensors().map(|sensor| sensor.kind).collect();
    depth_kinds.dedup();
    Model {
        id: &device.id,
        name: &device.name,
        manufacturer: &device.manufacturer,
        generation: &device.generation,
        cameras: device
            .cameras
            .iter()
            .map(|camera| ModelCamera {
                role: camera.role,
                prim: &camera.prim,
                sensor: &camera.sensor,
                hfov_deg: camera.hfov_deg,
            })
            .collect(),
        depth_sensors: sensors().map(|sensor| sensor.prim.as_str()).collect(),
        depth_kinds,
        stereo_baseline_mm: device.stereo_baseline_mm,
        aliases: &device.aliases,
    }
}

/// Returns the table of one maker's models.
fn table(devices: &[&Device]) -> TextTable {
    let optics = |device: &Device, role| {
        device.camera(role).map_or_else(String::new, |camera| {
            format!("{} {}°", camera.sensor, camera.hfov_deg)
        })
    };
    // A device may have several stereo pairs.
    let baseline = |device: &Device| {
        let stereo = device
            .depth_sensors
            .iter()
            .filter(|sensor| sensor.kind == DepthKind::Stereo);
        let all: Vec<String> = stereo.map(|sensor| sensor.baseline_mm.to_string()).collect();
        if all.is_empty() {
            String::new()
        } else {
            format!("{} mm", all.join(", "))
        }
    };
    TextTable {
        title: devices
            .first()
            .map_or_else(String::new, |device| device.manufacturer.clone()),
        header: ["Model", "Generation", "RGB", "Stereo", "ToF", "Baseline", "Asset"]
            .map(String::from)
            .to_vec(),
        rows: devices
            .iter()
            .map(|device| {
                vec![
                    device.name.clone(),
                    device.generation.clone(),
                    optics(device, Role::Rgb),
                    optics(device, Role::Left),
                    optics(device, Role::Tof),
                    baseline(device),
                    device.id.clone(),
                ]
            })
            .collect(),
    }
}
