//! Textures compressed by Basis Universal, in KTX2 or in their own container.

use std::panic::{AssertUnwindSafe, catch_unwind};

use basisu::{DecodeFlags, TargetFormat, Transcoder};

use crate::{CodecError, Image, limits};

const KTX2: &[u8] = b"\xabKTX 20\xbb\r\n\x1a\n";
const BASIS: &[u8] = b"sB";

pub(crate) fn is_basis(bytes: &[u8]) -> bool {
    bytes.starts_with(KTX2) || bytes.starts_with(BASIS)
}

/// Decodes the full-size image of a texture.
pub(crate) fn decode(bytes: &[u8]) -> Result<Image<[u8; 4]>, CodecError> {
    // A corrupt file may make the decoder panic.
    catch_unwind(AssertUnwindSafe(|| decode_checked(bytes)))
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

fn damaged(problem: &str) -> CodecError {
    let remedy = "the file is truncated or damaged; save it again";
    CodecError::new("KTX2", "pixels", problem.to_string(), remedy)
}
