//! What RVC4 does with the winners: how sure they are, holes, and a median of what is not sure.
//!
//! What the device leaves out is left out last: Qualcomm's interface to the hardware, which fills and filters, knows no
//! threshold of confidence and no left-right check.

mod adaptive_median;
mod confidence;
mod hole_filling;
mod superpixels;

use oaktwin_simd::{self as simd, Kernel, Level};
use rayon::prelude::*;

use self::superpixels::Superpixels;
use super::census::Census;
use super::parameters::{ConfidenceMetrics, HoleFilling, Parameters};
use crate::preset::Platform;

/// A bit of a winner's disparity: it does not pass the left-right check, or is beyond an image.
pub(super) const LOST: u16 = 1 << 15;

/// A bit of a winner's disparity: the right image has another.
pub(super) const OCCLUDED: u16 = 1 << 14;

/// The bits of a winner's disparity itself, steps from the shift: at most 177 px of 32 steps.
pub(super) const DISPARITY: u16 = OCCLUDED - 1;

/// Rows that a thread takes at a time.
const BAND: usize = superpixels::SIDE;

/// The steps of RVC4.
#[derive(Clone, Copy, Debug)]
pub(super) struct Steps {
    metrics: ConfidenceMetrics,
    holes: Option<HoleFilling>,
    /// What is less sure is filtered.
    median: Option<u8>,
    /// Fractional bits of disparities.
    bits: u32,
    /// What is less sure is lost.
    kept_from: u8,
}

/// Memory of the steps, kept for the next image.
#[derive(Clone, Debug, Default)]
pub(super) struct Memory {
    superpixels: Superpixels,
    before: Vec<u16>,
}

impl Steps {
    /// None on another platform.
    pub(super) fn new(p: &Parameters) -> Option<Self> {
        (p.platform == Platform::Rvc4).then_some(Self {
            metrics: p.confidence_metrics,
            holes: p.hole_filling.enable.then_some(p.hole_filling),
            median: p
                .adaptive_median
                .enable
                .then_some(p.adaptive_median.confidence_threshold),
            bits: p.subpixel.bits(),
            kept_from: p.confidence_threshold,
        })
    }

    /// Whether they ask for the right image's disparities.
    pub(super) fn look_back(&self) -> bool {
        self.metrics.occlusion_weight > 0
    }

    /// Makes of winners with their [bits](LOST) disparities, 0 for none, and of shares the confidence.
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

/// Leaves out what is not sure, and the bits.
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

/// Visits each row of disparities with its confidence, a band of rows at a time on a thread with a state of its own.
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

/// A row and those above and below it; at a border itself.
fn three(all: &[u16], width: usize, y: usize) -> Option<[&[u16]; 3]> {
    let last = (all.len() / width).checked_sub(1)?;
    let row = |y: usize| all.get(y * width..(y + 1) * width);
    Some([row(y.saturating_sub(1))?, row(y)?, row((y + 1).min(last))?])
}

/// Makes something of the 3×3 pixels around each of a row: its own is the fifth. Beyond a border is what is at it.
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
