//! RVC4's post-processing of the winners: confidence, hole filling and the adaptive median.
//!
//! Pixels are invalidated last: Qualcomm's interface to the hardware, which fills and filters, has neither a confidence
//! threshold nor a left-right check.

mod adaptive_median;
mod confidence;
mod hole_filling;
pub(super) mod steps;
mod superpixels;

use oaktwin_simd::{self as simd, Kernel, Level};
use rayon::prelude::*;

use self::steps::Steps;
use self::superpixels::Superpixels;
use super::census::Census;

/// The bit of a disparity that fails the left-right check or whose counterpart is outside the image.
pub(super) const LOST: u16 = 1 << 15;

/// The bit of a disparity that differs from the right image's.
pub(super) const OCCLUDED: u16 = 1 << 14;

/// The bits of the disparity itself, in steps from the shift: at most 177 px of 32 steps.
pub(super) const DISPARITY: u16 = OCCLUDED - 1;

/// The number of rows in a unit of work.
const BAND: usize = superpixels::SIDE;

/// The buffers of the steps, reused for the next image.
#[derive(Clone, Debug, Default)]
pub(super) struct Memory {
    superpixels: Superpixels,
    before: Vec<u16>,
}

impl Steps {
    /// Converts disparities with their [bits](LOST) to final ones, with 0 for invalid, and cost ratios to confidence.
    pub(super) fn run(
        &self,
        level: Level,
        left: &Census,
        memory: &mut Memory,
        disparity: &mut [u16],
        confidence: &mut [u8],
    ) {
        let width = left.width();
        confidence::run(level, &self.metrics, self.bits, width, disparity, confidence);
        if let Some(holes) = &self.holes {
            memory.superpixels.find(level, left, disparity.len() / width);
            hole_filling::run(holes, &memory.superpixels, width, disparity, confidence);
        }
        if let Some(threshold) = self.median {
            memory.before.clear();
            memory.before.extend_from_slice(disparity);
            adaptive_median::run(level, threshold, width, &memory.before, disparity, confidence);
        }
        let bands = disparity
            .par_chunks_mut(BAND * width)
            .zip(confidence.par_chunks(BAND * width));
        bands.for_each(|(disparity, confidence)| {
            let keep = Keep {
                from: self.kept_from,
                disparity,
                confidence,
            };
            simd::run_at(level, keep);
        });
    }
}

/// Invalidates pixels that are lost or have a low confidence, and clears the bits.
struct Keep<'a> {
    from: u8,
    disparity: &'a mut [u16],
    confidence: &'a [u8],
}

impl Kernel for Keep<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (disparity, &confidence) in self.disparity.iter_mut().zip(self.confidence) {
            let is_kept = (*disparity < LOST) & (confidence >= self.from);
            *disparity = if is_kept { *disparity & DISPARITY } else { 0 };
        }
    }
}

/// Calls `visit` for each row of disparities with its confidence; each thread has its own state.
fn each_row<S>(
    width: usize,
    disparity: &mut [u16],
    confidence: &[u8],
    state: impl Fn() -> S + Sync + Send,
    visit: impl Fn(&mut S, usize, &mut [u16], &[u8]) + Sync + Send,
) {
    let bands = disparity
        .par_chunks_mut(BAND * width)
        .zip(confidence.par_chunks(BAND * width))
        .enumerate();
    bands.for_each_init(state, |state, (band, (disparity, confidence))| {
        let rows = disparity
            .chunks_exact_mut(width)
            .zip(confidence.chunks_exact(width));
        for (y, (disparity, confidence)) in (band * BAND..).zip(rows) {
            visit(state, y, disparity, confidence);
        }
    });
}

/// Returns a row between those above and below it; at the border the row itself is repeated.
fn three(all: &[u16], width: usize, y: usize) -> Option<[&[u16]; 3]> {
    let last = (all.len() / width).checked_sub(1)?;
    let row = |y: usize| all.get(y * width..(y + 1) * width);
    Some([row(y.saturating_sub(1))?, row(y)?, row((y + 1).min(last))?])
}

/// Computes a value from the 3×3 pixels around each pixel of a row; index 4 is the pixel itself. The border is
/// repeated.
#[inline(always)]
fn around<T>(rows: [&[u16]; 3], out: &mut [T], make: impl Fn([u16; 9], &mut T)) {
    let width = out.len();
    let [above, own, below] = rows.map(|row| row.get(..width).unwrap_or_default());
    if above.len() < width || own.len() < width || below.len() < width || width == 0 {
        return;
    }
    let at = |x: usize| {
        let (before, after) = (x.saturating_sub(1), (x + 1).min(width - 1));
        [above, own, below].map(|row| [row[before], row[x], row[after]])
    };
    let edge = |x: usize| {
        let [[a, b, c], [d, e, f], [g, h, i]] = at(x);
        [a, b, c, d, e, f, g, h, i]
    };
    make(edge(0), &mut out[0]);
    if width > 2 {
        let inside = width - 2;
        let [a, b, c] = [0, 1, 2].map(|from| &above[from..from + inside]);
        let [d, e, f] = [0, 1, 2].map(|from| &own[from..from + inside]);
        let [g, h, i] = [0, 1, 2].map(|from| &below[from..from + inside]);
        for (x, out) in out[1..=inside].iter_mut().enumerate() {
            make([a[x], b[x], c[x], d[x], e[x], f[x], g[x], h[x], i[x]], out);
        }
    }
    if width > 1 {
        make(edge(width - 1), &mut out[width - 1]);
    }
}
