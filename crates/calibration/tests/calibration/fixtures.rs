//! The project's own calibrations: valid files round-trip, suspicious ones cause findings, invalid ones errors.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on fails"
)]

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_calibration::{
    Calibration, CalibrationError, Raw, Socket, check_against, force, nominal_calibration, twin,
};
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Axes, ImageSize, LensModel, OpenCv};
use oaktwin_catalog::{Catalog, Origin, Role, Twin};

const GOOD: [(&str, &str); 5] = [
    ("example-oak-d-pro-poe.json", "OAK-D Pro PoE"),
    ("oak-d-pro-w-poe.json", "OAK-D Pro W PoE"),
    ("oak-4-d.json", "OAK4-D"),
    ("oak-d-sr-poe.json", "OAK-D ToF"),
    ("fisheye-two-roots.json", "OAK-D Pro W PoE"),
];

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name)
}

fn json_files(name: &str) -> Vec<(String, Vec<u8>)> {
    let mut files: Vec<_> = fs::read_dir(folder(name))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == "json"))
        .map(|path| {
            (
                path.file_name().unwrap().to_str().unwrap().to_owned(),
                fs::read(&path).unwrap(),
            )
        })
        .collect();
    files.sort();
    files
}

fn load(bytes: &[u8], name: &str) -> Result<(Calibration, Vec<Finding>), CalibrationError> {
    Calibration::from_raw(&Raw::parse(bytes, name)?)
}

fn good(name: &str) -> (Calibration, Vec<Finding>) {
    load(&fs::read(folder("").join(name)).unwrap(), name).unwrap()
}

fn nominal(model: &str) -> Twin {
    let catalog = Catalog::builtin();
    catalog.nominal(catalog.device(model).unwrap())
}

#[test]
fn files_by_depthai_round_trip_to_the_byte() {
    for (name, _) in GOOD {
        let text = fs::read_to_string(folder("").join(name)).unwrap();
        assert_eq!(Raw::parse(text.as_bytes(), name).unwrap().to_text(), text);
    }
}

#[test]
fn good_files_fit_their_models() {
    for (name, model) in GOOD {
        let (calibration, findings) = good(name);
        let nominal = nominal(model);
        let (twin, more) = twin(&calibration, &nominal, name).unwrap();
        let against = check_against(&calibration, &nominal, Catalog::builtin());
        let all: Vec<_> = findings
            .iter()
            .chain(&against)
            .chain(&more)
            .map(ToString::to_string)
            .collect();
        let expected: &[&str] = match name {
            "example-oak-d-pro-poe.json" => &[
                "note[design-baseline]: stereoUseSpecTranslation: as on the device, depth is computed with the baseline of the board's design, 75.00 mm, not with the calibrated 74.58 mm, so it is 0.6 % too large",
            ],
            "oak-d-pro-w-poe.json" | "oak-d-sr-poe.json" => &[
                "note[imu-nominal]: imuExtrinsics: the file has no extrinsics of the inertial unit; its nominal pose is used",
            ],
            "fisheye-two-roots.json" => &[
                "warning[focal-length-off]: cameraData[3].intrinsicMatrix: fx is 3082.9 px at 3840x2160, but nominally 2288.2 px for the Camera_rgb_imx378 camera (+34.7 %); check that the file belongs to this model",
                "warning[place-nominal]: cameraData[3].extrinsics: no extrinsics connect CAM_A and CAM_B; the RGB camera keeps its nominal pose; calibrate the cameras together",
                "note[design-baseline]: stereoUseSpecTranslation: as on the device, depth is computed with the baseline of the board's design, 75.00 mm, not with the calibrated 74.72 mm, so it is 0.4 % too large",
            ],
            _ => &[],
        };
        assert_eq!(all, expected, "{name}");
        assert_eq!(
            twin.origin,
            Origin::Calibration {
                product_name: calibration.board.product_name.clone(),
                file_name: name.to_owned()
            }
        );
    }
}

