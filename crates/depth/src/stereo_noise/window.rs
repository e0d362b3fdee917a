//! Exact sums over a square window that slides down an image of small integers.

use oaktwin_simd::Kernel;

/// The last `side` rows of a field, which is `side − 1` columns wider than the image, and the sums of their columns.
#[derive(Clone, Debug, Default)]
pub(super) struct WindowSum {
    side: usize,
    rows: Vec<u16>,
    next: usize,
    columns: Vec<u16>,
}

/// The largest side: the sum of a column of bytes fits 16 bits.
pub(super) const MAX_SIDE: usize = 255;

impl WindowSum {
    /// Clears the window, for a field of `width` columns. The numbers of the field must fit `u16 / side`.
    pub(super) fn reset(&mut self, width: usize, side: usize) {
        self.side = side;
        self.next = 0;
        self.rows.clear();
        self.rows.resize(width * side, 0);
        self.columns.clear();
        self.columns.resize(width, 0);
    }

    /// Adds the next rows of the field, which leave `side` rows later. After each row writes `stride` sums: for pixel x the
    /// sum of the columns x to x + side − 1. An empty `out` gets no sums.
    pub(super) fn slide<'a>(&'a mut self, field: &'a [u16], stride: usize, out: &'a mut [u32]) -> Slide<'a> {
        Slide {
            window: self,
            field,
            stride,
            out,
        }
    }
}

/// The columns of the field in the windows of an image.
pub(super) fn field_width(width: usize, side: usize) -> usize {
    width + side - 1
}

/// Adds and removes rows, and sums columns to windows.
pub(super) struct Slide<'a> {
    window: &'a mut WindowSum,
    field: &'a [u16],
    stride: usize,
    out: &'a mut [u32],
}

impl Kernel for Slide<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let WindowSum {
            side,
            rows,
            next,
            columns,
        } = self.window;
        let mut outs = self.out.chunks_exact_mut(self.stride);
        for row in self.field.chunks_exact(columns.len()) {
            let out = outs.next().unwrap_or_default();
            if *side == 1 {
                for (out, &number) in out.iter_mut().zip(row) {
                    *out = u32::from(number);
                }
                continue;
            }
            let old = rows.get_mut(*next * columns.len()..).unwrap_or_default();
            *next = (*next + 1) % *side;
            for ((sum, old), &new) in columns.iter_mut().zip(old).zip(row) {
                *sum = sum.wrapping_add(new).wrapping_sub(*old);
                *old = new;
            }
            sum_along(columns, *side, out);
        }
    }
}

/// Processes blocks as wide as possible; rows are multiples of 16.
#[inline(always)]
fn sum_along(columns: &[u16], side: usize, out: &mut [u32]) {
    let (wide, rest) = out.as_chunks_mut::<64>();
    let (narrow, last) = rest.as_chunks_mut::<16>();
    let mut start = 0;
    for block in wide {
        sum_block(columns, start, side, block);
        start += 64;
    }
    for block in narrow {
        sum_block(columns, start, side, block);
        start += 16;
    }
    for (x, out) in last.iter_mut().enumerate() {
        let window = columns.get(start + x..).unwrap_or_default();
        *out = window.iter().take(side).map(|&column| u32::from(column)).sum();
    }
}

/// Processes a block whose sums stay in registers.
#[inline(always)]
fn sum_block<const N: usize>(columns: &[u16], start: usize, side: usize, out: &mut [u32; N]) {
    let mut sums = [0u32; N];
    for first in start..start + side {
        let Some(columns) = columns.get(first..first + N) else {
            break;
        };
        for (sum, &column) in sums.iter_mut().zip(columns) {
            *sum = sum.wrapping_add(u32::from(column));
        }
    }
    *out = sums;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::philox4x32_10;
    use oaktwin_simd::{self as simd, Level};
    use proptest::prelude::*;

    #[expect(clippy::cast_possible_truncation, reason = "small numbers")]
    fn random_byte(seed: u32, row: usize, column: usize) -> u16 {
        u16::from(philox4x32_10([row as u32, column as u32, 0, 0], [seed, 0])[0].to_le_bytes()[0])
    }

    proptest! {
        #[test]
        fn sums_are_exact(
            (width, side) in (1usize..200, 1usize..20),
            seed: u32,
        ) {
            let columns = field_width(width, side);
            let rows: Vec<Vec<u16>> =
                (0..side + 5).map(|row| (0..columns).map(|column| random_byte(seed, row, column)).collect()).collect();
            for level in Level::available() {
                let mut window = WindowSum::default();
                window.reset(columns, side);
                for (y, row) in rows.iter().enumerate() {
                    let mut out = vec![0; width];
                    simd::run_at(level, window.slide(row, width, &mut out));
                    if y + 1 < side {
                        continue;
                    }
                    for (x, &sum) in out.iter().enumerate() {
                        let expected: u32 = rows[y + 1 - side..=y]
                            .iter()
                            .flat_map(|row| &row[x..x + side])
                            .map(|&value| u32::from(value))
                            .sum();
                        prop_assert_eq!(sum, expected);
                    }
                }
            }
        }
    }
}
