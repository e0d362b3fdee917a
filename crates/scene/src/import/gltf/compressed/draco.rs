//! Decodes primitives that are compressed by Draco.

use draco_core::{DecodeLimits, DecoderBuffer, Mesh, MeshDecoder};
use oaktwin_base::panics;
use serde_json::{Value, json};

use super::{DracoPrimitive, bytes_of, draco_primitives, list, number};
use crate::import::error::Fault;

/// Honest streams of constant values are tiny, so the limit depends little on the size of the file.
const ALWAYS_ALLOWED: usize = 1 << 28;
const MAX_RATIO: usize = 1024;

pub(super) fn decode(root: &mut Value, buffers: &mut Vec<Vec<u8>>) -> Result<(), Fault> {
    let size: usize = buffers.iter().map(Vec::len).sum();
    let mut allowed = size.saturating_mul(MAX_RATIO).max(ALWAYS_ALLOWED);
    for compressed in draco_primitives(root) {
        let fault = |message: &str| {
            Fault::damaged(
                compressed.place(),
                format!("its Draco-compressed data is invalid: {message}"),
            )
        };
        let DracoPrimitive {
            mesh,
            primitive,
            extension,
        } = &compressed;
        let view = number(extension, "bufferView").and_then(|view| root.get("bufferViews")?.get(view));
        let bytes = view
            .and_then(|view| bytes_of(view, buffers))
            .ok_or_else(|| fault("it exceeds its buffer"))?;
        let decoded = decoded(bytes, allowed).map_err(|message| fault(&message))?;
        let first = buffers.len();
        replace(root, buffers, [*mesh, *primitive], extension, &decoded);
        allowed = allowed.saturating_sub(buffers[first..].iter().map(Vec::len).sum());
    }
    Ok(())
}

fn decoded(bytes: &[u8], allowed: usize) -> Result<Mesh, String> {
    let limits = DecodeLimits::default().with_max_decoded_bytes(allowed as u64);
    let decode = || {
        let mut mesh = Mesh::new();
        let mut buffer = DecoderBuffer::new(bytes).with_limits(limits);
        MeshDecoder::new().decode(&mut buffer, &mut mesh).map(|()| mesh)
    };
    match panics::contain(decode) {
        Ok(Ok(mesh)) => Ok(mesh),
        Ok(Err(error)) => Err(error.to_string()),
        Err(_) => Err("it contradicts itself".into()),
    }
}

/// Makes the accessors of a primitive refer to the decoded mesh.
fn replace(
    root: &mut Value,
    buffers: &mut Vec<Vec<u8>>,
    [mesh, primitive]: [usize; 2],
    extension: &Value,
    decoded: &Mesh,
) {
    let attributes = root["meshes"][mesh]["primitives"][primitive]
        .get("attributes")
        .cloned();
    let ids = extension.get("attributes").and_then(Value::as_object);
    for (semantic, id) in ids.into_iter().flatten() {
        let id = id.as_u64().and_then(|id| u32::try_from(id).ok());
        let attribute = id.and_then(|id| decoded.attribute_by_unique_id(id));
        let index = attributes.as_ref().and_then(|all| number(all, semantic));
        let accessor = index.and_then(|index| list(root, "accessors").get(index));
        if let (Some(attribute), Some(index), Some(accessor)) = (attribute, index, accessor) {
            let kind = accessor.get("componentType").and_then(Value::as_u64);
            let values = attribute.read_f32s(decoded.num_points(), attribute.num_components().into());
            let view = push_bytes(root, buffers, encoded(kind, &values));
            root["accessors"][index]["bufferView"] = json!(view);
            root["accessors"][index]["byteOffset"] = json!(0);
            root["accessors"][index]["count"] = json!(decoded.num_points());
        }
    }
    let points = decoded.faces().iter().flatten();
    let view = push_bytes(
        root,
        buffers,
        points.flat_map(|point| point.0.to_le_bytes()).collect(),
    );
    let indices = json!({
        "bufferView": view, "componentType": 5125, "count": 3 * decoded.num_faces(), "type": "SCALAR",
    });
    // The declared accessor may be shared with a primitive that is not compressed.
    let accessor = push(root, "accessors", indices);
    let entry = &mut root["meshes"][mesh]["primitives"][primitive];
    entry["indices"] = json!(accessor);
    // Strips are decoded to triangles.
    entry["mode"] = json!(4);
}

/// Encodes values in the component type of an accessor.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "integers of that type"
)]
fn encoded(kind: Option<u64>, values: &[f32]) -> Vec<u8> {
    match kind {
        Some(5120) => values.iter().flat_map(|&x| (x as i8).to_le_bytes()).collect(),
        Some(5121) => values.iter().flat_map(|&x| (x as u8).to_le_bytes()).collect(),
        Some(5122) => values.iter().flat_map(|&x| (x as i16).to_le_bytes()).collect(),
        Some(5123) => values.iter().flat_map(|&x| (x as u16).to_le_bytes()).collect(),
        Some(5125) => values.iter().flat_map(|&x| (x as u32).to_le_bytes()).collect(),
        _ => values.iter().flat_map(|x| x.to_le_bytes()).collect(),
    }
}

/// Adds a buffer with one view and returns the number of the view.
fn push_bytes(root: &mut Value, buffers: &mut Vec<Vec<u8>>, bytes: Vec<u8>) -> usize {
    let view = json!({ "buffer": buffers.len(), "byteOffset": 0, "byteLength": bytes.len() });
    buffers.push(bytes);
    push(root, "bufferViews", view)
}

/// Appends to a list of the root and returns the number of the new entry.
fn push(root: &mut Value, name: &str, entry: Value) -> usize {
    let list = &mut root[name];
    if !list.is_array() {
        *list = json!([]);
    }
    let Some(list) = list.as_array_mut() else {
        return 0;
    };
    list.push(entry);
    list.len() - 1
}
