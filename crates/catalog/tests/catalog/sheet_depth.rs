//! Compares the depth sensors and fields of view of the catalog with the numbers that the parameter sheet prints.

use crate::common::assert_printed;
use oaktwin_catalog::{Catalog, DepthKind, Role};

/// model, kind, focalLengthPixel, baselineMM, minDistance, maxDistance.
const DEPTH: [(&str, DepthKind, &str, &str, &str, &str); 6] = [
    ("OAK-D Pro PoE", DepthKind::Stereo, "805.0", "75.0", "0.6", "12.0"),
    (
        "OAK-D Pro W PoE",
        DepthKind::Stereo,
        "566.0",
        "75.0",
        "0.2",
        "8.0",
    ),
    ("OAK4-D", DepthKind::Stereo, "805.0", "75.0", "0.6", "12.0"),
    ("OAK4-D Wide", DepthKind::Stereo, "566.0", "75.0", "0.2", "8.0"),
    ("OAK-D ToF", DepthKind::Stereo, "763.0", "20.0", "0.2", "5.0"),
    ("OAK-D ToF", DepthKind::Tof, "457.0", "0.5", "0.2", "5.0"),
];

#[test]
fn depth_sensors() {
    let catalog = Catalog::builtin();
    for (model, kind, focal_length, baseline, min, max) in DEPTH {
        let twin = catalog.nominal(catalog.device(model).unwrap());
        let sensor = twin
            .depth_sensors
            .iter()
            .find(|sensor| sensor.spec.kind == kind)
            .unwrap();
        let camera = twin.camera(sensor.spec.camera).unwrap();
        let what = |of: &str| format!("{model}, {kind:?}: {of}");
        assert_printed(sensor.focal_length_px, focal_length, &what("focalLengthPixel"));
        assert_printed(camera.intrinsics.fx.round(), focal_length, &what("fx, rounded"));
        assert_printed(sensor.spec.baseline_mm, baseline, &what("baselineMM"));
        assert_printed(sensor.spec.min_distance_m, min, &what("minDistance"));
        assert_printed(sensor.spec.max_distance_m, max, &what("maxDistance"));
        assert_printed(
            sensor.spec.sensor_size_px,
            &camera.intrinsics.size.width.to_string(),
            &what("sensorSizePixel"),
        );
        if kind == DepthKind::Stereo {
            assert_eq!(sensor.spec.baseline_mm, twin.device.stereo_baseline_mm.unwrap());
        }
    }
}

/// The notes on the least distance: model, largest disparity, as computed, as rounded to what the sheet then uses.
const MIN_DISTANCE: [(&str, &str, &str, &str); 5] = [
    ("OAK-D Pro W PoE", "95", "0.45", "0.2"),
    ("OAK4-D", "95", "0.64", "0.6"),
    ("OAK4-D", "191", "0.32", "0.3"),
    ("OAK4-D Wide", "95", "0.45", "0.2"),
    ("OAK-D ToF", "95", "0.161", "0.2"),
];

#[test]
fn min_distance_notes() {
    for (model, disparity, computed, used) in MIN_DISTANCE {
        let device = Catalog::builtin().device(model).unwrap();
        let sensor = device
            .depth_sensors
            .iter()
            .find(|sensor| sensor.kind == DepthKind::Stereo)
            .unwrap();
        let extended = disparity == "191";
        let (largest, shipped) = if extended {
            (
                sensor.extended_max_disparity_px.unwrap(),
                sensor.extended_min_distance_m.unwrap(),
            )
        } else {
            (sensor.max_disparity_px, sensor.min_distance_m)
        };
        assert_printed(largest, disparity, model);
        let metres = sensor.baseline_mm * sensor.focal_length_px / largest / 1000.0;
        assert_printed(metres, computed, model);
        assert_printed(shipped, used, model);
        let note = device
            .notes
            .iter()
            .find(|note| note.topic == "min-distance")
            .unwrap();
        assert!(
            note.text.contains(&format!("{metres:.3}")) || note.text.contains(computed),
            "{model}: {}",
            note.text
        );
    }
}

/// maxFOV of the sheet's camera tables, and the diagonals of the pinholes: the OAK4 rows are these diagonals.
#[test]
fn max_fov_rows() {
    let catalog = Catalog::builtin();
    for (model, role, max_fov, diagonal) in [
        ("OAK-D Pro PoE", Role::Rgb, "82.0", "71.3"),
        ("OAK-D Pro PoE", Role::Left, "89.5", "86.3"),
        ("OAK-D Pro PoE", Role::Right, "89.5", "86.3"),
        ("OAK-D Pro W PoE", Role::Rgb, "108.0", "87.8"),
        ("OAK-D Pro W PoE", Role::Left, "127.0", "106.2"),
        ("OAK-D Pro W PoE", Role::Right, "127.0", "106.2"),
        ("OAK4-D", Role::Rgb, "80.3", "80.3"),
        ("OAK4-D", Role::Left, "86.3", "86.3"),
        ("OAK4-D", Role::Right, "86.3", "86.3"),
        ("OAK4-D Wide", Role::Rgb, "100.7", "100.7"),
        ("OAK4-D Wide", Role::Left, "106.2", "106.2"),
        ("OAK4-D Wide", Role::Right, "106.2", "106.2"),
        ("OAK-D ToF", Role::Tof, "70.0", "82.4"),
        ("OAK-D ToF", Role::Left, "80.0", "89.4"),
        ("OAK-D ToF", Role::Right, "80.0", "89.4"),
    ] {
        let twin = catalog.nominal(catalog.device(model).unwrap());
        let camera = twin.camera(role).unwrap();
        assert_printed(camera.spec.max_fov_deg.unwrap(), max_fov, model);
        assert_printed(camera.intrinsics.dfov().to_degrees(), diagonal, model);
        if max_fov != diagonal {
            let role = serde_json::to_value(if role == Role::Right { Role::Left } else { role }).unwrap();
            let about = format!("camera.{}.max_fov_deg", role.as_str().unwrap());
            let evidence = twin
                .device
                .evidence
                .iter()
                .find(|evidence| evidence.about == about)
                .unwrap();
            assert_eq!(evidence.value, format!("{diagonal}°"), "{model}");
        }
    }
}
