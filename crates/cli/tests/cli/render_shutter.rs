//! Frames that take time, and animated glTF files.

use std::fs;

use crate::program::Program;

const STAGE: &str = r#"#usda 1.0
(
    metersPerUnit = 1
    upAxis = "Z"
    startTimeCode = 0
    endTimeCode = 20
    timeCodesPerSecond = 10
)
def Xform "Arm"
{
    float xformOp:rotateX.timeSamples = { 0: 0, 20: 720 }
    uniform token[] xformOpOrder = ["xformOp:rotateX"]
    def Cube "Link"
    {
        double size = 0.4
        double3 xformOp:translate = (2, 0.5, 0)
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }
}
def Camera "Eye"
{
    float focalLength = 20
    float horizontalAperture = 20
    double3 xformOp:translate.timeSamples = { 0: (0, 0, 0), 20: (0, 1, 0) }
    float3 xformOp:rotateXYZ = (90, 0, -90)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateXYZ"]
}
def DistantLight "Sun" { float inputs:intensity = 1000 }
"#;

const OUTPUTS: &str = "--resolution 96x60 --annotators rgb,distance_to_image_plane";

fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}

fn program() -> Program {
    let program = Program::new();
    program.put("stage.usda", STAGE);
    program.put(
        "path.tum",
        "0 0 0 0 0 0 0 1\n0.1 0 2 0 0 0 0 1\n0.2 0 6 0 0 0 0 1\n",
    );
    program.put("two.tum", "0 0 0 0 0 0 0 1\n0.005 0 0.1 0 0 0 0 1\n");
    program.put("one.tum", "0 0 0 0 0 0 0 1\n");
    program
}

fn read(program: &Program, name: &str) -> Vec<u8> {
    fs::read(program.path(name)).unwrap()
}

#[test]
fn exposure_changes_colours_and_not_the_ground_truth() {
    let program = program();
    let oak = "--model OAK-D-Pro-PoE --camera rgb";
    for (name, what) in [
        ("cameras", "--frames 0:10:5".to_owned()),
        ("path", format!("--trajectory path.tum {oak}")),
        (
            "mount",
            format!("--frames 0:10:5 {oak} --mount /Eye --pose 0 0 0 -0.5 0.5 0.5 0.5"),
        ),
        ("pose", format!("{oak} --pose 0 0 0 0 0 0 1")),
    ] {
        let velocity = if name == "pose" {
            "--velocity 0 3 0 0 0 60"
        } else {
            ""
        };
        for (folder, shutter) in [
            ("still", String::new()),
            ("taken", format!("--exposure 15 {velocity}")),
            ("again", format!("--exposure 15 {velocity} --threads 1")),
            ("rolls", format!("--readout 90 {velocity}")),
        ] {
            program.good(&words(&format!(
                "render stage.usda {what} {OUTPUTS} {shutter} -o {name}/{folder}"
            )));
        }
        // In the first frame, what is animated is at rest until its time.
        let number = usize::from(["cameras", "mount"].contains(&name));
        let of = |folder: &str, file: &str| {
            let end = if file == "rgb" { "png" } else { "npy" };
            read(&program, &format!("{name}/{folder}/{file}_000{number}.{end}"))
        };
        for folder in ["taken", "rolls"] {
            assert_eq!(
                of("still", "distance_to_image_plane"),
                of(folder, "distance_to_image_plane"),
                "{name}"
            );
            assert_ne!(of("still", "rgb"), of(folder, "rgb"), "{name}, {folder}");
        }
        assert_eq!(of("taken", "rgb"), of("again", "rgb"), "{name}");
        assert_ne!(of("taken", "rgb"), of("rolls", "rgb"), "{name}");
    }
}

#[test]
fn cameras_have_their_own_times() {
    let program = program();
    let oak = "--model OAK-D-Pro-PoE --camera rgb --trajectory path.tum --writer tum";
    program.good(&words(&format!("render stage.usda {oak} {OUTPUTS} -o same")));
    program.good(&words(&format!(
        "render stage.usda {oak} {OUTPUTS} --camera-offset rgb=50 -o later"
    )));
    let stamps = |folder: &str| -> Vec<String> {
        let list = String::from_utf8(read(&program, &format!("{folder}/000000/rgb.txt"))).unwrap();
        let lines = list.lines().filter(|line| !line.starts_with('#'));
        lines
            .map(|line| line.split(' ').next().unwrap().to_owned())
            .collect()
    };
    assert_eq!(stamps("same"), ["0.000000000", "0.100000000", "0.200000000"]);
    assert_eq!(stamps("later"), ["0.050000000", "0.150000000", "0.250000000"]);
    // Between the first two poses, the body is at y = 0.75 m, by the parabola through the three.
    let truth = String::from_utf8(read(&program, "later/000000/groundtruth.txt")).unwrap();
    let of = |folder: &str| -> Vec<f64> {
        let text = String::from_utf8(read(&program, &format!("{folder}/000000/groundtruth.txt"))).unwrap();
        let line = text
            .lines()
            .find(|line| !line.starts_with('#'))
            .unwrap()
            .to_owned();
        line.split(' ').map(|number| number.parse().unwrap()).collect()
    };
    let moved = of("later")[2] - of("same")[2];
    assert!((moved - 0.75).abs() < 1e-6, "{moved}: {truth}");

    program.good(&words(&format!(
        "render stage.usda --model OAK-D-Pro-PoE --camera rgb --trajectory path.tum {OUTPUTS} --exposure 5 --camera-offset rgb=50 --record a.mcap"
    )));
    let file = read(&program, "a.mcap");
    let messages = mcap::MessageStream::new(&file).unwrap();
    let images = messages
        .map(Result::unwrap)
        .filter(|message| message.channel.topic.ends_with("/rgb"));
    let times: Vec<u64> = images.map(|message| message.log_time).collect();
    assert_eq!(times, [50_000_000, 150_000_000, 250_000_000]);
}

