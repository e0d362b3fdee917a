//! Reports primitives that are compressed by Draco, in builds without its decoder.

use oaktwin_base::diagnostic::{message, opt};
use serde_json::Value;

use super::draco_primitives;
use crate::import::error::Fault;

pub(super) fn decode(root: &mut Value, _: &mut Vec<Vec<u8>>) -> Result<(), Fault> {
    let Some(compressed) = draco_primitives(root).into_iter().next() else {
        return Ok(());
    };
    Err(Fault::new(
        compressed.place(),
        "this build cannot read data compressed by Draco",
        message![
            "export the file without compression, or build oaktwin with ",
            opt("features").with("compressed-gltf")
        ],
    ))
}
