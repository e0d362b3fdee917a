//! `cargo xtask schema`: regenerates the JSON schemas of the catalog.

use crate::workspace;

/// Runs an example of the catalog, so that this program builds without the catalog.
pub(crate) fn run() -> Result<(), String> {
    let folder = workspace::root().join("crates/catalog/schema");
    let mut command = workspace::cargo();
    command
        .args([
            "run",
            "--quiet",
            "--package",
            "oaktwin-catalog",
            "--example",
            "schema",
            "--",
        ])
        .arg(&folder);
    workspace::check(&mut command)?;
    println!("wrote {}", folder.display());
    Ok(())
}
