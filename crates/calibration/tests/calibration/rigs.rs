//! Calibrations of rigs, which are in no catalog.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    reason = "a test that cannot go on fails"
)]

use std::fs;
use std::path::Path;

use oaktwin_base::parameter::Platform;
use oaktwin_calibration::{Calibration, Raw, Socket, rig};
use oaktwin_camera::math::DVec3;
use oaktwin_catalog::{Catalog, Role};
use serde_json::Value;

const EXAMPLE: &str = include_str!("../../fixtures/example-oak-d-pro-poe.json");

/// The example with changes, read.
fn changed(change: impl FnOnce(&mut Value)) -> Calibration {
    let mut json: Value = serde_json::from_str(EXAMPLE).unwrap();
    change(&mut json);
    let raw = Raw::parse(json.to_string().as_bytes(), "rig.json").unwrap();
    Calibration::from_raw(&raw).unwrap().0
}

fn camera(json: &mut Value, socket: u64) -> &mut Value {
    let cameras = json["cameraData"].as_array_mut().unwrap();
    let found = cameras.iter_mut().find(|camera| camera[0] == socket);
    &mut found.unwrap()[1]
}

fn unnamed(json: &mut Value) {
    json["productName"] = "OAK-FFC-3P".into();
    json["stereoRectificationData"] = serde_json::json!({});
}

/// Only the left and the right camera, on sockets A and D.
fn two_cameras(json: &mut Value) {
    unnamed(json);
    let (mut left, mut right) = (camera(json, 1).clone(), camera(json, 2).clone());
    left["extrinsics"]["toCameraSocket"] = 0.into();
    right["extrinsics"] = serde_json::json!({
        "rotationMatrix": [], "translation": {"x": 0, "y": 0, "z": 0},
        "specTranslation": {"x": 0, "y": 0, "z": 0}, "toCameraSocket": -1
    });
    json["cameraData"] = serde_json::json!([[3, left], [0, right]]);
    json["imuExtrinsics"] = serde_json::json!({});
    json["housingExtrinsics"] = serde_json::json!({});
}

fn error(calibration: &Calibration, pair: Option<(Socket, Socket)>) -> String {
    rig(calibration, pair, Platform::Rvc2, "rig.json")
        .unwrap_err()
        .to_string()
}

#[test]
fn the_only_two_cameras_are_the_pair() {
    let calibration = changed(two_cameras);
    let (twin, findings) = rig(&calibration, None, Platform::Rvc4, "rig.json").unwrap();
    let codes: Vec<&str> = findings.iter().map(|finding| finding.code).collect();
    assert_eq!(codes, ["design-baseline"]);
    assert_eq!(
        (twin.device.name.as_str(), twin.platform()),
        ("OAK-FFC-3P", Some(Platform::Rvc4))
    );
    let [left, right] = [Role::Left, Role::Right].map(|role| twin.camera(role).unwrap());
    // The numbers of the file, read without the crate.
    let mut json: Value = serde_json::from_str(EXAMPLE).unwrap();
    for (found, socket) in [(left, 1), (right, 2)] {
        let fx = camera(&mut json, socket)["intrinsicMatrix"][0][0]
            .as_f64()
            .unwrap();
        assert_eq!(found.intrinsics.fx, fx);
    }
    let t = &camera(&mut json, 1)["extrinsics"]["translation"];
    let t = DVec3::from(["x", "y", "z"].map(|axis| t[axis].as_f64().unwrap())) * 0.01;
    assert!(t.x < -0.07);
    let right_from_left = right.body_from_camera.inverse() * left.body_from_camera;
    assert!((right_from_left.translation - t).length() < 1e-8);
    let expected = DVec3::new(0.0, t.length() / 2.0, 0.0);
    assert!((left.body_from_camera.translation - expected).length() < 1e-8);
}

