//! Objects in files of different units.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;

use crate::case::Case;
use oaktwin_generate::GenerateOptions;

/// A recipe with a folder of boxes that are 0.12 long in metres, centimetres and millimetres.
fn case(rule: &str) -> Case {
    let recipe = format!(
        "frames = 4\nscene = 'table.usda'\ncamera = {{ resolution = [64, 40] }}\n\
         output = {{ annotators = 'distance_to_image_plane' }}\n\
         [[objects]]\nfiles = 'boxes/'\non = '/World/Table'\ncount = 2\n{rule}\n"
    );
    let case = Case::new(&recipe);
    let folder = case.folder.path().join("boxes");
    fs::create_dir(&folder).unwrap();
    for (name, unit) in [("m", 1.0), ("cm", 100.0), ("mm", 1000.0)] {
        let vertex = |index: u32| {
            let [x, y, z] = [0.12, 0.06, 0.03].map(|edge| edge * unit);
            let at = |bit: u32, edge: f64| if index >> bit & 1 == 1 { edge } else { 0.0 };
            format!("v {} {} {}\n", at(0, x), at(1, y), at(2, z))
        };
        let vertices: String = (0..8).map(vertex).collect();
        let faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
        fs::write(folder.join(format!("{name}.obj")), vertices + faces).unwrap();
    }
    case
}

#[test]
fn all_files_get_one_size() {
    let case = case("size_m = 0.2");
    let generator = case.open().unwrap();
    let mut units = std::collections::BTreeSet::new();
    for frame in 0..4 {
        for object in generator.explain(frame).unwrap()["arrangement"]["objects"]
            .as_array()
            .unwrap()
        {
            let file = object["file"].as_str().unwrap();
            let unit = if file.ends_with("cm.obj") {
                100.0
            } else if file.ends_with("mm.obj") {
                1000.0
            } else {
                1.0
            };
            units.insert(file.to_owned());
            let length = object["scale"].as_f64().unwrap() * 0.12 * unit;
            assert!((length - 0.2).abs() < 1e-6, "{object}");
        }
    }
    assert!(units.len() > 1, "{units:?}");
    assert_eq!(
        case.generate("set", &GenerateOptions::default())
            .unwrap()
            .findings,
        []
    );
}

#[test]
fn files_of_an_unlikely_size_are_named() {
    let error = case("label = 'box'")
        .generate("set", &GenerateOptions::default())
        .unwrap_err();
    assert!(
        error.contains("m.obj, 1") && error.contains(" m long) in 8 times"),
        "{error}"
    );
    // Small ones have a place.
    let generated = case("scale = 1e-5")
        .generate("set", &GenerateOptions::default())
        .unwrap();
    let finding = generated
        .findings
        .iter()
        .find(|finding| finding.code == "object-size")
        .unwrap();
    assert!(
        finding.place.ends_with(".obj") && finding.message.to_string().ends_with(" mm long"),
        "{finding:?}"
    );
}

#[test]
fn models_have_one_size() {
    let case = case("size_m = { uniform = [0.1, 0.2] }");
    let recipe = case.folder.path().join("recipe.toml");
    let text = fs::read_to_string(&recipe).unwrap();
    fs::write(
        &recipe,
        text.replace("output = { ", "output = { formats = 'bop', "),
    )
    .unwrap();
    let error = case.open().unwrap_err();
    assert!(
        error.contains("objects.0.size_m: bop describes objects by models of one size"),
        "{error}"
    );
}
