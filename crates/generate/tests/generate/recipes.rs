//! The schema, the manual's page and the example recipes are current.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_catalog::Catalog;
use oaktwin_generate::Generator;
use oaktwin_generate::recipe::{RecipeFile, page, schema};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn the_schema_and_the_page_are_current() {
    let read = |path: &str| fs::read_to_string(root().join(path)).unwrap();
    let schema = format!("{:#}\n", schema());
    assert!(
        schema == read("crates/generate/schema/recipe.schema.json"),
        "run cargo xtask schema"
    );
    assert!(
        page() == read("docs/manual/reference/recipes.md"),
        "run cargo xtask schema"
    );
}

#[test]
fn every_example_draws_its_first_frames() {
    let recipes = fs::read_dir(root().join("examples/recipes"))
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let recipes: Vec<PathBuf> = recipes
        .filter(|path| path.extension().is_some_and(|e| e == "toml"))
        .collect();
    assert_eq!(recipes.len(), 5);
    for path in recipes {
        let generator = Generator::open(RecipeFile::read(&path).unwrap(), Catalog::builtin()).unwrap();
        for frame in 0..20 {
            let drawn = generator.explain(frame).unwrap();
            assert!(
                !drawn["arrangement"]["objects"].as_array().unwrap().is_empty(),
                "{}",
                path.display()
            );
        }
    }
}
