//! Mipmaps with anisotropic filtering.

use glam::{Vec2, Vec3A};
use oaktwin_image::Image;
use oaktwin_image::srgb::linear_from_srgb;
use oaktwin_scene::Wrap;
use rayon::prelude::*;

use super::tone::Encoder;

/// An image and its reductions by powers of two, down to one pixel.
#[derive(Debug)]
pub(crate) struct Pyramid {
    levels: Vec<Image<[u8; 4]>>,
    linear: &'static [f32; 256],
}

/// The maximum number of samples along the longer axis of a pixel's footprint.
const MAX_PROBES: f32 = 4.0;

/// The values of data textures: 0 to 1 in equal steps.
static RAW: [f32; 256] = {
    let mut values = [0.0; 256];
    let mut i = 0;
    while i < 256 {
        values[i] = i as f32 / 255.0;
        i += 1;
    }
    values
};

/// The wrap modes of a texture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wraps {
    pub(super) s: Wrap,
    pub(super) t: Wrap,
}

impl Pyramid {
    /// Creates a pyramid from an image of sRGB colours or of data.
    pub(super) fn new(image: Image<[u8; 4]>, is_srgb: bool) -> Self {
        let linear = if is_srgb { linear_from_srgb() } else { &RAW };
        let mut levels = vec![image];
        while let Some(last) = levels.last()
            && (last.width() > 1 || last.height() > 1)
        {
            let next = halved(last, linear, is_srgb);
            levels.push(next);
        }
        Self { levels, linear }
    }

    /// Filters over the parallelogram of `across` and `down` around `at`, in texture coordinates: (0, 0) at the lower left,
    /// (1, 1) at the upper right.
    pub(super) fn filtered(&self, at: Vec2, across: Vec2, down: Vec2, wraps: Wraps) -> [f32; 3] {
        let Some(base) = self.levels.first() else {
            return [0.0; 3];
        };
        #[expect(clippy::cast_precision_loss, reason = "a texture has fewer than 2^24 columns")]
        let size = Vec2::new(base.width() as f32, base.height() as f32);
        let (a, b) = (across * size, down * size);
        let (a_length, b_length) = (a.length(), b.length());
        let (major, long, short) = if a_length >= b_length {
            (across, a_length, b_length)
        } else {
            (down, b_length, a_length)
        };
        if !(at.is_finite() && long.is_finite()) {
            return [0.0; 3];
        }
        let short = short.max(long / MAX_PROBES).max(1.0);
        let lod = log2(short);
        // Rounded: half a probe makes no visible difference.
        let mut probes = 1.0;
        while probes < MAX_PROBES && probes + 0.5 < long / short {
            probes += 1.0;
        }
        if probes <= 1.0 {
            return self.trilinear(at, lod, wraps).to_array();
        }
        let mut sum = Vec3A::ZERO;
        let mut probe = 0.5;
        while probe < probes {
            sum += self.trilinear(at + major * (probe / probes - 0.5), lod, wraps);
            probe += 1.0;
        }
        (sum / probes).to_array()
    }

    /// Returns the mean of the image.
    pub(super) fn mean(&self) -> [f32; 3] {
        let pixel = self.levels.last().and_then(|level| level.pixels().first());
        pixel.map_or([0.0; 3], |[r, g, b, _]| {
            [r, g, b].map(|value| self.linear[usize::from(*value)])
        })
    }

