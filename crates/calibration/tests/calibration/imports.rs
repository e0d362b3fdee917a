//! Round trips through the formats of other tools.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on fails"
)]

use std::fs;
use std::path::Path;

use oaktwin_base::diagnostic::Level;
use oaktwin_calibration::export::{Format, export};
use oaktwin_calibration::import::{
    CalibrationImportOptions, ImportedCalibration, InputFile, LengthUnit, NamedCamera, import,
};
use oaktwin_calibration::{Calibration, Raw, Socket, nominal_calibration};
use oaktwin_catalog::Catalog;

/// The tolerance of poses, m: rotations of real calibrations are orthonormal to 32 bits, so their products and inverses differ.
const SAME: f64 = 1e-7;

fn fixture(name: &str) -> (Raw, Calibration) {
    let bytes = fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name)).unwrap();
    let raw = Raw::parse(&bytes, name).unwrap();
    let calibration = Calibration::from_raw(&raw).unwrap().0;
    (raw, calibration)
}

/// Nominal units, whose lenses every format represents, and a real one.
pub(crate) fn nominal(model: &str) -> (Raw, Calibration) {
    let catalog = Catalog::builtin();
    let raw = nominal_calibration(&catalog.nominal(catalog.device(model).unwrap()));
    let calibration = Calibration::from_raw(&raw).unwrap().0;
    (raw, calibration)
}

pub(crate) fn exported(of: &(Raw, Calibration), format: Format) -> Vec<InputFile> {
    let files = export(&of.0, &of.1, format).unwrap().files;
    let input = |(name, text): (String, String)| InputFile {
        name,
        bytes: text.into_bytes(),
    };
    files.into_iter().map(input).collect()
}

fn imported(files: &[InputFile], options: &CalibrationImportOptions) -> Calibration {
    let ImportedCalibration { raw, findings, .. } = import(files, options, None).unwrap();
    assert!(
        findings.iter().all(|found| found.finding.level < Level::Error),
        "{findings:?}"
    );
    let (calibration, findings) = Calibration::from_raw(&raw).unwrap();
    assert!(
        findings.iter().all(|found| found.level < Level::Error),
        "{findings:?}"
    );
    calibration
}

fn assert_same_cameras(found: &Calibration, given: &Calibration) {
    assert_eq!(found.cameras.len(), given.cameras.len());
    for (socket, camera) in &given.cameras {
        let same = &found.cameras[socket];
        assert_eq!(same.intrinsics, camera.intrinsics, "{socket}");
        assert_eq!(same.lens, camera.lens, "{socket}");
        assert_eq!(same.kind, camera.kind, "{socket}");
    }
}

fn assert_same_pose(found: &Calibration, given: &Calibration, from: Socket, to: Socket) {
    let [found, given] = [found, given].map(|one| one.transform(from, to, false).unwrap());
    let rows = found
        .rows()
        .into_iter()
        .flatten()
        .zip(given.rows().into_iter().flatten());
    for (a, b) in rows {
        assert!((a - b).abs() < SAME, "{from} {to}: {found:?} {given:?}");
    }
}

#[test]
fn opencv_files_import_without_loss() {
    for given in [
        fixture("example-oak-d-pro-poe.json"),
        fixture("fisheye-two-roots.json"),
        nominal("OAK4-D"),
        nominal("OAK-D ToF"),
    ] {
        let found = imported(
            &exported(&given, Format::OpenCv),
            &CalibrationImportOptions::default(),
        );
        assert_same_cameras(&found, &given.1);
        assert_same_pose(&found, &given.1, Socket::CAM_B, Socket::CAM_C);
    }
}

#[test]
fn the_file_of_a_pair_is_enough() {
    let given = fixture("example-oak-d-pro-poe.json");
    let mut files = exported(&given, Format::OpenCv);
    files.retain(|file| file.name == "stereo.yml");
    let found = imported(&files, &CalibrationImportOptions::default());
    for socket in [Socket::CAM_B, Socket::CAM_C] {
        assert_eq!(
            found.cameras[&socket].intrinsics,
            given.1.cameras[&socket].intrinsics
        );
        assert_eq!(found.cameras[&socket].lens, given.1.cameras[&socket].lens);
    }
    assert_same_pose(&found, &given.1, Socket::CAM_B, Socket::CAM_C);
}

#[test]
fn ros_files_import_without_loss() {
    for given in [
        nominal("OAK4-D"),
        nominal("OAK-D Pro W PoE"),
        fixture("fisheye-two-roots.json"),
    ] {
        let found = imported(
            &exported(&given, Format::Ros),
            &CalibrationImportOptions::default(),
        );
        assert_same_cameras(&found, &given.1);
        assert_same_pose(&found, &given.1, Socket::CAM_B, Socket::CAM_C);
    }
    // The lenses of this one are fitted, its poses are exact.
    let given = fixture("example-oak-d-pro-poe.json");
    let found = imported(
        &exported(&given, Format::Ros),
        &CalibrationImportOptions::default(),
    );
    assert_same_pose(&found, &given.1, Socket::CAM_B, Socket::CAM_C);
}

