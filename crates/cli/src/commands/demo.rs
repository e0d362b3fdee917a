mod engines;
mod room;

use std::fmt::Write;

use oaktwin::catalog::compare;
use oaktwin::files;
use oaktwin::usd::asset::{self, AssetOptions, Format};
use oaktwin::{calibration, unit};

use crate::args::DemoArgs;
use crate::context::{Context, Exit, Result};
use crate::{destination, output};

/// The model of the example calibration.
const UNIT_MODEL: &str = "oak_d_pro_poe";

pub(crate) fn run(context: &Context, args: &DemoArgs) -> Result<Exit> {
    let format = Format::default();
    let options = AssetOptions::default();
    let mut listing = String::new();
    let mut put = |name: &str, what: &str, bytes: &[u8]| -> Result<std::path::PathBuf> {
        let path = destination::in_folder(&args.output, name)?;
        files::write(&path, bytes)?;
        let _ = writeln!(listing, "  {:<44} {what}", path.display().to_string());
        Ok(path)
    };
    let devices: Vec<_> = context.catalog.sheet().collect();
    let twins: Vec<_> = devices
        .iter()
        .map(|device| context.catalog.nominal(device))
        .collect();
    for (device, file) in devices.iter().zip(asset::files(&twins, &options, format)?) {
        put(&file.name, &device.name, &file.bytes)?;
    }
    let file = put(
        "example_calibration.json",
        "example calibration of one unit",
        calibration::EXAMPLE.as_bytes(),
    )?;
    let (twin, findings) = unit::open(&context.catalog, context.device(UNIT_MODEL)?, &file, false)?;
    let made = asset::asset(&twin, &options)?;
    let what = format!("twin of that {}", twin.device.name);
    let path = put(&format!("{}_unit.usd", made.stem), &what, &made.bytes(format)?)?;
    let renderer = room::open(&args.output)?;
    let sheet = room::render(&renderer, &args.output, &devices, &twins)?;
    put(
        "demo_room.png",
        "a room seen by all models: colour, depth and simulated sensor depth",
        &sheet,
    )?;
    put(
        "demo_engines.png",
        "the room through each engine: by day, at night with the dot projector, with time of flight",
        &engines::sheet(context, &renderer)?,
    )?;
    let room = args.output.join(room::FOLDER);
    let _ = writeln!(
        listing,
        "  {:<44} the room, and each model's images of it",
        room.display().to_string()
    );
    output::say_findings(&file, &findings);
    output::say_findings(&path, &made.findings);

    let tables = compare(&context.catalog, &devices);
    let tables: Vec<String> = tables.iter().map(output::text_table).collect();
    output::print(&format!(
        "{}\nWritten:\n{listing}\n{}",
        tables.join("\n"),
        next_steps(&args.output)
    ))?;
    Ok(Exit::Success)
}

fn next_steps(folder: &std::path::Path) -> String {
    let folder = folder.display();
    format!(
        "Next:\n  \
         drag {folder}/oak_d_pro_poe.usd into Isaac Sim, or open it in any OpenUSD tool\n  \
         oaktwin show OAK4-D\n  \
         oaktwin check {folder}/oak_d_tof.usd\n  \
         oaktwin render {folder}/demo_room/demo_room.usda --model OAK4-D --look-at 0 0 1.15 1 0 1.03 --preview\n  \
         oaktwin sense {folder}/demo_room/oak4_d --model OAK4-D --preset robotics --preview\n  \
         oaktwin accuracy OAK4-D --plot {folder}/accuracy.svg\n  \
         oaktwin asset OAK-D-Pro-PoE --calibration FILE -o my_oak.usd\n"
    )
}
