//! From linear light to sRGB bytes.

use std::sync::LazyLock;

use oaktwin_image::srgb::srgb_from_linear;
use oaktwin_simd::Lanes;

/// The value up to which the tone curve is the identity.
const SHOULDER: f32 = 0.6;

/// The number of buckets of the sRGB table. None contains two steps.
const BUCKETS: u16 = 16_384;

/// Maps exposed linear light to 0 to 1: the identity up to 0.6, then `0.6 + 0.4 t / (1 + t)` with `t = (x − 0.6) / 0.4`, which
/// continues with the same slope and never reaches 1. Most colours remain the scene's own, and highlights keep detail.
#[inline]
pub(super) fn tone(x: f32) -> f32 {
    // NaN becomes 0.
    let x = x.max(0.0);
    if x <= SHOULDER {
        return x;
    }
    let rest = 1.0 - SHOULDER;
    // This form also handles infinity.
    1.0 - rest / (1.0 + (x - SHOULDER) / rest)
}

/// Returns the light of a value that [`tone`] returned, at most 10⁶.
#[inline]
pub(super) fn untoned(y: f32) -> f32 {
    if y <= SHOULDER {
        return y;
    }
    let rest = 1.0 - SHOULDER;
    let most = 1e6;
    // `rest / (1 − y)` is 1 + (x − shoulder) / rest.
    (SHOULDER + rest * (rest / (1.0 - y) - 1.0)).min(most)
}

/// [`tone`] of numbers of at least 0.
#[inline(always)]
pub(super) fn tone_lanes<L: Lanes>(x: L) -> L {
    let (shoulder, one) = (L::splat(SHOULDER), L::splat(1.0));
    let rest = L::splat(1.0 - SHOULDER);
    let bright = one - rest / (one + (x - shoulder) / rest);
    L::select(x.le(shoulder), x, bright)
}

/// The sRGB value at the lower bound of each bucket, and the smallest linear value that rounds to the next one.
static TABLE: LazyLock<Vec<(f32, u8)>> = LazyLock::new(|| {
    let steps: Vec<f32> = (0..=255u8).map(step_after).collect();
    (0..=BUCKETS)
        .map(|i| srgb_from_linear(f32::from(i) / f32::from(BUCKETS)))
        .map(|low| (steps[usize::from(low)], low))
        .collect()
});

/// Returns the smallest linear value that rounds to the sRGB value after `low`.
fn step_after(low: u8) -> f32 {
    if low == u8::MAX {
        return f32::INFINITY;
    }
    // The bits of positive numbers are in the order of the numbers.
    let (mut below, mut step) = (0.0f32.to_bits(), 1.0f32.to_bits());
    while step - below > 1 {
        let middle = below.midpoint(step);
        if srgb_from_linear(f32::from_bits(middle)) > low {
            step = middle;
        } else {
            below = middle;
        }
    }
    f32::from_bits(step)
}

/// Encodes linear values of 0 to 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Encoder {
    table: &'static [(f32, u8)],
}

impl Encoder {
    pub(super) fn new() -> Self {
        Self { table: &TABLE }
    }

    /// Returns the nearest sRGB value; a faster [`srgb_from_linear`].
    #[inline]
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "clamped to the table"
    )]
    pub(super) fn srgb(self, linear: f32) -> u8 {
        let at = (linear * f32::from(BUCKETS)) as usize;
        match self.table.get(at) {
            Some((step, low)) => low + u8::from(linear >= *step),
            None => u8::MAX,
        }
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_simd::{LaneKernel, Level, run_lanes_at};

    use super::*;

    #[test]
    fn the_curve_is_smooth_and_bounded() {
        let step = 1e-3;
        let mut last = tone(0.0);
        assert_eq!(last, 0.0);
        for i in 1..20_000u16 {
            let x = f32::from(i) * step;
            let y = tone(x);
            assert!(y >= last && y < 1.0 && y - last < 1.001 * step);
            last = y;
        }
        assert_eq!(tone(0.5), 0.5);
        assert_eq!(tone(f32::INFINITY), 1.0);
        assert_eq!(tone(f32::NAN), 0.0);
        assert_eq!(tone(-1.0), 0.0);
    }

    #[test]
    fn light_is_found_again() {
        for x in [0.0, 0.3, 0.6, 0.61, 0.8, 1.5, 4.0, 40.0, 400.0] {
            assert!(
                (untoned(tone(x)) - x).abs() <= 1e-4 * x,
                "{x}: {}",
                untoned(tone(x))
            );
        }
        assert_eq!(untoned(1.0), 1e6);
    }

    #[test]
    fn lanes_have_the_same_curve() {
        struct Tones([f32; 8]);
        impl LaneKernel for Tones {
            type Output = [f32; 8];

            #[inline(always)]
            fn run<L: Lanes>(self) -> [f32; 8] {
                tone_lanes(L::load(&self.0)).to_array()
            }
        }
        let values = [0.0, 0.3, 0.6, 0.600_001, 0.9, 2.0, 1e9, f32::INFINITY];
        for level in Level::available() {
            assert_eq!(run_lanes_at(level, Tones(values)), values.map(tone));
        }
    }

    #[test]
    fn the_table_matches_the_formula() {
        let encoder = Encoder::new();
        for i in 0..=100_000u32 {
            let x = i as f32 / 99_000.0;
            assert_eq!(encoder.srgb(x), srgb_from_linear(x));
        }
        assert_eq!(
            [f32::NAN, -3.0, f32::INFINITY].map(|x| encoder.srgb(x)),
            [0, 0, 255]
        );
    }
}
