//! The cost of each candidate of a pixel: the mean over the block around it.
//!
//! A scan moves from row to row, and its blocks with it: the sums over the block's rows are stored for each pixel and
//! candidate, and each step adds the next row and subtracts the oldest one. Columns are summed likewise along a row.

use oaktwin_simd::{self as simd, Kernel};

use super::block_sum::{BlockSum, Columns, Mean};
use super::lanes::Lane;
use super::paths::{chunk, chunk_mut};
use super::plan::{Plan, Raw, Zone};
use super::view::View;

/// The block sums of a scan.
#[derive(Clone, Debug, Default)]
pub(super) struct Blocks {
    columns: Columns,
    entering: Stepped,
    leaving: Stepped,
}

/// A row of the right image, regrouped by the disparity step of a zone.
#[derive(Clone, Debug, Default)]
struct Stepped {
    rows: Vec<u8>,
}

impl Blocks {
    /// Computes the costs of the scan's next row, candidates innermost. `is_first` resets the sums.
    pub(super) fn row<P: Lane>(
        &mut self,
        view: View<'_>,
        y: usize,
        [is_first, is_up]: [bool; 2],
        out: &mut [P],
    ) {
        let View { plan, census, .. } = view;
        let (forward, last) = (if is_up { -1 } else { 1 }, census[0].height() - 1);
        // The border is repeated outside the image.
        let row = |by: isize| y.saturating_add_signed(forward * by).min(last);
        match (plan.raw, plan.planes(), plan.block) {
            (Raw::Bits { .. }, 1, ..=5) => self.follow::<u8, P>(view, is_first, row, out),
            (Raw::Bits { .. }, ..) => self.follow::<u16, P>(view, is_first, row, out),
            (Raw::Equation { .. }, ..) => self.follow::<u32, P>(view, is_first, row, out),
        }
    }

    fn follow<S: BlockSum, P: Lane>(
        &mut self,
        view: View<'_>,
        is_first: bool,
        row: impl Fn(isize) -> usize,
        out: &mut [P],
    ) {
        let reach = (view.plan.block / 2).cast_signed();
        if is_first {
            let columns = S::of_columns(&mut self.columns);
            columns.clear();
            columns.resize(view.width * view.plan.candidates, S::default());
            for by in -reach..reach {
                self.step::<S, P>(view, [Some(row(by)), None], out);
            }
        }
        let leaving = (!is_first).then(|| row(-reach - 1));
        self.step::<S, P>(view, [Some(row(reach)), leaving], out);
    }

    /// Adds the entering row to the block and subtracts the leaving one.
    fn step<S: BlockSum, P: Lane>(
        &mut self,
        view: View<'_>,
        [entering, leaving]: [Option<usize>; 2],
        out: &mut [P],
    ) {
        let View {
            level,
            plan,
            census: [left, right],
            width,
        } = view;
        for zone in &plan.zones {
            let stride = right.stride();
            let phase_stride = stride.div_ceil(zone.step);
            let rows = [(entering, &mut self.entering), (leaving, &mut self.leaving)];
            let rows = rows.map(|(y, stepped)| Line {
                left: left.row(y),
                right: stepped.of(zone.step, right.row(y), stride),
            });
            let work = Zoned::<S, P> {
                plan,
                zone,
                rows,
                left_stride: left.stride(),
                right_stride: phase_stride * zone.step,
                phase_stride,
                width,
                columns: S::of_columns(&mut self.columns),
                out,
            };
            // Most pairs have one zone; the others have zones of 16, 32 and 48. Blocks of 48 are slower than three of 16.
            match (left.planes(), zone.count) {
                (1, 96) => simd::run_at(level, Costs::<S, P, 1, 96>(work)),
                (2, 96) => simd::run_at(level, Costs::<S, P, 2, 96>(work)),
                (3, 96) => simd::run_at(level, Costs::<S, P, 3, 96>(work)),
                (6, 96) => simd::run_at(level, Costs::<S, P, 6, 96>(work)),
                (8, 96) => simd::run_at(level, Costs::<S, P, 8, 96>(work)),
                (1, 64) => simd::run_at(level, Costs::<S, P, 1, 64>(work)),
                (2, 64) => simd::run_at(level, Costs::<S, P, 2, 64>(work)),
                (3, 64) => simd::run_at(level, Costs::<S, P, 3, 64>(work)),
                (6, 64) => simd::run_at(level, Costs::<S, P, 6, 64>(work)),
                (8, 64) => simd::run_at(level, Costs::<S, P, 8, 64>(work)),
                (1, 32) => simd::run_at(level, Costs::<S, P, 1, 32>(work)),
                (2, 32) => simd::run_at(level, Costs::<S, P, 2, 32>(work)),
                (3, 32) => simd::run_at(level, Costs::<S, P, 3, 32>(work)),
                (6, 32) => simd::run_at(level, Costs::<S, P, 6, 32>(work)),
                (8, 32) => simd::run_at(level, Costs::<S, P, 8, 32>(work)),
                (1, _) => simd::run_at(level, Costs::<S, P, 1, 16>(work)),
                (2, _) => simd::run_at(level, Costs::<S, P, 2, 16>(work)),
                (3, _) => simd::run_at(level, Costs::<S, P, 3, 16>(work)),
                (6, _) => simd::run_at(level, Costs::<S, P, 6, 16>(work)),
                _ => simd::run_at(level, Costs::<S, P, 8, 16>(work)),
            }
        }
    }
}

