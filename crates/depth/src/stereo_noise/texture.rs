//! The matcher's confidence, from a colour image.
//!
//! An estimate, as the device's own measure is not published: the mean absolute difference between the luma (0 to 255) of
//! pixels that are [`LAG_PX`] matcher pixels apart along the row, or of neighbours where that is larger, over the matching window, times
//! [`GAIN`], at most 255. Only texture along the row distinguishes disparities; neighbours count for patterns that repeat over the distance. `DepthAI`'s default threshold of 55 requires 0.76 grey levels: most of a plain face
//! is dropped, brick, wood and plaster are kept.
//!
//! The distance is in matcher pixels, so that an image of any width has about the same confidence. Where it is not a whole number of
//! image pixels, the difference is scaled by the square root of the ratio: between neighbours, and over two and four pixels, the
//! textures of a rendered room differ by about that. An image with s < 1 pixels for each of the matcher's averages fine texture, and has
//! s^0.75 times as much: with this, as many pixels of rendered rooms, tables and heaps lack texture at 320 and 640 as at 1280 px.
//!
//! Little light makes noise, in which texture is lost: a difference counts by the signal-to-noise ratio of its pixel, relative to
//! that in a bright room. The exposure becomes longer up to [`LONGEST`] times; then the electrons of a pixel
//! decrease with the light. Shot and read noise are as in [`crate::imager`].
//!
//! The dots of a projector add to the sum of a window: on a surface of luma Y at depth z, the centre of a dot of contrast c to the ambient
//! light is Y·(√(1 + c/z²) − 1) brighter, at most 255, with the square root as the response of a display, and the dots contribute
//! [`dots_of`] that, times [`DOTS_SEEN`], to the mean absolute difference. This is the mean over the pattern: a device matches along
//! paths, which carry the texture of dots to the surface between them.

use oaktwin_image::ImageView;
use oaktwin_simd::{self as simd, Kernel, Level};

use super::Parameters;
use super::window::{WindowSum, field_width};
use crate::imager;

/// Confidence per grey level.
pub(super) const GAIN: u32 = 72;

/// The distance along the row over which luma is compared, matcher px. With it and [`GAIN`], a rendered room has about as much texture in
/// images 320 as 1280 px wide, about as few pixels without texture as a matcher finds there (2.4 and 1.6 %; over a distance of 1 px and
/// with a gain of 128, 4.8 %), and a plain cupboard beside it loses most of its depth, as it does to the matcher (77 and 91 %).
pub(super) const LAG_PX: f64 = 4.0;

/// The side of the smallest window in image pixels, unless the matcher's own is smaller: fewer pixels are mostly noise.
const MIN_SIDE: usize = 5;

/// How confidence is measured in images of one width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TextureScale {
    /// The side of the window, image px.
    pub(super) side: usize,
    /// The distance over which luma is compared, image px.
    lag: usize,
    /// What the mean difference is multiplied by.
    factor: f64,
}

impl TextureScale {
    /// The scale for a matching window of `window_px` matcher pixels, which are `window` image pixels.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "of checked parameters; saturates"
    )]
    pub(super) fn new(window_px: u32, window: usize, image_px: f64, color_step: u32) -> Self {
        let wanted = LAG_PX * image_px;
        // Between interpolated colours, there is no texture of the scene.
        let step = f64::from(color_step.max(1));
        let lag = wanted.round().max(step);
        let detail = (image_px / step).min(1.0);
        Self {
            side: window.max(MIN_SIDE.min(window_px as usize)),
            lag: lag as usize,
            factor: (wanted / lag).sqrt() / (detail.sqrt() * detail.sqrt().sqrt()),
        }
    }

    fn area(&self) -> f64 {
        (self.side * self.side) as f64
    }

    /// The sum of a window whose mean difference over [`LAG_PX`] is `mean`.
    pub(super) fn sum(&self, mean: f64) -> f64 {
        self.area() * mean / self.factor
    }

    /// The smallest sum of a window, times [`GAIN`], with this confidence.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "positive; saturates"
    )]
    pub(super) fn least(&self, confidence: u8) -> u32 {
        self.sum(f64::from(confidence)).ceil() as u32
    }

    /// The confidence of a window with this sum, rounded down.
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between 0 and 255"
    )]
    pub(super) fn confidence(&self, sum: u32) -> u16 {
        let mean = f64::from(sum) * f64::from(GAIN) * self.factor / self.area();
        mean.min(255.0) as u16
    }
}

