//! The median of what is not sure: [`AdaptiveMedian`](super::AdaptiveMedian).

use rayon::prelude::*;

use super::{BAND, DISPARITY, around, three};
use crate::simd::{self, Kernel, Level};

/// Filters what is less sure than `threshold`; `before` is what `disparity` is.
pub(super) fn run(
    level: Level,
    threshold: u8,
    width: usize,
    before: &[u16],
    disparity: &mut [u16],
    confidence: &[u8],
) {
    let bands = disparity
        .par_chunks_mut(BAND * width)
        .zip(confidence.par_chunks(BAND * width))
        .enumerate();
    bands.for_each(|(band, (disparity, confidence))| {
        let rows = disparity
            .chunks_exact_mut(width)
            .zip(confidence.chunks_exact(width));
        let mut medians = vec![0; width];
        for (y, (disparity, confidence)) in (band * BAND..).zip(rows) {
            // Often a row has nothing that is not sure.
            if confidence.iter().all(|&sure| sure >= threshold) {
                continue;
            }
            let Some(rows) = three(before, width, y) else {
                return;
            };
            simd::run_at(
                level,
                Medians {
                    rows,
                    out: &mut medians,
                },
            );
            for ((own, &sure), &median) in disparity.iter_mut().zip(confidence).zip(&medians) {
                if sure < threshold {
                    *own = (*own & !DISPARITY) | median;
                }
            }
        }
    });
}

/// Of a row; 0 stays 0.
struct Medians<'a> {
    rows: [&'a [u16]; 3],
    out: &'a mut [u16],
}

impl Kernel for Medians<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        around(self.rows, self.out, |near, out| {
            let own = near[4] & DISPARITY;
            let mut values = near.map(|value| {
                let value = value & DISPARITY;
                if value == 0 { own } else { value }
            });
            *out = median(&mut values);
        });
    }
}

/// The fifth of nine, by the fewest exchanges that find it.
#[inline(always)]
fn median(values: &mut [u16; 9]) -> u16 {
    let mut sort = |a: usize, b: usize| {
        let (low, high) = (values[a].min(values[b]), values[a].max(values[b]));
        (values[a], values[b]) = (low, high);
    };
    for column in [0, 3, 6] {
        sort(column + 1, column + 2);
        sort(column, column + 1);
        sort(column + 1, column + 2);
    }
    // Of the least the largest, of the middle ones the middle, of the largest the least.
    sort(0, 3);
    sort(3, 6);
    sort(4, 7);
    sort(1, 4);
    sort(4, 7);
    sort(5, 8);
    sort(2, 5);
    // And the middle of these three.
    sort(2, 4);
    sort(4, 6);
    sort(2, 4);
    values[4]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_median_is_the_fifth(values in any::<[u16; 9]>()) {
            let mut sorted = values;
            sorted.sort_unstable();
            prop_assert_eq!(super::median(&mut values.clone()), sorted[4]);
        }
    }
}
