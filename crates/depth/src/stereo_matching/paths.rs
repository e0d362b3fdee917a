//! Semi-global aggregation of costs along paths, row by row.
//!
//! The path cost of a candidate d at a pixel is L(d) = C(d) + min(L′(d), L′(d ± 1) + P1, min L′ + P2) − min L′, with L′
//! of the previous pixel of the path. L − min L is stored for 3 paths from the previous row and one along the row.

use oaktwin_simd::Kernel;

use super::lanes::Lane;

/// The number of paths from the previous row: vertical, and diagonally from the previous and from the next pixel.
pub(super) const FROM_ROW: usize = 3;

/// The number of maximal values between two pixels' candidates: the neighbours of the first and the last candidate.
const GUARD: usize = 32;

/// The maximum number of candidates, with a guard on either side.
const LINE: usize = 128;

/// The stored costs of one path for each pixel of a row.
#[derive(Clone, Debug)]
pub(super) struct Slots<P> {
    values: Vec<P>,
    /// The start of the first pixel's guard.
    start: usize,
}

impl<P> Default for Slots<P> {
    fn default() -> Self {
        Self {
            values: Vec::new(),
            start: 0,
        }
    }
}

impl<P: Lane> Slots<P> {
    /// Resets the slots for a row without predecessors.
    pub(super) fn reset(&mut self, width: usize, candidates: usize) {
        const ALIGNED: usize = 64;
        let stride = candidates + GUARD;
        self.values.clear();
        self.values.resize(width * stride + 2 * ALIGNED + GUARD, P::MAX);
        let to_line = self.values.as_ptr().align_offset(ALIGNED).min(ALIGNED);
        self.start = to_line + ALIGNED - 1;
        for x in 0..width {
            self.restart(x, candidates);
        }
    }

    /// Resets the slot of a pixel without a predecessor.
    pub(super) fn restart(&mut self, pixel: usize, candidates: usize) {
        let first = self.start + 1 + pixel * (candidates + GUARD);
        if let Some(slot) = self.values.get_mut(first..first + candidates) {
            slot.fill(P::default());
        }
    }

    /// The slots from the first pixel's guard on.
    fn all(&mut self) -> &mut [P] {
        self.values.get_mut(self.start..).unwrap_or_default()
    }
}

/// P1 and P2 of each pixel of a row, or one pair for all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Penalties<'a, P> {
    pub(super) pairs: &'a [[P; 2]],
}

/// The destination of a row's sums.
pub(super) enum Sums<'a, H, S> {
    /// The sums of the first scan, which the second one completes.
    Half(&'a mut [H]),
    /// The sums of the first scan, and the output for the sums of both.
    Whole(&'a [H], &'a mut [S]),
}

/// One row of a scan, with `PATHS` paths: along the row, then the paths of [`FROM_ROW`].
pub(super) struct ScanRow<'a, P, H, S, const D: usize, const PATHS: usize> {
    /// The costs of each pixel, candidates innermost.
    pub(super) costs: &'a [P],
    /// The sums in the layout of `costs`.
    pub(super) sums: Sums<'a, H, S>,
    pub(super) slots: &'a mut [Slots<P>; FROM_ROW],
    /// The index of this row in the scan.
    pub(super) number: usize,
    pub(super) penalties: [Penalties<'a, P>; 1 + FROM_ROW],
    /// Whether the scan goes from right to left.
    pub(super) is_mirrored: bool,
}

impl<P: Lane, H: Lane, S: Lane, const D: usize, const PATHS: usize> ScanRow<'_, P, H, S, D, PATHS> {
    /// Returns the slot of the first pixel for each path. Costs stay in their slots while pixels move from one slot to
    /// the next with each row, so that a pixel reads its predecessor's costs from the slot that it writes to.
    #[inline(always)]
    fn slots_of_first(&self, width: usize) -> [usize; FROM_ROW] {
        let shift = self.number % width.max(1);
        [0, (width - shift) % width.max(1), shift]
    }
}

