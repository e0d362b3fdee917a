//! `cargo xtask schema`: the catalog's JSON schemas, written by the catalog itself.

use crate::workspace;

/// Runs the catalog's own example, so that this program builds without the catalog.
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
