//! Anisotropic texture filtering of eight places at a time.

use oaktwin_image::Image;
use oaktwin_scene::Wrap;
use oaktwin_simd::{I32Lanes, LaneKernel, Lanes};

/// The maximum number of samples along the longer axis of a pixel's footprint.
const MAX_PROBES: u8 = 4;

/// The wrap modes of a texture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wraps {
    pub(super) s: Wrap,
    pub(super) t: Wrap,
}

/// Eight places on a texture and the parallelograms around them, in texture coordinates: (0, 0) at the lower left, (1, 1) at
/// the upper right.
#[derive(Clone, Debug, Default)]
pub(super) struct Footprints {
    pub(super) at: [[f32; 8]; 2],
    pub(super) across: [[f32; 8]; 2],
    pub(super) down: [[f32; 8]; 2],
}

impl Footprints {
    /// Sets one of eight lanes.
    #[inline]
    pub(super) fn set(&mut self, lane: usize, at: [f32; 2], across: [f32; 2], down: [f32; 2]) {
        let lane = lane & 7;
        for (columns, value) in [
            (&mut self.at, at),
            (&mut self.across, across),
            (&mut self.down, down),
        ] {
            columns[0][lane] = value[0];
            columns[1][lane] = value[1];
        }
    }
}

/// Filters a texture over footprints. Lanes without a bit in `used` return 0, as do footprints that are not finite.
pub(super) struct TextureFilter<'a> {
    /// The image and its reductions.
    pub(super) levels: &'a [Image<[u8; 4]>],
    /// Whether the bytes are sRGB rather than data.
    pub(super) is_srgb: bool,
    pub(super) wraps: Wraps,
    pub(super) footprints: &'a Footprints,
    pub(super) used: u32,
}

impl LaneKernel for TextureFilter<'_> {
    type Output = [[f32; 8]; 3];

    #[inline(always)]
    fn run<L: Lanes>(self) -> Self::Output {
        let mut out = [[0.0; 8]; 3];
        let Some(base) = self.levels.first() else {
            return out;
        };
        let zero = L::splat(0.0);
        let shape = FootprintShape::<L>::new(self.footprints, base);
        let used = self.used & shape.is_sane.signs();
        let (fine, coarse, parts, mixed) = self.levels_of(shape.lod);
        let part = L::load(&parts);
        let mut sum = [zero; 3];
        for probe in 0..MAX_PROBES {
            let probe = L::splat(f32::from(probe));
            let is_active = probe.lt(shape.probes);
            let active = used & is_active.signs();
            if active == 0 {
                break;
            }
            let offset = (probe + L::splat(0.5)) / shape.probes - L::splat(0.5);
            let at = [
                shape.at[0] + shape.major[0] * offset,
                shape.at[1] + shape.major[1] * offset,
            ];
            let mut color = self.bilinear::<L>(&fine, active, at);
            if active & mixed != 0 {
                let coarse = self.bilinear::<L>(&coarse, active & mixed, at);
                for (color, coarse) in color.iter_mut().zip(coarse) {
                    *color = *color + (coarse - *color) * part;
                }
            }
            for (sum, color) in sum.iter_mut().zip(color) {
                *sum = L::select(is_active, *sum + color, *sum);
            }
        }
        for (sum, out) in sum.into_iter().zip(&mut out) {
            (sum / shape.probes).store(out);
            for (lane, value) in out.iter_mut().enumerate() {
                if (used >> lane) & 1 == 0 {
                    *value = 0.0;
                }
            }
        }
        out
    }
}

/// Footprints in pixels of the full image.
struct FootprintShape<L: Lanes> {
    at: [L; 2],
    /// The longer axis of the parallelogram, in texture coordinates.
    major: [L; 2],
    /// The number of samples along it.
    probes: L,
    /// The logarithm of the size of a sample.
    lod: L,
    is_sane: L::I32,
}

impl<L: Lanes> FootprintShape<L> {
    #[inline(always)]
    fn new(footprints: &Footprints, base: &Image<[u8; 4]>) -> Self {
        let (one, max) = (L::splat(1.0), L::splat(f32::MAX));
        #[expect(clippy::cast_precision_loss, reason = "a texture has fewer than 2^24 columns")]
        let size = [L::splat(base.width() as f32), L::splat(base.height() as f32)];
        let across = [L::load(&footprints.across[0]), L::load(&footprints.across[1])];
        let down = [L::load(&footprints.down[0]), L::load(&footprints.down[1])];
        let at = [L::load(&footprints.at[0]), L::load(&footprints.at[1])];
        let a = length([across[0] * size[0], across[1] * size[1]]);
        let b = length([down[0] * size[0], down[1] * size[1]]);
        let is_across = b.le(a);
        let long = L::select(is_across, a, b);
        let short = L::select(is_across, b, a)
            .max(long * L::splat(1.0 / f32::from(MAX_PROBES)))
            .max(one);
        // Rounded: half a probe makes no visible difference.
        let ratio = long / short;
        let mut probes = one;
        for probe in 1..MAX_PROBES {
            let is_longer = L::splat(f32::from(probe) + 0.5).lt(ratio);
            probes = L::select(is_longer, probes + one, probes);
        }
        let zero = L::splat(0.0);
        let reach = magnitude(at[0]).max(magnitude(at[1]));
        Self {
            at,
            major: [
                L::select(is_across, across[0], down[0]),
                L::select(is_across, across[1], down[1]),
            ],
            probes,
            lod: log2(short),
            // NaN compares as false; the product is NaN if one of the coordinates is.
            is_sane: long.le(max) & reach.le(max) & (at[0] * zero + at[1] * zero).le(zero),
        }
    }
}

