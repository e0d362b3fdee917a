//! Frames of animated stages.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::program::Program;

fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}

/// An arm with a hand that carries a camera, before a sheet.
const STAGE: &str = r#"#usda 1.0
(
    metersPerUnit = 0.5
    upAxis = "Z"
    startTimeCode = 0
    endTimeCode = 20
    timeCodesPerSecond = 10
)
def Xform "Arm"
{
    double3 xformOp:translate = (0, 0, 2)
    float xformOp:rotateZ.timeSamples = { 0: 0, 20: 90 }
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateZ"]
    def Cube "Link"
    {
        double size = 0.5
        double3 xformOp:translate = (4, 0, 0)
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }
    def Xform "Hand"
    {
        double3 xformOp:translate.timeSamples = { 0: (6, 0, 0), 10: (6, 0, 2) }
        uniform token[] xformOpOrder = ["xformOp:translate"]
        def Camera "Eye"
        {
            float focalLength = 20
            float horizontalAperture = 20
            float3 xformOp:rotateXYZ = (0, 20, 0)
            uniform token[] xformOpOrder = ["xformOp:rotateXYZ"]
        }
    }
}
def Mesh "Sheet"
{
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
    point3f[] points = [(-90, -90, 0), (90, -90, 0), (0, 90, 0)]
    SHEET
}
def DistantLight "Sun" { float inputs:intensity = 1000 }
"#;

/// What changes besides transforms.
const HIDDEN: &str = r#"token visibility.timeSamples = { 0: "inherited", 10: "invisible" }"#;

fn stage(sheet: &str) -> Program {
    let program = Program::new();
    program.put("stage.usda", STAGE.replace("SHEET", sheet));
    program
}

fn read(program: &Program, name: &str) -> Vec<u8> {
    fs::read(program.path(name)).unwrap()
}

fn json(program: &Program, name: &str) -> Value {
    serde_json::from_slice(&read(program, name)).unwrap()
}

#[test]
fn frames_are_those_of_single_times() {
    for sheet in ["", HIDDEN] {
        let program = stage(sheet);
        let outputs = "--resolution 64x40 --annotators rgb,distance_to_image_plane,camera_params";
        program.good(&words(&format!(
            "render stage.usda --frames 0:20:5 {outputs} -o all"
        )));
        for (frame, time) in [0, 5, 10, 15, 20].into_iter().enumerate() {
            program.good(&words(&format!(
                "render stage.usda --time {time} {outputs} -o one{time}"
            )));
            for (name, end) in [
                ("rgb", "png"),
                ("distance_to_image_plane", "npy"),
                ("camera_params", "json"),
            ] {
                let all = read(&program, &format!("all/{name}_{frame:04}.{end}"));
                let one = read(&program, &format!("one{time}/{name}_0000.{end}"));
                assert!(all == one, "{name} at {time}, {sheet}");
            }
        }
        assert!(!program.path("all/rgb_0005.png").exists());
    }
}

#[test]
fn a_mounted_device_follows_its_prim() {
    let program = stage("");
    let device = "--model OAK4-D --camera depth --resolution 64x40 --annotators distance_to_image_plane,camera_params \
                  --mount /Arm/Hand --pose 0.1 0 0.2 0 0 0 1";
    program.good(&words(&format!(
        "render stage.usda --frames 0:20:20 {device} -o all"
    )));
    // A camera's position is the inverse of its view transform, whose last row is the translation for row vectors.
    let position = |name: &str| {
        let params = json(&program, name);
        let view: Vec<f64> = params["cameraViewTransform"]
            .as_array()
            .unwrap()
            .iter()
            .map(|x| x.as_f64().unwrap())
            .collect();
        let along = |axis: usize| -> f64 { -(0..3).map(|i| view[4 * axis + i] * view[12 + i]).sum::<f64>() };
        [along(0), along(1), along(2)]
    };
    // In stage units, of which a metre has two.
    let left = 0.075;
    for (name, expected) in [
        ("all/camera_params_0000.json", [6.2, left, 2.4]),
        ("all/camera_params_0001.json", [-left, 6.2, 4.4]),
    ] {
        let found = position(name);
        let is_near = found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(is_near, "{name}: {found:?}");
    }
    program.good(&words(&format!("render stage.usda --time 20 {device} -o one")));
    let name = "distance_to_image_plane_000";
    assert!(read(&program, &format!("all/{name}1.npy")) == read(&program, &format!("one/{name}0.npy")));
    // A trajectory is relative to the prim, too, with a pose for each frame.
    program.put("path.txt", "0 0.1 0 0.2 0 0 0 1\n1 0.1 0 0.2 0 0 0 1\n");
    let device = device.replace("--pose 0.1 0 0.2 0 0 0 1", "--trajectory path.txt");
    program.good(&words(&format!(
        "render stage.usda --frames 0:20:20 {device} -o path"
    )));
    assert!(read(&program, &format!("all/{name}1.npy")) == read(&program, &format!("path/{name}1.npy")));
    let refused = program.refused(&words(&format!(
        "render stage.usda --frames 0:20:10 {device} -o more"
    )));
    assert!(
        refused.contains("--trajectory: 2 poses, but 3 time codes; give one pose for each frame"),
        "{refused}"
    );
}