    /// Interpolates between two levels.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "clamped to the levels"
    )]
    #[inline]
    fn trilinear(&self, at: Vec2, lod: f32, wraps: Wraps) -> Vec3A {
        let last = self.levels.len() - 1;
        let lod = lod.clamp(0.0, last as f32);
        let (level, part) = (lod as usize, lod.fract());
        let fine = self.bilinear(level, at, wraps);
        // A difference of less than half an sRGB step is invisible.
        if part < 1e-3 || level == last {
            return fine;
        }
        let coarse = self.bilinear(level + 1, at, wraps);
        fine + (coarse - fine) * part
    }

    /// Interpolates between four pixels of a level.
    #[expect(clippy::cast_precision_loss, reason = "a texture has fewer than 2^24 columns")]
    #[inline]
    fn bilinear(&self, level: usize, at: Vec2, wraps: Wraps) -> Vec3A {
        let image = &self.levels[level];
        let (width, height) = (image.width(), image.height());
        let x = at.x * width as f32 - 0.5;
        let y = (1.0 - at.y) * height as f32 - 0.5;
        let (left, top) = (floor(x), floor(y));
        let (right_part, lower_part) = (x - left as f32, y - top as f32);
        let pixels = image.pixels();
        let inside = |at: i64, count: u32| at >= 0 && at + 1 < i64::from(count);
        let square = if inside(left, width) && inside(top, height) {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "inside the image"
            )]
            let first = top as usize * width as usize + left as usize;
            let row = |first: usize| pixels.get(first..first + 2).and_then(|row| row.first_chunk());
            row(first)
                .zip(row(first + width as usize))
                .map(|(a, b): (&[_; 2], &[_; 2])| [*a, *b])
        } else {
            None
        };
        let square = square.unwrap_or_else(|| across_border(image, [left, top], wraps));
        let [[a, b], [c, d]] = square;
        let (a, b, c, d) = (self.linear(a), self.linear(b), self.linear(c), self.linear(d));
        let upper = a + (b - a) * right_part;
        let lower = c + (d - c) * right_part;
        upper + (lower - upper) * lower_part
    }

    #[inline]
    fn linear(&self, [r, g, b, _]: [u8; 4]) -> Vec3A {
        let of = self.linear;
        Vec3A::new(of[usize::from(r)], of[usize::from(g)], of[usize::from(b)])
    }
}

/// Returns a square of four pixels, some of which may lie beyond the border.
#[cold]
fn across_border(image: &Image<[u8; 4]>, [left, top]: [i64; 2], wraps: Wraps) -> [[[u8; 4]; 2]; 2] {
    let (width, height) = (image.width(), image.height());
    [top, top + 1].map(|y| {
        [left, left + 1].map(|x| {
            let place = wrapped(x, width, wraps.s).zip(wrapped(y, height, wraps.t));
            place
                .and_then(|(x, y)| image.get(x, y))
                .copied()
                .unwrap_or_default()
        })
    })
}

/// Rounds down; the result is arbitrary far beyond the size of a texture.
#[inline]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_precision_loss,
    reason = "a texture's coordinates"
)]
fn floor(x: f32) -> i64 {
    let whole = x as i32;
    i64::from(whole) - i64::from(whole as f32 > x)
}

/// Applies a wrap mode to a coordinate; `None` for black.
#[inline]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "inside the image by then"
)]
fn wrapped(at: i64, count: u32, wrap: Wrap) -> Option<u32> {
    let n = i64::from(count);
    if (0..n).contains(&at) {
        return Some(at as u32);
    }
    let at = match wrap {
        Wrap::Repeat => at.rem_euclid(n),
        Wrap::Clamp => at.clamp(0, n - 1),
        Wrap::Mirror => {
            let at = at.rem_euclid(2 * n);
            at.min(2 * n - 1 - at)
        }
        Wrap::Black => return None,
    };
    Some(at as u32)
}

/// Returns the binary logarithm of a number of at least 1, exact at powers of two and linear between them.
#[expect(clippy::cast_precision_loss, reason = "an exponent")]
fn log2(x: f32) -> f32 {
    let bits = x.to_bits();
    let exponent = (bits >> 23) as f32 - 127.0;
    let mantissa = f32::from_bits(bits & 0x007F_FFFF | 0x3F80_0000);
    exponent + (mantissa - 1.0)
}

