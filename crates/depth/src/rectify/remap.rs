use oaktwin_camera::math::DMat3;
use oaktwin_camera::{Camera, ImageSize, Intrinsics};
use oaktwin_image::{Image, ImageView};
use oaktwin_simd as simd;
use rayon::prelude::*;

use super::options::{EdgeFill, Method};
use super::positions::positions;
use super::rows::{Grey, Remap};

/// Fractional bits of a position.
const BITS: u32 = 5;

/// Rows that a thread takes at a time.
const ROWS: usize = 16;

/// Pixels around an image, so that the four that are mixed are always there: one before, two after.
const BEFORE: u32 = 1;
const AFTER: u32 = 2;

/// Raw images of one camera to rectified ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Rectify {
    raw: ImageSize,
    size: ImageSize,
    edge_fill: EdgeFill,
    /// Into the raw image with its borders: the upper left one of four pixels.
    places: Vec<u32>,
    /// 32nds of the way to the right one and to the lower one.
    parts: Vec<[u8; 2]>,
}

impl Rectify {
    /// Of a camera whose image is turned by a rotation and seen through other intrinsics, which say its size.
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

    /// Of the position in the raw image, in the [`OpenCv`](oaktwin_camera::OpenCv) convention, of each pixel of an image
    /// of `size`, row by row: a table of `cv2.initUndistortRectifyMap`. Where there is none, or no number, is outside.
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

    /// The size of the images it takes.
    #[must_use]
    pub fn raw_size(&self) -> ImageSize {
        self.raw
    }

    /// The size of the images it makes.
    #[must_use]
    pub fn size(&self) -> ImageSize {
        self.size
    }

    /// A rectified image; `None` where the raw one is not of [`Rectify::raw_size`].
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

/// A place along an axis, in the image with its borders, and 32nds of the way to the next. Anything beyond the borders
/// is in them.
fn around(at: f32, length: u32) -> [u32; 2] {
    let last = units(length);
    let at = if at.is_nan() { f32::NEG_INFINITY } else { at };
    // The place −1 is the first.
    split((units_of(at) + units(1)).clamp(0, last + units(1)))
}

/// The same, but never between a pixel and a border.
fn inside(at: f32, length: u32) -> [u32; 2] {
    let at = if at.is_nan() { 0.0 } else { at };
    split(units_of(at).clamp(0, units(length.saturating_sub(1))) + units(1))
}

/// 32nds, the nearest, halves to even.
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
