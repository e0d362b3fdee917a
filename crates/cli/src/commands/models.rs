use oaktwin::catalog::{Device, Role, Table};
use serde::Serialize;

use crate::args::JsonArgs;
use crate::context::{Context, Exit, Result};
use crate::output;

#[derive(Serialize)]
struct Model<'a> {
    id: &'a str,
    name: &'a str,
    generation: &'a str,
    cameras: Vec<ModelCamera<'a>>,
    depth_sensors: Vec<&'a str>,
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

pub(crate) fn run(context: &Context, args: &JsonArgs) -> Result<Exit> {
    let devices = context.devices(&[])?;
    if args.json {
        output::print_json(&devices.iter().map(|device| model(device)).collect::<Vec<_>>())?;
    } else {
        output::print(&output::text_table(&table(&devices)))?;
    }
    Ok(Exit::Success)
}

fn model(device: &Device) -> Model<'_> {
    Model {
        id: &device.id,
        name: &device.name,
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
        depth_sensors: device
            .depth_sensors
            .iter()
            .map(|sensor| sensor.prim.as_str())
            .collect(),
        stereo_baseline_mm: device.stereo_baseline_mm,
        aliases: &device.aliases,
    }
}

fn table(devices: &[&Device]) -> Table {
    let optics = |device: &Device, role| {
        device.camera(role).map_or_else(String::new, |camera| {
            format!("{} {}°", camera.sensor, camera.hfov_deg)
        })
    };
    Table {
        title: String::new(),
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
                    device
                        .stereo_baseline_mm
                        .map_or_else(String::new, |baseline| format!("{baseline} mm")),
                    device.id.clone(),
                ]
            })
            .collect(),
    }
}
