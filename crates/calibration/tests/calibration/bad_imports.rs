//! Files that cannot be imported: each is rejected in one line that names file, place and remedy.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on fails"
)]

use std::fmt::Write as _;

use oaktwin_base::diagnostic::Level;
use oaktwin_calibration::Calibration;
use oaktwin_calibration::export::Format;
use oaktwin_calibration::import::{CalibrationImportOptions, ImportedCalibration, InputFile, import};

use crate::imports::{exported, file, nominal};

type Case = (&'static str, Vec<InputFile>);

fn error_of(files: &[InputFile]) -> String {
    match import(files, &CalibrationImportOptions::default(), None) {
        Ok(ImportedCalibration { raw, findings, .. }) => {
            let mut errors = findings
                .into_iter()
                .filter(|found| found.finding.level == Level::Error);
            let first = errors
                .next()
                .map(|found| format!("{}: {}", found.file, found.finding));
            first.unwrap_or_else(|| Calibration::from_raw(&raw).unwrap_err().to_string())
        }
        Err(error) => error.to_string(),
    }
}

/// Returns the files with these names of an export, one of them edited.
fn edited(format: Format, names: &[&str], from: &str, to: &str) -> Vec<InputFile> {
    let mut files = exported(&nominal("OAK4-D"), format);
    files.retain(|file| names.contains(&file.name.as_str()));
    let last = files.last_mut().unwrap();
    let text = String::from_utf8(last.bytes.clone()).unwrap();
    assert!(text.contains(from), "{from}");
    last.bytes = text.replacen(from, to, 1).into_bytes();
    files
}

fn ros(from: &str, to: &str) -> Vec<InputFile> {
    edited(Format::Ros, &["left.yaml"], from, to)
}

fn kalibr(from: &str, to: &str) -> Vec<InputFile> {
    edited(Format::Kalibr, &["camchain.yaml"], from, to)
}

fn no_files_of_calibrations() -> Vec<Case> {
    let mut truncated = kalibr("", "");
    let middle = truncated[0].bytes.len() / 2;
    truncated[0].bytes.truncate(middle);
    let binary = InputFile {
        name: "a.yaml".into(),
        bytes: (0..=255).collect(),
    };
    let one = |name, text| vec![file(name, text)];
    vec![
        ("empty", one("a.yaml", "")),
        ("binary", vec![binary]),
        ("truncated", truncated),
        ("a list", one("a.yaml", "- 1\n- 2\n")),
        ("unknown", one("a.yaml", "one: 1\ntwo: 2\n")),
        ("DepthAI's own", one("a.json", "{\"cameraData\": []}")),
        (
            "XML",
            one("a.xml", "<?xml version=\"1.0\"?>\n<opencv_storage/>\n"),
        ),
        (
            "noise",
            one("imu.yaml", "imu0:\n  gyroscope_noise_density: 1.0e-3\n"),
        ),
        ("an anchor", one("a.yaml", "a: &x 1\n")),
    ]
}

fn wrong_fields() -> Vec<Case> {
    let matrix = "camera_matrix:\n  rows: 3\n  cols: 3\n  data: [";
    let zeros = "data: [0.0, 0.0, 0.0, 0.0, 0.0]";
    vec![
        ("NaN", ros(matrix, &format!("{matrix}.nan, "))),
        ("a text", ros("image_width: 1280", "image_width: wide")),
        ("a size of zero", ros("image_width: 1280", "image_width: 0")),
        ("no size", ros("image_width: 1280\n", "")),
        ("few numbers", ros(zeros, "data: [0.0, 0.0]")),
        (
            "few coefficients",
            kalibr("distortion_coeffs: [0.0, ", "distortion_coeffs: ["),
        ),
        ("a lens model", ros("plumb_bob", "thin_prism_fisheye")),
        (
            "a camera model",
            kalibr("camera_model: pinhole", "camera_model: omni"),
        ),
        ("a matrix's size", ros("  cols: 3\n", "  cols: 4\n")),
        ("five intrinsics", kalibr("intrinsics: [", "intrinsics: [1.0, ")),
        (
            "no rotation",
            kalibr("T_cn_cnm1:\n  - [1.0", "T_cn_cnm1:\n  - [1.5"),
        ),
        ("millimetres", kalibr("-0.075]", "-75.0]")),
    ]
}

fn wrong_sets_of_files() -> Vec<Case> {
    let mut nameless = ros("camera_name: left", "camera_name: front");
    nameless[0].name = "front.yaml".into();
    let left = ros("", "");
    let text = String::from_utf8(left[0].bytes.clone()).unwrap();
    let right = file(
        "right.yaml",
        &text.replace("camera_name: left", "camera_name: right"),
    );
    let mut extrinsics = edited(Format::OpenCv, &["stereo.yml"], "M1:", "m1:");
    let text = String::from_utf8(extrinsics[0].bytes.clone()).unwrap();
    extrinsics[0].bytes = text.replace("M2:", "m2:").into_bytes();
    let pair = ["left.yaml", "right.yaml"];
    let width = ["image_width: 1280", "image_width: 640"];
    vec![
        ("no position", nameless),
        ("twice", [left.clone(), left.clone()].concat()),
        ("two sizes", edited(Format::Ros, &pair, width[0], width[1])),
        ("no pair", [left, vec![right]].concat()),
        ("extrinsics alone", extrinsics),
    ]
}

#[test]
fn rejects_bad_files_in_one_line() {
    let mut all = String::new();
    let cases = [no_files_of_calibrations(), wrong_fields(), wrong_sets_of_files()];
    for (what, files) in cases.into_iter().flatten() {
        let error = error_of(&files);
        assert!(
            !error.contains('\n') && error.matches(": ").count() >= 2 && error.contains("; "),
            "{what}: {error}"
        );
        writeln!(all, "{what}:\n  {error}").unwrap();
    }
    insta::assert_snapshot!(all);
}