/// The differences of an image's rows in a window that slides down.
#[derive(Clone, Debug, Default)]
pub(super) struct Texture {
    window: WindowSum,
    luma: Vec<u16>,
    field: Vec<u16>,
}

impl Texture {
    pub(super) fn reset(&mut self, width: usize, scale: &TextureScale) {
        let columns = field_width(width, scale.side);
        self.window.reset(columns, scale.side);
        self.luma.resize(width, 0);
        self.field.resize(columns, 0);
    }

    /// Adds row `row` of the field: the image row half a window above, at the border the last one. Then computes the sums of
    /// the windows that end there.
    pub(super) fn slide(
        &mut self,
        level: Level,
        picture: &ImageView<'_, [u8; 4]>,
        row: usize,
        scale: &TextureScale,
        out: &mut [u32],
    ) {
        let (width, half) = (self.luma.len(), scale.side / 2);
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
                lag: scale.lag,
                out: inside,
            },
        );
        let (first, last) = (inside.first().copied(), inside.last().copied());
        self.field[..half].fill(first.unwrap_or(0));
        self.field[half + width..].fill(last.unwrap_or(0));
        simd::run_at(level, self.window.slide(&self.field, width, out));
    }
}

/// Scales the sums of the windows of row `y` by the share of the texture that noise does not hide, and adds the texture of a projector's
/// dots.
pub(super) fn light(
    level: Level,
    light: Option<&Light>,
    picture: &ImageView<'_, [u8; 4]>,
    depth: &ImageView<'_, f32>,
    y: usize,
    sums: &mut [u32],
) {
    let Some(light) = light else { return };
    let lit = Lit {
        light,
        pixels: picture.row(y).unwrap_or_default(),
        depth: depth.row(y).unwrap_or_default(),
        sums,
    };
    simd::run_at(level, lit);
}

/// The light in which a surface is seen, where it changes the texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Light {
    /// [`Parameters::ambient`](super::Parameters::ambient).
    ambient: f32,
    /// [`Parameters::dot_contrast`](super::Parameters::dot_contrast), and its ratio to the ambient light.
    dots: f32,
    contrast: f32,
    /// What dots add to the sum of a window for each grey level between a dot's centre and the surface.
    sum: f32,
    /// The largest sum of a window.
    largest: f32,
    /// The electrons of a white pixel, and the variance of its read noise.
    white: f32,
    read_variance: f32,
    /// How many times longer the exposure becomes.
    longest: f32,
}

/// Pixels in less than this ratio of ambient light to dots are not distinguished: the dots saturate the image.
const LARGEST_CONTRAST: f64 = 1e9;

impl Light {
    /// Returns the light of these parameters; `None` in a bright room without dots.
    #[expect(clippy::cast_possible_truncation, reason = "rows are single precision")]
    pub(super) fn new(p: &Parameters, scale: &TextureScale) -> Option<Self> {
        let imager = imager::Parameters::default();
        let longest = imager.max_exposure_time;
        if p.dot_contrast == 0.0 && p.ambient * longest >= 1.0 {
            return None;
        }
        let contrast = if p.dot_contrast > 0.0 {
            (p.dot_contrast / p.ambient).min(LARGEST_CONTRAST)
        } else {
            0.0
        };
        Some(Self {
            ambient: p.ambient as f32,
            dots: p.dot_contrast as f32,
            contrast: contrast as f32,
            sum: scale.sum(DOTS_SEEN * dots_of(p.stereo.focal_length_px)) as f32,
            largest: 255.0 * (scale.side * scale.side) as f32,
            white: imager.full_well_e as f32,
            read_variance: imager.read_noise_e.powi(2) as f32,
            longest: longest as f32,
        })
    }