#[test]
fn twins_are_aligned_with_their_rectified_pair() {
    for (name, model) in GOOD {
        let (calibration, _) = good(name);
        let (twin, _) = twin(&calibration, &nominal(model), name).unwrap();
        let (left, right) = (
            twin.camera(Role::Left).unwrap(),
            twin.camera(Role::Right).unwrap(),
        );
        let (l, r) = (left.body_from_camera, right.body_from_camera);
        let baseline = calibration.baseline(Socket::CAM_B, Socket::CAM_C, false).unwrap();
        assert!(
            (l.translation + r.translation).length() < 1e-8,
            "the origin is midway"
        );
        assert!((l.translation.y - baseline / 2.0).abs() < 1e-9 && l.translation.x.abs() < 1e-12);
        // The relative pose is the file's.
        let expected = calibration
            .transform(Socket::CAM_B, Socket::CAM_C, false)
            .unwrap();
        let found = r.inverse() * l;
        assert!((found.translation - expected.translation).length() < 1e-8);
        let off = found.rotation - expected.rotation;
        assert!(off.abs_diff_eq(DMat3::ZERO, 1e-6), "{name} {off}");
        // Both cameras look forward, each half of the relative rotation off, and nothing rolls with the baseline.
        for camera in [l, r] {
            let forward = camera.rotation * DVec3::Z;
            assert!(forward.x > 0.999, "{name} {forward}");
            assert!(camera.orthonormality_error() < 1e-5);
        }
        // The rectified rotations that DepthAI's file carries say the same.
        let stored = calibration.stereo.unwrap().rectified_from_left.unwrap();
        let rotation = Axes::Ros.rotation_from(Axes::OpenCv) * stored;
        assert!((rotation - l.rotation).abs_diff_eq(DMat3::ZERO, 1e-6), "{name}");
    }
}

#[test]
fn twins_have_the_units_optics_at_the_nominal_size() {
    let (calibration, _) = good("oak-4-d.json");
    let nominal = nominal("OAK4-D");
    let (twin, _) = twin(&calibration, &nominal, "x.json").unwrap();
    for (camera, before) in twin.cameras.iter().zip(&nominal.cameras) {
        assert_eq!(camera.intrinsics.size, before.intrinsics.size);
        assert!(matches!(camera.lens, LensModel::OpenCvPinhole(_)));
        assert_eq!(camera.spec, before.spec);
    }
    let fx = twin.camera(Role::Left).unwrap().intrinsics.fx;
    assert_eq!(twin.depth_sensors[0].focal_length_px, fx.round());
    assert_eq!(twin.depth_sensors[0].focal_length_px, 807.0);
    // IMU and RGB, independently: through the root camera.
    let rgb = twin.camera(Role::Rgb).unwrap().body_from_camera;
    let in_rgb = rgb.inverse() * twin.body_from_imu.unwrap();
    let expected = calibration.camera_from_imu(Socket::CAM_A, false).unwrap();
    assert!((in_rgb.translation - expected.translation).length() < 1e-7);
    let left_in_rgb = rgb
        .inverse()
        .apply(twin.camera(Role::Left).unwrap().body_from_camera.translation);
    assert!((left_in_rgb.x + 0.037_419).abs() < 1e-6, "{left_in_rgb}");
}

#[test]
fn time_of_flight_twins_use_the_focal_length_of_each_sensor() {
    let (calibration, _) = good("oak-d-sr-poe.json");
    let (twin, _) = twin(&calibration, &nominal("OAK-D ToF"), "x.json").unwrap();
    let focal: Vec<f64> = twin.depth_sensors.iter().map(|d| d.focal_length_px).collect();
    // On RVC2 rectified images have the intrinsics of the right camera.
    assert_eq!(focal, [770.0, 459.0]);
}

#[test]
fn rescales_calibrations_of_another_size() {
    let (mut calibration, _) = good("example-oak-d-pro-poe.json");
    let full = calibration.cameras[&Socket::CAM_A].intrinsics;
    let half = calibration.cameras[&Socket::CAM_A]
        .intrinsics
        .resized(ImageSize::new(1920, 1080), true);
    calibration.cameras.get_mut(&Socket::CAM_A).unwrap().intrinsics = half;
    let (twin, _) = twin(&calibration, &nominal("OAK-D Pro PoE"), "x.json").unwrap();
    let found = twin.camera(Role::Rgb).unwrap().intrinsics;
    assert!((found.fx - full.fx).abs() < 1e-9);
    assert!((found.principal_point::<OpenCv>().x - full.principal_point::<OpenCv>().x).abs() < 1e-9);
}