/// A triangle that moves 2 m to the left in 2 s, and whose third corner rises by its morph target, and sinks again.
fn gltf() -> String {
    let numbers: [f32; 30] = [
        0., 0., 0., 1., 0., 0., 0., 1., 0., // POSITION
        0., 0., 0., 0., 0., 0., 0., 1., 0., // the target
        0., 1., 2., // keyframes
        0., 0., 0., 1., 0., 0., 2., 0., 0.,
    ];
    let bytes = numbers
        .iter()
        .chain(&[0.0f32, 1.0, 0.0])
        .flat_map(|number| number.to_le_bytes());
    let data: String = bytes.map(|byte| format!("%{byte:02x}")).collect();
    format!(
        r#"{{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":132,"uri":"data:application/octet-stream,{data}"}}],
        "bufferViews":[{{"buffer":0,"byteLength":132}}],
        "accessors":[
            {{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}},
            {{"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"}},
            {{"bufferView":0,"byteOffset":72,"componentType":5126,"count":3,"type":"SCALAR"}},
            {{"bufferView":0,"byteOffset":84,"componentType":5126,"count":3,"type":"VEC3"}},
            {{"bufferView":0,"byteOffset":120,"componentType":5126,"count":3,"type":"SCALAR"}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"targets":[{{"POSITION":1}}]}}]}}],
        "nodes":[{{"mesh":0,"name":"Sail"}}],
        "animations":[{{"channels":[{{"sampler":0,"target":{{"node":0,"path":"translation"}}}}, MORE],
            "samplers":[{{"input":2,"output":3}},{{"input":2,"output":4}}]}}]}}"#
    )
}

#[test]
fn gltf_frames_are_those_of_single_times() {
    let morph = r#"{"sampler":1,"target":{"node":0,"path":"weights"}}"#;
    for more in [format!(", {morph}"), String::new()] {
        let program = Program::new();
        program.put("sail.gltf", gltf().replace(", MORE", &more));
        let oak = format!("--model OAK4-D --camera rgb --look-at 1 0.5 4 1 0.5 0 0 1 0 {OUTPUTS}");
        program.good(&words(&format!("render sail.gltf --frames 0:2:0.5 {oak} -o all")));
        let mut frames = Vec::new();
        for (number, time) in ["0", "0.5", "1", "1.5", "2"].iter().enumerate() {
            program.good(&words(&format!("render sail.gltf --time {time} {oak} -o one")));
            for (file, kind) in [("rgb", "png"), ("distance_to_image_plane", "npy")] {
                let frame = read(&program, &format!("all/{file}_000{number}.{kind}"));
                assert_eq!(
                    frame,
                    read(&program, &format!("one/{file}_0000.{kind}")),
                    "{time}"
                );
                frames.push(frame);
            }
        }
        let count = frames.len();
        frames.sort();
        frames.dedup();
        assert_eq!(frames.len(), count, "every frame differs");
        program.good(&words(&format!(
            "render sail.gltf --frames 0:2:0.5 {oak} --exposure 100 -o blurred"
        )));
        assert_ne!(
            read(&program, "all/rgb_0001.png"),
            read(&program, "blurred/rgb_0001.png")
        );
    }
}

#[test]
fn impossible_times_are_rejected() {
    let program = program();
    let oak = "render stage.usda --model OAK-D-Pro-PoE --camera rgb --pose 0 0 0 0 0 0 1";
    let path = "render stage.usda --model OAK-D-Pro-PoE --camera rgb --trajectory";
    for (line, part) in [
        (
            format!("{oak} --exposure -1"),
            "--exposure: -1 ms is out of range; give 0 to 10000 ms",
        ),
        (
            format!("{oak} --exposure NaN"),
            "--exposure: NaN ms is out of range",
        ),
        (
            format!("{oak} --exposure 5"),
            "require motion; give --trajectory of at least two poses",
        ),
        (format!("{path} one.tum --exposure 5"), "require motion"),
        (
            format!("{oak} --velocity 0 1 0 0 0 0"),
            "--velocity requires --exposure or --readout",
        ),
        (
            format!("{oak} --exposure 5 --velocity 0 inf 0 0 0 0"),
            "--velocity: inf is not finite",
        ),
        (
            format!("{path} two.tum --exposure 8 --readout 0"),
            "8 ms is longer than the frame period of 5.0000 ms",
        ),
        (
            format!("{path} two.tum --exposure 1"),
            "reads its rows in 23.8 ms, longer than the frame period of 5.0000 ms",
        ),
        (
            format!("{path} path.tum --camera-offset tof=3"),
            "no such camera is rendered; choose one of rgb",
        ),
        (
            format!("{path} path.tum --camera-offset rgb"),
            "invalid offset 'rgb'; write CAMERA=MS",
        ),
        (
            format!("{path} path.tum --camera-offset rgb=-1"),
            "is out of range; give 0 to 10000 ms",
        ),
    ] {
        let error = program.refused(&words(&line));
        assert!(error.contains(part), "{line}: {error}");
    }
}
