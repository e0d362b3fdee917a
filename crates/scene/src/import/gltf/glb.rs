//! The container of binary glTF.

use std::ops::Range;

use super::json::{OLD_VERSION_REMEDY, old_version};
use crate::import::error::Fault;

pub(super) const MAGIC: &[u8] = b"glTF";
const JSON: &[u8] = b"JSON";
const BINARY: &[u8] = b"BIN\0";

/// The ranges of the JSON chunk and of the binary chunk.
///
/// The file's length in the header is not checked, and chunks need not be aligned: some exporters get them wrong.
pub(super) fn chunks(bytes: &[u8]) -> Result<(Range<usize>, Option<Range<usize>>), Fault> {
    let word = |at: usize| {
        let word = bytes.get(at..at.checked_add(4)?)?.first_chunk()?;
        usize::try_from(u32::from_le_bytes(*word)).ok()
    };
    let short = || Fault::damaged("header", "the file ends too early");
    match word(4).ok_or_else(short)? {
        2 => {}
        1 => return Err(old_version("header", "1.0")),
        version => {
            let message = format!("is binary glTF {version}; only glTF 2.0 is supported");
            return Err(Fault::new("header", message, OLD_VERSION_REMEDY));
        }
    }
    let chunk = |at: usize| {
        let start = at.checked_add(8)?;
        let end = start.checked_add(word(at)?)?;
        bytes.get(start..end)?;
        Some((bytes.get(at + 4..start)?, start..end))
    };
    let (kind, json) = chunk(12).ok_or_else(short)?;
    if kind != JSON {
        return Err(Fault::damaged("header", "the first chunk is not JSON"));
    }
    let binary_at = |at: usize| chunk(at).filter(|(kind, _)| *kind == BINARY);
    let binary = binary_at(json.end.next_multiple_of(4)).or_else(|| binary_at(json.end));
    Ok((json, binary.map(|(_, range)| range)))
}
