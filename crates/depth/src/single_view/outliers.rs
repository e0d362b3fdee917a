//! Lone pixels become what all their neighbours are.

use std::ops::Range;

use super::plan::Plan;

/// Columns of a word of bits.
const BITS: usize = 64;

/// Which pixels of some rows were measured: one bit each, rows in words of their own with one of zeros behind each, so
/// that all rows are looked at in one go.
#[derive(Debug, Default)]
pub(super) struct Validity {
    /// Words of a row.
    stride: usize,
    /// The first row.
    first: usize,
    /// From one word of zeros and as many rows of zeros as the range reaches on, with such rows behind.
    measured: Vec<u64>,
    missing: Vec<u64>,
    /// The lone ones of rows from `lone_first` on.
    lone_first: usize,
    lone_measured: Vec<u64>,
    lone_missing: Vec<u64>,
    sum: Vec<u64>,
}

/// The lone pixels of a row, one bit each.
#[derive(Debug)]
pub(super) struct Lone<'a> {
    pub(super) measured: &'a [u64],
    pub(super) missing: &'a [u64],
}

impl Validity {
    /// Forgets the image, and makes place for some rows.
    pub(super) fn reset(&mut self, plan: &Plan, rows: Range<usize>) {
        self.stride = plan.width.div_ceil(BITS) + 1;
        self.first = rows.start;
        let words = 1 + (rows.len() + 2 * plan.outlier_range) * self.stride;
        for bits in [&mut self.measured, &mut self.missing] {
            bits.clear();
            bits.resize(words, 0);
        }
    }

    /// Takes depths of row `y`: word `word` of its columns, of which so many are in the image.
    #[inline(always)]
    pub(super) fn set(&mut self, plan: &Plan, y: usize, word: usize, depths: &[f32; BITS], columns: usize) {
        let place = self.place(plan, y) + word;
        let measured = bits(depths);
        self.measured[place] = measured;
        self.missing[place] = !measured & (u64::MAX >> (BITS - columns));
    }

    /// Finds the lone pixels of some rows.
    #[inline(always)]
    pub(super) fn find(&mut self, plan: &Plan, rows: Range<usize>) {
        self.lone_first = rows.start;
        let start = self.place(plan, rows.start);
        let words = start..start + rows.len() * self.stride;
        for (all, lone) in [
            (&self.measured, &mut self.lone_measured),
            (&self.missing, &mut self.lone_missing),
        ] {
            find(plan, self.stride, all, words.clone(), &mut self.sum, lone);
        }
    }

    /// The lone pixels of row `y`, one of those that were asked for: words of 64 columns.
    #[inline(always)]
    pub(super) fn lone(&self, y: usize) -> Lone<'_> {
        let start = (y - self.lone_first) * self.stride;
        let words = start..start + self.stride - 1;
        Lone {
            measured: &self.lone_measured[words.clone()],
            missing: &self.lone_missing[words],
        }
    }

    /// The first word of row `y`.
    #[inline(always)]
    fn place(&self, plan: &Plan, y: usize) -> usize {
        1 + (y - self.first + plan.outlier_range) * self.stride
    }
}

/// Those bits of some words of `all` that have no other one up to the range away.
#[inline(always)]
fn find(
    plan: &Plan,
    stride: usize,
    all: &[u64],
    words: Range<usize>,
    sum: &mut Vec<u64>,
    lone: &mut Vec<u64>,
) {
    let (range, count) = (plan.outlier_range, words.len());
    // First the others: those of the same row, then those of the rows above and below.
    lone.clear();
    lone.resize(count, 0);
    spread(&all[words.start - 1..][..count + 2], range, lone);
    sum.clear();
    sum.resize(count + 2, 0);
    for away in 1..=range {
        let above = &all[words.start - away * stride..][..count];
        let below = &all[words.start + away * stride..][..count];
        for (sum, (above, below)) in sum[1..].iter_mut().zip(above.iter().zip(below)) {
            *sum |= above | below;
        }
        if plan.outlier_diamond || away == range {
            let half = if plan.outlier_diamond { range - away } else { range };
            lone.iter_mut()
                .zip(&sum[1..])
                .for_each(|(lone, bits)| *lone |= bits);
            spread(sum, half, lone);
            sum.fill(0);
        }
    }
    lone.iter_mut()
        .zip(&all[words])
        .for_each(|(lone, bits)| *lone = bits & !*lone);
}

/// Adds the bits of some words to what is 1 to `half` columns to the left and right of them; `row` has one word more on
/// either side.
#[inline(always)]
fn spread(row: &[u64], half: usize, out: &mut [u64]) {
    for by in 1..=half {
        for (out, words) in out.iter_mut().zip(row.windows(3)) {
            let right = words[1] << by | words[0] >> (BITS - by);
            let left = words[1] >> by | words[2] << (BITS - by);
            *out |= right | left;
        }
    }
}

/// Which depths are measured.
#[inline(always)]
fn bits(depths: &[f32; BITS]) -> u64 {
    let mut bits = 0;
    for (&z, i) in depths.iter().zip(0..) {
        bits |= if z > 0.0 { 1u64 << i } else { 0 };
    }
    bits
}

/// The columns of set bits, from the left.
pub(super) fn columns(words: &[u64]) -> impl Iterator<Item = usize> {
    words.iter().enumerate().flat_map(|(i, &word)| {
        let mut rest = word;
        std::iter::from_fn(move || {
            let column = (rest != 0).then(|| i * BITS + rest.trailing_zeros() as usize);
            rest &= rest.wrapping_sub(1);
            column
        })
    })
}
