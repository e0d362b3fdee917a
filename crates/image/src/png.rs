//! PNG: grey of 8 and 16 bits, RGB and RGBA of 8 bits, lossless.
//!
//! Encoding is optimized for speed rather than size: it is twenty times faster than with the default compression, and files are
//! about twice as large.

use ::png::{BitDepth, ColorType, Compression, Decoder, Encoder, Filter, Limits, Transformations};

use oaktwin_files::memory;

use crate::bytes::Scalar;
use crate::{CodecError, Image};

const FORMAT: &str = "PNG";

/// The remedy for an image of another pixel type.
pub const CONVERT: &str = "convert the image";

/// The maximum compression ratio of DEFLATE; a header that claims more is invalid.
const MAX_RATIO: usize = 1032;

/// A pixel type that PNG supports.
pub trait PngPixel: Copy + sealed::Pixel {}

mod sealed {
    use super::{BitDepth, ColorType};

    pub trait Pixel: Sized {
        const COLOR: ColorType;
        const DEPTH: BitDepth;
        const NAME: &'static str;
        /// Appends samples, most significant byte first.
        fn put(pixels: &[Self], out: &mut Vec<u8>);
        fn get(bytes: &[u8]) -> Vec<Self>;
    }
}

macro_rules! pixel {
    ($pixel:ty, $color:ident, $depth:ident, $name:literal, $put:expr, $get:expr) => {
        impl PngPixel for $pixel {}

        impl sealed::Pixel for $pixel {
            const COLOR: ColorType = ColorType::$color;
            const DEPTH: BitDepth = BitDepth::$depth;
            const NAME: &'static str = $name;

            fn put(pixels: &[Self], out: &mut Vec<u8>) {
                $put(pixels, out);
            }

            fn get(bytes: &[u8]) -> Vec<Self> {
                $get(bytes)
            }
        }
    };
}

pixel!(u8, Grayscale, Eight, "grey of 8 bits", u8::put_be, <[u8]>::to_vec);
pixel!(
    u16,
    Grayscale,
    Sixteen,
    "grey of 16 bits",
    u16::put_be,
    u16::get_be
);
pixel!([u8; 3], Rgb, Eight, "RGB of 8 bits", put_samples, get_samples);
pixel!([u8; 4], Rgba, Eight, "RGBA of 8 bits", put_samples, get_samples);

fn put_samples<const N: usize>(pixels: &[[u8; N]], out: &mut Vec<u8>) {
    out.extend_from_slice(pixels.as_flattened());
}

fn get_samples<const N: usize>(bytes: &[u8]) -> Vec<[u8; N]> {
    bytes.as_chunks().0.to_vec()
}

/// Encodes an image.
///
/// # Errors
/// Returns an error if the image has no pixels or more than 2³¹ − 1 pixels on a side, which PNG does not support.
pub fn encode<P: PngPixel>(image: &Image<P>) -> Result<Vec<u8>, CodecError> {
    let refused = |error: ::png::EncodingError| {
        CodecError::new(
            FORMAT,
            "image",
            format!("{} × {}: {error}", image.width(), image.height()),
            "write another format, or an image of 1 to 2147483647 pixels a side",
        )
    };
    let mut samples = Vec::with_capacity(size_of_val(image.pixels()));
    P::put(image.pixels(), &mut samples);
    let mut out = Vec::with_capacity(samples.len() / 2);
    let mut encoder = Encoder::new(&mut out, image.width(), image.height());
    encoder.set_color(P::COLOR);
    encoder.set_depth(P::DEPTH);
    encoder.set_compression(Compression::Fast);
    encoder.set_filter(Filter::Adaptive);
    let mut writer = encoder.write_header().map_err(refused)?;
    writer.write_image_data(&samples).map_err(refused)?;
    writer.finish().map_err(refused)?;
    Ok(out)
}

