//! The matcher's confidence, from a colour image.
//!
//! An estimate, as the device's own measure is not published: the mean absolute difference between the luma (0 to 255) of
//! a pixel and of the next pixel on its right over the matching window, times [`GAIN`], at most 255. Only texture along
//! the row distinguishes disparities. `DepthAI`'s default threshold of 55 requires 0.43 grey levels: a plain face is
//! dropped, brick and wood are kept.
//!
//! The dots of a projector add to the sum of a window: on a surface of luma Y at depth z, the centre of a dot of contrast c is
//! Y·(√(1 + c/z²) − 1) brighter, with the square root as the response of a display, and the dots contribute
//! [`DOTS_PER_PX`](super::scale::DOTS_PER_PX)/f of that to the mean absolute difference. This is the mean over the pattern: a device matches along
//! paths, which carry the texture of dots to the surface between them.

use oaktwin_image::ImageView;
use oaktwin_simd::{self as simd, Kernel, Level};

use super::scale::Scale;
use super::window::{WindowSum, field_width};

/// Confidence per grey level.
pub(super) const GAIN: u32 = 128;

/// The differences of an image's rows in a window that slides down.
#[derive(Clone, Debug, Default)]
pub(super) struct Texture {
    window: WindowSum,
    luma: Vec<u16>,
    field: Vec<u16>,
}

impl Texture {
    pub(super) fn reset(&mut self, width: usize, side: usize) {
        self.window.reset(field_width(width, side), side);
        self.luma.resize(width, 0);
        self.field.resize(field_width(width, side), 0);
    }

    /// Adds row `row` of the field: the image row half a window above, at the border the last one. Then computes the sums of
    /// the windows that end there.
    pub(super) fn slide(
        &mut self,
        level: Level,
        picture: &ImageView<'_, [u8; 4]>,
        row: usize,
        side: usize,
        out: &mut [u32],
    ) {
        let (width, half) = (self.luma.len(), side / 2);
        let last = (picture.height() as usize).saturating_sub(1);
        let y = row.saturating_sub(half).min(last);
        let Some(pixels) = picture.row(y) else {
            return;
        };
        let Some(inside) = self.field.get_mut(half..half + width) else {
            return;
        };
        simd::run_at(
            level,
            Differences {
                pixels,
                luma: &mut self.luma,
                out: inside,
            },
        );
        let (first, last) = (inside.first().copied(), inside.last().copied());
        self.field[..half].fill(first.unwrap_or(0));
        self.field[half + width..].fill(last.unwrap_or(0));
        simd::run_at(level, self.window.slide(&self.field, width, out));
    }
}

/// Adds the texture of a projector's dots, if it is on, to the sums of the windows of row `y`.
pub(super) fn add_dots(
    level: Level,
    scale: &Scale,
    picture: &ImageView<'_, [u8; 4]>,
    depth: &ImageView<'_, f32>,
    y: usize,
    sums: &mut [u32],
) {
    if scale.dot_contrast > 0.0 {
        let dotted = Dotted {
            scale,
            pixels: picture.row(y).unwrap_or_default(),
            depth: depth.row(y).unwrap_or_default(),
            sums,
        };
        simd::run_at(level, dotted);
    }
}

/// Computes that texture for a row.
struct Dotted<'a> {
    scale: &'a Scale,
    pixels: &'a [[u8; 4]],
    depth: &'a [f32],
    sums: &'a mut [u32],
}

impl Kernel for Dotted<'_> {
    type Output = ();

    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and the largest sum of a window"
    )]
    fn run(self) {
        let Scale {
            dot_contrast,
            dots,
            window,
            ..
        } = *self.scale;
        let largest = 255.0 * (window * window) as f32;
        for ((sum, pixel), &z) in self.sums.iter_mut().zip(self.pixels).zip(self.depth) {
            let peak = f32::from(luma(*pixel)) * ((1.0 + dot_contrast / (z * z)).sqrt() - 1.0);
            let added = peak * dots;
            let bounded = if added < largest { added } else { largest };
            // False for NaN.
            let is_surface = (z > 0.0) & (z < f32::INFINITY);
            *sum = (*sum + if is_surface { bounded } else { 0.0 } as i32 as u32).min(largest as i32 as u32);
        }
    }
}

#[inline(always)]
fn luma([r, g, b, _]: [u8; 4]) -> u16 {
    (77 * u16::from(r) + 150 * u16::from(g) + 29 * u16::from(b)) >> 8
}

/// Computes the luma of a row and its difference to the next pixel on the right; the last difference is repeated.
struct Differences<'a> {
    pixels: &'a [[u8; 4]],
    luma: &'a mut [u16],
    out: &'a mut [u16],
}

impl Kernel for Differences<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (out, pixel) in self.luma.iter_mut().zip(self.pixels) {
            *out = luma(*pixel);
        }
        let next = self.luma.get(1..).unwrap_or_default();
        for ((out, a), b) in self.out.iter_mut().zip(self.luma.iter()).zip(next) {
            *out = a.abs_diff(*b);
        }
        if let [.., before, last] = self.out {
            *last = *before;
        }
    }
}
