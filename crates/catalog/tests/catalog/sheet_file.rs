//! The published parameter sheet, found through `OAKTWIN_TEST_DATA`: every cell of its sensor, device, camera, virtual
//! camera and depth-sensor tables is compared with the catalog. An unknown row fails the test.
#![expect(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

use std::path::PathBuf;

use crate::common::assert_printed;
use oaktwin_camera::{ApertureOffsets, Usd, UsdOptics};
use oaktwin_catalog::{Camera, Catalog, DepthKind, Device, Role, Sensor, Twin, TwinCamera};

/// A table: its header and its rows.
struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

fn tables(text: &str) -> Vec<Table> {
    let cells = |line: &str| -> Vec<String> {
        line.trim_matches('|')
            .split(" | ")
            .map(|cell| cell.trim().to_owned())
            .collect()
    };
    let lines: Vec<&str> = text.lines().collect();
    let is_rule = |i: usize| lines.get(i).is_some_and(|line| line.starts_with("|---"));
    let mut tables: Vec<Table> = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        // A table may follow another without a blank line: its header is then the line before the next rule.
        if is_rule(i + 1) {
            tables.push(Table {
                header: cells(line),
                rows: Vec::new(),
            });
        } else if line.starts_with('|')
            && !is_rule(i)
            && let Some(table) = tables.last_mut()
        {
            table.rows.push(cells(line));
        }
    }
    tables
}

/// Returns the folder of the public test data.
fn test_data() -> PathBuf {
    std::env::var_os("OAKTWIN_TEST_DATA")
        .expect("OAKTWIN_TEST_DATA names the folder of the test data")
        .into()
}

fn sheet() -> Vec<Table> {
    let path = test_data().join("reference/oak-isaac-parameters.txt");
    tables(&std::fs::read_to_string(path).unwrap())
}

fn with_header(tables: &[Table], header: &[&str]) -> Vec<usize> {
    (0..tables.len())
        .filter(|i| tables[*i].header == header)
        .collect()
}

const SENSORS: [&str; 5] = ["IMX378", "OV9282", "IMX586", "OV9782", "33D"];
/// The model of each depth sensor's tables, in the sheet's order.
const DEPTH: [(usize, DepthKind); 6] = [
    (0, DepthKind::Stereo),
    (1, DepthKind::Stereo),
    (2, DepthKind::Stereo),
    (3, DepthKind::Stereo),
    (4, DepthKind::Stereo),
    (4, DepthKind::Tof),
];

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn sensor_and_device_tables() {
    let tables = sheet();
    let catalog = Catalog::builtin();
    let properties = with_header(&tables, &["Property", "Value"]);
    assert_eq!(properties.len(), SENSORS.len() + catalog.sheet().count());
    for (i, id) in properties.iter().zip(SENSORS) {
        for row in &tables[*i].rows {
            sensor_row(catalog.sensor(id).unwrap(), &row[0], &row[1]);
        }
    }
    for (i, device) in properties[SENSORS.len()..].iter().zip(catalog.sheet()) {
        for row in &tables[*i].rows {
            device_row(device, &row[0], &row[1]);
        }
    }
}

fn sensor_row(sensor: &Sensor, key: &str, cell: &str) {
    let size = |(w, h): (u32, u32)| format!("{w} x {h}");
    let starts = |text: String| {
        assert!(
            cell.starts_with(&text),
            "{}: {key}: {cell}, not {text}",
            sensor.id
        );
    };
    match key {
        "Sensor Type" => assert_eq!(cell, sensor.kind),
        "Native Resolution" | "Resolution" => {
            starts(size(sensor.native_resolution));
            if cell.contains("MP") {
                assert!(
                    cell.contains(&format!("({} MP)", sensor.megapixels.unwrap())),
                    "{cell}"
                );
            }
        }
        "Used Resolution" => starts(size(sensor.used_resolution)),
        "Pixel Size" => {
            assert_printed(sensor.pixel_size_um, cell.trim_end_matches(" µm"), &sensor.id);
            assert_eq!(sensor.pixel_size_um, sensor.native_pixel_size_um);
        }
        "Native Pixel Size" => assert_printed(
            sensor.native_pixel_size_um,
            cell.trim_end_matches(" µm"),
            &sensor.id,
        ),
        "Effective Pixel Size (12MP)" => {
            assert_printed(sensor.pixel_size_um, cell.trim_end_matches(" µm"), &sensor.id);
        }
        "Optical Format" => assert_eq!(cell, sensor.optical_format.as_deref().unwrap()),
        "Stereo Baseline" => starts("75 mm".to_owned()),
        "Notes" => assert!(!sensor.notes.is_empty()),
        "VCSEL Wavelength" => assert_eq!(cell, format!("{} nm", sensor.wavelength_nm.unwrap())),
        "Depth Range" => {
            let (near, far) = sensor.depth_range_m.unwrap();
            assert_eq!(cell, format!("{} cm - {far} m", near * 100.0));
        }
        "Depth Accuracy" => assert_eq!(Some(cell), sensor.depth_accuracy.as_deref()),
        _ => panic!("{}: unknown row {key}", sensor.id),
    }
}

