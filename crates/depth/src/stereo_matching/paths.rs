//! Costs along paths, summed: the rows of a scan, one after the other.
//!
//! A path's cost of a candidate d at a pixel is L(d) = C(d) + min(L′(d), L′(d ± 1) + P1, min L′ + P2) − min L′, with L′ of
//! the pixel before. What is kept of a pixel is L − min L, for 3 paths that come from the row before and one along the row.

use oaktwin_simd::Kernel;

use super::lanes::Lane;

/// Paths that come from the row before: straight, from the pixel before, from the pixel after.
pub(super) const FROM_ROW: usize = 3;

/// Between two pixels' candidates, worse than all: what is next to the first and the last.
const GUARD: usize = 32;

/// Most candidates, and a guard on either side.
const LINE: usize = 128;

/// What is kept of a path for each pixel of a row.
#[derive(Clone, Debug)]
pub(super) struct Slots<P> {
    values: Vec<P>,
    /// Of the first pixel's guard.
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
    /// Of a row of pixels that nothing comes before.
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

    /// Nothing comes before this pixel.
    pub(super) fn restart(&mut self, pixel: usize, candidates: usize) {
        let first = self.start + 1 + pixel * (candidates + GUARD);
        if let Some(slot) = self.values.get_mut(first..first + candidates) {
            slot.fill(P::default());
        }
    }

    /// From the first pixel's guard on.
    fn all(&mut self) -> &mut [P] {
        self.values.get_mut(self.start..).unwrap_or_default()
    }
}

/// The two penalties of each pixel of a row, or one pair for all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Penalties<'a, P> {
    pub(super) pairs: &'a [[P; 2]],
}

/// Where a row's sums go.
pub(super) enum Sums<'a, H, S> {
    /// To the scan that comes later, as far as they are.
    Half(&'a mut [H]),
    /// With those that the earlier scan left.
    Whole(&'a [H], &'a mut [S]),
}

/// One row of a scan, with the first `PATHS` of: along the row, and [`FROM_ROW`].
pub(super) struct Row<'a, P, H, S, const D: usize, const PATHS: usize> {
    /// Of each pixel, candidates innermost.
    pub(super) costs: &'a [P],
    /// As `costs`.
    pub(super) sums: Sums<'a, H, S>,
    pub(super) slots: &'a mut [Slots<P>; FROM_ROW],
    /// The number of this row in the scan.
    pub(super) number: usize,
    pub(super) penalties: [Penalties<'a, P>; 1 + FROM_ROW],
    /// Whether the scan goes from right to left.
    pub(super) is_mirrored: bool,
}

impl<P: Lane, H: Lane, S: Lane, const D: usize, const PATHS: usize> Row<'_, P, H, S, D, PATHS> {
    /// Slots stay where they are and pixels go from one to the next, so that what comes from the pixel before stands where
    /// its own is written.
    #[inline(always)]
    fn slots_of_first(&self, width: usize) -> [usize; FROM_ROW] {
        let shift = self.number % width.max(1);
        [0, (width - shift) % width.max(1), shift]
    }
}

impl<P: Lane, H: Lane, S: Lane, const D: usize, const PATHS: usize> Kernel for Row<'_, P, H, S, D, PATHS> {
    type Output = ();

    #[inline(always)]
    fn run(mut self) {
        let width = self.costs.len() / D;
        if width == 0 {
            return;
        }
        let mut at = self.slots_of_first(width);
        // Nothing comes from beyond the borders.
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

/// One path's costs at a pixel, from those of the pixel before at `slot`'s guard, where they then stand less the least of
/// them; they are added to `total`. Says what the least is.
///
/// Along the row, which comes first, `total` begins, and they stand as they are; `base` is the least of those before. There
/// the next pixel waits for this one: that its least need not be known before it is taken off saves half of that.
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
        }
    }
    let mut least = P::MAX;
    for cost in own {
        least = least.min(cost);
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
