//! What `sense` refuses: in one line, and nothing is left behind.

use std::fmt::Write;
use std::fs;

use oaktwin::image::{Image, exr, pfm, png};

use crate::program::Program;
use crate::sense::{array, depth, foreign};

fn refusals(program: &Program, runs: &[&[&str]]) -> String {
    let mut all = String::new();
    for run in runs {
        let arguments = [&["sense"], *run].concat();
        let _ = write!(
            all,
            "$ oaktwin {}\n{}",
            arguments.join(" "),
            program.refused(&arguments)
        );
    }
    all
}

const TO: [&str; 6] = ["--model", "oak4-d", "--input-kind", "z", "-o", "out"];

#[test]
fn files_without_depth() {
    let program = Program::new();
    let good = array(&[20, 32], &depth(32, 20));
    let grey8 = png::encode(&Image::filled(32, 20, 7u8)).unwrap();
    let rgba = png::encode(&Image::filled(32, 20, [7u8; 4])).unwrap();
    let exr = exr::encode(&Image::filled(32, 20, 2f32)).unwrap();
    let pfm = pfm::encode(&Image::filled(32, 20, 2f32));
    let files: [(&str, Vec<u8>); 17] = [
        ("empty", Vec::new()),
        ("text.npy", b"depth".to_vec()),
        ("cut.npy", good[..good.len() - 100].to_vec()),
        ("header.npy", good[..40].to_vec()),
        ("long.npy", [&good[..], &[0; 4]].concat()),
        ("batch0.npy", array::<f32>(&[0, 20, 32], &[])),
        ("row.npy", array(&[4], &[1f32; 4])),
        ("channels.npy", array(&[2, 2, 2, 2], &[1f32; 16])),
        ("nothing.npy", array::<f32>(&[0, 32], &[])),
        ("bytes.npy", array(&[20, 32], &[7u8; 640])),
        ("ints.npy", foreign("<u8", false, "(20, 32)", &[0; 5120])),
        (
            "huge.npy",
            foreign("<f4", false, "(99999999999, 99999999999)", &[]),
        ),
        ("hugef.npy", foreign("<f4", true, "(99999, 99999)", &[0; 8])),
        ("grey8.png", grey8),
        ("rgba.png", rgba),
        ("cut.exr", exr[..exr.len() / 2].to_vec()),
        ("cut.pfm", pfm[..pfm.len() - 9].to_vec()),
    ];
    fs::create_dir(program.path("folder")).unwrap();
    let mut all = String::new();
    for (name, bytes) in &files {
        program.put(name, bytes);
        all += &refusals(&program, &[&[&[*name], &TO[..]].concat()]);
    }
    for name in ["missing.npy", "folder"] {
        all += &refusals(&program, &[&[&[name], &TO[..]].concat()]);
    }
    insta::assert_snapshot!(all);
}

