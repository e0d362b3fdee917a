use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::math::DVec3;
use oaktwin_camera::{Axes, RigidTransform};
use oaktwin_catalog::{Origin, Role, Twin, TwinCamera};

use crate::against::{calibrated, pair_of, socket_of};
use crate::design;
use crate::rectify::rectifying_rotations;
use crate::{Calibration, CalibrationError};

/// Creates the twin of one unit: `nominal` with the intrinsics, lenses and poses of a calibration.
///
/// Intrinsics are rescaled to the nominal image size by `DepthAI`'s rule. As in the nominal device, the origin of the body frame
/// is midway between the left and right optical centres, and its axes follow the *rectified* stereo pair, as do
/// depth images: y to the left along the baseline, x forward in the mean direction of both cameras. Thus the cameras have
/// their small calibrated rotations relative to a frame that depends on no single camera. Depth sensors keep their parameters
/// except the focal length, which is the rounded fx of their camera. Depth is computed with the baseline of the board's design unless
/// the calibration says otherwise, as on the device; a finding reports the error. Cameras that are missing in the calibration keep their
/// nominal values, with a warning.
///
/// This function does not validate the calibration; call [`crate::check_against`] first.
///
/// # Errors
/// Returns an error if the left camera is not to the left of the right one.
pub fn twin(
    calibration: &Calibration,
    nominal: &Twin,
    file_name: &str,
) -> Result<(Twin, Vec<Finding>), CalibrationError> {
    let mut findings = Vec::new();
    let mut twin = nominal.clone();
    twin.origin = Origin::Calibration {
        product_name: calibration.board.product_name.clone(),
        file_name: file_name.to_owned(),
    };
    let body = body(calibration, nominal, &mut findings)?;
    for camera in &mut twin.cameras {
        apply(camera, calibration, body, &mut findings);
    }
    let sources = twin.depth_sensors.iter().map(|depth| twin.depth_camera(depth));
    let sources: Vec<Option<TwinCamera>> = sources.collect();
    for (depth, camera) in twin.depth_sensors.iter_mut().zip(sources) {
        if let Some(camera) = camera.filter(|camera| calibrated(calibration, camera).is_some()) {
            depth.focal_length_px = camera.intrinsics.fx.round();
        }
    }
    if let Some((left, body_from_left)) = body {
        design::apply(calibration, &mut twin, &mut findings);
        match calibration.camera_from_imu(left, false) {
            Ok(left_from_imu) => twin.body_from_imu = Some(body_from_left * left_from_imu),
            Err(_) if nominal.body_from_imu.is_none() => {}
            Err(_) => findings.push(Finding::new(
                "imu-nominal",
                Level::Note,
                "imuExtrinsics",
                "the file has no extrinsics of the inertial unit; its nominal pose is used",
                "",
            )),
        }
    }
    Ok((twin, findings))
}

type Body = (crate::Socket, RigidTransform);

/// Returns the left camera's socket and `body_from_left`, or `None` with a warning if no extrinsics connect the pair.
fn body(
    calibration: &Calibration,
    nominal: &Twin,
    findings: &mut Vec<Finding>,
) -> Result<Option<Body>, CalibrationError> {
    let Some((left, right)) = pair_of(nominal) else {
        return Ok(None);
    };
    let right_from_left = match calibration.transform(left, right, false) {
        Ok(right_from_left) => right_from_left,
        Err(error) => {
            findings.push(Finding::new(
                "pair-nominal",
                Level::Warning,
                "cameraData",
                format!(
                    "no extrinsics connect {left} and {right} ({error}); all cameras keep their nominal poses"
                ),
                "calibrate the stereo pair",
            ));
            return Ok(None);
        }
    };
    let t = right_from_left.translation;
    if t.x >= 0.0 || t.x.abs() <= t.y.abs().max(t.z.abs()) {
        let message = format!(
            "{left}, the left camera, is at ({:.2}, {:.2}, {:.2}) cm in the frame of {right}, not to its left",
            t.x * 100.0,
            t.y * 100.0,
            t.z * 100.0
        );
        return Err(CalibrationError::Invalid {
            file: calibration.file_name.clone(),
            errors: vec![Finding::new(
                "stereo-swapped",
                Level::Error,
                calibration.baseline_place(left, right),
                message,
                "calibrate the stereo pair again",
            )],
        });
    }
    let Some((rectified_from_left, _)) = rectifying_rotations(&right_from_left) else {
        return Ok(None);
    };
    let rotation = Axes::Ros.rotation_from(Axes::OpenCv) * rectified_from_left;
    let left_in_body = DVec3::new(0.0, t.length() / 2.0, 0.0);
    Ok(Some((left, RigidTransform::new(rotation, left_in_body))))
}

fn apply(
    camera: &mut TwinCamera,
    calibration: &Calibration,
    body: Option<Body>,
    findings: &mut Vec<Finding>,
) {
    let role = match camera.spec.role {
        Role::Rgb => "RGB",
        Role::Left => "left",
        Role::Right => "right",
        Role::Tof => "time-of-flight",
    };
    let Some(found) = calibrated(calibration, camera) else {
        let socket = socket_of(camera).map_or_else(|| "its socket".to_owned(), |socket| socket.to_string());
        findings.push(Finding::new(
            "camera-nominal",
            Level::Warning,
            "cameraData",
            format!("{socket} is missing; the {role} camera keeps its nominal values"),
            "calibrate it",
        ));
        return;
    };
    camera.intrinsics = found.intrinsics.resized(camera.intrinsics.size, true);
    camera.lens = found.lens;
    let Some((left, body_from_left)) = body else {
        return;
    };
    match calibration.transform(found.socket, left, false) {
        Ok(left_from_camera) => camera.body_from_camera = body_from_left * left_from_camera,
        Err(_) => findings.push(Finding::new(
            "place-nominal",
            Level::Warning,
            format!("{}.extrinsics", found.place),
            format!(
                "no extrinsics connect {} and {left}; the {role} camera keeps its nominal pose",
                found.socket
            ),
            "calibrate the cameras together",
        )),
    }
}
