use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::math::DMat3;
use oaktwin_camera::{Intrinsics, OpenCvLens};

use super::simplify::rational;
use super::text::{list, rows};
use super::{CalibrationFiles, camera_name, no_fit, pair};
use crate::{Calibration, CalibrationError, CameraCalibration};

/// Creates `camera_info` files for `camera_info_manager`: K of the raw image, R and P of the rectified image, metres. R and P
/// come from the calibration even where K and D are fitted: D and K give the ray of a raw pixel, R and P the rectified pixel of the ray.
pub(super) fn export(calibration: &Calibration) -> Result<CalibrationFiles, CalibrationError> {
    let mut export = CalibrationFiles::default();
    let pair = pair(calibration, &mut export.findings)?;
    for camera in calibration.cameras.values() {
        let name = camera_name(calibration, camera.socket);
        let (rotation, projection) = match &pair {
            Some(pair) if pair.left == camera.socket => (
                pair.rectification.rectified_from_left,
                pair.rectification.projection_left(),
            ),
            Some(pair) if pair.right == camera.socket => (
                pair.rectification.rectified_from_right,
                pair.rectification.projection_right(),
            ),
            _ => {
                let k = camera.intrinsics.opencv_matrix();
                (DMat3::IDENTITY, k.map(|[a, b, c]| [a, b, c, 0.0]))
            }
        };
        let Info {
            intrinsics,
            model,
            coefficients,
        } = info(calibration, camera, &mut export.findings)?;
        let text = format!(
            "image_width: {width}\nimage_height: {height}\ncamera_name: {name}\n\
             camera_matrix:\n  rows: 3\n  cols: 3\n  data: {k}\n\
             distortion_model: {model}\ndistortion_coefficients:\n  rows: 1\n  cols: {n}\n  data: {coefficients}\n\
             rectification_matrix:\n  rows: 3\n  cols: 3\n  data: {r}\n\
             projection_matrix:\n  rows: 3\n  cols: 4\n  data: {p}\n",
            width = camera.size().width,
            height = camera.size().height,
            k = list(intrinsics.opencv_matrix().as_flattened()),
            n = coefficients.len(),
            coefficients = list(&coefficients),
            r = list(&rows(rotation)),
            p = list(projection.as_flattened()),
        );
        export.files.push((format!("{name}.yaml"), text));
    }
    Ok(export)
}

/// A camera as ROS represents it.
struct Info {
    intrinsics: Intrinsics,
    model: &'static str,
    coefficients: Vec<f64>,
}

/// Returns the camera with a lens of ROS's three models. One with thin prism or tilt is fitted, with a finding about the residual.
fn info(
    calibration: &Calibration,
    camera: &CameraCalibration,
    findings: &mut Vec<Finding>,
) -> Result<Info, CalibrationError> {
    let exact = |model, coefficients: &[f64]| Info {
        intrinsics: camera.intrinsics,
        model,
        coefficients: coefficients.to_vec(),
    };
    let [k1, k2, p1, p2, k3, k4, k5, k6, rest @ ..] = match camera.lens.as_opencv() {
        Some(OpenCvLens::Fisheye(k)) => return Ok(exact("equidistant", &k)),
        Some(OpenCvLens::Pinhole(coefficients)) => coefficients,
        // No calibration has another lens.
        None => [0.0; 14],
    };
    let first = [k1, k2, p1, p2, k3, k4, k5, k6];
    if rest.iter().all(|c| *c == 0.0) {
        let is_polynomial = [k4, k5, k6] == [0.0; 3];
        return Ok(if is_polynomial {
            exact("plumb_bob", &[k1, k2, p1, p2, k3])
        } else {
            exact("rational_polynomial", &first)
        });
    }
    let place = format!("{}.distortionCoeff", camera.place);
    let fitted = rational(&camera.camera(), first).ok_or_else(|| no_fit(calibration, &place))?;
    let what =
        "ROS has neither thin prism nor tilt, so K and the first eight coefficients were fitted to this lens";
    findings.push(fitted.finding(place, what, "undistort with the OpenCV export if that matters"));
    let coefficients = fitted.camera.lens.coefficients().iter().take(first.len());
    Ok(Info {
        intrinsics: fitted.camera.intrinsics,
        model: "rational_polynomial",
        coefficients: coefficients.copied().collect(),
    })
}
