//! Images that are too large for the memory, read at a fraction of their size.

mod areas;
mod exr;
mod jpeg;
mod png;
mod rows;

use oaktwin_files::memory::{self as memory, Shortage};

pub(crate) use self::exr::decode as decode_exr;
use crate::srgb::{linear_from_data, linear_from_srgb, srgb_from_linear};
use crate::{CodecError, Image};

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
pub(crate) struct Reduced<P> {
    pub(crate) image: Image<P>,
    /// The width and height in the file.
    pub(crate) full_size: (u32, u32),
    /// The memory that the full size needs.
    pub(crate) shortage: Shortage,
}

/// Reads a PNG or JPEG image if its full size does not fit into the memory: at the largest size, divided by a power of two, that
/// does. `None` if it fits, and for other formats.
///
/// `per_pixel` is the number of bytes that a pixel of the result needs in total.
///
/// # Errors
/// Returns an error if the file is damaged, or the decoder does not fit.
pub(crate) fn decode(
    bytes: &[u8],
    per_pixel: u64,
    average: Average,
) -> Result<Option<Reduced<[u8; 4]>>, CodecError> {
    if bytes.starts_with(&[0xFF, 0xD8]) {
        return jpeg::decode(bytes, per_pixel, average);
    }
    png::decode(bytes, per_pixel, average)
}

/// Returns the smallest power of two by which an image has to be divided to fit, given a pixel's bytes in the result and
/// the bytes of everything else for a divisor.
fn divisor(size: (u64, u64), per_pixel: u64, other: impl Fn(u32) -> u64) -> Option<u32> {
    let fits = |divisor: u32| {
        let pixels = size.0.div_ceil(divisor.into()) * size.1.div_ceil(divisor.into());
        memory::check((pixels * per_pixel).saturating_add(other(divisor))).is_ok()
    };
    (1..32).map(|power| 1 << power).find(|divisor| fits(*divisor))
}

impl Average {
    /// Returns the values, 0 to 1, of the samples of a colour.
    fn values(self) -> [f32; 256] {
        match self {
            Self::Srgb => *linear_from_srgb(),
            Self::Raw => *linear_from_data(),
        }
    }

    /// Converts the mean of a pixel back to samples.
    fn encode(self, [r, g, b, a]: [f32; 4]) -> [u8; 4] {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "casts of floats saturate"
        )]
        let raw = |value: f32| (value * 255.0 + 0.5) as u8;
        let encode = match self {
            Self::Srgb => srgb_from_linear,
            Self::Raw => raw,
        };
        [encode(r), encode(g), encode(b), raw(a)]
    }
}

/// Returns the values of a pixel's samples: grey or colours, with or without alpha.
fn values(of_color: &[f32; 256], samples: &[u8]) -> [f32; 4] {
    let rgba = match *samples {
        [grey] => [grey, grey, grey, 255],
        [grey, alpha] => [grey, grey, grey, alpha],
        [r, g, b] => [r, g, b, 255],
        [r, g, b, a] => [r, g, b, a],
        _ => [0; 4],
    };
    let [r, g, b, a] = rgba.map(usize::from);
    [of_color[r], of_color[g], of_color[b], linear_from_data()[a]]
}

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

    /// Returns the mean over the area of a pixel of the result, by sampling 60 × 60 points of it.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
    pub(super) fn mean(full: &Image<[u8; 4]>, size: (u32, u32), at: (u32, u32), average: Average) -> [u8; 4] {
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

    /// Compares an image with the means of the areas of its pixels in `full`.
    pub(super) fn assert_means(
        reduced: &Image<[u8; 4]>,
        full: &Image<[u8; 4]>,
        divisor: u32,
        average: Average,
        tolerance: u8,
    ) {
        let size = (full.width().div_ceil(divisor), full.height().div_ceil(divisor));
        assert_eq!((reduced.width(), reduced.height()), size);
        for (x, y) in (0..size.1).flat_map(|y| (0..size.0).map(move |x| (x, y))) {
            let expected = mean(full, size, (x, y), average);
            let found = *reduced.get(x, y).unwrap();
            // Where the areas have fractions of pixels, the points give approximate means.
            let is_near = found
                .iter()
                .zip(expected)
                .all(|(a, b)| a.abs_diff(b) <= tolerance);
            assert!(
                is_near,
                "{} × {} / {divisor} at {x}, {y}: {found:?}, not {expected:?}",
                full.width(),
                full.height()
            );
        }
    }

    /// Returns an image of reproducible noise.
    pub(super) fn noise(width: u32, height: u32) -> Image<[u8; 4]> {
        let mut random = 1u32;
        let mut next = || {
            random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (random >> 24) as u8
        };
        let pixels = (0..width * height).map(|_| [next(), next(), next(), next()]);
        Image::new(width, height, pixels.collect()).unwrap()
    }

    #[test]
    fn small_and_damaged_images_are_left_to_the_other_decoder() {
        let file = crate::png::encode(&Image::filled(4, 4, 1u8)).unwrap();
        assert!(decode(&file, 8, Average::Srgb).unwrap().is_none());
        assert!(decode(b"GIF89a", 8, Average::Srgb).unwrap().is_none());
        assert!(decode(b"\xFF\xD8 no JPEG", 8, Average::Srgb).unwrap().is_none());
    }
}
