//! Cameras without intrinsics, as in the calibrations of units whose colour camera was not calibrated. They count as missing, but
//! other cameras may refer to them.

use std::collections::BTreeSet;

use crate::Socket;
use crate::raw::Value;
use crate::reader::{Field, Reader};

/// Returns the sockets of the cameras in a list that have no intrinsics: the matrix is empty, or the focal lengths are 0.
pub(super) fn uncalibrated(list: &[Field<'_>]) -> BTreeSet<Socket> {
    list.iter().filter_map(socket_without_intrinsics).collect()
}

fn socket_without_intrinsics(item: &Field<'_>) -> Option<Socket> {
    let Value::Array(pair) = &item.node.value else {
        return None;
    };
    let [socket, info] = pair.as_slice() else {
        return None;
    };
    let Value::Number(number) = &socket.value else {
        return None;
    };
    let matrix = Field {
        node: info.get("intrinsicMatrix")?,
        path: String::new(),
    };
    // Errors in the matrix are reported when the camera is read.
    let has_none = match Reader::default().matrix(&matrix)? {
        None => true,
        Some(rows) => rows[0][0] == 0.0 && rows[1][1] == 0.0,
    };
    let number = number.parse().ok().filter(|_| has_none)?;
    Socket::from_file(number).ok()?
}
