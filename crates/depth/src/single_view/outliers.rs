//! Lone pixels become what all their neighbours are.

use super::plan::Plan;

/// Columns of a word of bits.
const BITS: usize = 64;

/// Which pixels of some rows were measured: one bit each.
#[derive(Debug, Default)]
pub(super) struct Validity {
    /// Words of a row: one of zeros, the row's, one of zeros.
    stride: usize,
    measured: Vec<u64>,
    missing: Vec<u64>,
    /// The first row.
    first: usize,
    end: usize,
    buffers: [Vec<u64>; 3],
}

/// The lone pixels of a row, one bit each.
#[derive(Debug)]
pub(super) struct Lone<'a> {
    pub(super) measured: &'a [u64],
    pub(super) missing: &'a [u64],
}

impl Validity {
    /// Forgets the image, and makes place for rows `first` to `end`.
    pub(super) fn reset(&mut self, plan: &Plan, first: usize, end: usize) {
        self.stride = plan.width.div_ceil(BITS) + 2;
        (self.first, self.end) = (first, end);
        for bits in [&mut self.measured, &mut self.missing] {
            bits.clear();
            bits.resize((end - first) * self.stride, 0);
        }
        for buffer in &mut self.buffers {
            buffer.clear();
            buffer.resize(self.stride, 0);
        }
    }

    /// Takes row `y`.
    #[inline(always)]
    pub(super) fn set(&mut self, y: usize, row: &[f32]) {
        let start = (y - self.first) * self.stride + 1;
        let words = self.stride - 2;
        let measured = &mut self.measured[start..][..words];
        let missing = &mut self.missing[start..][..words];
        for ((measured, missing), pixels) in measured.iter_mut().zip(missing).zip(row.chunks(BITS)) {
            *measured = bits(pixels);
            *missing = !*measured & (u64::MAX >> (BITS - pixels.len()));
        }
    }

    /// The lone pixels of row `y`: words of 64 columns.
    #[inline(always)]
    pub(super) fn lone(&mut self, plan: &Plan, y: usize) -> Lone<'_> {
        let [sum, measured, missing] = &mut self.buffers;
        let range = Rows {
            stride: self.stride,
            first: self.first,
            end: self.end,
            y,
        };
        range.lone(plan, &self.measured, sum, measured);
        range.lone(plan, &self.missing, sum, missing);
        let words = 1..self.stride - 1;
        Lone {
            measured: &measured[words.clone()],
            missing: &missing[words],
        }
    }
}

struct Rows {
    stride: usize,
    first: usize,
    end: usize,
    y: usize,
}

impl Rows {
    /// The bits of row `y` in `all` that have no other one up to the range away.
    #[inline(always)]
    fn lone(&self, plan: &Plan, all: &[u64], sum: &mut [u64], out: &mut [u64]) {
        let row = |y: usize| &all[(y - self.first) * self.stride..][..self.stride];
        let here = row(self.y);
        let range = plan.outlier_range;
        // First the others: those of this row, then those of the rows above and below.
        out.fill(0);
        spread(here, range, out);
        sum.fill(0);
        for away in 1..=range {
            if self.y >= self.first + away {
                sum.iter_mut()
                    .zip(row(self.y - away))
                    .for_each(|(sum, bits)| *sum |= bits);
            }
            if self.y + away < self.end {
                sum.iter_mut()
                    .zip(row(self.y + away))
                    .for_each(|(sum, bits)| *sum |= bits);
            }
            if plan.outlier_diamond || away == range {
                let half = if plan.outlier_diamond { range - away } else { range };
                out.iter_mut().zip(&*sum).for_each(|(out, bits)| *out |= bits);
                spread(sum, half, out);
                sum.fill(0);
            }
        }
        out.iter_mut()
            .zip(here)
            .for_each(|(out, bits)| *out = bits & !*out);
    }
}

/// Adds the bits of a row to what is 1 to `half` columns to the left and right of them.
#[inline(always)]
fn spread(row: &[u64], half: usize, out: &mut [u64]) {
    let inner = 1..row.len() - 1;
    for by in 1..=half {
        for (out, words) in out[inner.clone()].iter_mut().zip(row.windows(3)) {
            let right = words[1] << by | words[0] >> (BITS - by);
            let left = words[1] >> by | words[2] << (BITS - by);
            *out |= right | left;
        }
    }
}

/// Which of up to 64 depths are measured.
#[inline(always)]
fn bits(pixels: &[f32]) -> u64 {
    let mut bits = 0;
    for (&z, i) in pixels.iter().zip(0u64..) {
        bits |= u64::from(z > 0.0) << i;
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