#[test]
fn nominal_devices_round_trip_through_depthai() {
    for device in Catalog::builtin().devices() {
        let nominal = Catalog::builtin().nominal(device);
        let raw = nominal_calibration(&nominal);
        let raw = Raw::parse(raw.to_text().as_bytes(), &raw.name).unwrap();
        let (calibration, findings) = Calibration::from_raw(&raw).unwrap();
        assert_eq!(findings, []);
        assert_eq!(check_against(&calibration, &nominal, Catalog::builtin()), []);
        let (twin, findings) = twin(&calibration, &nominal, "x.json").unwrap();
        assert_eq!(findings, []);
        assert_eq!(twin.depth_sensors, nominal.depth_sensors);
        for (found, expected) in twin.cameras.iter().zip(&nominal.cameras) {
            assert_eq!(found.intrinsics, expected.intrinsics, "{}", device.id);
            assert_eq!(found.lens, expected.lens);
            let error = found.body_from_camera.inverse() * expected.body_from_camera;
            assert!(error.translation.length() < 1e-12);
            assert_eq!(
                found.body_from_camera.rotation,
                expected.body_from_camera.rotation
            );
        }
        assert_eq!(twin.body_from_imu.is_some(), nominal.body_from_imu.is_some());
        let (Some(found), Some(expected)) = (twin.body_from_imu, nominal.body_from_imu) else {
            continue;
        };
        let error = found.inverse() * expected;
        assert!(error.translation.length() < 1e-12, "{error:?}");
    }
}

#[test]
fn rejects_invalid_files_in_one_line() {
    let mut text = String::new();
    for (name, bytes) in json_files("bad") {
        let error = load(&bytes, &name).expect_err(&name);
        let line = error.to_string();
        assert!(
            line.starts_with(&format!("{name}: ")) && !line.contains('\n'),
            "{line}"
        );
        writeln!(text, "{line}").unwrap();
        for more in error.findings().iter().skip(1) {
            writeln!(text, "    {more}").unwrap();
        }
    }
    insta::assert_snapshot!(text);
}

#[test]
fn findings_of_suspicious_files() {
    let nominal = nominal("OAK-D Pro PoE");
    let mut text = String::new();
    for (name, bytes) in json_files("odd") {
        let (calibration, mut findings) = load(&bytes, &name).unwrap();
        findings.extend(check_against(&calibration, &nominal, Catalog::builtin()));
        assert_ne!(findings, [], "{name}");
        writeln!(text, "{name}").unwrap();
        for finding in &findings {
            writeln!(text, "    {finding}").unwrap();
        }
        if let Err(error) = twin(&calibration, &nominal, &name) {
            writeln!(text, "    twin: {error}").unwrap();
        }
        force(&mut findings);
        assert!(findings.iter().all(|f| f.level < Level::Error));
    }
    insta::assert_snapshot!(text);
}

#[test]
fn damaged_files_never_panic() {
    let bytes = fs::read(folder("example-oak-d-pro-poe.json")).unwrap();
    let nominal = nominal("OAK-D Pro PoE");
    let mut through = 0;
    let mut run = |bytes: &[u8]| {
        if let Ok((calibration, _)) = load(bytes, "x") {
            through += 1;
            let _ = check_against(&calibration, &nominal, Catalog::builtin());
            let _ = twin(&calibration, &nominal, "x");
            let _ = oaktwin_calibration::summary(&calibration, &[]);
        }
    };
    for end in (0..bytes.len()).step_by(17) {
        run(&bytes[..end]);
    }
    // Every byte replaced by another, the whole alphabet of JSON among them.
    let mut damaged = bytes.clone();
    for (i, byte) in bytes
        .iter()
        .enumerate()
        .filter(|(_, byte)| !byte.is_ascii_whitespace())
        .step_by(3)
    {
        damaged[i] = b"09-e.\"[]{},:\xff"[i % 13];
        run(&damaged);
        damaged[i] = *byte;
    }
    assert!(through > 100, "some damage is harmless: {through}");
}