#[test]
fn what_a_device_cannot_follow_is_reported_at_each_time() {
    let program = stage("");
    for (scale, expected) in [
        (
            "(2, 2, 2)",
            "its transform contains a scale, which the mounted device ignores",
        ),
        (
            "(0, 0, 0)",
            "its transform is singular; the mounted device stays where it was",
        ),
    ] {
        let scaled = STAGE.replace("SHEET", "").replace(
            "uniform token[] xformOpOrder = [\"xformOp:translate\"]\n        def Camera",
            &format!(
                "float3 xformOp:scale.timeSamples = {{ 0: (1, 1, 1), 20: {scale} }}\n        \
                 uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:scale\"]\n        def Camera"
            ),
        );
        program.put("scaled.usda", scaled);
        let line = "render scaled.usda --model OAK4-D --camera depth --resolution 8x8 --mount /Arm/Hand --pose 0 0 0 0 0 0 1 \
                    --annotators distance_to_image_plane -o out --frames";
        let at = |frames: &str| program.run(&words(&format!("{line} {frames}"))).stderr;
        assert!(!at("0").contains("mount-transform"));
        let said = at("0:20:20");
        assert!(said.contains(expected) && said.contains("/Arm/Hand"), "{said}");
    }
}

#[test]
fn recordings_have_the_times_of_the_stage() {
    let program = stage("");
    program.good(&words(
        "render stage.usda --frames 0:20:5 --resolution 32x20 --record all.mcap",
    ));
    let bytes = read(&program, "all.mcap");
    let stamps = [0_u64, 500_000_000, 1_000_000_000, 1_500_000_000, 2_000_000_000];
    for stamp in stamps {
        assert!(
            bytes.windows(8).any(|window| window == stamp.to_le_bytes()),
            "{stamp}"
        );
    }
    program.good(&words(
        "render stage.usda --frames 0:20:5 --fps 4 --resolution 32x20 --record slow.mcap",
    ));
    let slow = read(&program, "slow.mcap");
    assert!(
        slow.windows(8)
            .any(|window| window == 250_000_000_u64.to_le_bytes())
    );
    assert!(
        !bytes
            .windows(8)
            .any(|window| window == 250_000_000_u64.to_le_bytes())
    );
}

#[test]
fn invalid_requests_are_rejected() {
    let program = stage("");
    program.put("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    program.put(
        "still.usda",
        "#usda 1.0\ndef Cube \"Box\" {}\ndef Camera \"Eye\" {}\n",
    );
    let device = "--model OAK4-D --pose 0 0 0 0 0 0 1";
    for (line, expected) in [
        ("stage.usda --frames 5:0".to_owned(), "--frames: 0 is before 5"),
        (
            "stage.usda --frames 0:5:0".to_owned(),
            "--frames: the step is 0; give a number above 0",
        ),
        (
            "stage.usda --frames a".to_owned(),
            "write FIRST:LAST or FIRST:LAST:STEP",
        ),
        ("stage.usda --frames 0:1e12".to_owned(), "give at most 1000000"),
        (
            "stage.usda --frames 0:1 --fps 0".to_owned(),
            "--fps: must be a number above 0",
        ),
        (
            "mesh.obj --frames 0:1".to_owned(),
            "mesh.obj: is not animated, because only USD stages and glTF files are",
        ),
        (
            format!("stage.usda --frames 0:1 --imu imu.csv {device}"),
            "remove --frames and --mount",
        ),
        (
            format!("stage.usda {device} --mount /Arm/Hnd"),
            "/Arm/Hnd: there is no such prim with a transform; did you mean '/Arm/Hand'",
        ),
        (
            "still.usda --frames 0:1 --strict".to_owned(),
            "is not animated: all times show the same",
        ),
        (
            "stage.usda --frames 10:30:10 --strict".to_owned(),
            "is animated from 0 to 20; 1 of 3 time codes are outside",
        ),
        (
            "stage.usda --time 30 --strict".to_owned(),
            "is animated from 0 to 20; the time code 30 is outside",
        ),
        (
            format!("stage.usda --time -1 --strict {device} --mount /Arm/Hand"),
            "is animated from 0 to 20; the time code -1 is outside",
        ),
    ] {
        let refused = program.refused(&words(&format!("render {line} --resolution 8x8 -o out")));
        assert!(refused.contains(expected), "{line}: {refused}");
        assert!(!Path::new(&program.path("out")).exists(), "{line}");
    }
}
