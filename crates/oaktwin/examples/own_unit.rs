//! Writes the USD asset of an individual OAK from its calibration:
//!
//! ```sh
//! cargo run --example own_unit -- OAK-D-Pro-PoE calibration.json my_oak.usd
//! ```

#![expect(clippy::print_stdout, reason = "the output is the program's purpose")]

use std::error::Error;
use std::path::PathBuf;

use oaktwin::camera::OpenCv;
use oaktwin::catalog::Catalog;
use oaktwin::usd::asset::{AssetOptions, Format, asset};
use oaktwin::{files, unit};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [model, calibration, output] = arguments.as_slice() else {
        return Err("usage: own_unit MODEL CALIBRATION.json OUTPUT.usd".into());
    };
    let catalog = Catalog::builtin();
    let device = catalog.device(&model.to_string_lossy())?;
    let (twin, findings) = unit::open(catalog, device, calibration, false)?;
    for finding in findings {
        println!("{finding}");
    }
    for camera in &twin.cameras {
        let (k, c) = (&camera.intrinsics, camera.intrinsics.principal_point::<OpenCv>());
        println!(
            "{}: fx {:.2} fy {:.2} cx {:.2} cy {:.2} px at {}",
            camera.spec.prim, k.fx, k.fy, c.x, c.y, k.size
        );
    }
    files::write(
        output,
        &asset(&twin, &AssetOptions::default())?.bytes(Format::Usd)?,
    )?;
    Ok(())
}
