//! Subpixel interpolation, confidence and invalidation.

use oaktwin_simd::{self as simd, Kernel, Level};

use super::out::Out;
use super::parameters::Interpolation;
use super::plan::PassPlan;
use super::rvc4::{LOST, OCCLUDED};
use super::select::RowWinners;
use crate::Reason;

/// The value for a pixel without a disparity in the right image.
pub(super) const NONE: u16 = u16::MAX;

/// The buffers of a row.
#[derive(Clone, Debug, Default)]
pub(super) struct Refined {
    /// The fractions of the disparity steps, relative to the winner.
    fractions: Vec<f32>,
    /// The winning disparity of each right pixel in px, or [`NONE`].
    pub(super) right: Vec<u16>,
}

/// Computes a row's disparities, in steps from the shift with 0 for invalid, and its confidence 255 (s₂ − s₁) / s₂. For
/// RVC4, the disparities of all winners are kept, with [bits](LOST) that mark the rejected ones.
pub(super) fn row(level: Level, plan: &PassPlan, found: &RowWinners, memory: &mut Refined, out: Out<'_>) {
    let Out {
        disparity,
        confidence,
        lost,
    } = out;
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
    for (x, code) in lost.iter_mut().enumerate() {
        *code = reason(plan, found, memory, x).code();
    }
    if plan.rvc4.is_some() {
        for (x, out) in disparity.iter_mut().enumerate() {
            *out = marked(plan, found, memory, x);
        }
        return;
    }
    for x in 0..width {
        let candidate = usize::from(found.best[x]);
        let own = plan.disparities[candidate];
        let is_kept = holds(plan, own, x, apart(memory, own, x)) && confidence[x] >= plan.confidence;
        disparity[x] = if is_kept {
            fixed(plan, candidate, memory.fractions[x])
        } else {
            0
        };
    }
}

/// Returns why a winner does not [hold](holds), or [`Reason::Measured`] if it does.
fn reason(plan: &PassPlan, found: &RowWinners, memory: &Refined, x: usize) -> Reason {
    let own = found
        .best
        .get(x)
        .and_then(|best| plan.disparities.get(usize::from(*best)));
    let own = own.copied().unwrap_or_default();
    if usize::from(own) > x {
        Reason::OutsideOtherView
    } else if x < plan.invalid_edge {
        Reason::Border
    } else if holds(plan, own, x, apart(memory, own, x)) {
        Reason::Measured
    } else {
        Reason::LeftRightCheck
    }
}

/// Returns a winner's disparity, in steps from the shift.
#[inline(always)]
fn fixed(plan: &PassPlan, candidate: usize, fraction: f32) -> u16 {
    let own = plan.disparities[candidate];
    // The distance to the neighbour on the side of the fraction.
    let toward = if fraction < 0.0 {
        candidate.wrapping_sub(1)
    } else {
        candidate + 1
    };
    let neighbour = plan.disparities.get(toward).copied().unwrap_or(own);
    let step = f32::from(neighbour.abs_diff(own).max(1));
    let exact = (f32::from(own - plan.shift) + fraction * step) * f32::from(1u16 << plan.bits);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "saturates"
    )]
    let fixed = (exact + 0.5) as u16;
    fixed
}

/// Returns a winner's disparity with its bits.
fn marked(plan: &PassPlan, found: &RowWinners, memory: &Refined, x: usize) -> u16 {
    let candidate = usize::from(found.best[x]);
    let own = plan.disparities[candidate];
    let apart = apart(memory, own, x);
    let is_seen = apart.is_some_and(|apart| apart <= 1);
    fixed(plan, candidate, memory.fractions[x])
        | if holds(plan, own, x, apart) { 0 } else { LOST }
        | if is_seen { 0 } else { OCCLUDED }
}

/// Returns the difference between a winner's disparity and its counterpart's in the right image, px; `None` if
/// the counterpart has none or is outside the image.
#[inline(always)]
fn apart(memory: &Refined, own: u16, x: usize) -> Option<u16> {
    let partner = x.checked_sub(own.into())?;
    let other = *memory.right.get(partner)?;
    (other != NONE).then(|| other.abs_diff(own))
}

/// Whether a winner is inside both images, not in the invalid edge, and passes the left-right check, if enabled.
#[inline(always)]
fn holds(plan: &PassPlan, own: u16, x: usize, apart: Option<u16>) -> bool {
    let agrees = match plan.check {
        Some(threshold) => apart.is_some_and(|apart| apart <= threshold),
        None => usize::from(own) <= x,
    };
    agrees && x >= plan.invalid_edge
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
        match self.interpolation {
            Interpolation::Parabola => self.all(|[_, b, c, d, _], _| parabola(b, c, d)),
            Interpolation::Lines => self.all(|[_, b, c, d, _], _| {
                let (before, after) = (b - c, d - c);
                let steeper = if before > after { before } else { after };
                (b - d, 2.0 * steeper)
            }),
            Interpolation::Parabola5 => self.all(|[a, b, c, d, e], is_inside| {
                let (slope, bend) = parabola(b, c, d);
                let slope5 = 7.0 * (2.0 * (a - e) + (b - d));
                let bend5 = 10.0 * (2.0 * (a + e - c) - b - d);
                let is_five = is_inside & (bend5 > 0.0);
                (
                    if is_five { slope5 } else { slope },
                    if is_five { bend5 } else { bend },
                )
            }),
        }
    }
}

#[inline(always)]
fn parabola(before: f32, own: f32, after: f32) -> (f32, f32) {
    (before - after, 2.0 * (before - 2.0 * own + after))
}

impl Fractions<'_> {
    /// Computes the fractions. `vertex` returns the numerator and the denominator from five sums and whether all of
    /// them are valid.
    #[inline(always)]
    fn all(self, vertex: impl Fn([f32; 5], bool) -> (f32, f32)) {
        let width = self.fractions.len();
        let [a, b, c, d, e] = self.around.map(|sums| sums.get(..width).unwrap_or_default());
        let sums = a
            .iter()
            .zip(b)
            .zip(c)
            .zip(d)
            .zip(e)
            .zip(self.second)
            .zip(self.best);
        let out = self.fractions.iter_mut().zip(self.confidence);
        #[expect(clippy::cast_possible_truncation, reason = "95")]
        let last = self.last as u8;
        for (((((((a, b), c), d), e), second), &best), (fraction, confidence)) in sums.zip(out) {
            let [a, b, c, d, e] = [a, b, c, d, e].map(|&sum| f32::from(sum));
            let (over, under) = vertex([a, b, c, d, e], (best >= 2) & (best + 2 <= last));
            let is_vertex = (under > 0.0) & (best > 0) & (best < last);
            let place = over / if is_vertex { under } else { 1.0 };
            let place = if is_vertex { place } else { 0.0 };
            let place = if place < 0.5 { place } else { 0.5 };
            *fraction = if place > -0.5 { place } else { -0.5 };

            let second = f32::from(*second);
            let share = 255.0 * (second - c) / if second > 0.0 { second } else { 1.0 };
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
            let share = simd::saturating_trunc(share) as u8;
            *confidence = share;
        }
    }
}
