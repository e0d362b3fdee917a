//! How much memory an image file can ask for.

use crate::CodecError;

/// Pixels of the largest image that is read.
const MOST_PIXELS: u64 = 1 << 31;

/// Decoded bytes that any file may take: an 8-bit image of 4096 × 4096 pixels.
const ALWAYS_ALLOWED: u64 = 1 << 26;

/// Decoded bytes for each byte of a larger file. DEFLATE reaches 1032, and no other compression of images more but for
/// pictures of one colour.
const LARGEST_RATIO: u64 = 1100;

/// The decoded bytes that a file of `length` bytes may take.
pub(crate) fn allowed_bytes(length: usize) -> u64 {
    ALWAYS_ALLOWED.max((length as u64).saturating_mul(LARGEST_RATIO))
}

/// Refuses an image before memory is taken for it.
pub(crate) fn check(
    format: &'static str,
    (width, height): (u64, u64),
    bytes_per_pixel: u64,
    length: usize,
) -> Result<(), CodecError> {
    let pixels = width.saturating_mul(height);
    let refuse = |problem: String, remedy| Err(CodecError::new(format, "header", problem, remedy));
    if pixels == 0 {
        return refuse(
            format!("{width} × {height} pixels"),
            "give an image with pixels in it",
        );
    }
    if pixels >= MOST_PIXELS {
        return refuse(
            format!("{width} × {height} pixels, 2^31 or more"),
            "give a smaller image",
        );
    }
    if pixels.saturating_mul(bytes_per_pixel) > allowed_bytes(length) {
        return refuse(
            format!("{width} × {height} pixels cannot be in {length} bytes"),
            "the file is damaged: save it again",
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::check;

    #[test]
    fn what_is_refused() {
        let says = |size, length| check("X", size, 4, length).map_err(|error| error.to_string());
        assert_eq!(says((4096, 4096), 10), Ok(()));
        assert_eq!(says((16384, 16384), 1 << 20), Ok(()));
        assert_eq!(
            says((16384, 16384), 1000).unwrap_err(),
            "X: header: 16384 × 16384 pixels cannot be in 1000 bytes; the file is damaged: save it again"
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
