//! The steps for one row, as loops that are compiled for each instruction set.

use oaktwin_simd::Kernel;

use super::scale::Scale;
use crate::turns::sin_of_turns;

/// A disparity beyond every range: it is finite, and farther left than every image.
const LARGEST_PX: f32 = 8192.0;

/// 2²³: from here to 2²⁴, `float32` represents exactly the integers, in its lowest bits. Adding it rounds, halves to even.
const ONE_A_STEP: f32 = 8_388_608.0;

/// Converts depth to disparity in place. Invalid depth becomes a disparity of 0.
pub(super) struct Disparities<'a> {
    pub(super) px_m: f32,
    pub(super) depth: &'a mut [f32],
}

impl Kernel for Disparities<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for place in self.depth {
            let z = *place;
            let d = self.px_m / z;
            let finite = if d < LARGEST_PX { d } else { LARGEST_PX };
            // False for NaN.
            let surface = (z > 0.0) & (z < f32::INFINITY);
            *place = if surface { finite } else { 0.0 };
        }
    }
}

/// Drops pixels at random.
pub(super) struct Dropout<'a> {
    pub(super) limit: u32,
    /// The low and high bytes.
    pub(super) bytes: (&'a [u8], &'a [u8]),
    pub(super) disparities: &'a mut [f32],
}

impl Kernel for Dropout<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let (low, high) = self.bytes;
        for ((d, &low), &high) in self.disparities.iter_mut().zip(low).zip(high) {
            let number = u32::from(low) + 256 * u32::from(high);
            *d = if number < self.limit { 0.0 } else { *d };
        }
    }
}

/// Drops pixels whose window has too little texture.
pub(super) struct Textured<'a> {
    /// The minimum sum of a window.
    pub(super) least: u32,
    pub(super) gain: u32,
    pub(super) sums: &'a [u32],
    pub(super) disparities: &'a mut [f32],
}

impl Kernel for Textured<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (d, &sum) in self.disparities.iter_mut().zip(self.sums) {
            *d = if sum.wrapping_mul(self.gain) < self.least {
                0.0
            } else {
                *d
            };
        }
    }
}

/// Applies systematic error, jitter, quantization and range to disparities. A disparity of 0 is invalid.
pub(super) struct Measure<'a> {
    pub(super) scale: &'a Scale,
    /// Image pixels per matcher pixel if the left band is invalid, else 0.
    pub(super) band_px: f32,
    /// The column of each pixel.
    pub(super) columns: &'a [f32],
    pub(super) disparities: &'a [f32],
    /// The sums of random numbers in the window.
    pub(super) sums: &'a [u32],
    pub(super) out: &'a mut [u16],
}

impl Kernel for Measure<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        // Most devices have the same errors at close range, and need not compute the factor.
        if self.scale.close_change == 0.0 {
            self.measure::<false>();
        } else {
            self.measure::<true>();
        }
    }
}

impl Measure<'_> {
    #[inline(always)]
    #[expect(clippy::cast_possible_wrap, reason = "sums are below 2³¹, values fit 16 bits")]
    fn measure<const IS_CLOSER: bool>(self) {
        let s = self.scale;
        let beyond = s.max_fixed as i32 as f32 + 1.0;
        let pixels = self.columns.iter().zip(self.disparities).zip(self.sums);
        for (out, ((&x, &d), &sum)) in self.out.iter_mut().zip(pixels) {
            let factor = if IS_CLOSER {
                let close = (d - s.close_from) * s.close_per_px;
                let close = if close > 0.0 { close } else { 0.0 };
                let close = if close < 1.0 { close } else { 1.0 };
                1.0 + s.close_change * close
            } else {
                1.0
            };
            let biased = d + factor * s.bias;
            let locked = biased - factor * s.locking * sin_of_turns(biased);
            let jitter = (sum as i32 as f32 - s.jitter_mean) * (factor * s.jitter);
            let steps = (locked + jitter - s.shift) * s.steps;
            let positive = if steps > 0.0 { steps } else { 0.0 };
            let bounded = if positive < beyond { positive } else { beyond };
            let fixed = (bounded + ONE_A_STEP).to_bits() & 0xFFFF;
            let seen = (d > 0.0) & (x - d * self.band_px >= 0.0) & (fixed <= s.max_fixed);
            *out = if seen { fixed as u16 } else { 0 };
        }
    }
}
