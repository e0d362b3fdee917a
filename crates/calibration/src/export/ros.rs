use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::math::DMat3;
use oaktwin_camera::{Camera, LensModel, OpenCvLens, OpenCvPinhole};

use super::simplify::error_px;
use super::text::{list, rows};
use super::{Export, camera_name, pair};
use crate::{Calibration, CalibrationError, CameraCalibration};

/// Creates `camera_info` files for `camera_info_manager`: K of the raw image, R and P of the rectified image, metres.
pub(super) fn export(calibration: &Calibration) -> Result<Export, CalibrationError> {
    let mut export = Export::default();
    let pair = pair(calibration, &mut export.findings)?;
    for camera in calibration.cameras.values() {
        let name = camera_name(calibration, camera.socket);
        let k = camera.intrinsics.opencv_matrix();
        let (rotation, projection) = match &pair {
            Some(pair) if pair.left == camera.socket => (
                pair.rectification.rectified_from_left,
                pair.rectification.projection_left(),
            ),
            Some(pair) if pair.right == camera.socket => (
                pair.rectification.rectified_from_right,
                pair.rectification.projection_right(),
            ),
            _ => (DMat3::IDENTITY, k.map(|[a, b, c]| [a, b, c, 0.0])),
        };
        let (model, coefficients) = distortion(camera, &mut export.findings);
        let text = format!(
            "image_width: {width}\nimage_height: {height}\ncamera_name: {name}\n\
             camera_matrix:\n  rows: 3\n  cols: 3\n  data: {k}\n\
             distortion_model: {model}\ndistortion_coefficients:\n  rows: 1\n  cols: {n}\n  data: {coefficients}\n\
             rectification_matrix:\n  rows: 3\n  cols: 3\n  data: {r}\n\
             projection_matrix:\n  rows: 3\n  cols: 4\n  data: {p}\n",
            width = camera.size().width,
            height = camera.size().height,
            k = list(k.as_flattened()),
            n = coefficients.len(),
            coefficients = list(&coefficients),
            r = list(&rows(rotation)),
            p = list(projection.as_flattened()),
        );
        export.files.push((format!("{name}.yaml"), text));
    }
    Ok(export)
}

/// Returns the name of the distortion model and its coefficients.
fn distortion(camera: &CameraCalibration, findings: &mut Vec<Finding>) -> (&'static str, Vec<f64>) {
    let coefficients = match camera.lens.as_opencv() {
        Some(OpenCvLens::Fisheye(k)) => return ("equidistant", k.to_vec()),
        Some(OpenCvLens::Pinhole(coefficients)) => coefficients,
        // No calibration has another lens.
        None => [0.0; 14],
    };
    let (plumb_bob, rational, rest) = (&coefficients[..5], &coefficients[..8], &coefficients[8..]);
    if rest.iter().any(|c| *c != 0.0) {
        let mut kept = [0.0; 14];
        kept[..8].copy_from_slice(rational);
        findings.push(dropped(&camera.camera(), &camera.place, kept));
    } else if rational[5..].iter().all(|c| *c == 0.0) {
        return ("plumb_bob", plumb_bob.to_vec());
    }
    ("rational_polynomial", rational.to_vec())
}

fn dropped(camera: &Camera, place: &str, kept: [f64; 14]) -> Finding {
    let (_, worst) = error_px(camera, &LensModel::OpenCvPinhole(OpenCvPinhole::new(kept)));
    Finding::new(
        "distortion-dropped",
        Level::Warning,
        format!("{place}.distortionCoeff"),
        format!(
            "ROS has the first eight coefficients only; ignoring thin prism and tilt causes an error of up to {worst:.2} px"
        ),
        "undistort with the OpenCV export if that matters",
    )
}
