//! The cost of each candidate of a pixel: the mean over the block around it.
//!
//! A scan moves from row to row, and its blocks with it: the sums over the block's rows are stored for each pixel and
//! candidate, and each step adds the next row and subtracts the oldest one. Columns are summed likewise along a row.
//!
//! With several zones, the candidates of each pixel are first gathered from the right image, so that all are compared at once.

use oaktwin_simd::{self as simd, Kernel};

use super::block_sum::{BlockSum, Columns, Mean};
use super::gather::Gathered;
use super::lanes::Lane;
use super::paths::{chunk, chunk_mut};
use super::plan::{PassPlan, Raw};
use super::scan_input::ScanInput;

/// The block sums of a scan.
#[derive(Clone, Debug, Default)]
pub(super) struct Blocks {
    columns: Columns,
    entering: Gathered,
    leaving: Gathered,
}

impl Blocks {
    /// Computes the costs of the scan's next row, candidates innermost. `is_first` resets the sums.
    pub(super) fn row<P: Lane>(
        &mut self,
        view: ScanInput<'_>,
        y: usize,
        [is_first, is_up]: [bool; 2],
        out: &mut [P],
    ) {
        let ScanInput { plan, census, .. } = view;
        let (forward, last) = (if is_up { -1 } else { 1 }, census[0].height() - 1);
        // The border is repeated outside the image.
        let row = |by: isize| y.saturating_add_signed(forward * by).min(last);
        match (plan.raw, plan.planes(), plan.area()) {
            // The reciprocal of 21 in 8-bit sums is not exact.
            (Raw::Bits { .. }, 1, ..=15 | 25) => self.follow::<u8, P>(view, is_first, row, out),
            (Raw::Bits { .. }, ..) => self.follow::<u16, P>(view, is_first, row, out),
            (Raw::Equation { .. }, ..) => self.follow::<u32, P>(view, is_first, row, out),
        }
    }

    fn follow<S: BlockSum, P: Lane>(
        &mut self,
        view: ScanInput<'_>,
        is_first: bool,
        row: impl Fn(isize) -> usize,
        out: &mut [P],
    ) {
        let reach = (view.plan.block_rows / 2).cast_signed();
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
        view: ScanInput<'_>,
        [entering, leaving]: [Option<usize>; 2],
        out: &mut [P],
    ) {
        let ScanInput {
            level,
            plan,
            census: [left, right],
            width,
        } = view;
        let is_gathered = plan.zones.len() > 1;
        let rows = [(entering, &mut self.entering), (leaving, &mut self.leaving)];
        let rows = rows.map(|(y, gathered)| ImagePlanes {
            left: left.row(y),
            right: match is_gathered {
                true => gathered.of(level, plan, right.row(y), right.stride(), width),
                false => right.row(y),
            },
        });
        let work = CostRows::<S, P> {
            plan,
            rows,
            left_stride: left.stride(),
            right_stride: match is_gathered {
                true => width * plan.candidates,
                false => right.stride(),
            },
            is_gathered,
            width,
            columns: S::of_columns(&mut self.columns),
            out,
        };
        match (left.planes(), plan.candidates) {
            (1, 64) => simd::run_at(level, Costs::<S, P, 1, 64>(work)),
            (2, 64) => simd::run_at(level, Costs::<S, P, 2, 64>(work)),
            (3, 64) => simd::run_at(level, Costs::<S, P, 3, 64>(work)),
            (6, 64) => simd::run_at(level, Costs::<S, P, 6, 64>(work)),
            (8, 64) => simd::run_at(level, Costs::<S, P, 8, 64>(work)),
            (1, _) => simd::run_at(level, Costs::<S, P, 1, 96>(work)),
            (2, _) => simd::run_at(level, Costs::<S, P, 2, 96>(work)),
            (3, _) => simd::run_at(level, Costs::<S, P, 3, 96>(work)),
            (6, _) => simd::run_at(level, Costs::<S, P, 6, 96>(work)),
            _ => simd::run_at(level, Costs::<S, P, 8, 96>(work)),
        }
    }
}

/// A row's planes of both images, the right one mirrored.
#[derive(Clone, Copy)]
struct ImagePlanes<'a> {
    left: &'a [u8],
    right: &'a [u8],
}