/// Decodes an image of exactly this pixel type.
///
/// # Errors
/// Returns an error if the bytes are not a PNG of this pixel type.
pub fn decode<P: PngPixel>(bytes: &[u8]) -> Result<Image<P>, CodecError> {
    let broken = |place: &'static str, problem: String| {
        CodecError::new(
            FORMAT,
            place,
            problem,
            "the file is truncated or damaged; copy it again",
        )
    };
    let limits = Limits {
        bytes: bytes.len().saturating_mul(MAX_RATIO),
    };
    let mut decoder = Decoder::new_with_limits(std::io::Cursor::new(bytes), limits);
    decoder.set_transformations(Transformations::IDENTITY);
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_ignore_text_chunk(true);
    let mut reader = decoder
        .read_info()
        .map_err(|error| broken("header", error.to_string()))?;
    let (color, depth) = reader.output_color_type();
    let (width, height) = (reader.info().width, reader.info().height);
    if (color, depth) != (P::COLOR, P::DEPTH) {
        return Err(CodecError::new(
            FORMAT,
            "header",
            format!("{color:?} of {} bits, expected {}", depth as u8, P::NAME),
            CONVERT,
        ));
    }
    let size = reader
        .output_buffer_size()
        .filter(|&size| size <= bytes.len().saturating_mul(MAX_RATIO))
        .ok_or_else(|| {
            broken(
                "header",
                format!("{width} × {height} pixels cannot be in {} bytes", bytes.len()),
            )
        })?;
    // Twice: the bytes and the pixels.
    memory::check(2 * size as u64)
        .map_err(|shortage| CodecError::shortage(FORMAT, (width.into(), height.into()), shortage))?;
    let mut samples = vec![0; size];
    reader
        .next_frame(&mut samples)
        .map_err(|error| broken("pixels", error.to_string()))?;
    Image::new(width, height, P::get(&samples)).ok_or_else(|| broken("pixels", "incomplete".into()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn writes_signature_and_header() {
        let file = encode(&Image::new(2, 1, vec![0x1234u16, 7]).unwrap()).unwrap();
        assert_eq!(file[..8], *b"\x89PNG\r\n\x1a\n");
        // Width, height, 16 bits, grey, DEFLATE, filters, not interlaced.
        assert_eq!(file[16..29], [0, 0, 0, 2, 0, 0, 0, 1, 16, 0, 0, 0, 0]);
    }

    #[test]
    fn errors_state_a_remedy() {
        let error = encode(&Image::<u8>::filled(0, 3, 0)).unwrap_err().to_string();
        assert!(error.starts_with("PNG: image: 0 × 3: "), "{error}");
        let grey = encode(&Image::filled(2, 2, 7u8)).unwrap();
        assert_eq!(
            decode::<u16>(&grey).unwrap_err().to_string(),
            "PNG: header: Grayscale of 8 bits, expected grey of 16 bits; convert the image"
        );
        assert!(
            decode::<u8>(b"JPEG")
                .unwrap_err()
                .to_string()
                .starts_with("PNG: header: ")
        );
    }

    #[test]
    fn rejects_huge_headers_before_allocating() {
        let mut file = encode(&Image::filled(2, 2, 7u8)).unwrap();
        file[16..24].copy_from_slice(&[0x7F, 0xFF, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF, 0xFF]);
        // The header's checksum.
        let mut crc = u32::MAX;
        for byte in &file[12..29] {
            crc ^= u32::from(*byte);
            for _ in 0..8 {
                crc = (crc >> 1) ^ (0xEDB8_8320 & 0u32.wrapping_sub(crc & 1));
            }
        }
        file[29..33].copy_from_slice(&(!crc).to_be_bytes());
        let error = decode::<u8>(&file).unwrap_err().to_string();
        assert!(
            error.contains("cannot be in") || error.contains("imit"),
            "{error}"
        );
    }

    fn comes_back<P: PngPixel + PartialEq + std::fmt::Debug>(
        width: u32,
        pixels: &[P],
    ) -> Result<(), TestCaseError> {
        let height = u32::try_from(pixels.len()).unwrap() / width;
        let image = Image::new(width, height, pixels[..(width * height) as usize].to_vec()).unwrap();
        if height > 0 {
            prop_assert_eq!(decode::<P>(&encode(&image).unwrap()).unwrap(), image);
        }
        Ok(())
    }

    proptest! {
        #[test]
        fn round_trip_is_lossless(
            width in 1u32..20, grey in prop::collection::vec(any::<u16>(), 0..400),
            rgb in prop::collection::vec(any::<[u8; 3]>(), 0..400),
            rgba in prop::collection::vec(any::<[u8; 4]>(), 0..400),
        ) {
            comes_back(width, &grey)?;
            comes_back(width, &rgb)?;
            comes_back(width, &rgba)?;
            comes_back(width, rgb.as_flattened())?;
        }

        #[test]
        fn never_panics_on_damaged_files(at in 0usize..90, value: u8, cut in 0usize..200) {
            let mut file = encode(&Image::new(4, 4, (0..16).collect::<Vec<u16>>()).unwrap()).unwrap();
            let at = at % file.len();
            file[at] = value;
            file.truncate(cut);
            let _ = decode::<u16>(&file);
        }
    }
}
