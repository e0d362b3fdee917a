//! Data sets of small recipes: determinism, resumption, placement and errors.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use oaktwin_catalog::Catalog;
use oaktwin_generate::recipe::RecipeFile;
use oaktwin_generate::{GenerateOptions, Generated, Generator};
use oaktwin_pipeline::progress::Progress;
use serde_json::Value;

/// The example recipes.
fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/recipes")
}

/// A folder with the scenes and objects of the examples, and a recipe.
struct Case {
    folder: tempfile::TempDir,
}

impl Case {
    fn new(recipe: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        for file in ["table.usda", "bin.usda"] {
            fs::copy(examples().join(file), folder.path().join(file)).unwrap();
        }
        fs::create_dir(folder.path().join("objects")).unwrap();
        for entry in fs::read_dir(examples().join("objects")).unwrap() {
            let entry = entry.unwrap();
            fs::copy(
                entry.path(),
                folder.path().join("objects").join(entry.file_name()),
            )
            .unwrap();
        }
        let case = Self { folder };
        case.write(recipe);
        case
    }

    fn write(&self, recipe: &str) {
        fs::write(self.folder.path().join("recipe.toml"), recipe).unwrap();
    }

    fn open(&self) -> Result<Generator, String> {
        let file =
            RecipeFile::read(&self.folder.path().join("recipe.toml")).map_err(|error| error.to_string())?;
        Generator::open(file, Catalog::builtin()).map_err(|error| error.to_string())
    }

    fn generate(&self, name: &str, options: &GenerateOptions) -> Result<Generated, String> {
        let root = self.folder.path().join(name);
        let watch = |_: Progress| ControlFlow::Continue(());
        self.open()?
            .generate(&root, options, &watch)
            .map_err(|error| error.to_string())
    }

    /// The bytes of all files of a data set.
    fn files(&self, name: &str) -> BTreeMap<PathBuf, Vec<u8>> {
        fn collect(root: &Path, folder: &Path, files: &mut BTreeMap<PathBuf, Vec<u8>>) {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    collect(root, &path, files);
                } else {
                    files.insert(
                        path.strip_prefix(root).unwrap().to_owned(),
                        fs::read(&path).unwrap(),
                    );
                }
            }
        }
        let root = self.folder.path().join(name);
        let mut files = BTreeMap::new();
        collect(&root, &root, &mut files);
        files
    }
}

const TABLE: &str = "
frames = 5
frames_per_scene = 2
scene = 'table.usda'
[[objects]]
files = 'objects/'
count = { uniform = [2, 5] }
on = '/World/Table'
pose = 'resting'
look = { keep = 0.5 }
[light]
lamps = {}
projector = 1
[camera]
resolution = [160, 100]
";

#[test]
fn a_frame_does_not_depend_on_other_frames_or_workers() {
    let case = Case::new(TABLE);
    let whole = case.generate("whole", &GenerateOptions::default()).unwrap();
    assert_eq!((whole.made, whole.missing, whole.is_interrupted), (5, 0, false));
    let parallel = GenerateOptions {
        workers: Some(3),
        ..GenerateOptions::default()
    };
    case.generate("parallel", &parallel).unwrap();
    // Backwards, one at a time, in separate runs.
    for frame in (0..5).rev() {
        let options = GenerateOptions {
            frames: Some(frame..frame + 1),
            resume: true,
            workers: Some(1),
            ..GenerateOptions::default()
        };
        let part = case.generate("parts", &options).unwrap();
        assert_eq!((part.made, part.missing), (1, frame));
    }
    let files = case.files("whole");
    assert_eq!(
        files.len() as u64,
        whole.files + 8,
        "the manifest, the recipe, the lock and five records"
    );
    assert!(files == case.files("parallel") && files == case.files("parts"));
}

#[test]
fn an_interrupted_data_set_is_completed() {
    let case = Case::new(TABLE);
    case.generate("whole", &GenerateOptions::default()).unwrap();
    let calls = AtomicU64::new(0);
    let watch = |_: Progress| match calls.fetch_add(1, Ordering::Relaxed) {
        0..2 => ControlFlow::Continue(()),
        _ => ControlFlow::Break(()),
    };
    let root = case.folder.path().join("broken");
    let one = GenerateOptions {
        workers: Some(1),
        ..GenerateOptions::default()
    };
    let broken = case.open().unwrap().generate(&root, &one, &watch).unwrap();
    assert!(broken.is_interrupted && broken.made == 2);
    assert!(!root.join("manifest.json").exists());
    // A lost file, and one that was cut short.
    fs::remove_file(root.join("rgb_0000.png")).unwrap();
    fs::write(root.join("depth_sensor_distance_0001.npy"), "x").unwrap();
    let resume = GenerateOptions {
        resume: true,
        ..GenerateOptions::default()
    };
    let resumed = case.generate("broken", &resume).unwrap();
    assert_eq!((resumed.made, resumed.skipped), (5, 0));
    assert!(case.files("whole") == case.files("broken"));
    let again = case.generate("broken", &resume).unwrap();
    assert_eq!((again.made, again.skipped), (0, 5));
    let error = case.generate("broken", &GenerateOptions::default()).unwrap_err();
    assert!(error.contains("already has a data set"), "{error}");
    case.write(&TABLE.replace("[160, 100]", "[160, 90]"));
    let error = case.generate("broken", &resume).unwrap_err();
    assert!(error.contains("camera.resolution.1: 100 became 90"), "{error}");
}

