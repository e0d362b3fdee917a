//! Checks of a calibration's content.

use oaktwin_base::diagnostic::{Finding, Level, message, opt};
use oaktwin_camera::{LensModel, OpenCv, PixelPoint, RigidTransform};

use crate::CalibrationError;
use crate::model::{Calibration, CameraCalibration, ExtrinsicLink};
use crate::reader::Reader;
use crate::rectify::rectifying_rotations;

/// The relative error of a baseline that causes a warning; real units are within 1.6 %.
pub(crate) const SUSPICIOUS_BASELINE: f64 = 0.03;
/// The relative error of a baseline that means a wrong scale of the calibration board, or another model.
pub(crate) const WRONG_BASELINE: f64 = 0.10;
/// The code of an error that [`force`] downgrades.
pub(crate) const BASELINE: &str = "baseline-off";
/// The code of another error that [`force`] downgrades.
pub(crate) const RESOLUTION: &str = "resolution-off";
/// The code of the residual of a lens that an export approximates, an error if large, which [`force`] downgrades.
pub(crate) const FITTED: &str = "distortion-fitted";
/// The angle between the file's rectification and the rectification by its extrinsics that causes a warning, rad.
const SUSPICIOUS_RECTIFICATION: f64 = 1e-3;

/// Downgrades the errors that a user may choose to ignore to warnings: a mismatch of the baseline or resolution, a lens
/// that a format cannot represent.
pub fn force(findings: &mut [Finding]) {
    for finding in findings {
        if finding.level == Level::Error && [BASELINE, RESOLUTION, FITTED].contains(&finding.code) {
            finding.level = Level::Warning;
        }
    }
}

pub(crate) fn cameras(reader: &mut Reader, calibration: &Calibration) {
    for camera in calibration.cameras.values() {
        let place = format!("{}.intrinsicMatrix", camera.place);
        let k = &camera.intrinsics;
        let (c, size) = (k.principal_point::<OpenCv>(), k.size);
        let inside = |x: f64, extent: u32| (-0.5..=f64::from(extent) - 0.5).contains(&x);
        if !inside(c.x, size.width) || !inside(c.y, size.height) {
            let message = format!(
                "the principal point ({}, {}) is outside the {size} image",
                c.x, c.y
            );
            reader.warn(
                "principal-point",
                &place,
                message,
                "calibrate again, or correct width and height",
            );
        }
        let hfov_deg = k.hfov().to_degrees();
        if !(5.0..=170.0).contains(&hfov_deg) {
            let message = format!(
                "fx = {} px and a width of {} px mean a field of view of {hfov_deg:.1} deg",
                k.fx, size.width
            );
            reader.warn(
                "field-of-view",
                &place,
                message,
                "correct width, or calibrate again",
            );
        }
        if !reaches_corners(camera) {
            let message = "the lens model folds back inside the image; some pixels have no ray";
            reader.warn(
                "distortion-folds",
                format!("{}.distortionCoeff", camera.place),
                message,
                "calibrate again with views that fill the image",
            );
        }
        cancelled_poles(reader, camera);
        if !(0.9..=1.1).contains(&(k.fx / k.fy)) {
            let message = format!("fx = {} and fy = {} px differ by more than 10 %", k.fx, k.fy);
            reader.warn(
                "focal-length",
                &place,
                message,
                "these sensors have square pixels; calibrate again",
            );
        }
    }
}

/// Reports the poles of a lens model that its rays pass over, as in OpenCV.
fn cancelled_poles(reader: &mut Reader, camera: &CameraCalibration) {
    let LensModel::OpenCvPinhole(lens) = &camera.lens else {
        return;
    };
    let k = &camera.intrinsics;
    let reach = corners(camera).map(|corner| k.normalized_from_pixel(corner).length());
    let reach = reach.into_iter().fold(0.0, f64::max);
    for radius in lens
        .cancelled_poles()
        .into_iter()
        .filter(|radius| *radius < reach)
    {
        let message = format!(
            "the lens model has a pole {:.0} px from the principal point, which a zero beside it cancels; rays pass over it as in \
             OpenCV, and pixels within a few px of that circle are inexact",
            k.fx * radius
        );
        reader.note(
            "distortion-pole",
            format!("{}.distortionCoeff", camera.place),
            message,
        );
    }
}

fn reaches_corners(camera: &CameraCalibration) -> bool {
    corners(camera)
        .into_iter()
        .all(|corner| camera.camera().unproject(corner).is_some())
}

fn corners(camera: &CameraCalibration) -> [PixelPoint<OpenCv>; 4] {
    let (right, bottom) = (
        f64::from(camera.size().width) - 1.0,
        f64::from(camera.size().height) - 1.0,
    );
    [(0.0, 0.0), (right, 0.0), (0.0, bottom), (right, bottom)].map(|(x, y)| PixelPoint::new(x, y))
}

