//! Lists the files in `data/`, so that a sensor, an inertial part or a device is one file.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// The devices of the parameter sheet in its order, which come first.
const SHEET: [&str; 5] = [
    "oak_d_pro_poe.toml",
    "oak_d_pro_w_poe.toml",
    "oak4_d.toml",
    "oak4_d_wide.toml",
    "oak_d_tof.toml",
];

fn main() -> io::Result<()> {
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());
    let mut files = Vec::new();
    for folder in ["data/sensors", "data/imus"] {
        let names = names(&root.join(folder))?;
        files.extend(names.into_iter().map(|name| format!("{folder}/{name}")));
    }
    let mut devices = names(&root.join("data/devices"))?;
    devices.sort_by_key(|name| {
        SHEET
            .iter()
            .position(|sheet| sheet == name)
            .unwrap_or(SHEET.len())
    });
    files.extend(devices.into_iter().map(|name| format!("data/devices/{name}")));
    let mut list = "/// The names and texts of the files: sensors, inertial parts, then devices, those of the sheet first.\n\
         pub(crate) const FILES: &[(&str, &str)] = &[\n"
        .to_owned();
    for file in files {
        let path = root.join(&file);
        let _ = writeln!(list, "    ({file:?}, include_str!({path:?})),");
    }
    list.push_str("];\n");
    fs::write(out.join("builtin.rs"), list)
}

/// Returns the names of the TOML files of a folder, sorted.
fn names(folder: &Path) -> io::Result<Vec<String>> {
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut names = Vec::new();
    for entry in fs::read_dir(folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if name.ends_with(".toml") {
            names.push(name);
        }
    }
    names.sort();
    Ok(names)
}
