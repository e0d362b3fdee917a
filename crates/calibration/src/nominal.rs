use oaktwin_camera::math::DVec3;
use oaktwin_camera::{OpenCvLens, RigidTransform};
use oaktwin_catalog::{Role, Twin, TwinCamera};

use crate::Socket;
use crate::against::{pair_of, socket_of};
use crate::raw::{Node, Raw, Value};
use crate::rectify::rectifying_rotations;

const CM_PER_M: f64 = 100.0;

/// Converts a nominal twin to a `DepthAI` JSON of version 7: the calibration of the ideal device. See [`calibration_of`].
#[must_use]
pub fn nominal_calibration(twin: &Twin) -> Raw {
    calibration_of(twin, twin)
}

/// Converts a twin to a `DepthAI` JSON of version 7, with the translations of another twin of the same device as the design's.
///
/// Principal points are in OpenCV's convention, with the centre of an image at (W − 1)/2. As in factory files, the extrinsics
/// of left refer to right, and right's to the camera on socket 0.
#[must_use]
pub fn calibration_of(twin: &Twin, design: &Twin) -> Raw {
    let device = &twin.device;
    let product = device.aliases.first().unwrap_or(&device.name);
    let mut cameras: Vec<_> = twin
        .cameras
        .iter()
        .filter_map(|camera| Some((socket_of(camera)?, camera)))
        .collect();
    cameras.sort_by_key(|(socket, _)| *socket);
    let root = cameras.first().copied();
    let camera_data: Vec<Node> = cameras
        .iter()
        .map(|(socket, camera)| {
            vec![
                Node::from(i64::from(socket.number())),
                self::camera([twin, design], root, camera),
            ]
            .into()
        })
        .collect();
    let imu = match (root, twin.body_from_imu) {
        (Some((socket, camera)), Some(body_from_imu)) => {
            let camera_from_imu = camera.body_from_camera.inverse() * body_from_imu;
            extrinsics(socket, &camera_from_imu, camera_from_imu.translation)
        }
        _ => no_extrinsics(),
    };
    let text = |text: &str| Node::from(text);
    let root = Node::from([
        ("batchName", text("")),
        ("batchTime", 0.into()),
        ("boardConf", text("")),
        ("boardCustom", text("")),
        ("boardName", text("")),
        ("boardOptions", 0.into()),
        ("boardRev", text("")),
        ("cameraData", camera_data.into()),
        ("deviceName", text("")),
        ("hardwareConf", text("")),
        ("housingExtrinsics", no_extrinsics()),
        ("imuExtrinsics", imu),
        ("miscellaneousData", Value::Array(Vec::new()).into()),
        ("productName", text(product)),
        ("stereoEnableDistortionCorrection", false.into()),
        ("stereoRectificationData", stereo(twin)),
        ("stereoUseSpecTranslation", true.into()),
        ("version", 7.into()),
        ("verticalCameraSocket", (-1).into()),
    ]);
    Raw {
        name: format!("{product}.json"),
        root,
    }
}

fn camera([twin, design]: [&Twin; 2], root: Option<(Socket, &TwinCamera)>, camera: &TwinCamera) -> Node {
    let (kind, coefficients) = match camera.lens.as_opencv() {
        Some(OpenCvLens::Pinhole(coefficients)) => (0, coefficients.to_vec()),
        Some(OpenCvLens::Fisheye(k)) => (1, k.to_vec()),
        // Neither DepthAI nor any calibration or catalog has another lens.
        None => (0, vec![0.0; 14]),
    };
    let size = camera.intrinsics.size;
    // Including distortion, if known.
    let spec_hfov_deg = camera.spec.fisheye_hfov_deg.unwrap_or(camera.spec.hfov_deg);
    let extrinsics = match next(twin, root, camera) {
        Some((socket, next)) => {
            let next_from_camera = next.body_from_camera.inverse() * camera.body_from_camera;
            let pose = |camera: &TwinCamera| Some(design.camera(camera.spec.role)?.body_from_camera);
            let designed = match (pose(next), pose(camera)) {
                (Some(next), Some(camera)) => (next.inverse() * camera).translation,
                _ => next_from_camera.translation,
            };
            extrinsics(socket, &next_from_camera, designed)
        }
        None => no_extrinsics(),
    };
    Node::from([
        ("cameraType", Node::from(kind)),
        ("distortionCoeff", coefficients.into()),
        ("extrinsics", extrinsics),
        ("height", i64::from(size.height).into()),
        ("intrinsicMatrix", matrix(camera.intrinsics.opencv_matrix())),
        ("lensPosition", 0.into()),
        ("specHfovDeg", spec_hfov_deg.into()),
        ("width", i64::from(size.width).into()),
    ])
}