#[test]
fn invalid_options() {
    let program = Program::new();
    program.put("depth.npy", array(&[20, 32], &depth(32, 20)));
    program.put("z.npy", array(&[20, 32], &depth(32, 20)));
    program.put("batch.npy", array(&[2, 20, 32], &depth(32, 20).repeat(2)));
    program.put("rgb.png", png::encode(&Image::filled(32, 20, [7u8; 3])).unwrap());
    program.put(
        "small.png",
        png::encode(&Image::filled(31, 20, [7u8; 3])).unwrap(),
    );
    let mut runs: Vec<Vec<&str>> = Vec::new();
    for more in [
        &["--fx", "0"][..],
        &["--fx", "nan"],
        &["--hfov", "0"],
        &["--hfov", "180"],
        &["--depth-scale", "0"],
        &["--depth-scale", "-1"],
        &["--param", "focalLength=0"],
        &["--param", "baseline=0"],
        &["--param", "noiseSigma=0.1"],
        &["--param", "jiter=0.1"],
        &["--engine", "single-view", "--param", "baselineMM=0"],
        &["--engine", "single-view", "--param", "focalLengthPixel=nan"],
        &["--engine", "single-view", "--param", "confidenceThreshold=2"],
        &["--engine", "single-view", "--param", "jitter=1"],
        &["--preset", "high_density"],
        &["--preset", "robotic"],
        &["--filter", "medien"],
        &["--filter", "median:size=4"],
        &["--sensor", "tof"],
        &["--align", "tof"],
        &["--align", "rgb", "--align-size", "0x5"],
        &["--outputs", "depth_sensor_imagre"],
        &["--outputs", "rgb"],
        &["--outputs", "depth_sensor_imager"],
        &["--engine", "single-view", "--outputs", "depth_sensor_imager"],
        &["--rgb", "small.png"],
        &["--rgb", "rgb.png", "rgb.png"],
        &["--rgb", "depth.npy"],
        &["--rgb", "missing.png"],
        &["--model", "oak5"],
    ] {
        let model: &[&str] = if more.contains(&"--model") {
            &[]
        } else {
            &["--model", "oak4-d"]
        };
        runs.push([&["depth.npy"], model, &["-o", "out"], more].concat());
    }
    runs.push(vec!["depth.npy", "--model", "oak4-d"]);
    runs.push(vec!["z.npy", "--model", "oak4-d", "-o", "out"]);
    runs.push(vec![
        "batch.npy",
        "--input-kind",
        "z",
        "--rgb",
        "rgb.png",
        "--model",
        "oak4-d",
        "-o",
        "out",
    ]);
    runs.push(vec!["-", "depth.npy", "--input-kind", "z", "--model", "oak4-d"]);
    runs.push(vec!["-", "--input-kind", "z", "--preview", "--model", "oak4-d"]);
    runs.push(vec!["-", "--input-kind", "z", "--model", "oak4-d", "-o", "out"]);
    runs.push(vec!["depth.npy", "./depth.npy", "--model", "oak4-d", "-o", "out"]);
    runs.push(vec![
        "depth.npy",
        "--model",
        "oak-d-tof",
        "--engine",
        "stereo-noise",
        "-o",
        "out",
    ]);
    runs.push(vec!["depth.npy", "--model", "oak4-d", "-o", "rgb.png"]);
    let runs: Vec<&[&str]> = runs.iter().map(Vec::as_slice).collect();
    insta::assert_snapshot!(refusals(&program, &runs));
}

#[test]
fn an_input_is_never_written_over() {
    let program = Program::new();
    program.put("depth.npy", array(&[20, 32], &depth(32, 20)));
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("depth.npy", program.path("depth_sensor_distance.npy")).unwrap();
        let error = program.refused(&["sense", "depth.npy", "--model", "oak4-d", "-o", "."]);
        assert!(error.contains("is an input"), "{error}");
    }
    assert_eq!(
        fs::read(program.path("depth.npy")).unwrap(),
        array(&[20, 32], &depth(32, 20))
    );
}

#[test]
fn a_sequence_is_of_one_camera() {
    let program = Program::new();
    program.put("depth_1.npy", array(&[20, 32], &depth(32, 20)));
    program.put("depth_2.npy", array(&[20, 31], &depth(31, 20)));
    let ended = program.run(&[
        "sense",
        "depth_1.npy",
        "depth_2.npy",
        "--model",
        "oak4-d",
        "-o",
        "out",
    ]);
    assert_eq!(ended.code, 2);
    insta::assert_snapshot!(ended.stderr);
    // Complete files remain.
    assert!(program.path("out/depth_sensor_distance_1.npy").is_file());
    assert!(!program.path("out/depth_sensor_distance_2.npy").exists());
}

#[test]
fn contradictory_camera_params() {
    let program = Program::new();
    fs::create_dir(program.path("set")).unwrap();
    program.put(
        "set/distance_to_image_plane_0000.npy",
        array(&[20, 32], &depth(32, 20)),
    );
    let mut all = String::new();
    for params in [
        "",
        "[]",
        "{\"renderProductResolution\": [64, 40]}",
        "{\"renderProductResolution\": [32, 20], \"cameraProjection\": [1, 2]}",
        "{\"renderProductResolution\": [32, 20], \"cameraProjection\": [0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]}",
        "{\"renderProductResolution\": [32, 20], \"cameraProjection\": [1,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0], \"cameraModel\": \"lut\"}",
    ] {
        program.put("set/camera_params_0000.json", params);
        all += &refusals(&program, &[&["set", "--model", "oak4-d"]]);
    }
    insta::assert_snapshot!(all);
}
