//! Recipes of data sets.

use std::path::Path;

use oaktwin_catalog::Catalog;
use oaktwin_generate::Generator;
use oaktwin_generate::recipe::{Recipe, RecipeFile, Texts};

/// A recipe, of which one frame is drawn without the files that it names.
pub(crate) fn check(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else {
        return;
    };
    let path = Path::new("recipe.toml");
    let mut recipe = match Recipe::parse(path, text) {
        Ok(recipe) => recipe,
        Err(error) => {
            assert!(error.to_string().starts_with("recipe.toml"), "{error}");
            return;
        }
    };
    // As the folder of a data set keeps it.
    let kept = serde_json::to_string(&recipe).unwrap_or_else(|error| panic!("{error}"));
    let again: Recipe = serde_json::from_str(&kept).unwrap_or_else(|error| panic!("{kept}: {error}"));
    assert_eq!(again.differences(&recipe), Vec::<String>::new());
    recipe.scene = Texts::default();
    recipe.objects.clear();
    recipe.looks.clear();
    recipe.light.sky = None;
    recipe.camera.trajectory = None;
    recipe.unit.calibration = None;
    let file = RecipeFile {
        path: path.to_owned(),
        recipe,
    };
    let Ok(generator) = Generator::open(file, Catalog::builtin()) else {
        return;
    };
    let frame = generator.frames().saturating_sub(1);
    if let Ok(drawn) = generator.explain(frame) {
        let again = generator.explain(frame).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(drawn, again);
    }
}

pub(crate) fn seeds() -> Vec<Vec<u8>> {
    let examples = [
        &include_bytes!("../../../examples/recipes/table_top.toml")[..],
        include_bytes!("../../../examples/recipes/bin_picking.toml"),
        include_bytes!("../../../examples/recipes/indoor_navigation.toml"),
        include_bytes!("../../../examples/recipes/stereo_training.toml"),
        include_bytes!("../../../examples/recipes/time_of_flight.toml"),
    ];
    let unit = b"[unit]\npopulation = 'factory'\ncount = 7\n[unit.drift]\nyaw_mrad = { normal = [0, 0.3] }\ntemperature_k = 12\n";
    examples
        .into_iter()
        .chain([&unit[..]])
        .map(<[u8]>::to_vec)
        .collect()
}
