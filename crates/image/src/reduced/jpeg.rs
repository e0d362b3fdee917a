//! JPEG: the decoder leaves out the finer frequencies of each block, which halves the size up to three times. What is left of the
//! divisor is averaged row by row.

use std::io::Cursor;

use jpeg_decoder::{CodingProcess, Decoder, ImageInfo, PixelFormat};
use oaktwin_files::memory;

use super::rows::Rows;
use super::{Average, Reduced, divisor};
use crate::{CodecError, Image, limits};

const FORMAT: &str = "JPEG";

/// The smallest size of a block of 8 × 8 pixels is one pixel.
const MAX_SCALE: u32 = 8;

pub(super) fn decode(
    bytes: &[u8],
    per_pixel: u64,
    average: Average,
) -> Result<Option<Reduced<[u8; 4]>>, CodecError> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    // The decoder of full images reports an invalid header.
    let (Ok(()), Some(info)) = (decoder.read_info(), decoder.info()) else {
        return Ok(None);
    };
    let size = (u64::from(info.width), u64::from(info.height));
    // Full images are decoded to grey or colours.
    let channels = if info.pixel_format == PixelFormat::L8 {
        1
    } else {
        3
    };
    limits::check_claim(FORMAT, size, channels, bytes.len())?;
    let Err(shortage) = memory::check(limits::needed(size, channels)) else {
        return Ok(None);
    };
    if info.pixel_format == PixelFormat::L16 || info.coding_process == CodingProcess::Lossless {
        return Ok(None);
    }
    let divisor = divisor(size, per_pixel, |divisor| needed(&info, divisor.min(MAX_SCALE)))
        .ok_or_else(|| CodecError::shortage(FORMAT, size, shortage))?;
    let image = read(decoder, &info, divisor, average).map_err(|problem| {
        let remedy = "the file is truncated or damaged; save it again";
        CodecError::new(FORMAT, "pixels", problem, remedy)
    })?;
    Ok(Some(Reduced {
        image,
        full_size: (info.width.into(), info.height.into()),
        shortage,
    }))
}

/// Returns the bytes for decoding at a scale: the planes and the pixels that are made of them, and all coefficients of a
/// progressive image.
fn needed(info: &ImageInfo, scale: u32) -> u64 {
    let channels = info.pixel_format.pixel_bytes() as u64;
    // Planes consist of whole groups of up to 32 × 32 pixels.
    let padded = |length: u16| u64::from(length).next_multiple_of(32);
    let samples = padded(info.width) * padded(info.height) * channels;
    let coefficients = match info.coding_process {
        CodingProcess::DctProgressive => 2 * samples,
        _ => 0,
    };
    coefficients + 2 * samples / u64::from(scale * scale)
}

fn read(
    mut decoder: Decoder<Cursor<&[u8]>>,
    info: &ImageInfo,
    divisor: u32,
    average: Average,
) -> Result<Image<[u8; 4]>, String> {
    let scale = divisor.min(MAX_SCALE);
    let scaled = |length: u16| {
        let scaled = u32::from(length).div_ceil(scale);
        u16::try_from(scaled).unwrap_or(u16::MAX)
    };
    let wanted = (scaled(info.width), scaled(info.height));
    let size = decoder
        .scale(wanted.0, wanted.1)
        .map_err(|error| error.to_string())?;
    let pixels = decoder.decode().map_err(|error| error.to_string())?;
    let channels = info.pixel_format.pixel_bytes();
    // The decoder prefers a larger size where both axes are small.
    let divisor = divisor * u32::from(size.0).div_ceil(u32::from(wanted.0).max(1)) / scale;
    let mut rows = Rows::new((size.0.into(), size.1.into()), divisor, average);
    for row in pixels.chunks_exact(channels * usize::from(size.0)) {
        if info.pixel_format == PixelFormat::CMYK32 {
            let row: Vec<u8> = row.as_chunks().0.iter().flat_map(rgb_from_cmyk).collect();
            rows.push(&row, 3);
        } else {
            rows.push(row, channels);
        }
    }
    rows.finish().ok_or_else(|| "incomplete".to_owned())
}

