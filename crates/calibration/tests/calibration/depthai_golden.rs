//! Real calibration exports and the results of DepthAI's own library for them, found through `OAKTWIN_TEST_DATA`.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::print_stdout,
    reason = "a test that cannot go on fails"
)]

use std::fs;
use std::path::PathBuf;

use oaktwin_calibration::{Calibration, CalibrationError, Raw, Socket};
use oaktwin_camera::math::DVec2;
use oaktwin_camera::{ImageSize, RigidTransform};
use serde_json::Value;

/// Returns the folder of the calibration data.
fn data() -> PathBuf {
    let folder =
        std::env::var_os("OAKTWIN_TEST_DATA").expect("OAKTWIN_TEST_DATA names the folder of the test data");
    PathBuf::from(folder).join("data")
}

fn read(path: &std::path::Path) -> (Raw, Vec<u8>) {
    let bytes = fs::read(path).unwrap();
    let name = path.file_name().unwrap().to_string_lossy();
    (Raw::parse(&bytes, &name).unwrap(), bytes)
}

fn socket(name: &str) -> Socket {
    Socket(name.bytes().last().unwrap() - b'A')
}

fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(numbers).collect(),
        other => vec![other.as_f64().unwrap()],
    }
}

/// Equal to the precision of 32-bit arithmetic on numbers of this size.
fn close(ours: f64, theirs: f64, scale: f64) -> bool {
    (ours - theirs).abs() <= 1e-6 * scale.max(theirs.abs())
}

/// Their 4×4 in centimetres, or their error.
fn agrees(ours: &Result<RigidTransform, CalibrationError>, theirs: &Value, what: &str) {
    match (ours, theirs) {
        (Ok(ours), Value::Array(_)) => {
            let mut rows = ours.rows();
            for row in rows.iter_mut().take(3) {
                row[3] *= 100.0;
            }
            for (a, b) in rows.iter().flatten().zip(numbers(theirs)) {
                assert!(
                    (a - b).abs() < 3e-6 * b.abs().max(1.0),
                    "{what}: {rows:?} {theirs}"
                );
            }
        }
        (Err(CalibrationError::Disconnected { .. }), Value::String(s))
            if s.contains("Missing extrinsic link") => {}
        (Err(CalibrationError::NotPlaced { .. }), Value::String(s)) if s.contains("not available") => {}
        _ => panic!("{what}: {ours:?} {theirs}"),
    }
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn real_exports_round_trip() {
    let data = data();
    let mut n = 0;
    for entry in fs::read_dir(data.join("calibration")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|e| e == "json") {
            let (raw, bytes) = read(&path);
            let text = String::from_utf8(bytes).unwrap();
            assert_eq!(
                raw.to_text(),
                format!("{}\n", text.trim_end()),
                "{}",
                path.display()
            );
            n += 1;
        }
    }
    assert_eq!(n, 9);
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn agrees_with_depthai() {
    let data = data();
    let golden = fs::read(data.join("depthai-golden/calibration_handler.json")).unwrap();
    let golden: Value = serde_json::from_slice(&golden).unwrap();
    let files = golden["files"].as_object().unwrap();
    assert_eq!(files.len(), 8);
    for (file, answers) in files {
        let (raw, _) = read(&data.join("calibration").join(file));
        let (calibration, _) = Calibration::from_raw(&raw).unwrap();
        let cams = answers["cams"].as_object().unwrap();
        assert_eq!(cams.len(), calibration.cameras.len());
        for (name, answer) in cams {
            let camera = calibration.camera(socket(name)).unwrap();
            let size = ImageSize::new(
                u32::try_from(answer["w"].as_u64().unwrap()).unwrap(),
                u32::try_from(answer["h"].as_u64().unwrap()).unwrap(),
            );
            assert_eq!(camera.size(), size);
            let k = camera.intrinsics.opencv_matrix();
            // The test's JSON reader is off by one unit in the last place at times.
            let same = |a: &[f64], b: &[f64]| {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-12 * b.abs())
            };
            assert!(same(k.as_flattened(), &numbers(&answer["K"])), "{file} {name}");
            assert!(
                same(&camera.distortion, &numbers(&answer["dist"])),
                "{file} {name}"
            );
            let hfov_deg = camera.intrinsics.hfov().to_degrees();
            assert!(close(hfov_deg, answer["fovCalc"].as_f64().unwrap(), 1.0));
            assert!(same(&[camera.spec_hfov_deg], &numbers(&answer["fovSpec"])));
            assert_eq!(format!("{:?}", camera.kind), answer["model"].as_str().unwrap());
            for resize in answer["resize"].as_array().unwrap() {
                let side = |i: usize| u32::try_from(resize[i].as_u64().unwrap()).unwrap();
                let size = ImageSize::new(side(0), side(1));
                let k = camera
                    .intrinsics
                    .resized(size, resize[2].as_bool().unwrap())
                    .opencv_matrix();
                let ours = [k[0][0], k[1][1], k[0][2], k[1][2]];
                for (ours, theirs) in ours.into_iter().zip(numbers(&resize[3])) {
                    assert!(close(ours, theirs, 100.0), "{file} {name} {resize} {ours}");
                }
            }
        }
        project(file, answers, &calibration);
        for (pair, answer) in answers["pairs"].as_object().unwrap() {
            let (from, to) = pair.split_once("->").unwrap();
            for (key, use_spec) in [("calib", false), ("spec", true)] {
                let ours = calibration.transform(socket(from), socket(to), use_spec);
                agrees(&ours, &answer[key], &format!("{file} {pair} {key}"));
            }
        }
        for (name, answer) in answers["imu"].as_object().unwrap() {
            for (key, use_spec) in [("calib", false), ("spec", true)] {
                let ours = calibration.camera_from_imu(socket(name), use_spec);
                agrees(&ours, &answer[key], &format!("{file} imu {name} {key}"));
            }
        }
    }
}

/// Points and pixels. The library computes in 32 bits; the large, nearly cancelling terms of factory lenses leave it
/// three to four decimals.
fn project(file: &str, answers: &Value, calibration: &Calibration) {
    for (name, answer) in answers["cams"].as_object().unwrap() {
        let camera = calibration.camera(socket(name)).unwrap();
        for pair in answer["project"].as_array().unwrap() {
            let (point, pixel) = (numbers(&pair[0]), numbers(&pair[1]));
            let normalized = DVec2::new(point[0] / point[2], point[1] / point[2]);
            let ours = camera
                .intrinsics
                .pixel_from_normalized(camera.lens.distort(normalized));
            let error = (ours.xy() - DVec2::new(pixel[0], pixel[1])).length();
            assert!(error < 1e-3, "{file} {name} {pair}: {ours:?}");
        }
    }
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn findings_of_real_exports() {
    let data = data();
    let mut paths: Vec<_> = fs::read_dir(data.join("calibration"))
        .unwrap()
        .map(|e| e.unwrap().path())
        .collect();
    paths.sort();
    let mut text = String::new();
    for path in paths
        .iter()
        .filter(|p| p.extension().is_some_and(|e| e == "json"))
    {
        let (raw, _) = read(path);
        let (_, findings) = Calibration::from_raw(&raw).unwrap();
        text += &format!("{}\n", raw.name);
        for finding in findings {
            text += &format!("    {finding}\n");
        }
    }
    insta::assert_snapshot!(text);
}
