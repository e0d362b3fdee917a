use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::bytestream::ZCursor;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

use super::{broken, check};
use crate::{CodecError, Image};

const FORMAT: &str = "JPEG";

/// Decodes a baseline or progressive image: grey, colours or CMYK.
pub(super) fn decode(bytes: &[u8]) -> Result<Image<[u8; 4]>, CodecError> {
    let options = DecoderOptions::default()
        .set_strict_mode(false)
        .set_max_width(usize::MAX)
        .set_max_height(usize::MAX);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder
        .decode_headers()
        .map_err(|error| broken(FORMAT, "header", &error))?;
    let no_header = || broken(FORMAT, "header", &"no image");
    let (width, height) = decoder.dimensions().ok_or_else(no_header)?;
    let size = (
        u32::try_from(width).map_err(|_| no_header())?,
        u32::try_from(height).map_err(|_| no_header())?,
    );
    let is_grey = matches!(
        decoder.input_colorspace(),
        Some(ColorSpace::Luma | ColorSpace::LumaA)
    );
    let color = if is_grey {
        ColorSpace::Luma
    } else {
        ColorSpace::RGB
    };
    check(FORMAT, size, color.num_components() as u64, bytes.len())?;
    decoder.set_options(options.jpeg_set_out_colorspace(color));
    let samples = decoder
        .decode()
        .map_err(|error| broken(FORMAT, "pixels", &error))?;
    let pixels = if is_grey {
        samples.iter().map(|&v| [v, v, v, u8::MAX]).collect()
    } else {
        samples
            .as_chunks()
            .0
            .iter()
            .map(|&[r, g, b]| [r, g, b, u8::MAX])
            .collect()
    };
    Image::new(size.0, size.1, pixels).ok_or_else(|| broken(FORMAT, "pixels", &"incomplete"))
}
