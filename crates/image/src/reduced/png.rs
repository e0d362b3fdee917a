//! Reads PNG images that are too large for the memory at a fraction of their size, row by row.

use std::io::Cursor;

use ::png::{BitDepth, ColorType, Decoder, Limits, Reader, Transformations};

use oaktwin_memory::{self as memory, Shortage};

use crate::srgb::{linear_from_srgb, srgb_from_linear};
use crate::{CodecError, Image, limits};

const FORMAT: &str = "PNG";

/// The bytes per column for the rows of the decoder and of the filter.
const BYTES_PER_COLUMN: u64 = 64;

/// Whether the colours of an image are averaged as sRGB or as numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Average {
    /// In linear light.
    Srgb,
    /// As they are in the file: data, such as a roughness.
    Raw,
}

/// An image that was reduced while it was read.
#[derive(Clone, Debug)]
pub(crate) struct Reduced {
    pub(crate) image: Image<[u8; 4]>,
    /// The width and height in the file.
    pub(crate) full_size: (u32, u32),
    /// The memory that the full size needs.
    pub(crate) shortage: Shortage,
}

/// Reads an image if its full size does not fit into the memory: at the largest size, divided by a power of two, that does.
/// `None` if it fits, and for interlaced images, whose rows are not in order.
///
/// `per_pixel` is the number of bytes that a pixel of the result needs in total.
///
/// # Errors
/// Returns an error if the file is damaged, or one row does not fit.
pub(crate) fn decode(bytes: &[u8], per_pixel: u64, average: Average) -> Result<Option<Reduced>, CodecError> {
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
    let (width, height) = (reader.info().width, reader.info().height);
    let size = (u64::from(width), u64::from(height));
    let (color, depth) = reader.output_color_type();
    let bytes_per_pixel = (color.samples() * if depth == BitDepth::Sixteen { 2 } else { 1 }) as u64;
    limits::check_claim(FORMAT, size, bytes_per_pixel, bytes.len())?;
    let Err(shortage) = memory::check(limits::needed(size, bytes_per_pixel)) else {
        return Ok(None);
    };
    if reader.info().interlaced {
        return Ok(None);
    }
    let fits = |divisor: u32| {
        let pixels = size.0.div_ceil(divisor.into()) * size.1.div_ceil(divisor.into());
        memory::check(pixels * per_pixel + size.0 * BYTES_PER_COLUMN).is_ok()
    };
    let divisor = (1..32).map(|power| 1 << power).find(|divisor| fits(*divisor));
    let divisor = divisor.ok_or_else(|| CodecError::shortage(FORMAT, size, shortage))?;
    let filter = Filter::new((width, height), divisor, average);
    let image = filter.run(reader, color).map_err(|problem| {
        let remedy = "the file is truncated or damaged; save it again";
        CodecError::new(FORMAT, "pixels", problem, remedy)
    })?;
    Ok(Some(Reduced {
        image,
        full_size: (width, height),
        shortage,
    }))
}

/// A box filter: a pixel of the result is the mean of the area that it covers, with parts of pixels at the edges.
struct Filter {
    full: (u32, u32),
    reduced: (u32, u32),
    average: Average,
    /// The values, 0 to 1, of the samples.
    values: [f32; 256],
    /// The sums of the current row of the result.
    sums: Vec<[f32; 4]>,
    pixels: Vec<[u8; 4]>,
}

impl Filter {
    fn new(full: (u32, u32), divisor: u32, average: Average) -> Self {
        let reduced = (full.0.div_ceil(divisor), full.1.div_ceil(divisor));
        let values = match average {
            Average::Srgb => *linear_from_srgb(),
            Average::Raw => RAW,
        };
        Self {
            full,
            reduced,
            average,
            values,
            sums: vec![[0.0; 4]; reduced.0 as usize],
            pixels: Vec::with_capacity(reduced.0 as usize * reduced.1 as usize),
        }
    }

