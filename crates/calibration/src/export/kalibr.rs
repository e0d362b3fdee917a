use std::fmt::Write as _;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::{LensModel, OpenCv, OpenCvLens};

use super::simplify::{equidistant, error_px, radial_tangential};
use super::text::list;
use super::{Export, camera_name};
use crate::{Calibration, CalibrationError, CameraCalibration, Socket};

/// Creates `camchain.yaml`: left and right first, then the others by socket; metres. Kalibr has four coefficients per camera, so
/// larger models are approximated, with a warning that states the residual error.
pub(super) fn export(calibration: &Calibration) -> Result<Export, CalibrationError> {
    let mut export = Export::default();
    let mut text = String::new();
    let pair = calibration.stereo_pair();
    let mut order: Vec<Socket> = calibration.cameras.keys().copied().collect();
    if let Some((left, right)) = pair {
        order.retain(|socket| *socket != left && *socket != right);
        order.splice(0..0, [left, right]);
    }
    let mut before: Option<Socket> = None;
    for (i, socket) in order.into_iter().enumerate() {
        let camera = calibration.camera(socket)?;
        let name = camera_name(calibration, socket);
        let (model, coefficients) = distortion(calibration, camera, &mut export.findings)?;
        let c = camera.intrinsics.principal_point::<OpenCv>();
        let intrinsics = list(&[camera.intrinsics.fx, camera.intrinsics.fy, c.x, c.y]);
        // Writing to a string cannot fail.
        _ = writeln!(text, "cam{i}:");
        if let Some(before) = before {
            match calibration.transform(before, socket, false) {
                Ok(here_from_before) => transform(&mut text, "T_cn_cnm1", &here_from_before.rows()),
                Err(_) => export.findings.push(Finding::new(
                    "not-joined",
                    Level::Warning,
                    format!("{}.extrinsics", camera.place),
                    format!("no extrinsics connect {before} and {socket}; cam{i} has no T_cn_cnm1, which Kalibr requires"),
                    "calibrate the cameras together, or remove this one from the file",
                )),
            }
        }
        if let Ok(camera_from_imu) = calibration.camera_from_imu(socket, false) {
            transform(&mut text, "T_cam_imu", &camera_from_imu.rows());
        }
        _ = write!(
            text,
            "  camera_model: pinhole\n  intrinsics: {intrinsics}\n  distortion_model: {model}\n  \
             distortion_coeffs: {}\n  resolution: [{}, {}]\n  rostopic: /{name}/image_raw\n",
            list(&coefficients),
            camera.size().width,
            camera.size().height,
        );
        before = Some(socket);
    }
    export.files.push(("camchain.yaml".to_owned(), text));
    Ok(export)
}

fn transform(text: &mut String, key: &str, rows: &[[f64; 4]; 4]) {
    _ = writeln!(text, "  {key}:");
    for row in rows {
        _ = writeln!(text, "  - {}", list(row));
    }
}

fn distortion(
    calibration: &Calibration,
    camera: &CameraCalibration,
    findings: &mut Vec<Finding>,
) -> Result<(&'static str, [f64; 4]), CalibrationError> {
    match camera.lens.as_opencv() {
        Some(OpenCvLens::Fisheye(k)) => return Ok(("equidistant", k)),
        Some(OpenCvLens::Pinhole([k1, k2, p1, p2, rest @ ..])) if rest == [0.0; 10] => {
            return Ok(("radtan", [k1, k2, p1, p2]));
        }
        _ => {}
    }
    let optics = camera.camera();
    let place = format!("{}.distortionCoeff", camera.place);
    let radtan = radial_tangential(&optics).map(|lens| {
        let [k1, k2, p1, p2, ..] = *lens.coefficients();
        (
            "radtan",
            [k1, k2, p1, p2],
            error_px(&optics, &LensModel::OpenCvPinhole(lens)),
        )
    });
    let fisheye = equidistant(&optics).map(|lens| {
        (
            "equidistant",
            lens.k,
            error_px(&optics, &LensModel::OpenCvFisheye(lens)),
        )
    });
    let best = radtan
        .into_iter()
        .chain(fisheye)
        .min_by(|a, b| a.2.0.total_cmp(&b.2.0));
    let Some((model, coefficients, (rms, worst))) = best else {
        return Err(CalibrationError::Unsuited {
            file: calibration.file_name.clone(),
            place,
            what: "too few pixels have a ray by the lens model to fit a simpler one".to_owned(),
            remedy: "calibrate again",
        });
    };
    findings.push(Finding::new(
        "distortion-fitted",
        Level::Warning,
        place,
        format!(
            "Kalibr has four coefficients; the fitted {model} model differs by {rms:.2} px (root mean square), at most \
             {worst:.2} px"
        ),
        "calibrate with Kalibr itself if that matters",
    ));
    Ok((model, coefficients))
}
