//! Textures compressed by Basis Universal, in KTX2 or in their own container.

use basisu::{DecodeFlags, TargetFormat, Transcoder};
use oaktwin_base::panics;

use crate::{CodecError, Image, limits};

const KTX2: &[u8] = b"\xabKTX 20\xbb\r\n\x1a\n";

/// Decodes the full-size image of a texture.
pub(super) fn decode(bytes: &[u8]) -> Result<Image<[u8; 4]>, CodecError> {
    // A corrupt file may make the decoder panic.
    panics::contain(|| decode_checked(bytes))
        .unwrap_or_else(|_| Err(damaged("its contents contradict each other")))
}

fn decode_checked(bytes: &[u8]) -> Result<Image<[u8; 4]>, CodecError> {
    let unsupported = |problem: &str| {
        CodecError::new(
            "KTX2",
            "header",
            problem.to_string(),
            "convert the texture to PNG or JPEG",
        )
    };
    check_levels(bytes)?;
    let texture =
        Transcoder::new(bytes).map_err(|_| unsupported("is damaged or not compressed by Basis Universal"))?;
    if !texture.supports(TargetFormat::Rgba32) {
        return Err(unsupported("has a high dynamic range, which is not supported"));
    }
    let (width, height) = texture.base_dimensions();
    limits::check("KTX2", (width.into(), height.into()), 4, bytes.len())?;
    let pixels = texture
        .transcode(0, TargetFormat::Rgba32, DecodeFlags::NONE)
        .map_err(|error| damaged(&format!("{error:?}")))?;
    let pixels = pixels.as_chunks().0.to_vec();
    Image::new(width, height, pixels).ok_or_else(|| damaged("incomplete"))
}

/// Rejects levels whose claimed length is too large, because the decoder allocates it. The levels of KTX2 (section 3.1 of its
/// specification): after a header of 80 bytes, three numbers of 64 bits for each level, the last of which is its length
/// after decompression.
fn check_levels(bytes: &[u8]) -> Result<(), CodecError> {
    const COUNT: usize = 40;
    const INDEX: usize = 80;
    const ENTRY: usize = 24;
    let (Some(index), Some(count)) = (
        bytes.get(INDEX..),
        bytes.get(COUNT..).and_then(<[u8]>::first_chunk),
    ) else {
        return Ok(());
    };
    if !bytes.starts_with(KTX2) {
        return Ok(());
    }
    let count = u32::from_le_bytes(*count).max(1) as usize;
    let allowed = limits::allowed_bytes(bytes.len());
    for (level, entry) in index.chunks_exact(ENTRY).take(count).enumerate() {
        let length = entry.last_chunk().map_or(0, |length| u64::from_le_bytes(*length));
        if length > allowed {
            let problem = format!(
                "level {level} of {length} bytes cannot be in {} bytes",
                bytes.len()
            );
            return Err(damaged(&problem));
        }
    }
    Ok(())
}

fn damaged(problem: &str) -> CodecError {
    let remedy = "the file is truncated or damaged; save it again";
    CodecError::new("KTX2", "pixels", problem.to_string(), remedy)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rejects_huge_levels_before_allocating() {
        let mut file = KTX2.to_vec();
        file.resize(80 + 2 * 24, 0);
        file[40] = 2;
        assert_eq!(check_levels(&file), Ok(()));
        // The last byte of the second level's length.
        file[127] = 1;
        let error = decode(&file).unwrap_err().to_string();
        assert!(
            error.contains("level 1 of 72057594037927936 bytes cannot be in 128 bytes"),
            "{error}"
        );
        for end in 0..file.len() {
            assert!(decode(&file[..end]).is_err());
        }
    }
}