impl<P: Lane, H: Lane, S: Lane, const D: usize, const PATHS: usize> Kernel
    for ScanRow<'_, P, H, S, D, PATHS>
{
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        let width = self.costs.len() / D;
        if width == 0 {
            return;
        }
        let mut at = self.slots_of_first(width);
        // Paths that start at a border have no predecessor.
        let [_, before, after] = self.slots;
        if PATHS > 2 {
            before.restart(at[1], D);
            after.restart((at[2] + width - 1) % width, D);
        }
        let [straight, before, after] = self.slots;
        let (straight, before, after) = (straight.all(), before.all(), after.all());
        let step = self.penalties.map(|own| usize::from(own.pairs.len() > 1));
        let mut line = [P::MAX; LINE];
        line[1..=D].fill(P::default());
        let none = P::default();
        let mut least = none;
        for i in 0..width {
            let x = if self.is_mirrored { width - 1 - i } else { i };
            let Some(costs) = chunk(self.costs, x * D) else {
                return;
            };
            let mut total = [H::default(); D];
            let pair = |path: usize| {
                let pairs = self.penalties[path].pairs;
                pairs.get(i * step[path]).copied().unwrap_or_default()
            };
            least = relax::<P, H, D, true>(&mut line, 0, least, costs, pair(0), &mut total);
            if PATHS > 1 {
                relax::<P, H, D, false>(straight, at[0] * (D + GUARD), none, costs, pair(1), &mut total);
            }
            if PATHS > 2 {
                relax::<P, H, D, false>(before, at[1] * (D + GUARD), none, costs, pair(2), &mut total);
                relax::<P, H, D, false>(after, at[2] * (D + GUARD), none, costs, pair(3), &mut total);
            }
            match &mut self.sums {
                Sums::Half(sums) => {
                    let Some(sums) = chunk_mut(sums, x * D) else {
                        return;
                    };
                    *sums = total;
                }
                Sums::Whole(half, sums) => {
                    let (Some(half), Some(sums)) =
                        (chunk::<H, D>(half, x * D), chunk_mut::<S, D>(sums, x * D))
                    else {
                        return;
                    };
                    for d in 0..D {
                        sums[d] = S::of(half[d].wide()).plus(S::of(total[d].wide()));
                    }
                }
            }
            for at in &mut at {
                *at = if *at + 1 == width { 0 } else { *at + 1 };
            }
        }
    }
}

#[inline(always)]
pub(super) fn chunk<T, const N: usize>(all: &[T], start: usize) -> Option<&[T; N]> {
    all.get(start..)?.first_chunk()
}

#[inline(always)]
pub(super) fn chunk_mut<T, const N: usize>(all: &mut [T], start: usize) -> Option<&mut [T; N]> {
    all.get_mut(start..)?.first_chunk_mut()
}

/// Computes one path's costs at a pixel from the previous pixel's at `slot`'s guard, adds them to `total`, and
/// stores them less their minimum in the same slot. Returns the minimum.
///
/// The path along the row comes first: it initializes `total` and stores its costs without subtracting their minimum;
/// `base` is the minimum of the previous pixel. Each pixel waits for the previous one there, and subtracting the
/// minimum later halves this latency.
#[inline(always)]
fn relax<P: Lane, H: Lane, const D: usize, const IS_ALONG: bool>(
    slots: &mut [P],
    slot: usize,
    base: P,
    costs: &[P; D],
    [p1, p2]: [P; 2],
    total: &mut [H; D],
) -> P {
    let mut own = [P::default(); D];
    let mut least = P::MAX;
    {
        let (Some(nearer), Some(same), Some(farther)) = (
            chunk::<P, D>(slots, slot),
            chunk::<P, D>(slots, slot + 1),
            chunk::<P, D>(slots, slot + 2),
        ) else {
            return base;
        };
        let most = base.plus(p2);
        for d in 0..D {
            let beside = nearer[d].min(farther[d]).plus_saturating(p1);
            let before = same[d].min(beside).min(most).minus(base);
            own[d] = costs[d].plus(before);
            // In a separate loop over 64 values, LLVM would unroll this before it vectorizes, and wait for one value after another.
            least = least.min(own[d]);
        }
    }
    for d in 0..D {
        let own = H::of(own[d].wide());
        total[d] = if IS_ALONG { own } else { total[d].plus(own) };
    }
    if let Some(slot) = chunk_mut::<P, D>(slots, slot + 1) {
        for d in 0..D {
            slot[d] = if IS_ALONG { own[d] } else { own[d].minus(least) };
        }
    }
    least
}
