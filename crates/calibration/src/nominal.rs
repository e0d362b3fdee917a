use oaktwin_camera::RigidTransform;
use oaktwin_catalog::{Role, Twin, TwinCamera};

use crate::Socket;
use crate::against::{pair_of, socket_of};
use crate::document::{self, Document, extrinsics, no_extrinsics};
use crate::raw::{Node, Raw};

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
    let camera_data = cameras
        .iter()
        .map(|(socket, camera)| (*socket, self::camera([twin, design], root, camera)))
        .collect();
    let imu = match (root, twin.body_from_imu) {
        (Some((socket, camera)), Some(body_from_imu)) => {
            let camera_from_imu = camera.body_from_camera.inverse() * body_from_imu;
            extrinsics(socket, &camera_from_imu, camera_from_imu.translation)
        }
        _ => no_extrinsics(),
    };
    let document = Document {
        product: product.clone(),
        cameras: camera_data,
        stereo: stereo(twin),
        imu,
        use_spec_translation: true,
    };
    document.into_raw(format!("{product}.json"))
}

fn camera([twin, design]: [&Twin; 2], root: Option<(Socket, &TwinCamera)>, camera: &TwinCamera) -> Node {
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
    document::camera(&camera.intrinsics, &camera.lens, spec_hfov_deg, extrinsics)
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
        return document::no_stereo();
    };
    let pose = |role| twin.camera(role).map(|camera| camera.body_from_camera);
    let right_from_left = match (pose(Role::Left), pose(Role::Right)) {
        (Some(body_from_left), Some(body_from_right)) => body_from_right.inverse() * body_from_left,
        _ => RigidTransform::IDENTITY,
    };
    document::stereo(left, right, &right_from_left)
}
