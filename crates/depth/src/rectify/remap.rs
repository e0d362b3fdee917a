use oaktwin_camera::math::DMat3;
use oaktwin_camera::{Camera, ImageSize, Intrinsics};
use oaktwin_image::{Image, ImageView};
use oaktwin_simd as simd;
use rayon::prelude::*;

use super::options::{EdgeFill, Method};
use super::positions::positions;
use super::rows::{Grey, Remap};

/// The fractional bits of a position.
const BITS: u32 = 5;

/// The number of rows in a unit of work.
const ROWS: usize = 16;

/// The border around an image, so that all four interpolated pixels exist: one pixel before, two after.
const BEFORE: u32 = 1;
const AFTER: u32 = 2;

/// Rectifies raw images of one camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Rectify {
    raw: ImageSize,
    size: ImageSize,
    edge_fill: EdgeFill,
    /// The index of the upper left of four pixels in the raw image with its border.
    places: Vec<u32>,
    /// The fractions to the right and to the lower pixel, in 1/32.
    parts: Vec<[u8; 2]>,
}

impl Rectify {
    /// Creates the rectification of a camera from its rotation and the target intrinsics, which determine the size.
    #[must_use]
    pub fn new(
        camera: &Camera,
        rectified_from_camera: DMat3,
        rectified: &Intrinsics,
        method: Method,
        edge_fill: EdgeFill,
    ) -> Self {
        let positions = positions(camera, rectified_from_camera, rectified, method);
        Self::from_positions(camera.intrinsics.size, rectified.size, &positions, edge_fill)
    }

    /// Creates it from the position in the raw image, in the [`OpenCv`](oaktwin_camera::OpenCv) convention, of each pixel of an image
    /// of `size`, row by row: a table of `cv2.initUndistortRectifyMap`. NaN is outside.
    #[must_use]
    pub fn from_positions(
        raw: ImageSize,
        size: ImageSize,
        positions: &[[f32; 2]],
        edge_fill: EdgeFill,
    ) -> Self {
        let stride = raw.width + BEFORE + AFTER;
        let found = positions.iter().copied().chain(std::iter::repeat([f32::NAN; 2]));
        let (places, parts) = found
            .take(size.width as usize * size.height as usize)
            .map(|[x, y]| {
                let ([column, right], [row, below]) = match edge_fill {
                    EdgeFill::Value(_) => (around(x, raw.width), around(y, raw.height)),
                    EdgeFill::Replicate => (inside(x, raw.width), inside(y, raw.height)),
                };
                #[expect(clippy::cast_possible_truncation, reason = "below 32")]
                let parts = [right as u8, below as u8];
                (row * stride + column, parts)
            })
            .unzip();
        Self {
            raw,
            size,
            edge_fill,
            places,
            parts,
        }
    }

    /// The size of raw images.
    #[must_use]
    pub fn raw_size(&self) -> ImageSize {
        self.raw
    }

    /// The size of rectified images.
    #[must_use]
    pub fn size(&self) -> ImageSize {
        self.size
    }

    /// Rectifies an image; `None` if its size is not [`Rectify::raw_size`].
    #[must_use]
    pub fn rectify<P: Grey>(&self, raw: ImageView<'_, P>) -> Option<Image<P>> {
        if (raw.width(), raw.height()) != (self.raw.width, self.raw.height) {
            return None;
        }
        let with_borders = self.with_borders(raw);
        let mut out = Image::filled(self.size.width, self.size.height, P::default());
        let band = (self.size.width as usize * ROWS).max(1);
        let stride = (self.raw.width + BEFORE + AFTER) as usize;
        out.pixels_mut()
            .par_chunks_mut(band)
            .zip(self.places.par_chunks(band).zip(self.parts.par_chunks(band)))
            .for_each(|(out, (places, parts))| {
                simd::run(Remap {
                    raw: &with_borders,
                    stride,
                    places,
                    parts,
                    out,
                });
            });
        Some(out)
    }

    fn with_borders<P: Grey>(&self, raw: ImageView<'_, P>) -> Vec<P> {
        let fill = match self.edge_fill {
            EdgeFill::Value(value) => P::from_u8(value),
            EdgeFill::Replicate => P::default(),
        };
        let stride = (self.raw.width + BEFORE + AFTER) as usize;
        let rows = (self.raw.height + BEFORE + AFTER) as usize;
        let mut out = vec![fill; stride * rows];
        let inner = out.chunks_exact_mut(stride).skip(BEFORE as usize);
        for (out, row) in inner.zip(raw.rows()) {
            out[BEFORE as usize..][..row.len()].copy_from_slice(row);
        }
        out
    }
}

/// The index along an axis of the image with its border, and the fraction to the next pixel in 1/32. Positions beyond the
/// border are clamped to it.
fn around(at: f32, length: u32) -> [u32; 2] {
    let last = units(length);
    let at = if at.is_nan() { f32::NEG_INFINITY } else { at };
    // Position −1 is the first index.
    split((units_of(at) + units(1)).clamp(0, last + units(1)))
}

/// The same, but never between a pixel and the border.
fn inside(at: f32, length: u32) -> [u32; 2] {
    let at = if at.is_nan() { 0.0 } else { at };
    split(units_of(at).clamp(0, units(length.saturating_sub(1))) + units(1))
}

/// The nearest 1/32; halves to even.
#[expect(clippy::cast_possible_truncation, reason = "saturates")]
fn units_of(at: f32) -> i64 {
    (at * 32.0).round_ties_even().clamp(-1e9, 1e9) as i64
}

fn units(pixels: u32) -> i64 {
    i64::from(pixels) << BITS
}

fn split(units: i64) -> [u32; 2] {
    let units = u32::try_from(units).unwrap_or(0);
    [units >> BITS, units & ((1 << BITS) - 1)]
}