impl TextureFilter<'_> {
    /// Returns the finer and the coarser level of each lane, the part of the coarser, and the lanes with two levels.
    #[inline(always)]
    fn levels_of<L: Lanes>(&self, lod: L) -> ([usize; 8], [usize; 8], [f32; 8], u32) {
        let last = self.levels.len() - 1;
        #[expect(clippy::cast_precision_loss, reason = "at most 32 levels")]
        let lod = lod.max(L::splat(0.0)).min(L::splat(last as f32)).to_array();
        let (mut fine, mut coarse, mut parts, mut mixed) = ([0; 8], [0; 8], [0.0; 8], 0);
        for lane in 0..8 {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                clippy::cast_precision_loss,
                reason = "clamped to the levels"
            )]
            {
                fine[lane] = lod[lane] as usize;
                parts[lane] = lod[lane] - fine[lane] as f32;
            }
            coarse[lane] = (fine[lane] + 1).min(last);
            // A difference of less than half an sRGB step is invisible.
            if parts[lane] < 1e-3 {
                parts[lane] = 0.0;
            } else {
                mixed |= 1 << lane;
            }
        }
        (fine, coarse, parts, mixed)
    }

    /// Interpolates between four pixels of a level for each of the lanes with a bit in `used`; the others are arbitrary.
    #[inline(always)]
    fn bilinear<L: Lanes>(&self, levels: &[usize; 8], used: u32, at: [L; 2]) -> [L; 3] {
        let (x, y, is_inside) = self.places::<L>(levels, at);
        let (left, top) = (floor(x), floor(y));
        let (right, lower) = (x - L::from_i32(left), y - L::from_i32(top));
        let (left, top) = (left.to_array(), top.to_array());
        // All pixels are requested before the first is needed.
        let mut texels = [[0u32; 8]; 4];
        for lane in 0..8 {
            if (used >> lane) & 1 == 0 {
                continue;
            }
            let image = &self.levels[levels[lane]];
            let corner = [left[lane], top[lane]];
            let square = if (is_inside >> lane) & 1 == 0 {
                across_border(image, corner, self.wraps)
            } else {
                square(image, corner)
            };
            for (texels, texel) in texels.iter_mut().zip(square) {
                texels[lane] = u32::from_le_bytes(texel);
            }
        }
        let [a, b, c, d] = &texels;
        let texels = [
            L::I32::load_unsigned(a),
            L::I32::load_unsigned(b),
            L::I32::load_unsigned(c),
            L::I32::load_unsigned(d),
        ];
        let mut color = [L::splat(0.0); 3];
        for (color, bits) in color.iter_mut().zip([0, 8, 16]) {
            let [a, b, c, d]: [L; 4] = [
                self.linear(texels[0], bits),
                self.linear(texels[1], bits),
                self.linear(texels[2], bits),
                self.linear(texels[3], bits),
            ];
            let upper = a + (b - a) * right;
            let lowest = c + (d - c) * right;
            *color = upper + (lowest - upper) * lower;
        }
        color
    }

    /// Returns the linear values, 0 to 1, of the bytes at a bit of eight pixels.
    #[inline(always)]
    fn linear<L: Lanes>(&self, texels: L::I32, bits: u32) -> L {
        let byte = L::from_i32(texels.shift_right(bits) & L::I32::splat(255));
        if self.is_srgb {
            linear_from_srgb_byte(byte)
        } else {
            byte * L::splat(1.0 / 255.0)
        }
    }

    /// Returns places in pixels of their levels, from the centre of the upper left pixel, and the lanes whose four pixels are
    /// inside the image.
    #[inline(always)]
    fn places<L: Lanes>(&self, levels: &[usize; 8], [u, v]: [L; 2]) -> (L, L, u32) {
        let mut sizes = [[0.0; 8]; 2];
        for (lane, level) in levels.iter().enumerate() {
            let image = &self.levels[*level];
            #[expect(clippy::cast_precision_loss, reason = "a texture has fewer than 2^24 columns")]
            {
                (sizes[0][lane], sizes[1][lane]) = (image.width() as f32, image.height() as f32);
            }
        }
        let (zero, half, one) = (L::splat(0.0), L::splat(0.5), L::splat(1.0));
        let (width, height) = (L::load(&sizes[0]), L::load(&sizes[1]));
        let x = bounded(folded(u, self.wraps.s) * width - half);
        let y = bounded((one - folded(v, self.wraps.t)) * height - half);
        let is_inside = zero.le(x) & x.lt(width - one) & zero.le(y) & y.lt(height - one);
        (x, y, is_inside.signs())
    }
}