    fn run(mut self, mut reader: Reader<Cursor<&[u8]>>, color: ColorType) -> Result<Image<[u8; 4]>, String> {
        let is_deep = reader.output_color_type().1 == BitDepth::Sixteen;
        let mut line = vec![[0.0; 4]; self.reduced.0 as usize];
        for y in 0..self.full.1 {
            let row = reader.next_row().map_err(|error| error.to_string())?;
            let row = row.ok_or("incomplete")?;
            line.fill([0.0; 4]);
            if is_deep {
                // Rounded like the conversion of full images.
                let narrow = |pair: &[u8; 2]| {
                    let rounded = (u32::from(u16::from_be_bytes(*pair)) + 128) / 257;
                    u8::try_from(rounded).unwrap_or(u8::MAX)
                };
                let samples: Vec<u8> = row.data().as_chunks().0.iter().map(narrow).collect();
                self.reduce(&samples, color, &mut line);
            } else {
                self.reduce(row.data(), color, &mut line);
            }
            let [(at, part), (_, rest)] = shares(y, self.full.1, self.reduced.1);
            self.add(&line, part);
            // The row of the result is complete.
            if rest > 0.0 || shares(y + 1, self.full.1, self.reduced.1)[0].0 > at {
                self.finish_row();
                self.add(&line, rest);
            }
        }
        Image::new(self.reduced.0, self.reduced.1, self.pixels).ok_or_else(|| "incomplete".to_owned())
    }

    /// Adds the samples of a row to the pixels of the result that cover them.
    fn reduce(&self, samples: &[u8], color: ColorType, line: &mut [[f32; 4]]) {
        let count = color.samples();
        for (x, pixel) in (0..self.full.0).zip(samples.chunks_exact(count)) {
            let rgba = match *pixel {
                [grey] => [grey, grey, grey, 255],
                [grey, alpha] => [grey, grey, grey, alpha],
                [r, g, b] => [r, g, b, 255],
                [r, g, b, a] => [r, g, b, a],
                _ => [0; 4],
            };
            let [r, g, b, a] = rgba.map(usize::from);
            let rgba = [self.values[r], self.values[g], self.values[b], RAW[a]];
            for (at, share) in shares(x, self.full.0, self.reduced.0) {
                if let Some(sums) = line.get_mut(at as usize).filter(|_| share > 0.0) {
                    for (sum, value) in sums.iter_mut().zip(rgba) {
                        *sum += value * share;
                    }
                }
            }
        }
    }

    fn add(&mut self, line: &[[f32; 4]], share: f32) {
        for (sums, values) in self.sums.iter_mut().zip(line) {
            for (sum, value) in sums.iter_mut().zip(values) {
                *sum += value * share;
            }
        }
    }

    fn finish_row(&mut self) {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "casts of floats saturate"
        )]
        let raw = |value: f32| (value * 255.0 + 0.5) as u8;
        let encode = match self.average {
            Average::Srgb => srgb_from_linear,
            Average::Raw => raw,
        };
        for sums in &mut self.sums {
            let [r, g, b, a] = std::mem::take(sums);
            self.pixels.push([encode(r), encode(g), encode(b), raw(a)]);
        }
    }
}

/// 0 to 1 in equal steps.
static RAW: [f32; 256] = {
    let mut values = [0.0; 256];
    let mut at = 0;
    while at < 256 {
        values[at] = at as f32 / 255.0;
        at += 1;
    }
    values
};

