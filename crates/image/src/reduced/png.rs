//! PNG: row by row, or by the passes of an interlaced image.

use std::io::Cursor;

use ::png::{BitDepth, Decoder, Limits, Reader, Transformations};

use oaktwin_files::memory;

use super::areas::{self, Areas};
use super::rows::Rows;
use super::{Average, Reduced, divisor, values};
use crate::{CodecError, Image, limits};

const FORMAT: &str = "PNG";

/// The bytes per column for the rows of the decoder and of the filter.
const BYTES_PER_COLUMN: u64 = 64;

/// The passes of an interlaced image: the first column and row, and the steps between them.
const PASSES: [[u32; 4]; 7] = [
    [0, 0, 8, 8],
    [4, 0, 8, 8],
    [0, 4, 4, 8],
    [2, 0, 4, 4],
    [0, 2, 2, 4],
    [1, 0, 2, 2],
    [0, 1, 1, 2],
];

pub(super) fn decode(
    bytes: &[u8],
    per_pixel: u64,
    average: Average,
) -> Result<Option<Reduced<[u8; 4]>>, CodecError> {
    let limits = Limits {
        bytes: usize::try_from(limits::allowed_bytes(bytes.len())).unwrap_or(usize::MAX),
    };
    let mut decoder = Decoder::new_with_limits(Cursor::new(bytes), limits);
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_ignore_text_chunk(true);
    // The decoder of full images reports an invalid header.
    let Ok(reader) = decoder.read_info() else {
        return Ok(None);
    };
    let (width, height) = reader.info().size();
    let size = (u64::from(width), u64::from(height));
    let (color, depth) = reader.output_color_type();
    let bytes_per_pixel = (color.samples() * if depth == BitDepth::Sixteen { 2 } else { 1 }) as u64;
    limits::check_claim(FORMAT, size, bytes_per_pixel, bytes.len())?;
    let Err(shortage) = memory::check(limits::needed(size, bytes_per_pixel)) else {
        return Ok(None);
    };
    let is_interlaced = reader.info().interlaced;
    let (per_column, per_pixel) = if is_interlaced {
        (
            BYTES_PER_COLUMN + areas::BYTES_PER_COLUMN,
            per_pixel + areas::BYTES_PER_PIXEL,
        )
    } else {
        (BYTES_PER_COLUMN, per_pixel)
    };
    let divisor = divisor(size, per_pixel, |_| size.0 * per_column)
        .ok_or_else(|| CodecError::shortage(FORMAT, size, shortage))?;
    let read = if is_interlaced { passes } else { rows };
    let image = read(reader, divisor, average).map_err(|problem| {
        let remedy = "the file is truncated or damaged; save it again";
        CodecError::new(FORMAT, "pixels", problem, remedy)
    })?;
    Ok(Some(Reduced {
        image,
        full_size: (width, height),
        shortage,
    }))
}

fn rows(mut reader: Reader<Cursor<&[u8]>>, divisor: u32, average: Average) -> Result<Image<[u8; 4]>, String> {
    let mut rows = Rows::new(reader.info().size(), divisor, average);
    let samples = reader.output_color_type().0.samples();
    for _ in 0..reader.info().height {
        with_row(&mut reader, |row| rows.push(row, samples))?;
    }
    rows.finish().ok_or_else(|| "incomplete".to_owned())
}

fn passes(
    mut reader: Reader<Cursor<&[u8]>>,
    divisor: u32,
    average: Average,
) -> Result<Image<[u8; 4]>, String> {
    let (width, height) = reader.info().size();
    let samples = reader.output_color_type().0.samples();
    let of_color = average.values();
    let mut areas = Areas::new((width, height), divisor);
    for [x, y, across, down] in PASSES {
        // A pass without columns has no rows either.
        let last = if x < width { height } else { 0 };
        for y in (y..last).step_by(down as usize) {
            with_row(&mut reader, |row| {
                let columns = (x..width).step_by(across as usize);
                let pixels = row.chunks_exact(samples).map(|pixel| values(&of_color, pixel));
                areas.add(y, columns.zip(pixels));
            })?;
        }
    }
    let means = areas.finish().ok_or_else(|| "incomplete".to_owned())?;
    Ok(means.map(|mean| average.encode(*mean)))
}

