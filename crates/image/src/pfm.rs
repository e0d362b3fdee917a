//! PFM: `float32` images of one channel, the format of Middlebury's and `SceneFlow`'s disparities.
//!
//! In the file, rows run from bottom to top. A negative scale means little endian, which is written.
//! Source: Paul Debevec's description of the format.

use crate::bytes::Scalar;
use crate::{CodecError, Image};

const FORMAT: &str = "PFM";

/// Encodes an image losslessly.
#[must_use]
pub fn encode(image: &Image<f32>) -> Vec<u8> {
    let mut out = format!("Pf\n{} {}\n-1.0\n", image.width(), image.height()).into_bytes();
    out.reserve_exact(size_of_val(image.pixels()));
    for row in image.rows().rev() {
        f32::put_le(row, &mut out);
    }
    out
}

/// Decodes an image of either byte order. The magnitude of the scale is ignored, as in all readers of disparities.
///
/// # Errors
/// Returns an error if the bytes are not a PFM of one channel, or their length differs from that in the header.
pub fn decode(bytes: &[u8]) -> Result<Image<f32>, CodecError> {
    let broken = |place: &'static str, problem: String| {
        CodecError::new(
            FORMAT,
            place,
            problem,
            "the file is truncated or damaged; copy it again",
        )
    };
    let mut rest = bytes;
    match word(&mut rest) {
        Some("Pf") => {}
        Some("PF") => {
            return Err(CodecError::new(
                FORMAT,
                "byte 0",
                "an image of three channels",
                "save one channel",
            ));
        }
        _ => {
            return Err(CodecError::new(
                FORMAT,
                "byte 0",
                "not a PFM file",
                "pass a .pfm file",
            ));
        }
    }
    let mut size = |name: &str| -> Result<u32, CodecError> {
        word(&mut rest)
            .and_then(|text| text.parse().ok())
            .ok_or_else(|| broken("header", format!("the {name} is not a whole number")))
    };
    let (width, height) = (size("width")?, size("height")?);
    let scale: f32 = word(&mut rest)
        .and_then(|text| text.parse().ok())
        .filter(|scale: &f32| *scale != 0.0 && !scale.is_nan())
        .ok_or_else(|| broken("header", "the scale is not a number".into()))?;
    let expected = (width as usize)
        .checked_mul(height as usize)
        .and_then(|pixels| pixels.checked_mul(4));
    if expected != Some(rest.len()) {
        return Err(broken(
            "pixels",
            format!("{} bytes are not {width} × {height} pixels", rest.len()),
        ));
    }
    let values = if scale < 0.0 {
        f32::get_le(rest)
    } else {
        f32::get_be(rest)
    };
    let pixels: Vec<f32> = values
        .chunks_exact((width as usize).max(1))
        .rev()
        .flatten()
        .copied()
        .collect();
    Image::new(width, height, pixels).ok_or_else(|| broken("pixels", "incomplete".into()))
}

/// Reads the next word of the header and one white space after it.
fn word<'a>(rest: &mut &'a [u8]) -> Option<&'a str> {
    /// More characters than any number in a header.
    const MAX_LENGTH: usize = 64;
    let end = rest.iter().take(MAX_LENGTH).position(u8::is_ascii_whitespace)?;
    let (word, after) = rest.split_at(end);
    *rest = &after[1..];
    std::str::from_utf8(word).ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn writes_the_last_row_first() {
        let image = Image::new(1, 2, vec![1f32, 2.0]).unwrap();
        let file = encode(&image);
        assert_eq!(file, b"Pf\n1 2\n-1.0\n\x00\x00\x00\x40\x00\x00\x80\x3F");
        assert_eq!(decode(&file).unwrap(), image);
        let big = b"Pf 1 2 1.0 \x40\x00\x00\x00\x3F\x80\x00\x00";
        assert_eq!(decode(big).unwrap(), image);
    }

    #[test]
    fn errors_state_a_remedy() {
        let says = |bytes: &[u8]| decode(bytes).unwrap_err().to_string();
        assert_eq!(says(b"P5\n"), "PFM: byte 0: not a PFM file; pass a .pfm file");
        assert_eq!(
            says(b"PF\n"),
            "PFM: byte 0: an image of three channels; save one channel"
        );
        assert!(says(b"Pf\n1 -2\n").contains("the height is not a whole number"));
        assert!(says(b"Pf\n1 2\nx\n").contains("the scale is not a number"));
        assert!(says(b"Pf\n4294967295 4294967295\n-1\n").contains("0 bytes are not"));
    }

    proptest! {
        #[test]
        fn round_trip_is_lossless(width in 0u32..9, height in 0u32..9, seed: u32) {
            let bits: Vec<u32> = (0..width * height).map(|i| (i + 1).wrapping_mul(seed | 1)).collect();
            let image = Image::new(width, height, bits.iter().map(|&b| f32::from_bits(b)).collect()).unwrap();
            let back = decode(&encode(&image)).unwrap();
            prop_assert_eq!((back.width(), back.height()), (width, height));
            prop_assert_eq!(back.pixels().iter().map(|v| v.to_bits()).collect::<Vec<_>>(), bits);
        }

        #[test]
        fn never_panics_on_damaged_files(at in 0usize..28, value: u8, cut in 0usize..29) {
            let mut file = encode(&Image::filled(2, 2, 1.0));
            let at = at % file.len();
            file[at] = value;
            file.truncate(cut);
            let _ = decode(&file);
        }
    }
}
