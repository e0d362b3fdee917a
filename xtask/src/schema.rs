//! `cargo xtask schema`: regenerates the JSON schemas, the manual page of models, and the manual page and the Python types of the parameters.

use crate::workspace;

/// Runs an example of the catalog and one of the depth sensor, so that this program builds without these.
pub(crate) fn run() -> Result<(), String> {
    let folder = workspace::root().join("crates/catalog/schema");
    let example = |package: &str, example: &str| {
        let mut command = workspace::cargo();
        command.args(["run", "--quiet", "--package", package, "--example", example, "--"]);
        command
    };
    let page = workspace::root().join("docs/manual/reference/models.md");
    workspace::check(example("oaktwin-catalog", "schema").arg(&folder).arg(page))?;
    workspace::check(&mut example("oaktwin-pipeline", "reference"))?;
    println!(
        "wrote {} the page of models, and the reference of the parameters",
        folder.display()
    );
    Ok(())
}