#[test]
fn kalibr_files_import_without_loss() {
    for given in [
        nominal("OAK4-D"),
        nominal("OAK-D ToF"),
        fixture("example-oak-d-pro-poe.json"),
    ] {
        let found = imported(
            &exported(&given, Format::Kalibr),
            &CalibrationImportOptions::default(),
        );
        let sockets: Vec<Socket> = given.1.cameras.keys().copied().collect();
        for from in &sockets {
            for to in &sockets {
                assert_same_pose(&found, &given.1, *from, *to);
            }
        }
        let imu = [&found, &given.1].map(|one| one.camera_from_imu(Socket::CAM_B, false).unwrap());
        assert!((imu[0].translation - imu[1].translation).length() < SAME);
    }
    let given = nominal("OAK4-D");
    assert_same_cameras(
        &imported(
            &exported(&given, Format::Kalibr),
            &CalibrationImportOptions::default(),
        ),
        &given.1,
    );
}

#[test]
fn imported_files_export_to_the_same_text() {
    let unit = || fixture("example-oak-d-pro-poe.json");
    // P depends on K and D, so the lenses that ROS does not represent would change it.
    let cases = [
        (nominal("OAK4-D"), Format::Ros),
        (unit(), Format::OpenCv),
        (unit(), Format::Kalibr),
    ];
    for (given, format) in cases {
        let files = exported(&given, format);
        let raw = import(&files, &CalibrationImportOptions::default(), None)
            .unwrap()
            .raw;
        let calibration = Calibration::from_raw(&raw).unwrap().0;
        let again = exported(&(raw, calibration), format);
        for (a, b) in files.iter().zip(&again) {
            assert_eq!(a.name, b.name);
            let words = |file: &InputFile| -> Vec<String> {
                let text = String::from_utf8(file.bytes.clone()).unwrap();
                let words = text.split(|c: char| c.is_whitespace() || "[],".contains(c));
                words.filter(|word| !word.is_empty()).map(str::to_owned).collect()
            };
            for (a, b) in words(a).iter().zip(&words(b)) {
                match (a.parse::<f64>(), b.parse::<f64>()) {
                    (Ok(a), Ok(b)) => assert!((a - b).abs() < 1e-6 * (1.0 + a.abs()), "{a} {b}"),
                    _ => assert_eq!(a, b),
                }
            }
        }
    }
}

#[test]
fn options_state_what_files_do_not() {
    let intrinsics = "%YAML:1.0\n---\nM1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 800., 0., 640., 0., 800., 400., 0., 0., 1. ]\n\
        D1: !!opencv-matrix\n   rows: 1\n   cols: 4\n   dt: d\n   data: [ 0.1, 0., 0.,\n       0. ]\n\
        M2: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 801., 0., 641., 0., 801., 401., 0., 0., 1. ]\n\
        D2: !!opencv-matrix\n   rows: 1\n   cols: 4\n   dt: d\n   data: [ 0.2, 0., 0., 0. ]\n";
    let extrinsics = "%YAML:1.0\n---\nR: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n   data: [ 1., 0., 0., 0., 1., 0., 0., 0., 1. ]\n\
        T: !!opencv-matrix\n   rows: 3\n   cols: 1\n   dt: d\n   data: [ -75., 0., 0. ]\n";
    let files = [
        file("intrinsics.yml", intrinsics),
        file("extrinsics.yml", extrinsics),
    ];
    let options = CalibrationImportOptions {
        unit: LengthUnit::Millimetres,
        size: Some(oaktwin_camera::ImageSize::new(1280, 800)),
        is_fisheye: true,
        ..CalibrationImportOptions::default()
    };
    let found = imported(&files, &options);
    assert_eq!(
        found.cameras[&Socket::CAM_B].lens.coefficients(),
        [0.1, 0.0, 0.0, 0.0]
    );
    assert!((found.baseline(Socket::CAM_B, Socket::CAM_C, false).unwrap() - 0.075).abs() < 1e-12);
    let swapped = CalibrationImportOptions {
        cameras: ["M1=right", "M2=left"]
            .map(|text| NamedCamera::from_text(text).unwrap())
            .to_vec(),
        ..options.clone()
    };
    assert_eq!(
        imported(&files, &swapped).cameras[&Socket::CAM_C].intrinsics.fx,
        800.0
    );
    // In metres, a baseline of 75 m is an error that can be ignored.
    let in_metres = CalibrationImportOptions {
        unit: LengthUnit::Metres,
        ..options
    };
    let findings = import(&files, &in_metres, None).unwrap().findings;
    assert!(findings[0].finding.level == Level::Error && findings[0].finding.code == "baseline-off");
}

pub(crate) fn file(name: &str, text: &str) -> InputFile {
    InputFile {
        name: name.to_owned(),
        bytes: text.as_bytes().to_vec(),
    }
}
