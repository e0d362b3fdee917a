//! `cargo xtask schema`: regenerates the JSON schemas, the manual pages of models and recipes, and the manual page and the Python types of the
//! parameters.

use crate::workspace;

/// Runs examples of the catalog, of recipes and of the depth sensor, so that this program builds without these.
pub(crate) fn run() -> Result<(), String> {
    let folder = workspace::root().join("crates/catalog/schema");
    let example = |package: &str, example: &str| {
        let mut command = workspace::cargo();
        command.args(["run", "--quiet", "--package", package, "--example", example]);
        command
    };
    let page = workspace::root().join("docs/manual/reference/models.md");
    workspace::check(
        example("oaktwin-catalog", "schema")
            .args(["--features", "schema", "--"])
            .arg(&folder)
            .arg(page),
    )?;
    let recipe = workspace::root().join("crates/generate/schema/recipe.schema.json");
    let page = workspace::root().join("docs/manual/reference/recipes.md");
    workspace::check(
        example("oaktwin-generate", "recipe_schema")
            .arg("--")
            .arg(recipe)
            .arg(page),
    )?;
    workspace::check(&mut example("oaktwin-pipeline", "reference"))?;
    println!(
        "wrote {}, the pages of models and recipes, and the reference of the parameters",
        folder.display()
    );
    Ok(())
}
