//! The colours of a Bayer mosaic.

use oaktwin_image::{Image, ImageView};
use rayon::prelude::*;

/// The number of units in a step of a recorded value: the weights of the interpolation are multiples of 1/16.
pub(super) const UNITS: u16 = 16;

/// Where a weight is, and the weight, in units. Sums are 16.
type Weights = &'static [([i64; 2], i32)];

/// Green at red or blue.
const GREEN: Weights = &[
    ([0, 0], 8),
    ([-1, 0], 4),
    ([1, 0], 4),
    ([0, -1], 4),
    ([0, 1], 4),
    ([-2, 0], -2),
    ([2, 0], -2),
    ([0, -2], -2),
    ([0, 2], -2),
];

/// Red or blue at green, whose own are in the same row.
const ALONG_ROW: Weights = &[
    ([0, 0], 10),
    ([-1, 0], 8),
    ([1, 0], 8),
    ([-2, 0], -2),
    ([2, 0], -2),
    ([-1, -1], -2),
    ([1, -1], -2),
    ([-1, 1], -2),
    ([1, 1], -2),
    ([0, -2], 1),
    ([0, 2], 1),
];

/// Red or blue at green, whose own are in the same column.
const ALONG_COLUMN: Weights = &[
    ([0, 0], 10),
    ([0, -1], 8),
    ([0, 1], 8),
    ([0, -2], -2),
    ([0, 2], -2),
    ([-1, -1], -2),
    ([1, -1], -2),
    ([-1, 1], -2),
    ([1, 1], -2),
    ([-2, 0], 1),
    ([2, 0], 1),
];

/// Red at blue, and blue at red.
const ACROSS: Weights = &[
    ([0, 0], 12),
    ([-1, -1], 4),
    ([1, -1], 4),
    ([-1, 1], 4),
    ([1, 1], 4),
    ([-2, 0], -3),
    ([2, 0], -3),
    ([0, -2], -3),
    ([0, 2], -3),
];

const OWN: Weights = &[([0, 0], 16)];

/// The weights of red, green and blue at (0, 0), (1, 0), (0, 1) and (1, 1): red and green, then green and blue.
const SITES: [[Weights; 3]; 4] = [
    [OWN, GREEN, ACROSS],
    [ALONG_ROW, OWN, ALONG_COLUMN],
    [ALONG_COLUMN, OWN, ALONG_ROW],
    [ACROSS, GREEN, OWN],
];

/// The channel of each of them.
const CHANNELS: [usize; 4] = [0, 1, 1, 2];

/// Returns the colours of recorded channels, of which each pixel uses one; in [`UNITS`].
pub(super) fn demosaic(recorded: &[Image<u16>; 3]) -> Image<[u16; 3]> {
    let [red, _, _] = recorded;
    let (width, height) = (red.width(), red.height());
    let mut raw = red.clone();
    let row_length = (width as usize).max(1);
    let site = |x: usize, y: usize| (x & 1) + 2 * (y & 1);
    for (y, row) in raw.pixels_mut().chunks_mut(row_length).enumerate() {
        for (x, value) in row.iter_mut().enumerate() {
            if let Some(own) = recorded[CHANNELS[site(x, y)]].pixels().get(y * row_length + x) {
                *value = *own;
            }
        }
    }
    let mut colors = Image::filled(width, height, [0u16; 3]);
    let rows = colors.pixels_mut().par_chunks_mut(row_length).enumerate();
    rows.for_each(|(y, row)| {
        // Five rows with two mirrored pixels at both ends.
        let around = [-2i64, -1, 0, 1, 2].map(|dy| padded(&raw, inside(y as i64 + dy, height)));
        for (x, color) in row.iter_mut().enumerate() {
            *color = SITES[site(x, y)].map(|weights| {
                let sum: i32 = (weights.iter())
                    .map(|([dx, dy], weight)| {
                        let (row, column) = ((dy + 2) as usize, x + (dx + 2) as usize);
                        i32::from(around[row][column]) * weight
                    })
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

/// Mirrors a place at the ends of `0..count`, so that its channel stays.
fn inside(at: i64, count: u32) -> i64 {
    let last = i64::from(count) - 1;
    let at = if at < 0 { -at } else { at };
    let at = if at > last { 2 * last - at } else { at };
    at.clamp(0, last.max(0))
}

fn padded(raw: &Image<u16>, y: i64) -> Vec<u16> {
    let row = u32::try_from(y)
        .ok()
        .and_then(|y| ImageView::from(raw).row(y as usize))
        .unwrap_or_default();
    let width = raw.width();
    (-2..i64::from(width) + 2)
        .map(|x| row.get(inside(x, width) as usize).copied().unwrap_or(0))
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
        let colors = demosaic(&[plane.clone(), plane.clone(), plane.clone()]);
        for y in 2..38 {
            for x in 2..58 {
                let expected = plane.get(x, y).unwrap() * UNITS;
                assert_eq!(colors.get(x, y), Some(&[expected; 3]), "{x} {y}");
            }
        }
        for (width, height) in [(1, 1), (2, 1), (1, 3), (3, 2), (5, 4)] {
            let grey = Image::filled(width, height, 500u16);
            let colors = demosaic(&[grey.clone(), grey.clone(), grey.clone()]);
            assert!(colors.pixels().iter().all(|color| *color == [8000; 3]));
        }
    }
}
