//! The chunks of a PNG file.

use std::borrow::Cow;

const SIGNATURE_BYTES: usize = 8;
/// The length, the type and the checksum.
const FRAME_BYTES: usize = 12;

/// Returns a file without colour profiles and texts, which are not used: a compressed one may unpack to a thousand times its
/// size.
pub(crate) fn without_unused(file: &[u8]) -> Cow<'_, [u8]> {
    let mut kept: Option<Vec<u8>> = None;
    let mut at = SIGNATURE_BYTES;
    while let Some(chunk) = chunk(file, at) {
        let is_unused = matches!(&chunk[4..8], b"iCCP" | b"zTXt" | b"iTXt" | b"tEXt");
        if is_unused {
            kept.get_or_insert_with(|| file[..at].to_vec());
        } else if let Some(kept) = &mut kept {
            kept.extend_from_slice(chunk);
        }
        at += chunk.len();
    }
    match kept {
        None => Cow::Borrowed(file),
        Some(mut kept) => {
            kept.extend_from_slice(&file[at.min(file.len())..]);
            Cow::Owned(kept)
        }
    }
}

/// Returns the chunk that begins at `at`; `None` at the end, and for an incomplete one.
fn chunk(file: &[u8], at: usize) -> Option<&[u8]> {
    let length = u32::from_be_bytes(*file.get(at..)?.first_chunk()?);
    let length = usize::try_from(length).ok()?.checked_add(FRAME_BYTES)?;
    file.get(at..at.checked_add(length)?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Image, png};

    #[test]
    fn leaves_out_profiles_and_texts() {
        let plain = png::encode(&Image::filled(3, 2, [1u8, 2, 3])).unwrap();
        assert!(matches!(without_unused(&plain), Cow::Borrowed(_)));
        let header = SIGNATURE_BYTES + FRAME_BYTES + 13;
        let mut long = plain[..header].to_vec();
        for kind in [b"iCCP", b"tEXt"] {
            long.extend(5_u32.to_be_bytes());
            long.extend(kind);
            long.extend([9; 5 + 4]);
        }
        long.extend(&plain[header..]);
        assert_eq!(&*without_unused(&long), plain);
        for end in 0..long.len() {
            assert!(without_unused(&long[..end]).len() <= end);
        }
    }
}