/// The coefficients of the transfer function of sRGB for bytes above 10, fitted to its 245 values.
const SRGB: [f32; 5] = [
    0.001_063_643_5,
    0.028_079_675 / 255.0,
    0.561_962_7 / (255.0 * 255.0),
    0.523_846_15 / (255.0 * 255.0 * 255.0),
    -0.115_389_99 / (255.0 * 255.0 * 255.0 * 255.0),
];

/// Returns the linear values, 0 to 1, of sRGB bytes: within a sixteenth of the difference to the next byte, without a table.
#[inline(always)]
fn linear_from_srgb_byte<L: Lanes>(byte: L) -> L {
    let [a, b, c, d, e] = SRGB;
    let curve = L::splat(e) * byte + L::splat(d);
    let curve = curve * byte + L::splat(c);
    let curve = curve * byte + L::splat(b);
    let curve = curve * byte + L::splat(a);
    let line = byte * L::splat(1.0 / (12.92 * 255.0));
    L::select(byte.le(L::splat(10.0)), line, curve)
}

/// Returns the four pixels from a corner on, which are inside the image.
#[inline(always)]
#[expect(clippy::cast_sign_loss, reason = "inside the image")]
fn square(image: &Image<[u8; 4]>, [left, top]: [i32; 2]) -> [[u8; 4]; 4] {
    let width = image.width() as usize;
    let first = top as usize * width + left as usize;
    let pixels = image.pixels();
    match (
        pixels.get(first..first + 2),
        pixels.get(first + width..first + width + 2),
    ) {
        (Some([a, b]), Some([c, d])) => [*a, *b, *c, *d],
        _ => [[0; 4]; 4],
    }
}

/// Moves a coordinate into the image where the wrap mode repeats it.
#[inline(always)]
fn folded<L: Lanes>(u: L, wrap: Wrap) -> L {
    let one = L::splat(1.0);
    match wrap {
        Wrap::Repeat => u - L::from_i32(floor(bounded(u))),
        Wrap::Clamp => u.max(L::splat(0.0)).min(one),
        Wrap::Mirror => {
            let two = L::splat(2.0);
            let u = u - two * L::from_i32(floor(bounded(u * L::splat(0.5))));
            u.min(two - u)
        }
        Wrap::Black => u,
    }
}

/// Clamps to numbers that fit into 32 bits.
#[inline(always)]
fn bounded<L: Lanes>(x: L) -> L {
    x.max(L::splat(-1e9)).min(L::splat(1e9))
}

/// Rounds down numbers that fit into 32 bits.
#[inline(always)]
fn floor<L: Lanes>(x: L) -> L::I32 {
    let whole = x.trunc();
    // The mask is −1 where the truncated number is larger.
    whole + x.lt(L::from_i32(whole))
}

/// Returns a square of four pixels, some of which may lie beyond the border.
#[cold]
fn across_border(image: &Image<[u8; 4]>, [left, top]: [i32; 2], wraps: Wraps) -> [[u8; 4]; 4] {
    let (width, height) = (image.width(), image.height());
    let (left, top) = (i64::from(left), i64::from(top));
    [[left, top], [left + 1, top], [left, top + 1], [left + 1, top + 1]].map(|[x, y]| {
        let place = wraps.s.index(x, width).zip(wraps.t.index(y, height));
        place
            .and_then(|(x, y)| image.get(x, y))
            .copied()
            .unwrap_or_default()
    })
}

/// Returns the binary logarithm of a number of at least 1, exact at powers of two and linear between them.
#[inline(always)]
fn log2<L: Lanes>(x: L) -> L {
    let bits = x.to_bits();
    let exponent = L::from_i32(bits.shift_right(23)) - L::splat(127.0);
    let mantissa = (bits & L::I32::splat(0x007F_FFFF)) | L::I32::splat(0x3F80_0000);
    exponent + (L::from_bits(mantissa) - L::splat(1.0))
}

#[inline(always)]
fn length<L: Lanes>([x, y]: [L; 2]) -> L {
    (x * x + y * y).sqrt()
}

#[inline(always)]
fn magnitude<L: Lanes>(x: L) -> L {
    x.max(L::splat(0.0) - x)
}

#[cfg(test)]
mod tests;