#[test]
fn a_pair_is_named() {
    let calibration = changed(unnamed);
    let (b, c) = (Socket::CAM_B, Socket::CAM_C);
    assert_eq!(
        error(&calibration, None),
        "rig.json: stereoRectificationData: names no stereo pair among CAM_A, CAM_B, CAM_C; name it, such as 'pair=CAM_B CAM_C'"
    );
    assert!(rig(&calibration, Some((b, c)), Platform::Rvc2, "rig.json").is_ok());
    let swapped = error(&calibration, Some((c, b)));
    assert!(
        swapped.ends_with("mm to the right of CAM_B; swap them: 'pair=CAM_B CAM_C'"),
        "{swapped}"
    );
    let same = error(&calibration, Some((b, b)));
    assert!(same.contains("left and right are both CAM_B"), "{same}");
    let missing = error(&calibration, Some((b, Socket(6))));
    assert!(missing.contains("no camera CAM_G"), "{missing}");
    let named = changed(|json| json["productName"] = "OAK-FFC-3P".into());
    assert!(rig(&named, None, Platform::Rvc2, "rig.json").is_ok());
    let alone = changed(|json| {
        unnamed(json);
        for socket in [0, 1] {
            camera(json, socket)["intrinsicMatrix"] = serde_json::json!([]);
        }
    });
    assert!(error(&alone, None).contains("CAM_C is the only camera with intrinsics"));
}

/// A colour camera without intrinsics is missing, but the chain of extrinsics goes through it.
#[test]
fn the_pair_of_a_device_without_a_calibrated_colour_camera_is_the_same() {
    let whole = changed(|_| ());
    for matrix in [
        serde_json::json!([]),
        serde_json::json!([[0, 0, 0], [0, 0, 0], [0, 0, 0]]),
    ] {
        let mut findings = Vec::new();
        let without = {
            let mut json: Value = serde_json::from_str(EXAMPLE).unwrap();
            let colour = camera(&mut json, 0);
            colour["intrinsicMatrix"] = matrix;
            colour["width"] = 0.into();
            colour["height"] = 0.into();
            let raw = Raw::parse(json.to_string().as_bytes(), "rig.json").unwrap();
            let (calibration, found) = Calibration::from_raw(&raw).unwrap();
            findings.extend(found);
            calibration
        };
        assert!(
            findings.iter().any(|finding| finding.code == "uncalibrated"),
            "{findings:?}"
        );
        assert!(without.camera(Socket::CAM_A).is_err());
        let (b, c) = (Socket::CAM_B, Socket::CAM_C);
        assert_eq!(without.transform(b, c, false), whole.transform(b, c, false));
        assert_eq!(without.transform(b, c, true), whole.transform(b, c, true));
        assert_eq!(without.camera_from_imu(b, false), whole.camera_from_imu(b, false));
        let catalog = Catalog::builtin();
        let nominal = catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap());
        let [of_whole, of_part] = [&whole, &without]
            .map(|calibration| oaktwin_calibration::twin(calibration, &nominal, "x").unwrap());
        for role in [Role::Left, Role::Right] {
            assert_eq!(of_part.0.camera(role), of_whole.0.camera(role));
        }
        assert_eq!(of_part.0.camera(Role::Rgb), nominal.camera(Role::Rgb));
        assert!(of_part.1.iter().any(|finding| finding.code == "camera-nominal"));
    }
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn real_rigs_and_old_units_have_a_pair() {
    let data = std::env::var_os("OAKTWIN_TEST_DATA").expect("OAKTWIN_TEST_DATA names the test data");
    let folder = Path::new(&data).join("data/calibration");
    let read = |name: &str| {
        let raw = Raw::parse(&fs::read(folder.join(name)).unwrap(), name).unwrap();
        Calibration::from_raw(&raw).unwrap()
    };
    for name in [
        "4cam_fisheye_v6_sensor07_with-imu.json",
        "more/268d2120_calib_sensor_07.json",
        "more/2d00331b_calib_17.json",
        "more/543efbb9_calib_15_june.json",
        "more/6fdfe02a_calib_sensor_09.json",
        "more/a437e495_calib_17_old.json",
    ] {
        let (twin, _) = rig(&read(name).0, None, Platform::Rvc2, name).unwrap();
        let baseline_mm = twin.device.stereo_baseline_mm.unwrap();
        // The boards are designed for 100 mm.
        assert!((baseline_mm - 100.0).abs() < 1.5, "{name}: {baseline_mm}");
    }
    // Converted from the first format, without sizes.
    let (calibration, findings) = read("more/762a369e_calib_data2_return_back.json");
    let sizes: Vec<String> = calibration
        .cameras
        .values()
        .map(|camera| camera.size().to_string())
        .collect();
    assert_eq!(sizes, ["1920x1080", "1280x800", "1280x800"]);
    assert!(findings.iter().any(|finding| finding.code == "size-assumed"));
}