impl Stepped {
    /// Regroups each plane: every `step`-th pixel from the first one, then from the second one, and so on.
    fn of<'a>(&'a mut self, step: usize, planes: &'a [u8], stride: usize) -> &'a [u8] {
        if step == 1 {
            return planes;
        }
        let phase_stride = stride.div_ceil(step);
        self.rows.clear();
        for plane in planes.chunks_exact(stride) {
            for phase in 0..step {
                let before = self.rows.len();
                self.rows.extend(plane.iter().skip(phase).step_by(step));
                self.rows.resize(before + phase_stride, 0);
            }
        }
        &self.rows
    }
}

/// A row's planes of both images, the right one mirrored.
#[derive(Clone, Copy)]
struct Line<'a> {
    left: &'a [u8],
    right: &'a [u8],
}

struct Zoned<'a, S, P> {
    plan: &'a Plan,
    zone: &'a Zone,
    /// The row that enters the block, and the one that leaves it.
    rows: [Line<'a>; 2],
    left_stride: usize,
    right_stride: usize,
    phase_stride: usize,
    width: usize,
    columns: &'a mut [S],
    out: &'a mut [P],
}

/// Costs from `PLANES` planes of the census transform, `B` candidates at a time.
struct Costs<'a, S, P, const PLANES: usize, const B: usize>(Zoned<'a, S, P>);

impl<S: BlockSum, P: Lane, const PLANES: usize, const B: usize> Kernel for Costs<'_, S, P, PLANES, B> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Zoned {
            plan,
            zone,
            rows: [entering, leaving],
            left_stride,
            right_stride,
            phase_stride,
            width,
            columns,
            out,
        } = self.0;
        let reach = plan.block / 2;
        #[expect(clippy::cast_possible_truncation, reason = "at most 7")]
        let beyond = S::of(plan.raw.beyond() * plan.block as u32);
        let mean = Mean::new(plan.area());
        for block in 0..zone.count / B {
            let at = |x: usize| x * plan.candidates + zone.start + block * B;
            let mut sum = [S::default(); B];
            for x in 0..width + reach {
                if x < width {
                    let place = width - 1 - x + zone.first;
                    // Division is as expensive as a block.
                    let place = match zone.step {
                        1 => place,
                        step => place % step * phase_stride + place / step,
                    } + block * B;
                    let places = [x, left_stride, place, right_stride];
                    let (Some(enters), Some(leaves), Some(column)) = (
                        raw::<S, PLANES, B>(plan.raw, entering, places),
                        raw::<S, PLANES, B>(plan.raw, leaving, places),
                        chunk_mut::<S, B>(columns, at(x)),
                    ) else {
                        return;
                    };
                    for k in 0..B {
                        column[k] = column[k].plus(enters[k]).minus(leaves[k]);
                    }
                    // Candidates outside the right image have a fixed cost.
                    let first = zone.first + block * B * zone.step;
                    let inside = (x + zone.step).saturating_sub(first) / zone.step;
                    for own in column.iter_mut().skip(inside) {
                        *own = beyond;
                    }
                }
                let newest = x.min(width - 1);
                // The border is repeated outside the image.
                for _ in 0..if x == 0 { reach + 1 } else { 1 } {
                    let Some(column) = chunk::<S, B>(columns, at(newest)) else {
                        return;
                    };
                    for k in 0..B {
                        sum[k] = sum[k].plus(column[k]);
                    }
                }
                if x < reach {
                    continue;
                }
                let oldest = x.saturating_sub(2 * reach);
                let (Some(costs), Some(column)) = (
                    chunk_mut::<P, B>(out, at(x - reach)),
                    chunk::<S, B>(columns, at(oldest)),
                ) else {
                    return;
                };
                for k in 0..B {
                    costs[k] = P::of(sum[k].mean(&mean));
                }
                for k in 0..B {
                    sum[k] = sum[k].minus(column[k]);
                }
            }
        }
    }
}

/// Returns the costs of the candidates at one pixel: the number of bits that differ, or the complete equation.
#[inline(always)]
fn raw<S: BlockSum, const PLANES: usize, const B: usize>(
    raw: Raw,
    row: Line<'_>,
    [x, left_stride, place, right_stride]: [usize; 4],
) -> Option<[S; B]> {
    let mut differing = [0u8; B];
    for plane in 0..PLANES {
        let own = *row.left.get(plane * left_stride + x)?;
        let others = chunk::<u8, B>(row.right, plane * right_stride + place)?;
        for k in 0..B {
            #[expect(clippy::cast_possible_truncation, reason = "at most 8")]
            let ones = (own ^ others[k]).count_ones() as u8;
            differing[k] += ones;
        }
    }
    let mut out = [S::default(); B];
    match raw {
        Raw::Equation { alpha, beta, most } if S::IS_EQUATION => {
            let own = *row.left.get(PLANES * left_stride + x)?;
            let others = chunk::<u8, B>(row.right, PLANES * right_stride + place)?;
            for k in 0..B {
                let levels = u32::from(own.abs_diff(others[k]));
                let both = alpha * levels + beta * (u32::from(differing[k]) << 3);
                out[k] = S::of(both.min(most));
            }
        }
        Raw::Bits { most } if !S::IS_EQUATION => {
            if usize::from(most) < 8 * PLANES {
                for own in &mut differing {
                    *own = (*own).min(most);
                }
            }
            for k in 0..B {
                out[k] = S::of(differing[k].into());
            }
        }
        _ => return None,
    }
    Some(out)
}
