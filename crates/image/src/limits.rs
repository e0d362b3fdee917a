//! Limits on the memory for decoding an image file.

use oaktwin_files::memory;

use crate::CodecError;

/// The maximum number of pixels, exclusive.
const MAX_PIXELS: u64 = 1 << 31;

/// The number of decoded bytes that is allowed for any file: an RGBA image of 4096 × 4096 pixels with 8 bits.
const ALWAYS_ALLOWED: u64 = 1 << 26;

/// The maximum ratio of decoded bytes to the bytes of a larger file. DEFLATE reaches 1032, other compressions of images more
/// only for a constant colour.
const MAX_RATIO: u64 = 1100;

/// Returns the maximum number of decoded bytes of a file of `length` bytes.
pub(crate) fn allowed_bytes(length: usize) -> u64 {
    ALWAYS_ALLOWED.max((length as u64).saturating_mul(MAX_RATIO))
}

/// Returns the number of bytes for decoding a texture: the decoder's pixels, and the conversion to four channels.
pub(crate) fn needed((width, height): (u64, u64), bytes_per_pixel: u64) -> u64 {
    let per_pixel = (2 * bytes_per_pixel).max(bytes_per_pixel + 8);
    width.saturating_mul(height).saturating_mul(per_pixel)
}

/// Rejects images that are too large, before memory is allocated.
pub(crate) fn check(
    format: &'static str,
    (width, height): (u64, u64),
    bytes_per_pixel: u64,
    length: usize,
) -> Result<(), CodecError> {
    check_claim(format, (width, height), bytes_per_pixel, length)?;
    // Twice: the decoder's pixels and ours.
    memory::check(width * height * 2 * bytes_per_pixel)
        .map_err(|shortage| CodecError::shortage(format, (width, height), shortage))
}

/// Rejects sizes that no file of `length` bytes has.
pub(crate) fn check_claim(
    format: &'static str,
    (width, height): (u64, u64),
    bytes_per_pixel: u64,
    length: usize,
) -> Result<(), CodecError> {
    let pixels = width.saturating_mul(height);
    let reject = |problem: String, remedy| Err(CodecError::new(format, "header", problem, remedy));
    if pixels == 0 {
        return reject(format!("{width} × {height} pixels"), "pass an image with pixels");
    }
    if pixels >= MAX_PIXELS {
        return reject(
            format!("{width} × {height} pixels, 2^31 or more"),
            "use a smaller image",
        );
    }
    if pixels.saturating_mul(bytes_per_pixel) > allowed_bytes(length) {
        return reject(
            format!("{width} × {height} pixels cannot be in {length} bytes"),
            "the file is damaged; save it again",
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::check;

    #[test]
    fn rejects_empty_and_large_images() {
        let says = |size, length| check("X", size, 4, length).map_err(|error| error.to_string());
        assert_eq!(says((4096, 4096), 10), Ok(()));
        assert_eq!(says((16384, 16384), 1 << 20), Ok(()));
        assert_eq!(
            says((16384, 16384), 1000).unwrap_err(),
            "X: header: 16384 × 16384 pixels cannot be in 1000 bytes; the file is damaged; save it again"
        );
        assert!(
            says((65536, 32768), usize::MAX)
                .unwrap_err()
                .contains("2^31 or more")
        );
        assert!(says((u64::MAX, u64::MAX), 1).is_err());
        assert!(says((0, 5), 1).unwrap_err().contains("0 × 5 pixels"));
    }
}
