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
use oaktwin_calibration::{Calibration, Raw, nominal_calibration};
use oaktwin_catalog::Catalog;

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
            assert_eq!(export.findings, [], "{}", device.id);
            assert!(!export.files.is_empty());
        }
    }
}
