use std::fmt::Write as _;

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{LensModel, OpenCvLens};

use super::text::{number, rows};
use super::{CalibrationFiles, camera_name, pair};
use crate::{Calibration, CalibrationError, CameraCalibration, StereoPair};

/// Creates `FileStorage` files: one per camera with the keys of OpenCV's `calibration` sample, and `stereo.yml` with the keys of its
/// `stereo_calib` sample. All 14 coefficients; metres.
pub(super) fn export(calibration: &Calibration) -> Result<CalibrationFiles, CalibrationError> {
    let mut export = CalibrationFiles::default();
    for camera in calibration.cameras.values() {
        let mut text = header();
        let fisheye = matches!(camera.lens.as_opencv(), Some(OpenCvLens::Fisheye(_)));
        // Writing to a string cannot fail.
        _ = writeln!(text, "image_width: {}", camera.size().width);
        _ = writeln!(text, "image_height: {}", camera.size().height);
        _ = writeln!(text, "fisheye_model: {}", i32::from(fisheye));
        lens(&mut text, camera, "camera_matrix", "distortion_coefficients");
        let name = camera_name(calibration, camera.socket);
        export.files.push((format!("{name}.yml"), text));
    }
    if let Some(pair) = pair(calibration, &mut export.findings)? {
        export
            .files
            .push(("stereo.yml".to_owned(), stereo(calibration, &pair)?));
    }
    Ok(export)
}

fn stereo(calibration: &Calibration, pair: &StereoPair) -> Result<String, CalibrationError> {
    let (left, right) = (calibration.camera(pair.left)?, calibration.camera(pair.right)?);
    let mut text = header();
    _ = writeln!(text, "image_width: {}", left.size().width);
    _ = writeln!(text, "image_height: {}", left.size().height);
    lens(&mut text, left, "M1", "D1");
    let right = CameraCalibration {
        intrinsics: right.intrinsics.resized(left.size(), true),
        ..right.clone()
    };
    lens(&mut text, &right, "M2", "D2");
    let (r, t) = (pair.right_from_left.rotation, pair.right_from_left.translation);
    let essential = cross(t) * r;
    let fundamental =
        right.intrinsics.matrix().inverse().transpose() * essential * left.intrinsics.matrix().inverse();
    let scale = fundamental.z_axis.z;
    let rectified = &pair.rectification;
    matrix(&mut text, "R", 3, &rows(r));
    matrix(&mut text, "T", 3, &t.to_array());
    matrix(&mut text, "E", 3, &rows(essential));
    matrix(
        &mut text,
        "F",
        3,
        &rows(fundamental * if scale == 0.0 { 1.0 } else { 1.0 / scale }),
    );
    matrix(&mut text, "R1", 3, &rows(rectified.rectified_from_left));
    matrix(&mut text, "R2", 3, &rows(rectified.rectified_from_right));
    matrix(&mut text, "P1", 3, rectified.projection_left().as_flattened());
    matrix(&mut text, "P2", 3, rectified.projection_right().as_flattened());
    matrix(
        &mut text,
        "Q",
        4,
        &rectified.disparity_to_depth().transpose().to_cols_array(),
    );
    Ok(text)
}

fn header() -> String {
    "%YAML:1.0\n---\n".to_owned()
}

fn lens(text: &mut String, camera: &CameraCalibration, k: &str, d: &str) {
    matrix(text, k, 3, camera.intrinsics.opencv_matrix().as_flattened());
    let coefficients = match camera.lens.as_opencv() {
        Some(_) if camera.lens != LensModel::Pinhole => camera.lens.coefficients(),
        _ => &[0.0; 5],
    };
    matrix(text, d, 1, coefficients);
}

fn matrix(text: &mut String, name: &str, rows: usize, entries: &[f64]) {
    let numbers: Vec<String> = entries.iter().map(|x| number(*x)).collect();
    _ = writeln!(
        text,
        "{name}: !!opencv-matrix\n   rows: {rows}\n   cols: {}\n   dt: d\n   data: [ {} ]",
        entries.len() / rows,
        numbers.join(", ")
    );
}

/// Returns the matrix of the cross product with v.
fn cross(v: DVec3) -> DMat3 {
    DMat3::from_cols(
        DVec3::new(0.0, v.z, -v.y),
        DVec3::new(-v.z, 0.0, v.x),
        DVec3::new(v.y, -v.x, 0.0),
    )
}
