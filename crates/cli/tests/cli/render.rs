//! `render`: which cameras, which files, and what is in them.

use std::fs;

use oaktwin::image::npy;
use serde_json::Value;

use crate::program::Program;

/// Two cameras, one of them a depth sensor's. The left one sees the middle of the box's front 2 m ahead.
const ROOM: &str = include_str!("fixtures/room.usda");
/// A cube of a metre about (0, 0, 0.5).
const CRATE: &str = include_str!("fixtures/crate.obj");

pub(crate) fn program() -> Program {
    let program = Program::new();
    program.put("room.usda", ROOM);
    program.put("crate.obj", CRATE);
    program
}

/// The depth image of a file: its size and its pixels.
pub(crate) fn depth(program: &Program, name: &str) -> ((usize, usize), Vec<f32>) {
    let bytes = fs::read(program.path(name)).unwrap();
    let image = npy::decode(&bytes).unwrap().into_f32_image().unwrap();
    (
        (image.width() as usize, image.height() as usize),
        image.into_pixels(),
    )
}

fn centre(program: &Program, name: &str) -> f32 {
    let ((width, height), pixels) = depth(program, name);
    pixels[height / 2 * width + width / 2]
}

#[test]
fn the_depth_sensor_by_default_flat() {
    let program = program();
    let printed = program.good(&["render", "room.usda", "-o", "out"]);
    assert_eq!(printed, "out  /Render/Depth, 64x40, 1 frame\n");
    let (size, _) = depth(&program, "out/distance_to_image_plane_0000.npy");
    assert_eq!(size, (64, 40));
    let z = centre(&program, "out/distance_to_image_plane_0000.npy");
    assert!((z - 2.0).abs() < 1e-6, "{z}");
}

#[test]
fn what_is_written_unless_asked_otherwise_and_beside_it() {
    let program = program();
    let written = |folder: &str, more: &[&str]| -> Vec<String> {
        program.good(&[&["render", "room.usda", "-o", folder], more].concat());
        let names = program.names().into_iter();
        names
            .filter_map(|name| name.strip_prefix(&format!("{folder}/")).map(str::to_owned))
            .collect()
    };
    assert_eq!(
        written("plain", &[]),
        [
            "camera_params_0000.json",
            "distance_to_image_plane_0000.npy",
            "metadata.txt",
            "rgb_0000.png",
        ]
    );
    // A file beside an annotator's own brings the annotator with it.
    let extras = [
        "--annotators",
        "normals",
        "--png16",
        "--exr",
        "--preview",
        "--ply",
    ];
    assert_eq!(
        written("more", &extras),
        [
            "distance_to_image_plane_0000.exr",
            "distance_to_image_plane_0000.npy",
            "distance_to_image_plane_millimetres_0000.png",
            "distance_to_image_plane_preview_0000.png",
            "metadata.txt",
            "normals_0000.png",
            "pointcloud_0000.npy",
            "pointcloud_0000.ply",
            "pointcloud_instance_0000.npy",
            "pointcloud_normals_0000.npy",
            "pointcloud_semantic_0000.npy",
        ]
    );
}

#[test]
fn apertures_as_isaac_or_openusd_reads_them() {
    let program = program();
    let focal = |projection: &str| {
        let printed = program.good(&[
            "render",
            "room.usda",
            "--camera",
            "Left",
            "--resolution",
            "64x64",
            "--annotators",
            "camera_params",
            "--projection",
            projection,
            "--json",
        ]);
        let report: Value = serde_json::from_str(&printed).unwrap();
        let number = |name: &str| report["cameras"][0][name].as_f64().unwrap();
        (number("fx"), number("fy"))
    };
    assert_eq!(focal("isaac"), (64.0, 64.0));
    let (fx, fy) = focal("openusd");
    assert!((fx - 64.0).abs() < 1e-9 && (fy - 64.0 * 20.0 / 15.0).abs() < 1e-4);
}

#[test]
fn a_stage_at_a_time() {
    let program = program();
    let moving = ROOM.replacen(
        "double3 xformOp:translate = (0, -225, 25)",
        "double3 xformOp:translate.timeSamples = { 0: (0, -225, 25), 10: (0, -325, 25) }",
        1,
    );
    program.put("moving.usda", moving);
    for (time, expected) in [("0", 2.0), ("5", 2.5), ("10", 3.0)] {
        program.good(&["render", "moving.usda", "--time", time, "-o", "out"]);
        let z = centre(&program, "out/distance_to_image_plane_0000.npy");
        assert!((z - expected).abs() < 1e-6, "{z} at {time}");
    }
}

