use png::{BitDepth, ColorType, Decoder, Limits, Transformations};

use super::{broken, check, png_chunks};
use crate::{CodecError, Image, limits};

const FORMAT: &str = "PNG";

/// Decodes an image of any colour type and depth.
pub(super) fn decode(bytes: &[u8]) -> Result<Image<[u8; 4]>, CodecError> {
    let allowed = usize::try_from(limits::allowed_bytes(bytes.len())).unwrap_or(usize::MAX);
    let file = png_chunks::without_unused(bytes);
    let mut decoder = Decoder::new_with_limits(std::io::Cursor::new(&file), Limits { bytes: allowed });
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder
        .read_info()
        .map_err(|error| broken(FORMAT, "header", &error))?;
    let (color, depth) = reader.output_color_type();
    let (width, height) = reader.info().size();
    let samples_per_pixel = color.samples();
    let per_pixel = samples_per_pixel * if depth == BitDepth::Sixteen { 2 } else { 1 };
    check(FORMAT, (width, height), per_pixel as u64, bytes.len())?;
    let incomplete = || broken(FORMAT, "pixels", &"incomplete");
    let mut samples = vec![0; reader.output_buffer_size().ok_or_else(incomplete)?];
    reader
        .next_frame(&mut samples)
        .map_err(|error| broken(FORMAT, "pixels", &error))?;
    if depth == BitDepth::Sixteen {
        samples = samples
            .as_chunks()
            .0
            .iter()
            .map(|&sample| of_16_bits(sample))
            .collect();
    }
    let pixels = match color {
        ColorType::Grayscale => samples.iter().map(|&v| [v, v, v, u8::MAX]).collect(),
        ColorType::GrayscaleAlpha => samples.as_chunks().0.iter().map(|&[v, a]| [v, v, v, a]).collect(),
        ColorType::Rgb => samples
            .as_chunks()
            .0
            .iter()
            .map(|&[r, g, b]| [r, g, b, u8::MAX])
            .collect(),
        ColorType::Rgba => samples.as_chunks().0.to_vec(),
        // Palettes are expanded.
        ColorType::Indexed => return Err(incomplete()),
    };
    Image::new(width, height, pixels).ok_or_else(incomplete)
}

/// Returns the nearest sample of 8 bits.
#[expect(clippy::cast_possible_truncation, reason = "at most 255")]
fn of_16_bits(sample: [u8; 2]) -> u8 {
    ((u32::from(u16::from_be_bytes(sample)) + 128) / 257) as u8
}