/// Returns the camera that a camera's extrinsics refer to.
fn next<'a>(
    twin: &'a Twin,
    root: Option<(Socket, &'a TwinCamera)>,
    camera: &TwinCamera,
) -> Option<(Socket, &'a TwinCamera)> {
    let (root_socket, root) = root?;
    if socket_of(camera)? == root_socket {
        return None;
    }
    let right = twin.camera(Role::Right);
    match right.and_then(|right| Some((socket_of(right)?, right))) {
        Some((socket, right)) if camera.spec.role == Role::Left && socket != root_socket => {
            Some((socket, right))
        }
        _ => Some((root_socket, root)),
    }
}

fn stereo(twin: &Twin) -> Node {
    let Some((left, right)) = pair_of(twin) else {
        return Value::Object(Vec::new()).into();
    };
    let pose = |role| twin.camera(role).map(|camera| camera.body_from_camera);
    let right_from_left = match (pose(Role::Left), pose(Role::Right)) {
        (Some(body_from_left), Some(body_from_right)) => body_from_right.inverse() * body_from_left,
        _ => RigidTransform::IDENTITY,
    };
    let (r1, r2) = rectifying_rotations(&right_from_left).unwrap_or_default();
    Node::from([
        ("leftCameraSocket", i64::from(left.number()).into()),
        ("rectifiedRotationLeft", matrix(r1.transpose().to_cols_array_2d())),
        (
            "rectifiedRotationRight",
            matrix(r2.transpose().to_cols_array_2d()),
        ),
        ("rightCameraSocket", i64::from(right.number()).into()),
    ])
}

fn extrinsics(to: Socket, transform: &RigidTransform, designed: DVec3) -> Node {
    // Rounding to 1e-10 cm, a picometre, hides rounding errors of the conversion from metres.
    let cm = |m: f64| tidy((m * CM_PER_M * 1e10).round() / 1e10);
    let translation = |t: DVec3| {
        Node::from([
            ("x", cm(t.x).into()),
            ("y", cm(t.y).into()),
            ("z", cm(t.z).into()),
        ])
    };
    Node::from([
        (
            "rotationMatrix",
            matrix(transform.rotation.transpose().to_cols_array_2d()),
        ),
        ("specTranslation", translation(designed)),
        ("toCameraSocket", i64::from(to.number()).into()),
        ("translation", translation(transform.translation)),
    ])
}

/// Returns empty extrinsics: zeros, and no socket.
fn no_extrinsics() -> Node {
    let zero = || Node::from([("x", 0.0.into()), ("y", 0.0.into()), ("z", 0.0.into())]);
    Node::from([
        ("rotationMatrix", matrix([[0.0; 3]; 3])),
        ("specTranslation", zero()),
        ("toCameraSocket", (-1).into()),
        ("translation", zero()),
    ])
}

fn matrix(rows: [[f64; 3]; 3]) -> Node {
    rows.map(|row| Node::from(row.map(tidy).to_vec())).to_vec().into()
}

/// Replaces −0 by 0.
fn tidy(x: f64) -> f64 {
    x + 0.0
}
