//! Data sets of small recipes: placement, units and errors.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::case::{Case, TABLE};
use oaktwin_generate::{GenerateOptions, Generator};
use serde_json::Value;

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
            "objects/carton.usda, 0.21 m long) in 8 times 20 attempts",
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

/// Every arrangement has its own unit, whose calibration lies beside the data; the drift moves its measurements.
#[test]
fn units_of_a_population_are_written_beside_the_data() {
    let recipe = |drift: &str| {
        format!("{TABLE}\n[unit]\npopulation = 'factory'\n{drift}\n[sensor]\nparameters = {{ jitter = 0 }}\n")
    };
    let case = Case::new(&recipe(""));
    case.generate("units", &GenerateOptions::default()).unwrap();
    let files = case.files("units");
    let names: Vec<&str> = (files.keys())
        .filter_map(|path| path.strip_prefix("units").ok()?.to_str())
        .collect();
    let unit = |number| format!("oak_d_pro_poe_00000{number}.json");
    assert_eq!(names, ["frames.csv", &unit(0), &unit(1), &unit(2)]);
    let table = String::from_utf8(files[Path::new("units/frames.csv")].clone()).unwrap();
    assert!(
        table.contains("\n3,OAK-D Pro PoE,1,oak_d_pro_poe_000001.json,\n"),
        "{table}"
    );
    let text = files[Path::new("units/oak_d_pro_poe_000001.json")].as_slice();
    let raw = oaktwin_calibration::Raw::parse(text, "unit").unwrap();
    let (calibration, _) = oaktwin_calibration::Calibration::from_raw(&raw).unwrap();
    let fx = calibration.cameras[&oaktwin_calibration::Socket::CAM_C]
        .intrinsics
        .fx;
    // RVC2 rectifies both images to the right camera's intrinsics.
    let params: Value = serde_json::from_slice(&files[Path::new("camera_params_0003.json")]).unwrap();
    let projection = params["cameraProjection"][0].as_f64().unwrap();
    assert!(
        (projection * 1280.0 / 2.0 / fx - 1.0).abs() < 1e-6,
        "{projection} {fx}"
    );

    // The same frames by several workers, with the exact depth unchanged by drift.
    case.write(&recipe(
        "count = 2\ndrift = { yaw_mrad = { normal = [0, 1] }, pitch_mrad = 1 }",
    ));
    case.generate("whole", &GenerateOptions::default()).unwrap();
    let parallel = GenerateOptions {
        workers: Some(3),
        ..GenerateOptions::default()
    };
    case.generate("parallel", &parallel).unwrap();
    let drifted = case.files("whole");
    assert_eq!(drifted, case.files("parallel"));
    let exact = Path::new("distance_to_image_plane_0000.npy");
    let sensed = Path::new("depth_sensor_distance_0000.npy");
    assert!(drifted[exact] == files[exact] && drifted[sensed] != files[sensed]);
    assert!(!drifted.contains_key(Path::new("units/oak_d_pro_poe_000002.json")));
}

#[test]
fn cameras_that_measure_nothing_are_named() {
    let recipe =
        "frames = 1\nscene = 'table.usda'\n[camera]\nresolution = [64, 40]\ncameras = ['depth', 'rgb']\n";
    let case = Case::new(recipe);
    let generated = case.generate("set", &GenerateOptions::default()).unwrap();
    let codes: Vec<_> = generated
        .findings
        .iter()
        .map(|finding| (finding.code, finding.place.as_str()))
        .collect();
    assert_eq!(codes, [("no-depth-sensor", "OAK-D Pro PoE/Camera_rgb_imx378")]);
    case.write(&format!("{recipe}[sensor]\nalign = 'rgb'\n"));
    let aligned = case.generate("aligned", &GenerateOptions::default()).unwrap();
    assert_eq!(aligned.findings, []);
}
