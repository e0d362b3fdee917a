//! The median filter of pixels with a low confidence: [`AdaptiveMedian`](super::AdaptiveMedian).

use oaktwin_simd::{self as simd, Kernel, Level};

use super::{DISPARITY, around, each_row, three};
use crate::filter::{Network, Networks};

/// Filters the pixels with a confidence below `threshold`; `before` is a copy of `disparity`.
pub(super) fn run(
    level: Level,
    threshold: u8,
    width: usize,
    before: &[u16],
    disparity: &mut [u16],
    confidence: &[u8],
) {
    let medians = || vec![0; width];
    each_row(
        width,
        disparity,
        confidence,
        medians,
        |medians, y, disparity, confidence| {
            // Many rows have no pixel to filter.
            if confidence.iter().all(|&sure| sure >= threshold) {
                return;
            }
            let Some(rows) = three(before, width, y) else {
                return;
            };
            simd::run_at(level, Medians { rows, out: medians });
            for ((own, &sure), &median) in disparity.iter_mut().zip(confidence).zip(&*medians) {
                if sure < threshold {
                    *own = (*own & !DISPARITY) | median;
                }
            }
        },
    );
}

/// The medians of a row; 0 remains 0.
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
            let values = near.map(|value| {
                let value = value & DISPARITY;
                if value == 0 { own } else { value }
            });
            *out = median(values);
        });
    }
}

/// Returns the median of nine values.
#[inline(always)]
fn median(values: [u16; 9]) -> u16 {
    let (columns, _) = values.as_chunks::<3>();
    let mut square = [[[0; 1]; 3]; 3];
    for (sorted, column) in square.iter_mut().zip(columns) {
        *sorted = column.map(|value| [value]);
        Networks::sort(sorted);
    }
    // The network expects the smallest values of all columns first, then the middle and the largest ones.
    let [a, b, c] = square;
    let [median] = Networks::median([0, 1, 2].map(|i| [a[i], b[i], c[i]]));
    median
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn median_matches_sorting(values in any::<[u16; 9]>()) {
            let mut sorted = values;
            sorted.sort_unstable();
            prop_assert_eq!(super::median(values), sorted[4]);
        }
    }
}
