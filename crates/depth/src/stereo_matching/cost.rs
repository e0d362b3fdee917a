//! What it costs to match a pixel with each candidate of the other image.

use super::census::Census;
use super::paths::{chunk, chunk_mut};
use super::plan::{Plan, Zone};
use crate::simd::{self, Kernel, Level};

/// Memory for a row of the right image in steps of a zone.
#[derive(Clone, Debug, Default)]
pub(super) struct Stepped {
    rows: Vec<u8>,
}

/// The costs of a row, candidates innermost.
pub(super) fn row(
    level: Level,
    plan: &Plan,
    [left, right]: [&Census; 2],
    y: usize,
    stepped: &mut Stepped,
    out: &mut [u8],
) {
    for zone in &plan.zones {
        let (planes, phase_stride) = if zone.step == 1 {
            (right.row(y), right.stride())
        } else {
            stepped.fill(zone.step, right.row(y), right.stride());
            (stepped.rows.as_slice(), right.stride().div_ceil(zone.step))
        };
        let work = Zoned {
            plan,
            zone,
            left: left.row(y),
            left_stride: left.stride(),
            right: planes,
            right_stride: phase_stride * zone.step,
            phase_stride,
            width: left.width(),
            out,
        };
        // Most pairs have one zone; the others have zones of several sizes.
        match (left.planes(), zone.count) {
            (1, 96) => simd::run_at(level, Costs::<1, 96>(work)),
            (2, 96) => simd::run_at(level, Costs::<2, 96>(work)),
            (3, 96) => simd::run_at(level, Costs::<3, 96>(work)),
            (6, 96) => simd::run_at(level, Costs::<6, 96>(work)),
            (8, 96) => simd::run_at(level, Costs::<8, 96>(work)),
            (1, _) => simd::run_at(level, Costs::<1, 16>(work)),
            (2, _) => simd::run_at(level, Costs::<2, 16>(work)),
            (3, _) => simd::run_at(level, Costs::<3, 16>(work)),
            (6, _) => simd::run_at(level, Costs::<6, 16>(work)),
            _ => simd::run_at(level, Costs::<8, 16>(work)),
        }
    }
    beyond(plan, left.width(), out);
}

/// What would be matched with what is left of the right image.
fn beyond(plan: &Plan, width: usize, out: &mut [u8]) {
    let near = out.chunks_exact_mut(plan.candidates).enumerate();
    let mut inside = 0;
    for (x, costs) in near.take(width.min(plan.last())) {
        let next = plan.disparities.iter().take(plan.candidates).skip(inside);
        inside += next.take_while(|&&d| usize::from(d) <= x).count();
        costs.get_mut(inside..).unwrap_or_default().fill(plan.beyond);
    }
}

impl Stepped {
    /// Every so many pixels of each plane, then those after them, and so on.
    fn fill(&mut self, step: usize, planes: &[u8], stride: usize) {
        let phase_stride = stride.div_ceil(step);
        self.rows.clear();
        for plane in planes.chunks_exact(stride) {
            for phase in 0..step {
                let before = self.rows.len();
                self.rows.extend(plane.iter().skip(phase).step_by(step));
                self.rows.resize(before + phase_stride, 0);
            }
        }
    }
}

struct Zoned<'a> {
    plan: &'a Plan,
    zone: &'a Zone,
    left: &'a [u8],
    left_stride: usize,
    /// From right to left.
    right: &'a [u8],
    right_stride: usize,
    phase_stride: usize,
    width: usize,
    out: &'a mut [u8],
}

/// `PLANES` of the census transform, `B` candidates at a time.
struct Costs<'a, const PLANES: usize, const B: usize>(Zoned<'a>);

impl<const PLANES: usize, const B: usize> Kernel for Costs<'_, PLANES, B> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Zoned {
            plan,
            zone,
            left,
            left_stride,
            right,
            right_stride,
            phase_stride,
            width,
            out,
        } = self.0;
        let is_plain = plan.alpha == 0 && plan.beta == 2;
        #[expect(clippy::cast_possible_truncation, reason = "at most 127")]
        let most = plan.threshold as u8;
        for x in 0..width {
            let place = width - 1 - x + zone.first;
            let place = place % zone.step * phase_stride + place / zone.step;
            for block in 0..zone.count / B {
                let mut differing = [0u8; B];
                for plane in 0..PLANES {
                    let (Some(&own), Some(others)) = (
                        left.get(plane * left_stride + x),
                        chunk::<u8, B>(right, plane * right_stride + place + block * B),
                    ) else {
                        return;
                    };
                    for k in 0..B {
                        #[expect(clippy::cast_possible_truncation, reason = "at most 8")]
                        let ones = (own ^ others[k]).count_ones() as u8;
                        differing[k] += ones;
                    }
                }
                let first = x * plan.candidates + zone.start + block * B;
                let Some(costs) = chunk_mut::<u8, B>(out, first) else {
                    return;
                };
                if is_plain {
                    for k in 0..B {
                        costs[k] = (differing[k] >> 1).min(most);
                    }
                    continue;
                }
                let (Some(&own), Some(others)) = (
                    left.get(PLANES * left_stride + x),
                    chunk::<u8, B>(right, PLANES * right_stride + place + block * B),
                ) else {
                    return;
                };
                for k in 0..B {
                    let levels = u32::from(own.abs_diff(others[k]));
                    let both = plan.alpha * levels + plan.beta * (u32::from(differing[k]) << 3);
                    #[expect(clippy::cast_possible_truncation, reason = "at most 127")]
                    let cost = (both >> 5).min(plan.threshold) as u8;
                    costs[k] = cost;
                }
            }
        }
    }
}
