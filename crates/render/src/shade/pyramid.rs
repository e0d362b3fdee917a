//! Mipmaps.

use oaktwin_image::Image;
use oaktwin_image::srgb::{linear_from_data, linear_from_srgb};
use oaktwin_simd::{Level, run_lanes_at};
use rayon::prelude::*;

use super::filter::{Footprints, TextureFilter, Wraps};
use super::tone::Encoder;

/// An image and its reductions by powers of two, down to one pixel.
#[derive(Debug)]
pub(crate) struct Pyramid {
    levels: Vec<Image<[u8; 4]>>,
    /// The linear values of bytes.
    linear: &'static [f32; 256],
    is_srgb: bool,
}

impl Pyramid {
    /// Creates a pyramid from an image of sRGB colours or of data.
    pub(super) fn new(image: Image<[u8; 4]>, is_srgb: bool) -> Self {
        let linear = if is_srgb {
            linear_from_srgb()
        } else {
            linear_from_data()
        };
        let mut levels = vec![image];
        while let Some(last) = levels.last()
            && (last.width() > 1 || last.height() > 1)
        {
            let next = halved(last, linear, is_srgb);
            levels.push(next);
        }
        Self {
            levels,
            linear,
            is_srgb,
        }
    }

    /// Filters over footprints; lanes without a bit in `used` return 0.
    pub(super) fn filtered(
        &self,
        level: Level,
        footprints: &Footprints,
        wraps: Wraps,
        used: u32,
    ) -> [[f32; 8]; 3] {
        let filter = TextureFilter {
            levels: &self.levels,
            is_srgb: self.is_srgb,
            wraps,
            footprints,
            used,
        };
        run_lanes_at(level, filter)
    }

    /// Returns the mean of the image.
    pub(super) fn mean(&self) -> [f32; 3] {
        let pixel = self.levels.last().and_then(|level| level.pixels().first());
        pixel.map_or([0.0; 3], |[r, g, b, _]| {
            [r, g, b].map(|value| self.linear[usize::from(*value)])
        })
    }
}

/// Returns an image of half the size, at least one pixel, by averaging in linear light.
fn halved(image: &Image<[u8; 4]>, linear: &[f32; 256], is_srgb: bool) -> Image<[u8; 4]> {
    let (width, height) = (image.width().div_ceil(2), image.height().div_ceil(2));
    let mut half = Image::filled(width, height, [0, 0, 0, 255]);
    let encoder = Encoder::new();
    let encode = |color: [f32; 3]| {
        let [r, g, b] = color.map(|value| encoded(value, is_srgb, encoder));
        [r, g, b, 255]
    };
    if image.width().is_multiple_of(2) && image.height().is_multiple_of(2) {
        halve_squares(image, linear, &mut half, encode);
    } else {
        halve_areas(image, linear, &mut half, encode);
    }
    half
}

/// Averages squares of four pixels.
fn halve_squares(
    image: &Image<[u8; 4]>,
    linear: &[f32; 256],
    half: &mut Image<[u8; 4]>,
    encode: impl Fn([f32; 3]) -> [u8; 4] + Sync,
) {
    let row_length = (half.width() as usize).max(1);
    let (pairs, _) = image.pixels().as_chunks::<2>();
    let rows = half.pixels_mut().par_chunks_mut(row_length).with_min_len(16);
    rows.zip(pairs.par_chunks(2 * row_length))
        .for_each(|(row, pairs)| {
            let (above, below) = pairs.split_at(row_length);
            for ((pixel, above), below) in row.iter_mut().zip(above).zip(below) {
                *pixel = encode(mean_of_square([*above, *below], linear));
            }
        });
}

/// Averages the areas that the pixels of an image of half the size cover.
fn halve_areas(
    image: &Image<[u8; 4]>,
    linear: &[f32; 256],
    half: &mut Image<[u8; 4]>,
    encode: impl Fn([f32; 3]) -> [u8; 4] + Sync,
) {
    let (width, height) = (half.width(), half.height());
    let columns: Vec<[(u32, f32); 3]> = (0..width).map(|x| covered(x, width, image.width())).collect();
    let row_length = (width as usize).max(1);
    let rows = half.pixels_mut().par_chunks_mut(row_length).with_min_len(16);
    rows.zip(0..height).for_each(|(row, y)| {
        let sources = covered(y, height, image.height());
        for (pixel, columns) in row.iter_mut().zip(&columns) {
            let mut sum = [0.0f32; 3];
            for (source, row_part) in sources {
                for (column, part) in columns {
                    let weight = row_part * part;
                    if weight > 0.0
                        && let Some(from) = image.get(*column, source)
                    {
                        for (sum, value) in sum.iter_mut().zip(from) {
                            *sum += linear[usize::from(*value)] * weight;
                        }
                    }
                }
            }
            *pixel = encode(sum);
        }
    });
}

/// Returns the mean of two rows of two pixels.
#[inline]
fn mean_of_square(square: [[[u8; 4]; 2]; 2], linear: &[f32; 256]) -> [f32; 3] {
    let [[a, b], [c, d]] = square;
    std::array::from_fn(|channel| {
        let [a, b, c, d] = [a, b, c, d].map(|pixel| linear[usize::from(pixel[channel])] * 0.25);
        a + b + c + d
    })
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "casts of floats saturate"
)]
fn encoded(value: f32, is_srgb: bool, encoder: Encoder) -> u8 {
    if is_srgb {
        encoder.srgb(value)
    } else {
        (value * 255.0 + 0.5) as u8
    }
}

/// Returns the pixels of `fine` that pixel `at` of `coarse` covers, with their weights.
#[expect(clippy::cast_precision_loss, reason = "a texture has fewer than 2^24 columns")]
fn covered(at: u32, coarse: u32, fine: u32) -> [(u32, f32); 3] {
    // In units of 1 / coarse of a fine pixel, which are integers.
    let (coarse, fine, at) = (u64::from(coarse), u64::from(fine), u64::from(at));
    let (start, end) = (at * fine, (at + 1) * fine);
    let first = start / coarse;
    [0, 1, 2].map(|i| {
        let pixel = first + i;
        let (from, to) = ((pixel * coarse).max(start), ((pixel + 1) * coarse).min(end));
        let share = to.saturating_sub(from) as f32 / fine as f32;
        (u32::try_from(pixel.min(fine - 1)).unwrap_or(u32::MAX), share)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_are_averaged_like_areas() {
        let pixels = (0..64 * 32u32).map(|i| i.wrapping_mul(0x9e37_79b1).rotate_left(9).to_le_bytes());
        let image = Image::new(64, 32, pixels.collect()).unwrap();
        for (linear, is_srgb) in [(linear_from_srgb(), true), (linear_from_data(), false)] {
            let encode = |color: [f32; 3]| {
                let [r, g, b] = color.map(|value| encoded(value, is_srgb, Encoder::new()));
                [r, g, b, 255]
            };
            let (mut squares, mut areas) = (Image::filled(32, 16, [0; 4]), Image::filled(32, 16, [0; 4]));
            halve_squares(&image, linear, &mut squares, encode);
            halve_areas(&image, linear, &mut areas, encode);
            assert_eq!(squares, areas);
        }
    }
}