/// Returns an image of half the size, at least one pixel, by averaging in linear light.
fn halved(image: &Image<[u8; 4]>, linear: &[f32; 256], is_srgb: bool) -> Image<[u8; 4]> {
    let encoder = Encoder::new();
    let (width, height) = (image.width().div_ceil(2), image.height().div_ceil(2));
    let mut half = Image::filled(width, height, [0, 0, 0, 255]);
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
            let [r, g, b] = sum.map(|value| encoded(value, is_srgb, encoder));
            *pixel = [r, g, b, 255];
        }
    });
    half
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

    const REPEAT: Wraps = Wraps {
        s: Wrap::Repeat,
        t: Wrap::Repeat,
    };

    fn numbered() -> Image<[u8; 4]> {
        // Columns in red, rows from the top in green.
        let pixels = (0..6u8).flat_map(|y| (0..8u8).map(move |x| [x * 30, y * 40, 7, 255]));
        Image::new(8, 6, pixels.collect()).unwrap()
    }

    fn bytes(color: [f32; 3]) -> [u8; 3] {
        color.map(|value| Encoder::new().srgb(value))
    }

    #[test]
    fn full_size_returns_the_texels() {
        let image = numbered();
        let pyramid = Pyramid::new(image.clone(), true);
        for y in 0..6u8 {
            for x in 0..8u8 {
                let at = Vec2::new((f32::from(x) + 0.5) / 8.0, 1.0 - (f32::from(y) + 0.5) / 6.0);
                let color =
                    pyramid.filtered(at, Vec2::new(1.0 / 8.0, 0.0), Vec2::new(0.0, 1.0 / 6.0), REPEAT);
                let [r, g, b, _] = *image.get(x.into(), y.into()).unwrap();
                assert_eq!(bytes(color), [r, g, b]);
            }
        }
    }

    #[test]
    fn distant_textures_are_averaged() {
        // Seven columns, which is not a multiple of two, alternately black and white.
        let pixels = (0..7 * 5).map(|i| if i % 7 % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] });
        let pyramid = Pyramid::new(Image::new(7, 5, pixels.collect()).unwrap(), true);
        let far = pyramid.filtered(Vec2::new(0.3, 0.3), Vec2::X * 2.0, Vec2::Y * 2.0, REPEAT);
        assert!((far[0] - 4.0 / 7.0).abs() < 0.01, "{far:?}");
        // At a grazing angle only one direction is filtered.
        let pixels = (0..64 * 64).map(|i| if i / 64 % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] });
        let stripes = Pyramid::new(Image::new(64, 64, pixels.collect()).unwrap(), true);
        let row = Vec2::new(0.5, 1.0 - 10.5 / 64.0);
        let along = stripes.filtered(
            row,
            Vec2::new(4.0 / 64.0, 0.0),
            Vec2::new(0.0, 1.0 / 64.0),
            REPEAT,
        );
        assert!(along[0] > 0.99, "{along:?}");
        let across = stripes.filtered(
            row,
            Vec2::new(0.0, 4.0 / 64.0),
            Vec2::new(1.0 / 64.0, 0.0),
            REPEAT,
        );
        assert!((across[0] - 0.5).abs() < 0.01, "{across:?}");
    }

    #[test]
    fn wrap_modes() {
        let at = |wrap, x| wrapped(x, 4, wrap);
        assert_eq!(
            [-1, 4, 9].map(|x| at(Wrap::Repeat, x)),
            [Some(3), Some(0), Some(1)]
        );
        assert_eq!(
            [-1, 4, 9].map(|x| at(Wrap::Mirror, x)),
            [Some(0), Some(3), Some(1)]
        );
        assert_eq!(
            [-9, 4, 9].map(|x| at(Wrap::Clamp, x)),
            [Some(0), Some(3), Some(3)]
        );
        assert_eq!([-1, 2, 4].map(|x| at(Wrap::Black, x)), [None, Some(2), None]);
    }

    #[test]
    fn non_finite_coordinates_give_finite_colours() {
        let pyramid = Pyramid::new(numbered(), false);
        for odd in [f32::NAN, f32::INFINITY, 1e30, -1e30] {
            for wraps in [
                REPEAT,
                Wraps {
                    s: Wrap::Mirror,
                    t: Wrap::Clamp,
                },
            ] {
                let color = pyramid.filtered(Vec2::splat(odd), Vec2::splat(odd), Vec2::ZERO, wraps);
                assert!(color.iter().all(|value| value.is_finite()), "{odd}");
                let color = pyramid.filtered(Vec2::splat(0.5), Vec2::splat(odd), Vec2::ZERO, wraps);
                assert!(color.iter().all(|value| value.is_finite()), "{odd}");
            }
        }
    }

    #[test]
    fn logarithms() {
        assert_eq!([1.0, 2.0, 3.0, 1024.0].map(log2), [0.0, 1.0, 1.5, 10.0]);
    }
}
