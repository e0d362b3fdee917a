//! Binary messages: the length of a header, the header as JSON, then data.

use serde::Serialize;

/// Returns the start of a message with this header.
pub(crate) fn begin(header: &impl Serialize) -> Vec<u8> {
    // Headers have string keys and finite or null numbers only.
    let json = serde_json::to_vec(header).unwrap_or_default();
    let length = u32::try_from(json.len()).unwrap_or(u32::MAX);
    let mut out = length.to_le_bytes().to_vec();
    out.extend(json);
    out
}
