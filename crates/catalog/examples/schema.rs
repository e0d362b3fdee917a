//! Writes the JSON schemas of the catalog's files into a folder, and the manual's page of models: `cargo xtask schema` runs it.

use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let (Some(folder), Some(page)) = (arguments.next(), arguments.next()) else {
        return Err("usage: schema DIR PAGE".into());
    };
    std::fs::create_dir_all(&folder)?;
    for (name, text) in oaktwin_catalog::schema_files() {
        std::fs::write(folder.join(name), text)?;
    }
    std::fs::write(page, oaktwin_catalog::models_page())?;
    Ok(())
}