/// Passes the samples of the next row, 8 bits each.
fn with_row(reader: &mut Reader<Cursor<&[u8]>>, take: impl FnOnce(&[u8])) -> Result<(), String> {
    let is_deep = reader.output_color_type().1 == BitDepth::Sixteen;
    let row = reader.next_row().map_err(|error| error.to_string())?;
    let row = row.ok_or("incomplete")?;
    if is_deep {
        // Rounded like the conversion of full images.
        let narrow = |pair: &[u8; 2]| {
            let rounded = (u32::from(u16::from_be_bytes(*pair)) + 128) / 257;
            u8::try_from(rounded).unwrap_or(u8::MAX)
        };
        let samples: Vec<u8> = row.data().as_chunks().0.iter().map(narrow).collect();
        take(&samples);
    } else {
        take(row.data());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::tests::{assert_means, noise};
    use super::*;
    use ::png::{ColorType, Encoder};

    fn reduced(file: &[u8], divisor: u32, average: Average) -> Image<[u8; 4]> {
        let mut decoder = Decoder::new(Cursor::new(file));
        decoder.set_transformations(Transformations::EXPAND);
        let reader = decoder.read_info().unwrap();
        if reader.info().interlaced {
            passes(reader, divisor, average).unwrap()
        } else {
            rows(reader, divisor, average).unwrap()
        }
    }

    /// Encodes an interlaced image; the encoder of the crate has no interlacing, so each pass is written as rows.
    fn interlaced(image: &Image<[u8; 4]>) -> Vec<u8> {
        let mut data = Vec::new();
        for [x0, y0, across, down] in PASSES {
            let last = if x0 < image.width() { image.height() } else { 0 };
            for y in (y0..last).step_by(down as usize) {
                data.push(0);
                for x in (x0..image.width()).step_by(across as usize) {
                    data.extend(image.get(x, y).unwrap());
                }
            }
        }
        let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
        let mut chunk = |name: &[u8; 4], data: &[u8]| {
            file.extend(u32::try_from(data.len()).unwrap().to_be_bytes());
            file.extend(name);
            file.extend(data);
            file.extend(crc([name, data].concat().as_slice()).to_be_bytes());
        };
        let mut header = [image.width().to_be_bytes(), image.height().to_be_bytes()].concat();
        header.extend([8, 6, 0, 0, 1]);
        chunk(b"IHDR", &header);
        chunk(b"IDAT", &stored(&data));
        chunk(b"IEND", &[]);
        file
    }

    /// A zlib stream without compression.
    fn stored(data: &[u8]) -> Vec<u8> {
        let length = u16::try_from(data.len()).unwrap();
        let (mut a, mut b) = (1u32, 0u32);
        for byte in data {
            a = (a + u32::from(*byte)) % 65521;
            b = (b + a) % 65521;
        }
        let mut out = vec![0x78, 0x01, 1];
        out.extend(length.to_le_bytes());
        out.extend((!length).to_le_bytes());
        out.extend(data);
        out.extend((b << 16 | a).to_be_bytes());
        out
    }

    fn crc(data: &[u8]) -> u32 {
        !data.iter().fold(u32::MAX, |crc, byte| {
            (0..8).fold(crc ^ u32::from(*byte), |crc, _| {
                (crc >> 1) ^ (0xEDB8_8320 & (crc & 1).wrapping_neg())
            })
        })
    }

    #[test]
    fn pixels_are_the_means_of_their_areas() {
        for (width, height) in [(16, 8), (15, 10), (9, 7), (1, 5), (30, 1)] {
            let image = noise(width, height);
            let file = crate::png::encode(&image).unwrap();
            for (divisor, average) in [(2, Average::Srgb), (4, Average::Raw), (8, Average::Srgb)] {
                assert_means(&reduced(&file, divisor, average), &image, divisor, average, 2);
            }
        }
    }

    #[test]
    fn interlaced_images_are_reduced_alike() {
        for (width, height) in [(16, 8), (15, 10), (9, 7), (1, 5), (4, 4), (30, 1), (33, 29)] {
            let image = noise(width, height);
            let file = interlaced(&image);
            assert_eq!(crate::texture::decode_srgb(&file, None).unwrap(), image);
            let plain = crate::png::encode(&image).unwrap();
            for (divisor, average) in [(2, Average::Srgb), (4, Average::Raw), (8, Average::Srgb)] {
                let (ours, others) = (
                    reduced(&file, divisor, average),
                    reduced(&plain, divisor, average),
                );
                let pairs = ours
                    .pixels()
                    .iter()
                    .flatten()
                    .zip(others.pixels().iter().flatten());
                // The sums are rounded in another order.
                assert!(
                    pairs.clone().all(|(a, b)| a.abs_diff(*b) <= 1),
                    "{width} × {height} / {divisor}"
                );
            }
        }
    }

    #[test]
    fn damaged_interlaced_images_are_rejected() {
        let file = interlaced(&noise(20, 20));
        let reader = Decoder::new(Cursor::new(&file[..file.len() / 2]))
            .read_info()
            .unwrap();
        assert!(passes(reader, 2, Average::Srgb).is_err());
    }

    #[test]
    fn all_kinds_of_pixels_are_read() {
        let grey = Image::filled(4, 4, 51u8);
        assert_eq!(
            reduced(&crate::png::encode(&grey).unwrap(), 4, Average::Srgb).pixels(),
            [[51, 51, 51, 255]]
        );
        let deep = Image::filled(4, 4, 51u16 * 257 + 100);
        assert_eq!(
            reduced(&crate::png::encode(&deep).unwrap(), 2, Average::Raw).pixels(),
            [[51, 51, 51, 255]; 4]
        );
        let mut palette = Vec::new();
        let mut encoder = Encoder::new(&mut palette, 3, 2);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(BitDepth::Two);
        encoder.set_palette(vec![0, 0, 0, 10, 20, 30]);
        encoder.set_trns(vec![0, 40]);
        encoder
            .write_header()
            .unwrap()
            .write_image_data(&[0b0101_0100; 2])
            .unwrap();
        assert_eq!(reduced(&palette, 4, Average::Raw).pixels(), [[10, 20, 30, 40]]);
    }
}
