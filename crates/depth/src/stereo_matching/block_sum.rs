//! Sums of costs over blocks of pixels, in the narrowest integers that hold them, and their means.

use oaktwin_simd as simd;

/// The sums over the block's rows, candidates innermost, in the width that the matcher needs.
#[derive(Clone, Debug, Default)]
pub(super) struct Columns {
    bytes: Vec<u8>,
    words: Vec<u16>,
    equations: Vec<u32>,
}

/// The mean of a block: its sum times the reciprocal of its area, exact for all possible sums.
#[derive(Clone, Copy, Debug)]
pub(super) struct Mean {
    area: u32,
    /// The reciprocal for 8-bit sums, in units of 2⁻¹¹.
    of_bytes: u16,
    /// The reciprocal for wider sums, in units of 2⁻²⁰.
    of_words: u32,
}

impl Mean {
    #[inline(always)]
    pub(super) fn new(area: u32) -> Self {
        #[expect(clippy::cast_possible_truncation, reason = "at most 2048")]
        let of_bytes = (1u32 << 11).div_ceil(area) as u16;
        Self {
            area,
            of_bytes,
            of_words: (1u32 << 20).div_ceil(area),
        }
    }
}

/// A sum over a block: of bits that differ, or of the complete equation.
pub(super) trait BlockSum: Copy + Default {
    /// Whether this is a sum of the complete equation.
    const IS_EQUATION: bool = size_of::<Self>() == size_of::<u32>();

    fn of_columns(columns: &mut Columns) -> &mut Vec<Self>;
    fn of(value: u32) -> Self;
    fn plus(self, other: Self) -> Self;
    fn minus(self, other: Self) -> Self;
    /// Returns an eighth of the equation's mean, halves up.
    fn mean(self, mean: &Mean) -> u16;
}

macro_rules! sum {
    ($sum:ty, $columns:ident, $mean:expr) => {
        impl BlockSum for $sum {
            fn of_columns(columns: &mut Columns) -> &mut Vec<Self> {
                &mut columns.$columns
            }

            #[inline(always)]
            #[expect(clippy::allow_attributes, reason = "one of the three is no cast")]
            #[allow(clippy::cast_possible_truncation, reason = "known to fit")]
            fn of(value: u32) -> Self {
                value as Self
            }

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self.wrapping_add(other)
            }

            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self.wrapping_sub(other)
            }

            #[inline(always)]
            #[expect(clippy::cast_possible_truncation, reason = "at most 508")]
            fn mean(self, mean: &Mean) -> u16 {
                let mean_of: fn(Self, &Mean) -> _ = $mean;
                mean_of(self, mean) as u16
            }
        }
    };
}

// All in 16 bits: sums of 8-bit costs over at most 15 pixels, or 25.
sum!(u8, bytes, |sum, mean| {
    (2 * u16::from(sum) + mean.area as u16 / 2).wrapping_mul(mean.of_bytes) >> 11
});
sum!(u16, words, |sum, mean| {
    ((2 * u32::from(sum) + mean.area / 2) * mean.of_words) >> 20
});
sum!(u32, equations, |sum, mean| {
    let over = (sum + 4 * mean.area) as f32;
    simd::saturating_trunc(over / (8 * mean.area) as f32).cast_unsigned()
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reciprocals_are_exact() {
        let sides = [1, 3, 5, 7];
        for area in sides.iter().flat_map(|rows| sides.map(|columns| rows * columns)) {
            let mean = Mean::new(area);
            let exact = |sum: u32| (2 * sum + area / 2) / area;
            for sum in 0..=8 * area {
                let of_bytes = || u32::from(u8::try_from(sum).unwrap().mean(&mean));
                assert!(
                    !matches!(area, 0..=15 | 25) || of_bytes() == exact(sum),
                    "{sum} / {area}"
                );
            }
            for sum in 0..=64 * area {
                assert_eq!(u32::from(u16::try_from(sum).unwrap().mean(&mean)), exact(sum));
            }
        }
    }
}