/// The arrangement of a frame.
fn arrangement(generator: &Generator, frame: u64) -> Value {
    generator.explain(frame).unwrap()["arrangement"].clone()
}

#[test]
fn objects_stand_on_the_table() {
    let case = Case::new(
        &TABLE
            .replace("'resting'", "'upright'")
            .replace("frames = 5", "frames = 40"),
    );
    let generator = case.open().unwrap();
    let mut counts = BTreeMap::new();
    for frame in (0..40).step_by(2) {
        let objects = arrangement(&generator, frame)["objects"]
            .as_array()
            .unwrap()
            .clone();
        *counts.entry(objects.len()).or_insert(0) += 1;
        for object in &objects {
            let pose = &object["world_from_object"];
            let [x, y, z] = [0, 1, 2].map(|axis| pose["position"][axis].as_f64().unwrap());
            // The top of the table is 1.2 m by 0.8 m, at 0.74 m; the objects' origins are at their bottom.
            assert!(
                x.abs() < 0.6 && y.abs() < 0.4 && (z - 0.7402).abs() < 1e-6,
                "{object}"
            );
            assert!(pose["orientation"][0].as_f64().unwrap().abs() < 1e-9);
        }
    }
    assert!(
        counts.keys().all(|count| (2..=5).contains(count)) && counts.len() > 2,
        "{counts:?}"
    );
}

#[test]
fn every_pose_finds_places_in_a_bin() {
    for pose in ["resting", "piled", "floating"] {
        let case = Case::new(&format!(
            "scene = 'bin.usda'\n[[objects]]\nfiles = 'objects/block.usda'\ncount = 15\npose = '{pose}'\n\
             region = {{ min = [-0.25, -0.15, 0.0], max = [0.25, 0.15, 0.3] }}\n"
        ));
        let objects = arrangement(&case.open().unwrap(), 0)["objects"]
            .as_array()
            .unwrap()
            .clone();
        assert_eq!(objects.len(), 15);
        // Blocks of 5 cm do not overlap if their centres are further apart than their edges.
        let centers: Vec<[f64; 3]> = objects
            .iter()
            .map(|object| center(&object["world_from_object"], 0.025))
            .collect();
        for (at, a) in centers.iter().enumerate() {
            for b in &centers[..at] {
                let distance = (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt();
                assert!(distance > 0.0499, "{pose}: {distance}");
            }
        }
        if pose == "piled" {
            assert!(
                centers.iter().any(|center| center[2] > 0.07),
                "some lie on others: {centers:?}"
            );
        }
    }
}

/// The centre of an object whose origin is at its bottom.
fn center(pose: &Value, half_height: f64) -> [f64; 3] {
    let number = |name: &str, index: usize| pose[name][index].as_f64().unwrap();
    let [x, y, z, w] = [0, 1, 2, 3].map(|index| number("orientation", index));
    // The third column of the rotation.
    let up = [
        2.0 * (x * z + y * w),
        2.0 * (y * z - x * w),
        1.0 - 2.0 * (x * x + y * y),
    ];
    [0, 1, 2].map(|axis| number("position", axis) + half_height * up[axis])
}

#[test]
fn errors_name_the_rule() {
    let error = |recipe: &str| {
        let case = Case::new(recipe);
        fs::create_dir(case.folder.path().join("empty")).unwrap();
        fs::write(
            case.folder.path().join("hollow.usda"),
            "#usda 1.0\ndef Xform \"A\"\n{\n}\n",
        )
        .unwrap();
        case.generate("out", &GenerateOptions::default()).unwrap_err()
    };
    let table = "frames = 1\nscene = 'table.usda'\n[camera]\nresolution = [160, 100]\n";
    for (recipe, expected) in [
        ("[[objects]]\nfiles = 'empty'", "empty: the folder has no objects"),
        (
            "[[objects]]\nfiles = 'none.usda'",
            "none.usda: there is no such file",
        ),
        (
            "[[objects]]\nfiles = 'hollow.usda'",
            "hollow.usda: has no triangles",
        ),
        (
            "[[objects]]\nfiles = 'objects'\non = '/World/Tabel'",
            "there is no prim /World/Tabel with triangles",
        ),
        (
            "[[objects]]\nfiles = 'objects/carton.usda'\ncount = 200\non = '/World/Table'\nattempts = 20",
            "of 200 (objects/carton.usda) in 8 times 20 attempts",
        ),
        (
            "min_coverage = 1\nattempts = 5\nbox = { min = [0, 0, 50], max = [1, 1, 60] }",
            "no pose in 5 attempts: 0 closer",
        ),
        ("look_at = '/World/Lamp'", "there is no prim /World/Lamp"),
        (
            "model = 'OAK-D Pro POE2'",
            "camera.model: unknown model 'OAK-D Pro POE2'; did you mean",
        ),
        (
            "[output]\nformats = ['basik']",
            "unknown format 'basik'; did you mean 'basic'",
        ),
        ("[output]\nannotators = ['rbg']", "rbg"),
        (
            "[sensor]\npreset = 'high detail'",
            "the temporal filter makes a frame depend",
        ),
        ("[sensor]\nengine = 'stereo-nose'", "did you mean 'stereo-noise'"),
        ("[sensor.parameters]\njiter = 1", "jiter"),
    ] {
        let error = error(&format!("{table}{recipe}"));
        assert!(error.contains(expected), "{recipe:?}: {error}");
    }
}