#[test]
fn several_cameras_in_a_folder_each() {
    let program = program();
    let printed = program.good(&[
        "render",
        "room.usda",
        "--camera",
        "left",
        "--camera",
        "/World/Right",
        "--resolution",
        "32x24",
        "--json",
    ]);
    let report: Value = serde_json::from_str(&printed).unwrap();
    assert_eq!(report["cameras"][0]["folder"], "oaktwin-render/Left");
    assert_eq!(report["cameras"][1]["path"], "/World/Right");
    assert_eq!(report["cameras"][1]["fx"], 32.0);
    for file in report["files"].as_array().unwrap() {
        let length = fs::metadata(program.path(file["path"].as_str().unwrap()))
            .unwrap()
            .len();
        assert_eq!(file["bytes"], length);
    }
    let written = report["files"].as_array().unwrap().len();
    let names = program.names();
    assert_eq!(
        names
            .iter()
            .filter(|name| name.starts_with("oaktwin-render/") && program.path(name).is_file())
            .count(),
        written
    );
    for folder in ["Left", "Right"] {
        let (size, _) = depth(
            &program,
            &format!("oaktwin-render/{folder}/distance_to_image_plane/distance_to_image_plane_0000.npy"),
        );
        assert_eq!(size, (32, 24));
    }
}

#[test]
fn an_oak_looks_at_a_mesh() {
    let program = program();
    let at = |arguments: &[&str]| {
        program.good(
            &[
                &["render", "crate.obj", "-o", "out", "--resolution", "64x40"],
                arguments,
            ]
            .concat(),
        );
        centre(&program, "out/distance_to_image_plane_0000.npy")
    };
    // The left camera is 3.75 cm beside the body's origin, and sees the front face 1.5 m ahead.
    let looked = at(&[
        "--model",
        "oak-d-pro-poe",
        "--look-at",
        "-2",
        "0",
        "0.5",
        "0",
        "0",
        "0.5",
    ]);
    assert!((looked - 1.5).abs() < 1e-6, "{looked}");
    let posed = at(&[
        "--model", "OAK4-D", "--pose", "-2", "0", "0.5", "0", "0", "0", "1",
    ]);
    assert!((posed - 1.5).abs() < 1e-6, "{posed}");
    // A view from above requires an up direction.
    let down = [
        "--model",
        "OAK4-D",
        "--look-at",
        "0",
        "0",
        "3",
        "0",
        "0",
        "0",
        "1",
        "0",
        "0",
    ];
    assert!((at(&down) - 2.0).abs() < 1e-6);
    assert!((at(&[&down[..], &["--scale", "0.5"]].concat()) - 2.5).abs() < 1e-6);
}

/// The asset of a model in a stage, and the model put at the same place: one camera.
#[test]
fn an_asset_and_its_model_see_the_same() {
    let program = program();
    for model in ["oak4-d", "oak-d-pro-w-poe"] {
        program.good(&["asset", model, "-o", "oak.usd"]);
        let things = r#"
            def Cube "Box" {
                double size = 0.5
                double3 xformOp:translate = (1.5, 0.2, 0.4)
                double xformOp:rotateZ = 30
                uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateZ"]
            }
            def Plane "Wall" {
                double width = 9
                double length = 9
                uniform token axis = "X"
                double3 xformOp:translate = (4, 0, 0)
                uniform token[] xformOpOrder = ["xformOp:translate"]
            }"#;
        let oak = r#"
            def Xform "Oak" (references = @oak.usd@) {
                double3 xformOp:translate = (0.1, 0.1, 0.5)
                double xformOp:rotateZ = 10
                uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateZ"]
            }"#;
        let header = "#usda 1.0\n(\n    metersPerUnit = 1\n    upAxis = \"Z\"\n)\n";
        program.put("with.usda", format!("{header}{things}{oak}\n"));
        program.put("without.usda", format!("{header}{things}\n"));
        let half = 5f64.to_radians();
        let (z, w) = (half.sin().to_string(), half.cos().to_string());
        let depth_only = ["--annotators", "distance_to_image_plane", "-o"];
        program.good(&[&["render", "with.usda"], &depth_only[..], &["asset"]].concat());
        let pose = ["--model", model, "--pose", "0.1", "0.1", "0.5", "0", "0", &z, &w];
        program.good(&[&["render", "without.usda"], &depth_only[..], &["model"], &pose].concat());
        let (_, asset) = depth(&program, "asset/distance_to_image_plane_0000.npy");
        let (_, model) = depth(&program, "model/distance_to_image_plane_0000.npy");
        // Attributes are floats: at a few places of an edge, another side of it is seen.
        let same = |a: f32, b: f32| a == b || (a / b - 1.0).abs() < 1e-5;
        let differ = asset.iter().zip(&model).filter(|(a, b)| !same(**a, **b)).count();
        assert!(differ < 20, "{differ} pixels");
        assert!(asset.iter().filter(|z| z.is_finite()).count() > 1280 * 800 / 2);
    }
}

