//! The bitstreams of `KHR_meshopt_compression` and `EXT_meshopt_compression`, after the appendices of their specifications.

mod attributes;
mod filter;
mod indices;

use serde_json::Value;

use super::number;

/// Decodes the data of a buffer view; `None` if it is invalid.
pub(super) fn decode(bytes: &[u8], extension: &Value) -> Option<Vec<u8>> {
    let (count, stride) = (number(extension, "count")?, number(extension, "byteStride")?);
    match extension.get("mode")?.as_str()? {
        "ATTRIBUTES" => {
            let mut decoded = attributes::decode(bytes, count, stride)?;
            let filter = extension.get("filter").and_then(Value::as_str).unwrap_or("NONE");
            filter::apply(filter, &mut decoded, stride)?;
            Some(decoded)
        }
        "TRIANGLES" => indices::triangles(bytes, count).and_then(|indices| packed(&indices, stride)),
        "INDICES" => indices::sequence(bytes, count).and_then(|indices| packed(&indices, stride)),
        _ => None,
    }
}

fn packed(indices: &[u32], stride: usize) -> Option<Vec<u8>> {
    Some(match stride {
        #[allow(clippy::cast_possible_truncation, reason = "the format wraps around")]
        2 => indices
            .iter()
            .flat_map(|&index| (index as u16).to_le_bytes())
            .collect(),
        4 => indices.iter().flat_map(|index| index.to_le_bytes()).collect(),
        _ => return None,
    })
}
