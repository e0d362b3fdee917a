//! TIFF images of one channel, as measuring software saves depth.

use std::io::Cursor;

use tiff::ColorType;
use tiff::decoder::{Decoder, DecodingResult, Limits};

use crate::CodecError;
use crate::limits::{allowed_bytes, check};
use crate::npy::Values;

const FORMAT: &str = "TIFF";

/// The maximum number of pages.
const MAX_PAGES: usize = 1 << 16;

/// A page of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// The width in pixels.
    pub width: u32,
    /// The height in pixels.
    pub height: u32,
    /// The pixels, row by row.
    pub values: Values,
}

/// Decodes all pages, uncompressed or compressed with LZW, Deflate or `PackBits`.
///
/// # Errors
/// Returns an error if the bytes are not a TIFF, a page has several channels or an unsupported type, or memory is short.
pub fn decode(bytes: &[u8]) -> Result<Vec<Page>, CodecError> {
    let broken = |page: usize, error: tiff::TiffError| {
        let remedy = match &error {
            tiff::TiffError::UnsupportedError(_) => {
                "save it uncompressed, as floats or integers of one channel"
            }
            _ => "the file is truncated or damaged; copy it again",
        };
        CodecError::new(FORMAT, format!("page {page}"), error.to_string(), remedy)
    };
    let mut limits = Limits::default();
    let allowed = usize::try_from(allowed_bytes(bytes.len())).unwrap_or(usize::MAX);
    limits.decoding_buffer_size = allowed;
    limits.intermediate_buffer_size = allowed;
    let decoder = Decoder::new(Cursor::new(bytes)).map_err(|error| broken(0, error))?;
    let mut decoder = decoder.with_limits(limits);
    let mut pages = Vec::new();
    loop {
        let at = pages.len();
        let (width, height) = decoder.dimensions().map_err(|error| broken(at, error))?;
        let bits = match decoder.colortype().map_err(|error| broken(at, error))? {
            ColorType::Gray(bits) => bits,
            other => {
                return Err(CodecError::new(
                    FORMAT,
                    format!("page {at}"),
                    format!("{} channels", other.num_samples()),
                    "save depth as one channel",
                ));
            }
        };
        check(
            FORMAT,
            (width.into(), height.into()),
            u64::from(bits).div_ceil(8),
            bytes.len(),
        )?;
        let values = match decoder.read_image().map_err(|error| broken(at, error))? {
            DecodingResult::U8(values) => Values::U8(values),
            DecodingResult::U16(values) => Values::U16(values),
            DecodingResult::U32(values) => Values::I64(values.into_iter().map(i64::from).collect()),
            DecodingResult::I16(values) => Values::I32(values.into_iter().map(i32::from).collect()),
            DecodingResult::I32(values) => Values::I32(values),
            DecodingResult::I64(values) => Values::I64(values),
            DecodingResult::F16(values) => Values::F32(values.into_iter().map(half::f16::to_f32).collect()),
            DecodingResult::F32(values) => Values::F32(values),
            DecodingResult::F64(values) => Values::F64(values),
            DecodingResult::I8(_) | DecodingResult::U64(_) => {
                return Err(CodecError::new(
                    FORMAT,
                    format!("page {at}"),
                    format!("integers of {bits} bits"),
                    "save float32 metres or 16-bit integers",
                ));
            }
        };
        pages.push(Page {
            width,
            height,
            values,
        });
        if !decoder.more_images() || pages.len() == MAX_PAGES {
            return Ok(pages);
        }
        decoder.next_image().map_err(|error| broken(at + 1, error))?;
    }
}

#[cfg(test)]
mod tests {
    use tiff::encoder::{Compression, DeflateLevel, TiffEncoder, colortype};

    use super::*;

    fn pages(compression: Compression, images: &[[f32; 6]]) -> Vec<u8> {
        let mut file = Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut file).unwrap().with_compression(compression);
        for image in images {
            encoder
                .write_image::<colortype::Gray32Float>(3, 2, image)
                .unwrap();
        }
        file.into_inner()
    }

    #[test]
    fn pages_of_floats() {
        let images = [[0.5, 1.5, f32::INFINITY, 0.0, -1.0, 2.25], [9.0; 6]];
        for compression in [
            Compression::Uncompressed,
            Compression::Lzw,
            Compression::Deflate(DeflateLevel::Fast),
            Compression::Packbits,
        ] {
            let read = decode(&pages(compression, &images)).unwrap();
            let expected = images.map(|image| Page {
                width: 3,
                height: 2,
                values: Values::F32(image.to_vec()),
            });
            assert_eq!(read, expected);
        }
    }

    #[test]
    fn integers() {
        let mut file = Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut file).unwrap();
        encoder
            .write_image::<colortype::Gray16>(1, 2, &[1500, 65535])
            .unwrap();
        encoder
            .write_image::<colortype::GrayI32>(1, 2, &[-1, 70_000])
            .unwrap();
        encoder
            .write_image::<colortype::Gray32>(1, 2, &[0, u32::MAX])
            .unwrap();
        let read: Vec<Values> = (decode(&file.into_inner()).unwrap().into_iter())
            .map(|page| page.values)
            .collect();
        assert_eq!(
            read,
            [
                Values::U16(vec![1500, 65535]),
                Values::I32(vec![-1, 70_000]),
                Values::I64(vec![0, u32::MAX.into()])
            ]
        );
    }

    #[test]
    fn errors_state_a_remedy() {
        let says = |bytes: &[u8]| decode(bytes).unwrap_err().to_string();
        let mut file = Cursor::new(Vec::new());
        let mut encoder = TiffEncoder::new(&mut file).unwrap();
        encoder.write_image::<colortype::RGB8>(1, 1, &[1, 2, 3]).unwrap();
        assert_eq!(
            says(&file.into_inner()),
            "TIFF: page 0: 3 channels; save depth as one channel"
        );
        let whole = pages(Compression::Uncompressed, &[[1.0; 6]]);
        for end in [3, 8, 20, whole.len() - 1] {
            assert!(says(&whole[..end]).contains("copy it again"), "{end}");
        }
    }
}
