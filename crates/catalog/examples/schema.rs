//! Writes the JSON schemas of the catalog's files into a folder: `cargo xtask schema` runs it.

use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os()
        .nth(1)
        .map(PathBuf::from)
        .ok_or("usage: schema DIR")?;
    std::fs::create_dir_all(&folder)?;
    for (name, text) in oaktwin_catalog::schema_files() {
        std::fs::write(folder.join(name), text)?;
    }
    Ok(())
}
