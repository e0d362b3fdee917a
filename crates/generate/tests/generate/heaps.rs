//! Heaps of small recipes: they lie still, in their bins, without interpenetration.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::case::Case;
use oaktwin_generate::GenerateOptions;
use serde_json::Value;

const HEAP: &str = "
frames = 4
scene = 'bin.usda'
[[objects]]
files = ['objects/block.usda', 'objects/can.usda', 'objects/mug.usda']
count = 12
pose = 'piled'
region = { min = [-0.24, -0.14, 0.03], max = [0.24, 0.14, 0.35] }
[camera]
resolution = [160, 100]
";

fn objects(explained: &Value) -> Vec<Value> {
    explained["arrangement"]["objects"].as_array().unwrap().clone()
}

fn number(object: &Value, name: &str, index: usize) -> f64 {
    object["world_from_object"][name][index].as_f64().unwrap()
}

/// A point of an object in the world.
fn point(object: &Value, at: [f64; 3]) -> [f64; 3] {
    let [x, y, z, w] = [0, 1, 2, 3].map(|index| number(object, "orientation", index));
    let rows = [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - z * w),
            2.0 * (x * z + y * w),
        ],
        [
            2.0 * (x * y + z * w),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - x * w),
        ],
        [
            2.0 * (x * z - y * w),
            2.0 * (y * z + x * w),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ];
    [0, 1, 2].map(|axis| {
        let turned: f64 = (0..3).map(|column| rows[axis][column] * at[column]).sum();
        turned + number(object, "position", axis)
    })
}

/// The corners of a block of 5 cm, whose origin is at its bottom.
fn corners(object: &Value) -> Vec<[f64; 3]> {
    let sign = |corner: u32, axis: u32| if corner >> axis & 1 == 0 { -0.025 } else { 0.025 };
    let corner = |corner| {
        point(
            object,
            [sign(corner, 0), sign(corner, 1), 0.025 + sign(corner, 2)],
        )
    };
    (0..8).map(corner).collect()
}

#[test]
fn heaps_stay_inside_their_bin() {
    let case = Case::new(&HEAP.replace("count = 12", "count = 30"));
    let generator = case.open().unwrap();
    for frame in 0..3 {
        let objects = objects(&generator.explain(frame).unwrap());
        assert_eq!(objects.len(), 30);
        for object in &objects {
            // The bin is 0.58 m by 0.38 m inside, and its bottom is 1 cm thick.
            let height = match object["label"].as_str().unwrap() {
                "block" => 0.05,
                "can" => 0.115,
                _ => 0.095,
            };
            let center = point(object, [0.0, 0.0, height / 2.0]);
            assert!(
                center[0].abs() < 0.27 && center[1].abs() < 0.17 && center[2] > 0.03,
                "{object}"
            );
            if object["label"] == "block" {
                let inside = corners(object);
                let mut inside = inside.iter();
                assert!(
                    inside.all(|[x, y, z]| x.abs() < 0.2909 && y.abs() < 0.1909 && *z > 0.0091),
                    "{object}"
                );
            }
        }
    }
}

#[test]
fn blocks_of_a_heap_do_not_overlap() {
    let recipe = HEAP
        .replace(
            "['objects/block.usda', 'objects/can.usda', 'objects/mug.usda']",
            "'objects/block.usda'",
        )
        .replace("count = 12", "count = 40");
    let case = Case::new(&recipe);
    let objects = objects(&case.open().unwrap().explain(1).unwrap());
    let blocks: Vec<Vec<[f64; 3]>> = objects.iter().map(corners).collect();
    let mut highest: f64 = 0.0;
    for (at, a) in blocks.iter().enumerate() {
        for b in &blocks[..at] {
            // 1 % of their size.
            assert!(separation(a, b) > -8.7e-4, "{}", separation(a, b));
        }
        highest = a.iter().map(|corner| corner[2]).fold(highest, f64::max);
    }
    assert!(highest > 0.09, "some lie on others: {highest}");
}

