//! The colours of a Bayer mosaic.

use oaktwin_image::{Image, ImageView};
use rayon::prelude::*;

/// The number of units in a step of a recorded value: the weights of the interpolation are multiples of 1/16.
pub(super) const UNITS: u16 = 16;

/// The column and the row of a weight within 5 × 5 pixels, and the weight, in units. Sums are 16.
type Weights = &'static [([usize; 2], i32)];

/// Green at red or blue.
const GREEN: Weights = &[
    ([2, 2], 8),
    ([1, 2], 4),
    ([3, 2], 4),
    ([2, 1], 4),
    ([2, 3], 4),
    ([0, 2], -2),
    ([4, 2], -2),
    ([2, 0], -2),
    ([2, 4], -2),
];

/// Red or blue at green, whose own are in the same row.
const ALONG_ROW: Weights = &[
    ([2, 2], 10),
    ([1, 2], 8),
    ([3, 2], 8),
    ([0, 2], -2),
    ([4, 2], -2),
    ([1, 1], -2),
    ([3, 1], -2),
    ([1, 3], -2),
    ([3, 3], -2),
    ([2, 0], 1),
    ([2, 4], 1),
];

/// Red or blue at green, whose own are in the same column.
const ALONG_COLUMN: Weights = &[
    ([2, 2], 10),
    ([2, 1], 8),
    ([2, 3], 8),
    ([2, 0], -2),
    ([2, 4], -2),
    ([1, 1], -2),
    ([3, 1], -2),
    ([1, 3], -2),
    ([3, 3], -2),
    ([0, 2], 1),
    ([4, 2], 1),
];

/// Red at blue, and blue at red.
const ACROSS: Weights = &[
    ([2, 2], 12),
    ([1, 1], 4),
    ([3, 1], 4),
    ([1, 3], 4),
    ([3, 3], 4),
    ([0, 2], -3),
    ([4, 2], -3),
    ([2, 0], -3),
    ([2, 4], -3),
];

const OWN: Weights = &[([2, 2], 16)];

/// The weights of red, green and blue at (0, 0), (1, 0), (0, 1) and (1, 1): red and green, then green and blue.
const SITES: [[Weights; 3]; 4] = [
    [OWN, GREEN, ACROSS],
    [ALONG_ROW, OWN, ALONG_COLUMN],
    [ALONG_COLUMN, OWN, ALONG_ROW],
    [ACROSS, GREEN, OWN],
];

/// Returns the colours of a recorded mosaic, in [`UNITS`].
pub(super) fn demosaic(raw: &Image<u16>) -> Image<[u16; 3]> {
    let (width, height) = (raw.width(), raw.height());
    let row_length = (width as usize).max(1);
    let site = |x: usize, y: usize| (x & 1) + 2 * (y & 1);
    let mut colors = Image::filled(width, height, [0u16; 3]);
    let rows = colors.pixels_mut().par_chunks_mut(row_length).enumerate();
    rows.for_each(|(y, row)| {
        // Five rows with two mirrored pixels at both ends.
        let around = [0, 1, 2, 3, 4].map(|row| padded(raw, inside(y + row, height)));
        for (x, color) in row.iter_mut().enumerate() {
            *color = SITES[site(x, y)].map(|weights| {
                let sum: i32 = (weights.iter())
                    .map(|([column, row], weight)| i32::from(around[*row][x + column]) * weight)
                    .sum();
                u16::try_from(sum.clamp(0, i32::from(UNITS) * 1023)).unwrap_or(0)
            });
        }
    });
    colors
}

/// Returns the colours of recorded channels, in [`UNITS`].
pub(super) fn whole(recorded: &[Image<u16>; 3]) -> Image<[u16; 3]> {
    let [red, green, blue] = recorded;
    let mut colors = red.map(|red| [red * UNITS, 0, 0]);
    let others = green.pixels().iter().zip(blue.pixels());
    for (color, (green, blue)) in colors.pixels_mut().iter_mut().zip(others) {
        [color[1], color[2]] = [green * UNITS, blue * UNITS];
    }
    colors
}

/// Returns a place, which is counted from two before the first, mirrored at the ends of `count` places, so that its channel stays.
fn inside(from_two_before: usize, count: u32) -> usize {
    let last = (count as usize).saturating_sub(1);
    let at = from_two_before.abs_diff(2);
    let at = if at > last {
        (2 * last).saturating_sub(at)
    } else {
        at
    };
    at.min(last)
}

/// Returns a row with two mirrored pixels at both ends.
fn padded(raw: &Image<u16>, y: usize) -> Vec<u16> {
    let row = ImageView::from(raw).row(y).unwrap_or_default();
    (0..row.len() + 4)
        .map(|x| row.get(inside(x, raw.width())).copied().unwrap_or(0))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Light that changes evenly, alike in all channels, is found again: within the image exactly, because each set of weights is symmetric.
    #[test]
    fn keeps_even_slopes_and_greys_of_any_size() {
        let slope: Vec<u16> = (0..40u16)
            .flat_map(|y| (0..60).map(move |x| 100 + 7 * x + 3 * y))
            .collect();
        let plane = Image::new(60, 40, slope).unwrap();
        let colors = demosaic(&plane);
        for y in 2..38 {
            for x in 2..58 {
                let expected = plane.get(x, y).unwrap() * UNITS;
                assert_eq!(colors.get(x, y), Some(&[expected; 3]), "{x} {y}");
            }
        }
        for (width, height) in [(1, 1), (2, 1), (1, 3), (3, 2), (5, 4)] {
            let grey = Image::filled(width, height, 500u16);
            let colors = demosaic(&grey);
            assert!(colors.pixels().iter().all(|color| *color == [8000; 3]));
        }
    }
}