/// Returns the two pixels of `reduced` that pixel `at` of `full` lies in, with the shares of their areas that it covers.
#[expect(clippy::cast_precision_loss, reason = "a share")]
fn shares(at: u32, full: u32, reduced: u32) -> [(u32, f32); 2] {
    // In units of 1 / reduced of a full pixel, in which a reduced pixel is `full` long.
    let (at, full, reduced) = (u64::from(at), u64::from(full), u64::from(reduced));
    let (start, end) = (at * reduced, (at + 1) * reduced);
    let first = start / full;
    let border = ((first + 1) * full).min(end);
    let share = |length: u64| length as f32 / full as f32;
    let index = |at: u64| u32::try_from(at).unwrap_or(u32::MAX);
    [
        (index(first), share(border - start)),
        (index(first + 1), share(end - border)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::png::Encoder;

    fn reduced(file: &[u8], divisor: u32, average: Average) -> Image<[u8; 4]> {
        let mut decoder = Decoder::new(Cursor::new(file));
        decoder.set_transformations(Transformations::EXPAND);
        let reader = decoder.read_info().unwrap();
        let (info, color) = (reader.info().size(), reader.output_color_type().0);
        Filter::new(info, divisor, average).run(reader, color).unwrap()
    }

    /// Returns the mean over the area of a pixel of the result, by sampling 60 × 60 points of it.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    fn mean(full: &Image<[u8; 4]>, size: (u32, u32), at: (u32, u32), average: Average) -> [u8; 4] {
        let mut sums = [0.0f64; 4];
        let of = |at: u32, point: u32, count: u32, full: u32| {
            (u64::from(at * 60 + point) * 2 + 1) * u64::from(full) / (u64::from(count) * 120)
        };
        for (u, v) in (0..60).flat_map(|v| (0..60).map(move |u| (u, v))) {
            let x = u32::try_from(of(at.0, u, size.0, full.width())).unwrap();
            let y = u32::try_from(of(at.1, v, size.1, full.height())).unwrap();
            let pixel = full.get(x, y).unwrap();
            for (channel, (sum, value)) in sums.iter_mut().zip(pixel).enumerate() {
                *sum += match average {
                    Average::Srgb if channel < 3 => f64::from(linear_from_srgb()[usize::from(*value)]),
                    _ => f64::from(*value) / 255.0,
                };
            }
        }
        let mut channel = 0;
        sums.map(|sum| {
            channel += 1;
            match average {
                Average::Srgb if channel < 4 => srgb_from_linear((sum / 3600.0) as f32),
                _ => (sum / 3600.0 * 255.0).round() as u8,
            }
        })
    }

    #[test]
    fn pixels_are_the_means_of_their_areas() {
        let mut random = 1u32;
        let mut next = || {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (random >> 24) as u8
        };
        for (width, height) in [(16, 8), (15, 10), (9, 7), (1, 5), (30, 1)] {
            let pixels = (0..width * height).map(|_| [next(), next(), next(), next()]);
            let image = Image::new(width, height, pixels.collect()).unwrap();
            let file = crate::png::encode(&image).unwrap();
            for (divisor, average) in [(2, Average::Srgb), (4, Average::Raw), (8, Average::Srgb)] {
                let reduced = reduced(&file, divisor, average);
                let size = (width.div_ceil(divisor), height.div_ceil(divisor));
                assert_eq!((reduced.width(), reduced.height()), size);
                for (x, y) in (0..size.1).flat_map(|y| (0..size.0).map(move |x| (x, y))) {
                    let expected = mean(&image, size, (x, y), average);
                    let near = reduced.get(x, y).unwrap().iter().zip(expected);
                    // Where the areas have fractions of pixels, the points give approximate means.
                    assert!(
                        near.clone().all(|(a, b)| a.abs_diff(b) <= 2),
                        "{width} × {height} / {divisor}: {near:?}"
                    );
                }
            }
        }
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

    #[test]
    fn small_and_damaged_images_are_left_to_the_other_decoder() {
        let file = crate::png::encode(&Image::filled(4, 4, 1u8)).unwrap();
        assert!(decode(&file, 8, Average::Srgb).unwrap().is_none());
        assert!(decode(b"GIF89a", 8, Average::Srgb).unwrap().is_none());
    }
}
