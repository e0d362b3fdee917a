//! The project's calibrations in every format, whole. Other programs read them in the Python tests.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on fails"
)]

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use oaktwin_calibration::export::{Format, export};
use oaktwin_calibration::{Calibration, Raw, nominal_calibration, twin};
use oaktwin_catalog::Catalog;
use proptest::prelude::*;
use serde_json::Value;

fn load(name: &str) -> (Raw, Calibration) {
    let bytes = fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name)).unwrap();
    let raw = Raw::parse(&bytes, name).unwrap();
    let (calibration, _) = Calibration::from_raw(&raw).unwrap();
    (raw, calibration)
}

fn whole(name: &str, format: Format) -> String {
    let (raw, calibration) = load(name);
    let export = export(&raw, &calibration, format).unwrap();
    let mut text = String::new();
    for finding in &export.findings {
        writeln!(text, "{finding}").unwrap();
    }
    for (name, content) in &export.files {
        write!(text, "==> {name} <==\n{content}").unwrap();
    }
    text
}

#[test]
fn ros() {
    insta::assert_snapshot!(whole("example-oak-d-pro-poe.json", Format::Ros));
}

#[test]
fn ros_of_short_and_fisheye_lenses() {
    let time_of_flight = whole("oak-d-sr-poe.json", Format::Ros);
    assert!(time_of_flight.contains("==> tof.yaml <==") && time_of_flight.contains("plumb_bob"));
    insta::assert_snapshot!(whole("fisheye-two-roots.json", Format::Ros));
}

#[test]
fn opencv() {
    insta::assert_snapshot!(whole("example-oak-d-pro-poe.json", Format::OpenCv));
}

#[test]
fn kalibr() {
    insta::assert_snapshot!(whole("example-oak-d-pro-poe.json", Format::Kalibr));
}

#[test]
fn kalibr_of_wide_lenses() {
    insta::assert_snapshot!(whole("oak-d-pro-w-poe.json", Format::Kalibr));
    assert!(whole("fisheye-two-roots.json", Format::Kalibr).contains("warning[not-joined]"));
}

#[test]
fn depthai_returns_the_file() {
    let (raw, calibration) = load("oak-4-d.json");
    let export = export(&raw, &calibration, Format::DepthAi).unwrap();
    let text =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/oak-4-d.json")).unwrap();
    assert_eq!(export.files, [("calibration.json".to_owned(), text)]);
}

#[test]
fn exports_nominal_devices_without_loss() {
    for device in Catalog::builtin().devices() {
        let raw = nominal_calibration(&Catalog::builtin().nominal(device));
        let (calibration, _) = Calibration::from_raw(&raw).unwrap();
        for format in [Format::Ros, Format::OpenCv, Format::Kalibr, Format::DepthAi] {
            let export = export(&raw, &calibration, format).unwrap();
            let mut codes = export.findings.iter().map(|finding| finding.code);
            let is_single = device.stereo_baseline_mm.is_none();
            assert!(codes.all(|code| is_single && code == "no-pair"), "{}", device.id);
            assert!(!export.files.is_empty());
        }
    }
}

/// All numbers of a document, in order.
fn numbers(value: &mut Value) -> Vec<&mut Value> {
    match value {
        Value::Number(_) => vec![value],
        Value::Array(items) => items.iter_mut().flat_map(numbers).collect(),
        Value::Object(entries) => entries.values_mut().flat_map(numbers).collect(),
        _ => Vec::new(),
    }
}

/// Whether a number in a text is not finite, found by its letters.
fn has_other_numbers(text: &str) -> bool {
    let mut words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_'));
    words.any(|word| ["nan", "inf", "infinity"].contains(&word.to_lowercase().as_str()))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    /// A field with an extreme finite number is rejected, or every exported number is finite.
    #[test]
    fn exports_are_finite(
        fixture in prop::sample::select(vec!["example-oak-d-pro-poe.json", "oak-d-pro-w-poe.json", "oak-4-d.json", "fisheye-two-roots.json"]),
        at in any::<prop::sample::Index>(),
        exponent in -40..39i32, is_negative: bool, mantissa in 1.0..9.9f64,
    ) {
        let bytes = fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(fixture)).unwrap();
        let mut document: Value = serde_json::from_slice(&bytes).unwrap();
        let number: f64 = format!("{mantissa}e{exponent}").parse().unwrap();
        {
            let mut all = numbers(&mut document);
            let count = all.len();
            *all[at.index(count)] = Value::from(if is_negative { -number } else { number });
        }
        let Ok(raw) = Raw::parse(document.to_string().as_bytes(), fixture) else { return Ok(()) };
        let Ok((calibration, _)) = Calibration::from_raw(&raw) else { return Ok(()) };
        for format in [Format::Ros, Format::OpenCv, Format::Kalibr, Format::DepthAi] {
            match export(&raw, &calibration, format) {
                Ok(export) => {
                    for (name, text) in &export.files {
                        prop_assert!(!has_other_numbers(text), "{name}: {text}");
                    }
                }
                Err(error) => prop_assert!(error.to_string().matches(": ").count() >= 2, "{error}"),
            }
        }
        let catalog = Catalog::builtin();
        let nominal = catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap());
        if let Ok((twin, _)) = twin(&calibration, &nominal, fixture) {
            for sensor in &twin.depth_sensors {
                let camera = twin.depth_camera(sensor).unwrap();
                let pose = camera.body_from_camera;
                prop_assert!(pose.rotation.is_finite() && pose.translation.is_finite());
            }
        }
    }
}

#[test]
fn an_odd_coefficient_is_an_error_that_names_the_field() {
    let bytes =
        fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/example-oak-d-pro-poe.json")).unwrap();
    let mut document: Value = serde_json::from_slice(&bytes).unwrap();
    let left = document["cameraData"]
        .as_array_mut()
        .unwrap()
        .iter_mut()
        .find(|camera| camera[0] == 1)
        .unwrap();
    left[1]["distortionCoeff"][2] = Value::from(1e30);
    let raw = Raw::parse(document.to_string().as_bytes(), "cal.json").unwrap();
    let (calibration, _) = Calibration::from_raw(&raw).unwrap();
    for format in [Format::Ros, Format::OpenCv] {
        let error = export(&raw, &calibration, format).unwrap_err().to_string();
        assert!(
            error.contains("distortionCoeff") && error.contains("left camera"),
            "{error}"
        );
    }
}
