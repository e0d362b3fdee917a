//! Writes the JSON schema of recipes and the manual's page of them: `cargo xtask schema` runs it.

use std::error::Error;
use std::path::PathBuf;

use oaktwin_generate::recipe::{page, schema};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args_os().skip(1).map(PathBuf::from);
    let (Some(file), Some(manual)) = (arguments.next(), arguments.next()) else {
        return Err("usage: schema FILE PAGE".into());
    };
    std::fs::write(file, format!("{:#}\n", schema()))?;
    std::fs::write(manual, page())?;
    Ok(())
}
