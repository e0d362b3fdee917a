//! Decodes the buffers that are compressed by meshopt or Draco, so that the rest of the importer reads plain buffers.

#[cfg(feature = "compressed-gltf")]
mod draco;
#[cfg(not(feature = "compressed-gltf"))]
#[path = "no_draco.rs"]
mod draco;
mod meshopt;

use serde_json::{Value, json};

use crate::import::error::Fault;

/// The names of meshopt's extension: the ratified one, and the vendor's with the same bitstream in its first version.
const MESHOPT: [&str; 2] = ["KHR_meshopt_compression", "EXT_meshopt_compression"];
const DRACO: &str = "KHR_draco_mesh_compression";

/// The extensions that this module implements.
pub(super) const EXTENSIONS: [&str; 3] = [MESHOPT[0], MESHOPT[1], DRACO];

/// Whether a buffer has only data for readers without meshopt.
pub(super) fn is_fallback(buffer: &Value) -> bool {
    meshopt_extension(buffer).is_some_and(|extension| extension.get("fallback") == Some(&json!(true)))
}

/// Whether any buffer view is compressed by meshopt.
pub(super) fn has_compressed_views(root: &Value) -> bool {
    list(root, "bufferViews")
        .iter()
        .any(|view| meshopt_extension(view).is_some())
}

/// Decodes everything into new buffers and changes the JSON to refer to them.
pub(super) fn decode(root: &mut Value, buffers: &mut Vec<Vec<u8>>) -> Result<(), Fault> {
    for view in 0..list(root, "bufferViews").len() {
        let place = || format!("bufferViews[{view}]");
        let Some(extension) = meshopt_extension(&root["bufferViews"][view]).cloned() else {
            continue;
        };
        let decoded = bytes_of(&extension, buffers)
            .and_then(|bytes| meshopt::decode(bytes, &extension))
            .ok_or_else(|| Fault::damaged(place(), "its meshopt-compressed data is invalid"))?;
        let Some(members) = root["bufferViews"][view].as_object_mut() else {
            continue;
        };
        members.insert("buffer".into(), json!(buffers.len()));
        members.insert("byteOffset".into(), json!(0));
        members.insert("byteLength".into(), json!(decoded.len()));
        buffers.push(decoded);
    }
    draco::decode(root, buffers)
}

/// A primitive that is compressed by Draco, and the object of its extension.
struct DracoPrimitive {
    mesh: usize,
    primitive: usize,
    #[cfg_attr(
        not(feature = "compressed-gltf"),
        expect(dead_code, reason = "read by the decoder")
    )]
    extension: Value,
}

impl DracoPrimitive {
    fn place(&self) -> String {
        format!("meshes[{}].primitives[{}]", self.mesh, self.primitive)
    }
}

/// Returns the primitives that only readers of Draco can use.
fn draco_primitives(root: &Value) -> Vec<DracoPrimitive> {
    let mut found = Vec::new();
    for (mesh, value) in list(root, "meshes").iter().enumerate() {
        for (primitive, value) in list(value, "primitives").iter().enumerate() {
            let extension = value.get("extensions").and_then(|all| all.get(DRACO));
            if let Some(extension) = extension.filter(|_| !has_uncompressed(root, value)) {
                found.push(DracoPrimitive {
                    mesh,
                    primitive,
                    extension: extension.clone(),
                });
            }
        }
    }
    found
}

/// Whether the file also contains the positions uncompressed, for readers without Draco.
fn has_uncompressed(root: &Value, primitive: &Value) -> bool {
    primitive
        .get("attributes")
        .and_then(|attributes| number(attributes, "POSITION"))
        .and_then(|index| root.get("accessors")?.get(index))
        .is_some_and(|accessor| accessor.get("bufferView").is_some() || accessor.get("sparse").is_some())
}

fn meshopt_extension(value: &Value) -> Option<&Value> {
    MESHOPT.iter().find_map(|name| value.get("extensions")?.get(name))
}

/// The bytes that a buffer view or a similar object refers to.
fn bytes_of<'a>(view: &Value, buffers: &'a [Vec<u8>]) -> Option<&'a [u8]> {
    let start = number(view, "byteOffset").unwrap_or(0);
    let end = start.checked_add(number(view, "byteLength")?)?;
    buffers.get(number(view, "buffer").unwrap_or(0))?.get(start..end)
}

fn number(value: &Value, name: &str) -> Option<usize> {
    usize::try_from(value.get(name)?.as_u64()?).ok()
}

fn list<'a>(root: &'a Value, name: &str) -> &'a [Value] {
    root.get(name)
        .and_then(Value::as_array)
        .map_or(&[], Vec::as_slice)
}