fn device_row(device: &Device, key: &str, cell: &str) {
    let hfov = |role| format!("~{}°", device.camera(role).unwrap().hfov_deg);
    let range = |kind| {
        let (near, far) = device
            .depth_sensors
            .iter()
            .find(|sensor| sensor.kind == kind)
            .unwrap()
            .ideal_range_m;
        let length = |m: f64| {
            if m < 1.0 {
                format!("{}cm", m * 100.0)
            } else {
                format!("{m}m")
            }
        };
        format!("{} - {}", length(near), length(far))
    };
    let sensor = |role: Role| {
        Catalog::builtin()
            .sensor(&device.camera(role).unwrap().sensor)
            .unwrap()
    };
    let expected = match key {
        "Manufacturer" => device.manufacturer.clone(),
        "Model" => device.full_name.clone().unwrap(),
        "RGB HFOV" => hfov(Role::Rgb),
        "Stereo HFOV" => hfov(Role::Left),
        "ToF HFOV" => hfov(Role::Tof),
        "Dimensions" => {
            let [w, h, d] = device.body.dimensions_mm;
            format!("{w} x {h} x {d} mm")
        }
        "IMU" => device
            .imu
            .as_ref()
            .unwrap()
            .detail
            .clone()
            .unwrap_or_else(|| device.imu.as_ref().unwrap().model.clone()),
        "Ideal Range" | "Ideal Range (stereo)" => range(DepthKind::Stereo),
        "Ideal Range (ToF)" => range(DepthKind::Tof),
        "Depth Accuracy" | "Depth Accuracy (ToF)" => {
            device.accuracy_headline.as_ref().unwrap().specification.clone()
        }
        "Platform" => device.generation.clone(),
        "RGB Sensor" => format!(
            "Sony {} ({} MP, Quad-Bayer)",
            sensor(Role::Rgb).id,
            sensor(Role::Rgb).megapixels.unwrap()
        ),
        "Stereo Sensor" => format!(
            "{} {}",
            sensor(Role::Left).manufacturer.as_deref().unwrap(),
            sensor(Role::Left).id
        ),
        "ToF Sensor" => format!("{} (640x480, ToF)", sensor(Role::Tof).id),
        "RGB Camera" => {
            assert!(device.camera(Role::Rgb).is_none());
            "None".to_owned()
        }
        "Stereo Baseline" => format!("{} mm", device.stereo_baseline_mm.unwrap()),
        "ToF Baseline (sim)" => format!("{} mm", device.depth_sensors[1].baseline_mm),
        _ => panic!("{}: unknown row {key}", device.name),
    };
    assert!(
        cell.starts_with(&expected),
        "{}: {key}: {cell}, not {expected}",
        device.name
    );
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn camera_tables() {
    let tables = sheet();
    let catalog = Catalog::builtin();
    let found: Vec<&Table> = tables
        .iter()
        .filter(|table| table.header.len() == 4 && table.header[1].starts_with("Camera_"))
        .collect();
    assert_eq!(found.len(), catalog.sheet().count());
    let mut cells = 0;
    for (table, device) in found.iter().zip(catalog.sheet()) {
        let twin = catalog.nominal(device);
        let prims: Vec<&str> = twin
            .cameras
            .iter()
            .map(|camera| camera.spec.prim.as_str())
            .collect();
        assert_eq!(table.header[1..], prims);
        for row in &table.rows {
            for (camera, cell) in twin.cameras.iter().zip(&row[1..]) {
                camera_row(camera, &row[0], cell);
                cells += 1;
            }
        }
    }
    assert_eq!(cells, 5 * 3 * 31, "31 rows, three cameras, five models");
}

fn optics(camera: &TwinCamera) -> UsdOptics {
    UsdOptics::from_intrinsics(&camera.intrinsics, camera.pixel_size_um, ApertureOffsets::OpenUsd)
}

fn camera_row(camera: &TwinCamera, key: &str, cell: &str) {
    let spec: &Camera = &camera.spec;
    let (optics, size) = (optics(camera), camera.intrinsics.size);
    let centre = camera.intrinsics.principal_point::<Usd>();
    let legacy = spec.legacy_distortion.as_ref().unwrap();
    let what = format!("{}: {key}", spec.prim);
    let number = |value: f64| assert_printed(value, cell, &what);
    let text = |value: &str| assert_eq!(cell, value, "{what}");
    let index = || key[key.len() - 1..].parse::<usize>().unwrap();
    match key {
        "name" => text(&spec.prim),
        "focalLength" => number(optics.focal_length_mm),
        "focusDistance" => number(spec.focus_distance),
        "fStop" => number(spec.f_stop),
        "projection" => text(&spec.projection),
        "stereoRole" => text(&spec.stereo_role),
        "horizontalAperture" => number(optics.horizontal_aperture_mm),
        "verticalAperture" => number(optics.vertical_aperture_mm),
        "horizontalApertureOffset" => number(optics.horizontal_aperture_offset_mm),
        "verticalApertureOffset" => number(optics.vertical_aperture_offset_mm),
        "clippingRange" => text(&format!("{:?}", spec.clipping_range_m)),
        "cameraProjectionType" => text(&spec.projection_type),
        "nominalWidth" => number(size.width.into()),
        "nominalHeight" => number(size.height.into()),
        "opticalCenterX" => number(centre.x),
        "opticalCenterY" => number(centre.y),
        "maxFOV" => number(spec.max_fov_deg.unwrap()),
        "physicalDistortionCoefficients" => text(&legacy.physical_coefficients),
        "physicalDistortionModel" => text(&legacy.physical_model),
        _ if key.starts_with("polyK") => number(legacy.poly_k[index()]),
        "p0" | "p1" => number(legacy.p[index()]),
        "s0" | "s1" | "s2" | "s3" => number(legacy.s[index()]),
        _ => panic!("{what}: unknown row"),
    }
}

fn twin_and_sensor(model: usize, kind: DepthKind) -> (Twin, usize) {
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(&catalog.devices()[model]);
    let i = twin
        .depth_sensors
        .iter()
        .position(|sensor| sensor.spec.kind == kind)
        .unwrap();
    (twin, i)
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn virtual_camera_tables() {
    let tables = sheet();
    let found = with_header(&tables, &["Parameter", "Value", "Source"]);
    assert_eq!(found.len(), DEPTH.len());
    for (i, (model, kind)) in found.into_iter().zip(DEPTH) {
        let (twin, sensor) = twin_and_sensor(model, kind);
        let spec = &twin.depth_sensors[sensor].spec;
        let optics = optics(twin.camera(spec.camera).unwrap());
        for row in &tables[i].rows {
            let (key, cell) = (row[0].as_str(), row[1].as_str());
            let number = |value: f64| assert_printed(value, cell, key);
            match key {
                "focalLength" => number(optics.focal_length_mm),
                "horizontalAperture" => number(optics.horizontal_aperture_mm),
                "verticalAperture" => number(optics.vertical_aperture_mm),
                "horizontalApertureOffset" => number(optics.horizontal_aperture_offset_mm),
                "verticalApertureOffset" => number(optics.vertical_aperture_offset_mm),
                "focusDistance" => number(spec.focus_distance),
                "clippingRange" => assert_eq!(cell, format!("{:?}", spec.clipping_range_m)),
                _ => panic!("{}: unknown row {key}", spec.prim),
            }
        }
    }
}

#[test]
#[ignore = "needs OAKTWIN_TEST_DATA"]
fn depth_sensor_tables() {
    let tables = sheet();
    let found = with_header(&tables, &["Parameter", "Value", "Description"]);
    assert_eq!(found.len(), DEPTH.len());
    for (i, (model, kind)) in found.into_iter().zip(DEPTH) {
        let (twin, sensor) = twin_and_sensor(model, kind);
        let spec = &twin.depth_sensors[sensor].spec;
        for row in &tables[i].rows {
            let (key, cell) = (row[0].as_str(), row[1].as_str());
            let number = |value: f64| assert_printed(value, cell, &format!("{}: {key}", twin.device.name));
            match key {
                "baselineMM" => number(spec.baseline_mm),
                "focalLengthPixel" => number(twin.depth_sensors[sensor].focal_length_px),
                "sensorSizePixel" => number(spec.sensor_size_px),
                "maxDisparityPixel" => {
                    number(spec.max_disparity_px);
                    let extended = spec
                        .extended_max_disparity_px
                        .map(|px| format!("({px:.1} for extended)"));
                    match extended {
                        Some(text) => assert!(row[2].contains(&text), "{}", row[2]),
                        None => assert_eq!(row[2], "Standard mode"),
                    }
                }
                "minDistance" => number(spec.min_distance_m),
                "maxDistance" => number(spec.max_distance_m),
                "noiseMean" => number(spec.noise_mean_px),
                "noiseSigma" => number(spec.noise_sigma_px),
                "noiseDownscaleFactorPixel" => number(spec.noise_downscale_factor_px),
                "confidenceThreshold" => number(spec.confidence_threshold),
                "outlierRemovalRange" => number(spec.outlier_removal_range_px.into()),
                _ => panic!("{}: unknown row {key}", spec.prim),
            }
        }
    }
}