struct CostRows<'a, S, P> {
    plan: &'a PassPlan,
    /// The row that enters the block, and the one that leaves it.
    rows: [ImagePlanes<'a>; 2],
    left_stride: usize,
    right_stride: usize,
    is_gathered: bool,
    width: usize,
    columns: &'a mut [S],
    out: &'a mut [P],
}

/// Costs of `D` candidates from `PLANES` planes of the census transform.
struct Costs<'a, S, P, const PLANES: usize, const D: usize>(CostRows<'a, S, P>);

impl<S: BlockSum, P: Lane, const PLANES: usize, const D: usize> Kernel for Costs<'_, S, P, PLANES, D> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let CostRows {
            plan,
            rows: [entering, leaving],
            left_stride,
            right_stride,
            is_gathered,
            width,
            columns,
            out,
        } = self.0;
        let reach = plan.block / 2;
        #[expect(clippy::cast_possible_truncation, reason = "at most 7")]
        let beyond = S::of(plan.raw.beyond() * plan.block_rows as u32);
        let mean = Mean::new(plan.area());
        let first = plan.zones.first().map_or(0, |zone| zone.first);
        let last = plan.last();
        let mut sum = [S::default(); D];
        for x in 0..width + reach {
            if x < width {
                let place = if is_gathered { x * D } else { width - 1 - x + first };
                let places = [x, left_stride, place, right_stride];
                let (Some(enters), Some(leaves), Some(column)) = (
                    raw::<S, PLANES, D>(plan.raw, entering, places),
                    raw::<S, PLANES, D>(plan.raw, leaving, places),
                    chunk_mut::<S, D>(columns, x * D),
                ) else {
                    return;
                };
                for k in 0..D {
                    column[k] = column[k].plus(enters[k]).minus(leaves[k]);
                }
                if x < last {
                    replace_outside(plan, x, beyond, column);
                }
            }
            let newest = x.min(width - 1);
            // The border is repeated outside the image.
            for _ in 0..if x == 0 { reach + 1 } else { 1 } {
                let Some(column) = chunk::<S, D>(columns, newest * D) else {
                    return;
                };
                for k in 0..D {
                    sum[k] = sum[k].plus(column[k]);
                }
            }
            if x < reach {
                continue;
            }
            let oldest = x.saturating_sub(2 * reach);
            let (Some(costs), Some(column)) = (
                chunk_mut::<P, D>(out, (x - reach) * D),
                chunk::<S, D>(columns, oldest * D),
            ) else {
                return;
            };
            for k in 0..D {
                costs[k] = P::of(sum[k].mean(&mean));
            }
            for k in 0..D {
                sum[k] = sum[k].minus(column[k]);
            }
        }
    }
}

/// Gives the candidates outside the right image a fixed cost.
#[inline(always)]
fn replace_outside<S: Copy, const D: usize>(plan: &PassPlan, x: usize, beyond: S, column: &mut [S; D]) {
    for zone in &plan.zones {
        let inside = (x + zone.step).saturating_sub(zone.first) / zone.step;
        let own = column.get_mut(zone.start..zone.start + zone.count);
        for own in own.unwrap_or_default().iter_mut().skip(inside) {
            *own = beyond;
        }
    }
}

/// Returns the costs of the candidates at one pixel: the number of bits that differ, or the complete equation.
#[inline(always)]
fn raw<S: BlockSum, const PLANES: usize, const D: usize>(
    raw: Raw,
    row: ImagePlanes<'_>,
    [x, left_stride, place, right_stride]: [usize; 4],
) -> Option<[S; D]> {
    let mut differing = [0u8; D];
    for plane in 0..PLANES {
        let own = *row.left.get(plane * left_stride + x)?;
        let others = chunk::<u8, D>(row.right, plane * right_stride + place)?;
        for k in 0..D {
            #[expect(clippy::cast_possible_truncation, reason = "at most 8")]
            let ones = (own ^ others[k]).count_ones() as u8;
            differing[k] += ones;
        }
    }
    let mut out = [S::default(); D];
    match raw {
        Raw::Equation { alpha, beta, most } if S::IS_EQUATION => {
            let own = *row.left.get(PLANES * left_stride + x)?;
            let others = chunk::<u8, D>(row.right, PLANES * right_stride + place)?;
            for k in 0..D {
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
            for k in 0..D {
                out[k] = S::of(differing[k].into());
            }
        }
        _ => return None,
    }
    Some(out)
}
