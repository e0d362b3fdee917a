//! Fractions of disparities, confidence, and what is lost.

use super::parameters::Interpolation;
use super::plan::Plan;
use super::select::Found;
use crate::simd::{self, Kernel, Level};

/// No candidate of the right image.
pub(super) const NONE: u16 = u16::MAX;

/// Memory for a row.
#[derive(Clone, Debug, Default)]
pub(super) struct Refined {
    /// Steps of disparity from the winner.
    fractions: Vec<f32>,
    /// The winning disparity of each right pixel, px, or [`NONE`].
    pub(super) right: Vec<u16>,
}

/// A row's disparities, in steps from the shift, 0 for none; and its confidence.
pub(super) fn row(
    level: Level,
    plan: &Plan,
    found: &Found,
    memory: &mut Refined,
    disparity: &mut [u16],
    confidence: &mut [u8],
) {
    let width = disparity.len();
    memory.fractions.resize(width, 0.0);
    let [a, b, c, d, e] = found.around.each_ref().map(Vec::as_slice);
    simd::run_at(
        level,
        Fractions {
            interpolation: plan.interpolation,
            last: plan.candidates - 1,
            best: &found.best,
            around: [a, b, c, d, e],
            second: &found.second,
            fractions: &mut memory.fractions,
            confidence,
        },
    );
    let unit = f32::from(1u16 << plan.bits);
    for x in 0..width {
        let candidate = usize::from(found.best[x]);
        let own = plan.disparities[candidate];
        let Some(partner) = x.checked_sub(own.into()) else {
            disparity[x] = 0;
            continue;
        };
        let agrees = plan.check.is_none_or(|threshold| {
            let other = memory.right.get(partner).copied().unwrap_or(NONE);
            other != NONE && other.abs_diff(own) <= threshold
        });
        let fraction = memory.fractions[x];
        // The step to the neighbour that the fraction goes to.
        let toward = if fraction < 0.0 {
            candidate.wrapping_sub(1)
        } else {
            candidate + 1
        };
        let neighbour = plan.disparities.get(toward).copied().unwrap_or(own);
        let step = f32::from(neighbour.abs_diff(own).max(1));
        let exact = (f32::from(own - plan.shift) + fraction * step) * unit;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates"
        )]
        let fixed = (exact + 0.5) as u16;
        let is_kept = agrees && confidence[x] >= plan.confidence && x >= plan.invalid_edge;
        disparity[x] = if is_kept { fixed } else { 0 };
    }
}

struct Fractions<'a> {
    interpolation: Interpolation,
    last: usize,
    best: &'a [u8],
    around: [&'a [u16]; 5],
    second: &'a [u16],
    fractions: &'a mut [f32],
    confidence: &'a mut [u8],
}

impl Kernel for Fractions<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let width = self.fractions.len().min(self.confidence.len());
        let [a, b, c, d, e] = self.around;
        let shortest = [a, b, c, d, e, self.second].iter().map(|row| row.len()).min();
        if shortest < Some(width) || self.best.len() < width {
            return;
        }
        #[expect(clippy::cast_possible_truncation, reason = "95")]
        let last = self.last as u8;
        for x in 0..width {
            let best = self.best[x];
            let (y0, yn, yp) = (f32::from(c[x]), f32::from(b[x]), f32::from(d[x]));
            let (ynn, ypp) = (f32::from(a[x]), f32::from(e[x]));
            let slope = yn - yp;
            let bend = 2.0 * (yn - 2.0 * y0 + yp);
            let (over, under) = match self.interpolation {
                Interpolation::Parabola => (slope, bend),
                Interpolation::Lines => {
                    let (before, after) = (yn - y0, yp - y0);
                    let steeper = if before > after { before } else { after };
                    (slope, 2.0 * steeper)
                }
                Interpolation::Parabola5 => {
                    let bend5 = 10.0 * (2.0 * (ynn + ypp - y0) - yn - yp);
                    let is_inside = best >= 2 && best + 2 <= last && bend5 > 0.0;
                    let slope5 = 7.0 * (2.0 * (ynn - ypp) + slope);
                    (
                        if is_inside { slope5 } else { slope },
                        if is_inside { bend5 } else { bend },
                    )
                }
            };
            let fraction = over / if under > 0.0 { under } else { 1.0 };
            let fraction = if under > 0.0 { fraction } else { 0.0 };
            let fraction = if fraction < 0.5 { fraction } else { 0.5 };
            let fraction = if fraction > -0.5 { fraction } else { -0.5 };
            let is_between = best > 0 && best < last;
            self.fractions[x] = if is_between { fraction } else { 0.0 };

            let second = f32::from(self.second[x]);
            let lead = second - y0;
            let share = 255.0 * lead / if second > 0.0 { second } else { 1.0 };
            let share = if second > 0.0 { share } else { 0.0 };
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
            let share = simd::whole(share) as u8;
            self.confidence[x] = share;
        }
    }
}