/// The largest gap between two blocks along a normal of a face or across two edges; negative if they overlap.
fn separation(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let minus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
    let cross =
        |a: [f64; 3], b: [f64; 3]| [1, 2, 0].map(|i: usize| a[i] * b[(i + 1) % 3] - a[(i + 1) % 3] * b[i]);
    let edges = |block: &[[f64; 3]]| [1, 2, 4].map(|corner| minus(block[corner], block[0]));
    let mut axes: Vec<[f64; 3]> = edges(a).into_iter().chain(edges(b)).collect();
    for first in edges(a) {
        axes.extend(edges(b).map(|second| cross(first, second)));
    }
    let range = |block: &[[f64; 3]], axis: [f64; 3]| {
        let along = block
            .iter()
            .map(|corner| (0..3).map(|i| corner[i] * axis[i]).sum::<f64>());
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
            [low.min(value), high.max(value)]
        })
    };
    let gaps = axes.into_iter().filter_map(|axis| {
        let length = axis.iter().map(|x| x * x).sum::<f64>().sqrt();
        let ([low, high], [other_low, other_high]) = (range(a, axis), range(b, axis));
        (length > 1e-5).then(|| (low - other_high).max(other_low - high) / length)
    });
    gaps.fold(f64::NEG_INFINITY, f64::max)
}

#[test]
fn objects_fall_into_a_bowl() {
    let case = Case::new(
        "scene = 'table.usda'\n[[objects]]\nfiles = 'objects/bowl.usda'\non = '/World/Table'\n\
         region = { min = [0, 0, 0.7], max = [0, 0, 0.8] }\n\
         [[objects]]\nfiles = 'objects/block.usda'\nscale = 0.4\ncount = 3\npose = 'piled'\n\
         region = { min = [-0.02, -0.02, 0.8], max = [0.02, 0.02, 1.0] }\n",
    );
    let objects = objects(&case.open().unwrap().explain(0).unwrap());
    assert_eq!(objects.len(), 4);
    // The bowl stands on the table, 0.74 m high, and is 5 cm high and 13 cm wide.
    assert!((number(&objects[0], "position", 2) - 0.7402).abs() < 1e-6);
    for block in &objects[1..] {
        let [x, y, z] = point(block, [0.0, 0.0, 0.01]);
        assert!(x.hypot(y) < 0.06 && (0.755..0.785).contains(&z), "{x} {y} {z}");
    }
}

#[test]
fn heaps_do_not_depend_on_the_number_of_workers() {
    let case = Case::new(HEAP);
    let generate = |name: &str, workers| {
        let options = GenerateOptions {
            workers: Some(workers),
            ..GenerateOptions::default()
        };
        let generated = case.generate(name, &options).unwrap();
        assert_eq!(generated.made, 4);
        case.files(name)
    };
    assert!(generate("one", 1) == generate("four", 4), "the files differ");
}

#[test]
fn what_leaves_its_region_is_left_out_and_reported() {
    let case = Case::new(
        "frames = 1\nscene = 'table.usda'\n[[objects]]\nfiles = 'objects/block.usda'\ncount = 24\npose = 'piled'\n\
         region = { min = [-0.01, -0.01, 0.76], max = [0.01, 0.01, 3.0] }\n[camera]\nresolution = [160, 100]\n",
    );
    let generated = case.generate("out", &GenerateOptions::default()).unwrap();
    let overflows = generated
        .findings
        .iter()
        .find(|finding| finding.code == "heap-overflows");
    let Some(finding) = overflows else {
        panic!("{:?}", generated.findings);
    };
    assert!(
        finding.place.ends_with("recipe.toml: objects.0: frame 0"),
        "{finding}"
    );
    let objects = objects(&case.open().unwrap().explain(0).unwrap());
    assert!((2..24).contains(&objects.len()), "{}", objects.len());
    for object in &objects {
        let [x, y, z] = point(object, [0.0, 0.0, 0.025]);
        assert!(x.abs() < 0.06 && y.abs() < 0.06 && z > 0.76, "{object}");
    }
}
