//! Renders the images of an OAK's stereo cameras in the demo room as PNG files, with the dot projector off and on:
//!
//! ```sh
//! cargo run --release --example stereo_pair -- OAK-D-Pro-PoE images
//! ```

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

use std::error::Error;
use std::fs;
use std::path::PathBuf;
use std::time::Instant;

use oaktwin::catalog::Catalog;
use oaktwin::image::png;
use oaktwin::pair::{PairCameras, PairOptions};
use oaktwin::render::{OpenOptions, Renderer, SceneFile};
use oaktwin_demo as demo_room;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1);
    let usage = "usage: stereo_pair MODEL FOLDER";
    let model = arguments.next().ok_or(usage)?;
    let folder = PathBuf::from(arguments.next().ok_or(usage)?);

    fs::create_dir_all(&folder)?;
    for (name, bytes) in demo_room::files()? {
        fs::write(folder.join(name), bytes)?;
    }
    let scene = SceneFile::open(&folder.join(demo_room::STAGE), &OpenOptions::default())?;
    let renderer = Renderer::new(scene.scene);
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device(&model.to_string_lossy())?);
    for (name, projector, ambient) in [("off", 0.0, 1.0), ("on", 1.0, 1.0), ("dark", 1.0, 0.02)] {
        if projector > 0.0 && twin.device.projector.is_none() {
            println!("{} has no dot projector", twin.device.name);
            break;
        }
        let options = PairOptions {
            projector,
            ambient,
            ..PairOptions::default()
        };
        let start = Instant::now();
        let cameras = PairCameras::new(&twin, &options)?;
        let prepared = start.elapsed();
        let pair = cameras.capture(&renderer, &demo_room::world_from_body(), 0);
        println!(
            "{name}: exposure {:.2}, gain {:.2}; prepared in {prepared:.0?}, rendered in {:.0?}",
            pair.exposure.time,
            pair.exposure.gain,
            start.elapsed() - prepared,
        );
        for (side, image) in [("left", &pair.left), ("right", &pair.right)] {
            fs::write(
                folder.join(format!("{side}_{name}.png")),
                png::encode(&image.to_eight())?,
            )?;
        }
    }
    Ok(())
}