    /// The signal-to-noise ratio in a light of `factor` times a bright room's, relative to that in a bright room, of a surface
    /// with these electrons there.
    #[inline(always)]
    fn clearness(&self, factor: f32, electrons: f32) -> f32 {
        let exposed = factor * self.longest;
        let share = if exposed < 1.0 { exposed } else { 1.0 };
        let noise = (electrons + self.read_variance) / (share * electrons + self.read_variance);
        share * noise.sqrt()
    }
}

/// The share of the texture of dots that counts: they are sparse, and the windows between them have none. With it, a grey wall is measured
/// about as far as [`crate::stereo_matching`] measures it with rendered dots: 2 m in a bright room, 5 m in a tenth of the light.
const DOTS_SEEN: f64 = 0.53;

/// The mean absolute difference over [`LAG_PX`], relative to the peak of a dot, of the pattern of an ams Belago 1.1
/// ([`crate::dots`]) near the axis, at a focal length in matcher pixels: a fit to the pattern within 8 % from 300 to 2400 px.
pub(super) fn dots_of(focal_length_px: f64) -> f64 {
    /// Twice the mean of the pattern: dots do not overlap themselves.
    const FAR: f64 = 0.046;
    /// Where the distance is about the width of a dot.
    const WIDTH_PX: f64 = 1600.0;
    FAR / (1.0 + (focal_length_px / WIDTH_PX).powi(3)).sqrt()
}

/// Computes the texture in the light for a row.
struct Lit<'a> {
    light: &'a Light,
    pixels: &'a [[u8; 4]],
    depth: &'a [f32],
    sums: &'a mut [u32],
}

impl Kernel for Lit<'_> {
    type Output = ();

    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        clippy::cast_sign_loss,
        reason = "between 0 and the largest sum of a window"
    )]
    fn run(self) {
        let light = *self.light;
        for ((sum, pixel), &z) in self.sums.iter_mut().zip(self.pixels).zip(self.depth) {
            let level = f32::from(luma(*pixel));
            let electrons = light.white * (level * level) / (255.0 * 255.0);
            let nearness = 1.0 / (z * z);
            let peak = level * ((1.0 + light.contrast * nearness).sqrt() - 1.0);
            let peak = if peak < 255.0 { peak } else { 255.0 };
            let dots = peak * light.sum * light.clearness(light.ambient + light.dots * nearness, electrons);
            // False for NaN.
            let is_surface = (z > 0.0) & (z < f32::INFINITY);
            let seen = *sum as i32 as f32 * light.clearness(light.ambient, electrons);
            let total = seen.floor() + if is_surface { dots } else { 0.0 };
            let bounded = if total < light.largest {
                total
            } else {
                light.largest
            };
            *sum = bounded as i32 as u32;
        }
    }
}

#[inline(always)]
fn luma([r, g, b, _]: [u8; 4]) -> u16 {
    (77 * u16::from(r) + 150 * u16::from(g) + 29 * u16::from(b)) >> 8
}

/// Computes the luma of a row and, at the pixel between those that are `lag` apart, the larger difference of theirs and of
/// neighbours; the first and last differences are repeated.
struct Differences<'a> {
    pixels: &'a [[u8; 4]],
    luma: &'a mut [u16],
    lag: usize,
    out: &'a mut [u16],
}

impl Kernel for Differences<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (out, pixel) in self.luma.iter_mut().zip(self.pixels) {
            *out = luma(*pixel);
        }
        let lag = self.lag.min(self.luma.len().saturating_sub(1));
        if lag == 0 {
            return self.out.fill(0);
        }
        let (before, apart) = (lag / 2, self.luma.get(lag..).unwrap_or_default());
        let Some(inside) = self.out.get_mut(before..) else {
            return;
        };
        let here = self.luma.get(before..).unwrap_or_default();
        let next = here.get(1..).unwrap_or_default();
        let pairs = self.luma.iter().zip(apart).zip(here.iter().zip(next));
        for (out, ((a, b), (here, next))) in inside.iter_mut().zip(pairs) {
            *out = a.abs_diff(*b).max(here.abs_diff(*next));
        }
        let end = before + apart.len();
        if let Some(&first) = self.out.get(before) {
            self.out[..before].fill(first);
        }
        if let Some(&last) = end.checked_sub(1).and_then(|last| self.out.get(last)) {
            self.out[end..].fill(last);
        }
    }
}
