use std::collections::BTreeMap;

use super::link::{rotation, socket};
use crate::Socket;
use crate::model::{CameraCalibration, StereoRectification};
use crate::raw::Value;
use crate::reader::{Field, Reader};

const STEREO_KEYS: [&str; 4] = [
    "leftCameraSocket",
    "rightCameraSocket",
    "rectifiedRotationLeft",
    "rectifiedRotationRight",
];

pub(super) fn stereo(
    reader: &mut Reader,
    field: &Field<'_>,
    cameras: &BTreeMap<Socket, CameraCalibration>,
) -> Option<StereoRectification> {
    if let Value::Object(entries) = &field.node.value
        && entries.is_empty()
    {
        return None;
    }
    reader.object(field, &STEREO_KEYS)?;
    let mut side = |socket_key: &str, rotation_key: &str| {
        let socket_field = reader.require(field, socket_key)?;
        let place = socket_field.path.clone();
        let socket = socket(reader, &socket_field)?;
        let rotation_field = reader.require(field, rotation_key)?;
        let rotation = rotation(reader, &rotation_field)?;
        if let Some(socket) = socket
            && !cameras.contains_key(&socket)
        {
            let message = format!("{socket} is not in cameraData; the rectification is ignored");
            reader.warn("dangling-socket", place, message, "calibrate the stereo pair");
            return Some((None, rotation));
        }
        Some((socket, rotation))
    };
    let left = side("leftCameraSocket", "rectifiedRotationLeft");
    let right = side("rightCameraSocket", "rectifiedRotationRight");
    let ((left, rectified_from_left), (right, rectified_from_right)) = (left?, right?);
    let (left, right) = (left?, right?);
    if left == right {
        let message = format!("left and right are both {left}");
        reader.error("stereo-pair", &field.path, message, "set two different sockets");
        return None;
    }
    Some(StereoRectification {
        left,
        right,
        rectified_from_left,
        rectified_from_right,
    })
}