pub(crate) fn links(reader: &mut Reader, calibration: &Calibration) {
    let of_cameras = calibration.cameras.values().filter_map(|c| c.extrinsics.as_ref());
    let others = calibration.imu.iter().chain(&calibration.housing);
    for link in of_cameras.chain(others) {
        if calibration.link(link.to).is_none() {
            let message = format!("refers to {}, which is not in cameraData", link.to);
            reader.error(
                "dangling-socket",
                format!("{}.toCameraSocket", link.place),
                message,
                "add that camera, or set -1",
            );
        }
    }
    let mut reported: Vec<crate::Socket> = Vec::new();
    for camera in calibration.cameras.values() {
        let cycle = cycle_through(calibration, camera);
        if let Some(cycle) = cycle.filter(|_| !reported.contains(&camera.socket)) {
            let names: Vec<String> = cycle.iter().map(ToString::to_string).collect();
            let message = format!(
                "the extrinsics form a cycle: {} -> {}",
                names.join(" -> "),
                camera.socket
            );
            reader.error(
                "cycle",
                format!("{}.extrinsics.toCameraSocket", camera.place),
                message,
                "set the root's to -1",
            );
            reported.extend(cycle);
        }
    }
}

/// Returns the sockets of the cycle that contains the camera.
fn cycle_through(calibration: &Calibration, start: &CameraCalibration) -> Option<Vec<crate::Socket>> {
    let mut seen = vec![start.socket];
    let mut link = start.extrinsics.as_ref();
    while let Some(ExtrinsicLink { to, .. }) = link {
        if *to == start.socket {
            return Some(seen);
        }
        if seen.contains(to) {
            return None; // a cycle that does not contain this camera
        }
        seen.push(*to);
        link = calibration.link(*to)?;
    }
    None
}

pub(crate) fn stereo(reader: &mut Reader, calibration: &Calibration) {
    let Some((left, right)) = calibration.stereo_pair() else {
        return;
    };
    let Ok(right_from_left) = calibration.transform(left, right, false) else {
        return;
    };
    let place = || calibration.baseline_place(left, right);
    let t = right_from_left.translation;
    match calibration.baseline(left, right, true) {
        Ok(spec) => {
            let finding = baseline_finding(place(), t.length(), spec, "the board's design has");
            reader.findings.extend(finding);
        }
        Err(CalibrationError::NoSpecTranslation { place, .. }) => reader.warn(
            "no-design",
            format!("{place}.specTranslation"),
            format!("is zero: the baseline of {left} and {right} cannot be compared with the design, depth is computed with the calibrated one, and getBaselineDistance of DepthAI fails"),
            "write the translation of the board's design, in centimetres",
        ),
        Err(_) => {}
    }
    if t.length() < 1e-3 {
        let message = format!("{left} and {right} are {:.3} mm apart", t.length() * 1e3);
        reader.warn("no-baseline", place(), message, "calibrate the stereo pair");
        return;
    }
    if t.x > 0.0 {
        let message = format!("{left}, the left camera, is to the right of {right}");
        reader.warn(
            "stereo-swapped",
            place(),
            message,
            "swap leftCameraSocket and rightCameraSocket",
        );
    } else if -t.x < 0.9 * t.length() {
        let message = format!(
            "{left} and {right} are not side by side: {:.1} mm in x of {:.1} mm",
            -t.x * 1e3,
            t.length() * 1e3
        );
        reader.warn(
            "stereo-not-horizontal",
            place(),
            message,
            "calibrate the stereo pair again",
        );
    }
    rectification(reader, calibration, &right_from_left);
}

fn rectification(reader: &mut Reader, calibration: &Calibration, right_from_left: &RigidTransform) {
    let Some(stereo) = calibration.stereo else { return };
    let Some((r1, r2)) = rectifying_rotations(right_from_left) else {
        return;
    };
    for (stored, computed, key) in [
        (stereo.rectified_from_left, r1, "rectifiedRotationLeft"),
        (stereo.rectified_from_right, r2, "rectifiedRotationRight"),
    ] {
        let Some(stored) = stored else { continue };
        let angle = rotation_angle(stored * computed.transpose());
        if angle > SUSPICIOUS_RECTIFICATION {
            let message = format!(
                "differs by {:.3} deg from the rotation by the extrinsics; ignored",
                angle.to_degrees()
            );
            reader.warn(
                "rectification-off",
                format!("stereoRectificationData.{key}"),
                message,
                "calibrate the pair again",
            );
        }
    }
}

fn rotation_angle(r: oaktwin_camera::math::DMat3) -> f64 {
    // The skew part is more accurate than acos near zero.
    let skew = oaktwin_camera::math::DVec3::new(
        r.y_axis.z - r.z_axis.y,
        r.z_axis.x - r.x_axis.z,
        r.x_axis.y - r.y_axis.x,
    );
    let trace = r.x_axis.x + r.y_axis.y + r.z_axis.z;
    skew.length().atan2(trace - 1.0)
}

pub(crate) fn baseline_finding(place: String, found_m: f64, nominal_m: f64, who: &str) -> Option<Finding> {
    let off = found_m / nominal_m - 1.0;
    let level = if off.abs() > WRONG_BASELINE {
        Level::Error
    } else if off.abs() > SUSPICIOUS_BASELINE {
        Level::Warning
    } else {
        return None;
    };
    Some(Finding::new(
        BASELINE,
        level,
        place,
        format!(
            "the baseline is {:.2} mm, but {who} {:.2} mm ({:+.1} %)",
            found_m * 1e3,
            nominal_m * 1e3,
            off * 100.0
        ),
        message![
            "check the model and the square size of the calibration board; ",
            opt("force"),
            " ignores the error"
        ],
    ))
}