#[test]
fn the_fisheye_of_a_wide_model_sees_beyond_its_pinhole() {
    let program = program();
    // A wall that fills all of the pinhole's view, but not of the fisheye's.
    program.put("wall.obj", "v 1 -2 -2\nv 1 2 -2\nv 1 2 2\nv 1 -2 2\nf 1 2 3 4\n");
    let seen = |lens: &str| {
        program.good(&[
            "render",
            "wall.obj",
            "-o",
            lens,
            "--up",
            "z",
            "--model",
            "oak-d-pro-w-poe",
            "--camera",
            "left",
            "--lens",
            lens,
            "--pose",
            "0",
            "0",
            "0",
            "0",
            "0",
            "0",
            "1",
            "--resolution",
            "128x80",
        ]);
        let (_, pixels) = depth(&program, &format!("{lens}/distance_to_image_plane_0000.npy"));
        let hit = pixels.iter().filter(|z| z.is_finite());
        assert!(hit.clone().all(|z| (z - 1.0).abs() < 1e-6), "{lens}");
        hit.count()
    };
    assert_eq!(seen("pinhole"), 128 * 80);
    assert!(seen("fisheye") < 128 * 80);
}

#[test]
fn a_frame_for_each_pose() {
    let program = program();
    program.put("tum.txt", "# t x y z q\n0 -2 0 0.5 0 0 0 1\n1 -3 0 0.5 0 0 0 1\n");
    program.put(
        "path.json",
        r#"[{"position": [-2, 0, 0.5], "orientation": [0, 0, 0, 1]},
            {"time": 1, "position": [-3, 0, 0.5], "orientation": [0, 0, 0, 1]}]"#,
    );
    for path in ["tum.txt", "path.json"] {
        let printed = program.good(&[
            "render",
            "crate.obj",
            "--model",
            "oak4-d",
            "--trajectory",
            path,
            "-o",
            "out",
            "--resolution",
            "64x40",
        ]);
        assert_eq!(printed, "out  OAK4-D/Camera_pseudo_depth, 64x40, 2 frames\n");
        let z = [0, 1].map(|n| centre(&program, &format!("out/distance_to_image_plane_000{n}.npy")));
        assert!((z[0] - 1.5).abs() < 1e-6 && (z[1] - 2.5).abs() < 1e-6, "{z:?}");
    }
    // A stage's own camera: its optical frame, z forward. Here down from above the box.
    program.put("down.txt", "0 0 0 1.5 1 0 0 0\n");
    program.good(&["render", "room.usda", "--trajectory", "down.txt", "-o", "down"]);
    assert!((centre(&program, "down/distance_to_image_plane_0000.npy") - 1.0).abs() < 1e-6);
}

#[test]
fn the_same_bytes_on_any_number_of_threads() {
    let program = program();
    for (folder, threads) in [("one", "1"), ("two", "2"), ("three", "3")] {
        program.good(&[
            "render",
            "room.usda",
            "-o",
            folder,
            "--annotators",
            "all",
            "--threads",
            threads,
        ]);
    }
    let names: Vec<String> = program
        .names()
        .into_iter()
        .filter_map(|name| name.strip_prefix("one/").map(str::to_owned))
        .collect();
    assert!(!names.is_empty());
    for name in names {
        let read = |folder: &str| fs::read(program.path(folder).join(&name)).unwrap();
        assert_eq!(read("one"), read("two"), "{name}");
        assert_eq!(read("one"), read("three"), "{name}");
    }
}

#[test]
fn missing_contents_are_reported_and_rejected_when_strict() {
    let program = program();
    program.put(
        "part.usda",
        ROOM.replace(
            "def Xform \"World\"",
            "def Xform \"World\" (references = @gone.usda@)",
        ),
    );
    let ended = program.run(&["render", "part.usda", "-o", "out"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    assert!(
        ended.stderr.contains("part.usda: warning[composition]: /World: ")
            && ended.stderr.contains("gone.usda"),
        "{}",
        ended.stderr
    );
    let error = program.refused(&["render", "part.usda", "-o", "strict", "--strict"]);
    assert!(error.contains("gone.usda"), "{error}");
    // A texture that turns out to be none only when it is needed.
    program.put("crate.mtl", "newmtl wood\nmap_Kd wood.png\n");
    program.put("wood.png", "no picture");
    program.put(
        "textured.obj",
        CRATE.replace("o Crate", "mtllib crate.mtl\no Crate\nusemtl wood"),
    );
    let textured = [
        "render",
        "textured.obj",
        "--model",
        "oak4-d",
        "--pose",
        "-2",
        "0",
        "0.5",
        "0",
        "0",
        "0",
        "1",
        "--resolution",
        "64x40",
    ];
    let ended = program.run(&textured);
    assert!(
        ended.code == 0 && ended.stderr.contains("wood.png"),
        "{}",
        ended.stderr
    );
    fs::remove_dir_all(program.path("oaktwin-render")).unwrap();
    let error = program.refused(&[&textured[..], &["--strict"]].concat());
    assert!(error.contains("wood.png"), "{error}");
}
