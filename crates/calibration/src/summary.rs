use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DMat3;
use oaktwin_catalog::nearest_directions;
use serde::Serialize;

use crate::rectify::rectifying_rotations;
use crate::{Board, Calibration, CalibrationError, CameraKind, Socket};

/// A summary of a calibration, as printed and in JSON. Matrices (3×3 and 4×4) are lists of rows, lengths in centimetres as in
/// the file. Transforms equal `DepthAI`'s `getCameraExtrinsics(from, to)`.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CalibrationSummary {
    /// The file's name in messages.
    pub file: String,
    /// The version of the format.
    pub version: u32,
    /// The identification of the board.
    pub board: Board,
    /// The cameras, ordered by socket.
    pub cameras: Vec<CameraSummary>,
    /// All ordered pairs of cameras.
    pub pairs: Vec<PairSummary>,
    /// The stereo pair, if extrinsics connect its cameras.
    pub stereo: Option<StereoSummary>,
    /// Whether the device converts disparity to depth with the baseline of the board's design.
    pub use_spec_translation: bool,
    /// The inertial unit relative to each connected camera.
    pub imu: Vec<ImuSummary>,
    /// Notes, warnings and errors.
    pub findings: Vec<Finding>,
}

/// One camera of a [`CalibrationSummary`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CameraSummary {
    /// `CAM_A`
    pub socket: Socket,
    /// The family of lens models.
    pub model: CameraKind,
    /// The calibrated image width, px.
    pub width: u32,
    /// The calibrated image height, px.
    pub height: u32,
    /// OpenCV's camera matrix, px.
    pub camera_matrix: [[f64; 3]; 3],
    /// `2 atan(width / (2 fx))`.
    pub hfov_deg: f64,
    /// `2 atan(height / (2 fy))`.
    pub vfov_deg: f64,
    /// The diagonal field of view, degrees.
    pub dfov_deg: f64,
    /// The horizontal field of view of the design including distortion, degrees.
    pub spec_hfov_deg: f64,
    /// The coefficients in OpenCV's order.
    pub distortion: Vec<f64>,
    /// The position of the focus motor.
    pub lens_position: u8,
    /// The camera that the extrinsics refer to; `None` at a root.
    pub extrinsics_to: Option<Socket>,
}

/// Two cameras of a [`CalibrationSummary`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PairSummary {
    /// The camera of the source frame.
    pub from: Socket,
    /// The camera of the target frame.
    pub to: Socket,
    /// The calibrated transform, translation in cm; `None` if no extrinsics connect the two.
    pub to_from_from_cm: Option<[[f64; 4]; 4]>,
    /// The transform with the translations of the board's design; `None` if the file lacks one.
    pub spec_to_from_from_cm: Option<[[f64; 4]; 4]>,
    /// The calibrated distance, cm.
    pub baseline_cm: Option<f64>,
    /// The distance of the board's design, cm.
    pub spec_baseline_cm: Option<f64>,
}

/// The stereo pair of a [`CalibrationSummary`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StereoSummary {
    /// The left camera.
    pub left: Socket,
    /// The right camera.
    pub right: Socket,
    /// R1 of `cv2.stereoRectify`, computed from the calibrated extrinsics.
    pub rectified_from_left: [[f64; 3]; 3],
    /// R2 of `cv2.stereoRectify`.
    pub rectified_from_right: [[f64; 3]; 3],
}

/// The inertial unit and a camera of a [`CalibrationSummary`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ImuSummary {
    /// The camera.
    pub camera: Socket,
    /// The calibrated transform, translation in cm.
    pub camera_from_imu_cm: [[f64; 4]; 4],
    /// The transform with the translations of the board's design; `None` if the file lacks one.
    pub spec_camera_from_imu_cm: Option<[[f64; 4]; 4]>,
    /// The direction of the camera that is nearest to each axis of the unit: `x down, y left, z forward`.
    pub axes: String,
    /// The largest angle between an axis and its direction, degrees.
    pub axes_deviation_deg: f64,
}

/// Creates the summary of a calibration with its findings.
#[must_use]
pub fn summary(calibration: &Calibration, findings: &[Finding]) -> CalibrationSummary {
    CalibrationSummary {
        file: calibration.file_name.clone(),
        version: calibration.version,
        board: calibration.board.clone(),
        cameras: cameras(calibration),
        pairs: pairs(calibration),
        stereo: stereo(calibration),
        use_spec_translation: calibration.use_spec_translation,
        imu: imu(calibration),
        findings: findings.to_vec(),
    }
}

fn cameras(calibration: &Calibration) -> Vec<CameraSummary> {
    calibration
        .cameras
        .values()
        .map(|camera| CameraSummary {
            socket: camera.socket,
            model: camera.kind,
            width: camera.size().width,
            height: camera.size().height,
            camera_matrix: camera.intrinsics.opencv_matrix(),
            hfov_deg: camera.intrinsics.hfov().to_degrees(),
            vfov_deg: camera.intrinsics.vfov().to_degrees(),
            dfov_deg: camera.intrinsics.dfov().to_degrees(),
            spec_hfov_deg: camera.spec_hfov_deg,
            distortion: camera.distortion.clone(),
            lens_position: camera.lens_position,
            extrinsics_to: camera.extrinsics.as_ref().map(|link| link.to),
        })
        .collect()
}

fn pairs(calibration: &Calibration) -> Vec<PairSummary> {
    let sockets = || calibration.cameras.keys().copied();
    sockets()
        .flat_map(|from| sockets().map(move |to| (from, to)))
        .filter(|(from, to)| from != to)
        .map(|(from, to)| {
            let calibrated = calibration.transform(from, to, false);
            let spec = calibration.transform(from, to, true);
            let distance = |t: &Result<RigidTransform, CalibrationError>| {
                t.as_ref().ok().map(|t| t.translation.length() * 100.0)
            };
            PairSummary {
                from,
                to,
                baseline_cm: distance(&calibrated),
                spec_baseline_cm: distance(&spec),
                to_from_from_cm: rows_cm(calibrated),
                spec_to_from_from_cm: rows_cm(spec),
            }
        })
        .collect()
}

fn stereo(calibration: &Calibration) -> Option<StereoSummary> {
    let (left, right) = calibration.stereo_pair()?;
    let (r1, r2) = rectifying_rotations(&calibration.transform(left, right, false).ok()?)?;
    let rows = |r: DMat3| r.transpose().to_cols_array_2d();
    Some(StereoSummary {
        left,
        right,
        rectified_from_left: rows(r1),
        rectified_from_right: rows(r2),
    })
}

fn imu(calibration: &Calibration) -> Vec<ImuSummary> {
    calibration
        .cameras
        .keys()
        .filter_map(|camera| {
            let camera_from_imu = calibration.camera_from_imu(*camera, false);
            let (axes, axes_deviation_deg) = nearest_directions(camera_from_imu.as_ref().ok()?.rotation);
            Some(ImuSummary {
                camera: *camera,
                axes,
                axes_deviation_deg,
                camera_from_imu_cm: rows_cm(camera_from_imu)?,
                spec_camera_from_imu_cm: rows_cm(calibration.camera_from_imu(*camera, true)),
            })
        })
        .collect()
}

fn rows_cm(transform: Result<RigidTransform, CalibrationError>) -> Option<[[f64; 4]; 4]> {
    let t = transform.ok()?;
    Some(RigidTransform::new(t.rotation, t.translation * 100.0).rows())
}