/// Converts inks, of which 255 is full, to colours.
fn rgb_from_cmyk(&[c, m, y, k]: &[u8; 4]) -> [u8; 3] {
    [c, m, y].map(|ink| {
        let light = u16::from(255 - ink) * u16::from(255 - k);
        u8::try_from((light + 127) / 255).unwrap_or(u8::MAX)
    })
}

#[cfg(test)]
mod tests {
    use super::super::tests::assert_means;
    use super::*;

    fn jpeg(image: &Image<[u8; 4]>) -> Vec<u8> {
        let pixels: Vec<u8> = image
            .pixels()
            .iter()
            .flat_map(|&[r, g, b, _]| [r, g, b])
            .collect();
        let mut file = Vec::new();
        ::image::codecs::jpeg::JpegEncoder::new_with_quality(&mut file, 100)
            .encode(
                &pixels,
                image.width(),
                image.height(),
                ::image::ExtendedColorType::Rgb8,
            )
            .unwrap();
        file
    }

    fn reduced(file: &[u8], divisor: u32, average: Average) -> Image<[u8; 4]> {
        let mut decoder = Decoder::new(Cursor::new(file));
        decoder.read_info().unwrap();
        let info = decoder.info().unwrap();
        read(decoder, &info, divisor, average).unwrap()
    }

    /// Colours that change slowly, because the decoder averages sRGB within a block.
    fn slopes(width: u32, height: u32) -> Image<[u8; 4]> {
        let level = |at: u32, of: u32| u8::try_from(40 + 150 * at / of.max(1)).unwrap();
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let pixels = pixels.map(|(x, y)| [level(x, width), level(y, height), 128, 255]);
        Image::new(width, height, pixels.collect()).unwrap()
    }

    #[test]
    fn pixels_are_the_means_of_their_areas() {
        // At the right and at the bottom of an odd size, blocks reach beyond the image, so that pixels are displaced by less than
        // one.
        for (width, height, largest) in [(64, 48, 32), (160, 80, 32), (643, 333, 8)] {
            let image = slopes(width, height);
            let file = jpeg(&image);
            for average in [Average::Srgb, Average::Raw] {
                for divisor in [2, 4, 8, 16, 32]
                    .into_iter()
                    .filter(|divisor| *divisor <= largest)
                {
                    assert_means(&reduced(&file, divisor, average), &image, divisor, average, 5);
                }
            }
        }
    }

    #[test]
    fn grey_images_stay_grey() {
        let mut file = Vec::new();
        ::image::codecs::jpeg::JpegEncoder::new(&mut file)
            .encode(&[90; 64 * 32], 64, 32, ::image::ExtendedColorType::L8)
            .unwrap();
        assert_eq!(
            reduced(&file, 4, Average::Srgb),
            Image::filled(16, 8, [90, 90, 90, 255])
        );
    }

    #[test]
    fn inks_become_colours() {
        assert_eq!(rgb_from_cmyk(&[0, 255, 0, 0]), [255, 0, 255]);
        assert_eq!(rgb_from_cmyk(&[0, 0, 0, 255]), [0; 3]);
    }

    #[test]
    fn progressive_images_need_their_coefficients() {
        let info = |coding_process| ImageInfo {
            width: 3200,
            height: 320,
            pixel_format: PixelFormat::RGB24,
            coding_process,
        };
        assert_eq!(
            needed(&info(CodingProcess::DctSequential), 2),
            3200 * 320 * 3 * 2 / 4
        );
        assert_eq!(
            needed(&info(CodingProcess::DctProgressive), 2),
            3200 * 320 * 3 * (2 * 4 + 2) / 4
        );
    }

    #[test]
    fn damaged_images_are_rejected() {
        let file = jpeg(&slopes(64, 64));
        let mut decoder = Decoder::new(Cursor::new(&file[..30]));
        assert!(decoder.read_info().is_err());
    }
}
