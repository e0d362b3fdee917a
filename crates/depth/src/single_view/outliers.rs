//! Outlier removal: a lone pixel takes the state of its neighbours.

use std::ops::Range;

use super::plan::SingleViewPlan;

/// The columns in a word of bits.
const BITS: usize = 64;

/// The measured pixels of some rows, one bit each. Each row has its own words and a word of zeros behind them, so that all
/// rows are processed in one loop.
#[derive(Debug, Default)]
pub(super) struct Validity {
    /// The words in a row.
    stride: usize,
    /// The first row.
    first: usize,
    /// The rows, with a word of zeros before them and as many rows of zeros before and behind them as the range is large.
    measured: Vec<u64>,
    missing: Vec<u64>,
    /// The lone pixels of the rows from `lone_first`.
    lone_first: usize,
    lone_measured: Vec<u64>,
    lone_missing: Vec<u64>,
    sum: Vec<u64>,
}

/// The lone pixels of a row, one bit per pixel.
#[derive(Debug)]
pub(super) struct Lone<'a> {
    pub(super) measured: &'a [u64],
    pub(super) missing: &'a [u64],
}

impl Validity {
    /// Clears the buffers and sizes them for some rows.
    pub(super) fn reset(&mut self, plan: &SingleViewPlan, rows: Range<usize>) {
        self.stride = plan.width.div_ceil(BITS) + 1;
        self.first = rows.start;
        let words = 1 + (rows.len() + 2 * plan.outlier_range) * self.stride;
        for bits in [&mut self.measured, &mut self.missing] {
            bits.clear();
            bits.resize(words, 0);
        }
    }

    /// Sets a word of row `y` from its depths; the first `columns` of them are inside the image.
    #[inline(always)]
    pub(super) fn set(
        &mut self,
        plan: &SingleViewPlan,
        y: usize,
        word: usize,
        depths: &[f32; BITS],
        columns: usize,
    ) {
        let place = self.place(plan, y) + word;
        let measured = bits(depths);
        self.measured[place] = measured;
        self.missing[place] = !measured & (u64::MAX >> (BITS - columns));
    }

    /// Finds the lone pixels of some rows.
    #[inline(always)]
    pub(super) fn find(&mut self, plan: &SingleViewPlan, rows: Range<usize>) {
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

    /// Returns the lone pixels of row `y`, one of the rows of the last [`Measured::find`], in words of 64 columns.
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
    fn place(&self, plan: &SingleViewPlan, y: usize) -> usize {
        1 + (y - self.first + plan.outlier_range) * self.stride
    }
}

/// Finds the bits of some words of `all` without another one within the range.
#[inline(always)]
fn find(
    plan: &SingleViewPlan,
    stride: usize,
    all: &[u64],
    words: Range<usize>,
    sum: &mut Vec<u64>,
    lone: &mut Vec<u64>,
) {
    let (range, count) = (plan.outlier_range, words.len());
    // First the other bits of the same row, then the bits of the rows above and below.
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

/// Adds the bits of a row to the columns at a distance of 1 to `half` on both sides; `row` has one more word on either
/// side.
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

/// Returns a bit for each measured depth.
#[inline(always)]
fn bits(depths: &[f32; BITS]) -> u64 {
    let mut bits = 0;
    for (&z, i) in depths.iter().zip(0..) {
        bits |= if z > 0.0 { 1u64 << i } else { 0 };
    }
    bits
}

/// Returns the columns of set bits, from the left.
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
