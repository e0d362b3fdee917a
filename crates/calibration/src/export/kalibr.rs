use std::fmt::Write as _;

use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::{Intrinsics, OpenCv, OpenCvLens};

use super::simplify::{better, equidistant, radial_tangential};
use super::text::list;
use super::{CalibrationFiles, camera_name, no_fit};
use crate::{Calibration, CalibrationError, CameraCalibration, Socket};

/// Creates `camchain.yaml`: left and right first, then the others by socket; metres. Kalibr has four coefficients per camera, so
/// larger models are fitted, with a finding about the residual.
pub(super) fn export(calibration: &Calibration) -> Result<CalibrationFiles, CalibrationError> {
    let mut export = CalibrationFiles::default();
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
        let Pinhole {
            intrinsics,
            model,
            coefficients,
        } = pinhole(calibration, camera, &mut export.findings)?;
        let c = intrinsics.principal_point::<OpenCv>();
        let intrinsics = list(&[intrinsics.fx, intrinsics.fy, c.x, c.y]);
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

/// A camera as Kalibr represents it.
struct Pinhole {
    intrinsics: Intrinsics,
    model: &'static str,
    coefficients: [f64; 4],
}

/// Returns the camera with a lens of Kalibr's models. Other lenses are fitted, with a finding about the residual.
fn pinhole(
    calibration: &Calibration,
    camera: &CameraCalibration,
    findings: &mut Vec<Finding>,
) -> Result<Pinhole, CalibrationError> {
    if let Some((model, coefficients)) = exact(camera.lens.as_opencv()) {
        return Ok(Pinhole {
            intrinsics: camera.intrinsics,
            model,
            coefficients,
        });
    }
    let optics = camera.camera();
    let place = format!("{}.distortionCoeff", camera.place);
    let fitted = better(radial_tangential(&optics), equidistant(&optics));
    let (fitted, (model, coefficients)) = fitted
        .and_then(|fitted| Some((fitted, exact(fitted.camera.lens.as_opencv())?)))
        .ok_or_else(|| no_fit(calibration, &place))?;
    let what = format!(
        "Kalibr has four coefficients, so intrinsics and coefficients of its {model} model were fitted to this lens"
    );
    findings.push(fitted.finding(place, &what, "calibrate with Kalibr itself if that matters"));
    Ok(Pinhole {
        intrinsics: fitted.camera.intrinsics,
        model,
        coefficients,
    })
}

/// Returns the model and coefficients of a lens that Kalibr represents.
fn exact(lens: Option<OpenCvLens>) -> Option<(&'static str, [f64; 4])> {
    match lens? {
        OpenCvLens::Fisheye(k) => Some(("equidistant", k)),
        OpenCvLens::Pinhole([k1, k2, p1, p2, rest @ ..]) => {
            (rest == [0.0; 10]).then_some(("radtan", [k1, k2, p1, p2]))
        }
    }
}
