//! Samples of a row get their disparity and move by it.

use super::assumptions::TargetRounding;
use super::plan::Plan;
use crate::random::Plane;

/// What lands on a pixel: what is less wins.
pub(super) trait Key: Copy + Ord {
    /// Nothing landed.
    const NONE: Self;
    fn new(rank: u32, column: u32) -> Self;
    /// Twice the bits of the depth that is reported, and 1 more where confidence is lacking: nearer is less.
    fn rank(self) -> u32;
    /// Where the sample comes from, where the key says so.
    fn column(self) -> u32;
}

/// Only the depth.
impl Key for u32 {
    const NONE: Self = u32::MAX;
    #[inline(always)]
    fn new(rank: u32, _: u32) -> Self {
        rank
    }
    #[inline(always)]
    fn rank(self) -> u32 {
        self
    }
    #[inline(always)]
    fn column(self) -> u32 {
        0
    }
}

/// The depth and the column it comes from.
impl Key for u64 {
    const NONE: Self = u64::MAX;
    #[inline(always)]
    fn new(rank: u32, column: u32) -> Self {
        u64::from(rank) << 32 | u64::from(column)
    }
    #[inline(always)]
    fn rank(self) -> u32 {
        (self >> 32) as u32
    }
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "the lower half")]
    fn column(self) -> u32 {
        self as u32
    }
}

/// The depth of a rank: 0 where nothing landed or confidence is lacking.
#[inline(always)]
pub(super) fn depth(rank: u32) -> f32 {
    if rank & 1 == 0 {
        f32::from_bits(rank >> 1)
    } else {
        0.0
    }
}

/// Samples of a row: where they go, and with what.
#[derive(Clone, Copy)]
struct Samples<'a> {
    disparity: &'a [f32],
    reported: &'a [f32],
}

/// Buffers of one row.
#[derive(Debug, Default)]
pub(super) struct Row {
    /// Disparity, px; infinite for no sample.
    pub(super) disparity: Vec<f32>,
    /// Depths as they are computed from disparity.
    recomputed: Vec<f32>,
    ranks: Vec<u32>,
    targets: Vec<u32>,
    /// Normal numbers of the row's patches, then of its columns.
    patches: Vec<f32>,
    jitter: Vec<f32>,
    patch_of: Vec<u32>,
    /// The row of patches that `jitter` holds.
    held: Option<u32>,
}

impl Row {
    /// Forgets the image.
    pub(super) fn reset(&mut self, plan: &Plan) {
        let width = plan.width;
        for buffer in [&mut self.disparity, &mut self.recomputed, &mut self.jitter] {
            buffer.resize(width, 0.0);
        }
        self.ranks.resize(width, 0);
        self.targets.resize(width, 0);
        self.patch_of.clear();
        self.patch_of.extend((0..width).map(|x| plan.patch(x)));
        self.patches.resize(plan.patch(width - 1) as usize + 1, 0.0);
        self.held = None;
    }

    /// Moves a row of depths: what lands on each pixel. `lacking` is 1 where a sample has no confidence, and empty
    /// where nobody asks.
    #[inline(always)]
    pub(super) fn warp<K: Key>(
        &mut self,
        plan: &Plan,
        random: &Plane,
        y: usize,
        row: &[f32],
        lacking: &[u32],
        landed: &mut [K],
    ) {
        disparities(plan, row, &mut self.disparity);
        if plan.step_px > 0.0 {
            if plan.sigma_px > 0.0 {
                self.draw(plan, random, y);
            }
            quantize(plan, &self.jitter, &mut self.disparity);
        }
        let reported = if plan.recomputes {
            recompute(plan, &mut self.disparity, &mut self.recomputed);
            self.recomputed.as_slice()
        } else {
            row
        };
        let samples = Samples {
            disparity: &self.disparity,
            reported,
        };
        let (ranks, targets) = (&mut self.ranks, &mut self.targets);
        match plan.assumptions.target_rounding {
            TargetRounding::Nearest => aim(f32::round_ties_even, plan.side, samples, ranks, targets),
            TargetRounding::Floor => aim(f32::floor, plan.side, samples, ranks, targets),
        }
        for (rank, lacking) in self.ranks.iter_mut().zip(lacking) {
            *rank |= lacking;
        }
        scatter(plan.last_wins, &self.ranks, &self.targets, landed);
    }

    /// Normal numbers for row `y`, new where it begins a row of patches.
    #[inline(always)]
    fn draw(&mut self, plan: &Plan, random: &Plane, y: usize) {
        let patch = plan.patch(y);
        if self.held == Some(patch) {
            return;
        }
        self.held = Some(patch);
        if plan.patch_px > 1.0 {
            random.normals_here(patch, &mut self.patches);
            for (jitter, &patch) in self.jitter.iter_mut().zip(&self.patch_of) {
                *jitter = self.patches[patch as usize];
            }
        } else {
            random.normals_here(patch, &mut self.jitter);
        }
    }
}

#[inline(always)]
fn disparities(plan: &Plan, row: &[f32], out: &mut [f32]) {
    let ([near, far], max) = (plan.looked_at, plan.max_disparity_px);
    let dropped_from = if plan.clamps { f32::INFINITY } else { max };
    for (out, &z) in out.iter_mut().zip(row) {
        let d = plan.disparity_times_depth / z;
        // Not a number is neither.
        let is_seen = (z > 0.0) & (z >= near) & (z <= far) & (d <= dropped_from);
        let d = if d < max { d } else { max };
        *out = if is_seen { d } else { f32::INFINITY };
    }
}

#[inline(always)]
fn quantize(plan: &Plan, jitter: &[f32], disparity: &mut [f32]) {
    let (step, sigma) = (plan.step_px, plan.sigma_px);
    let samples = disparity.iter_mut().zip(jitter);
    if plan.floors {
        samples.for_each(|(d, n)| *d = step * (*d / step).floor() + sigma * n);
    } else {
        samples.for_each(|(d, n)| *d = step * (*d / step).round_ties_even() + sigma * n);
    }
}

/// Depth from disparity; what has none is no sample.
#[inline(always)]
fn recompute(plan: &Plan, disparity: &mut [f32], out: &mut [f32]) {
    for (d, out) in disparity.iter_mut().zip(out) {
        *out = plan.disparity_times_depth / *d;
        *d = if (*d > 0.0) & (*out <= f32::MAX) {
            *d
        } else {
            f32::INFINITY
        };
    }
}

/// Ranks and targets of samples that shift by so many columns; a sample that leaves the image has no rank, and its own
/// column for a target.
#[inline(always)]
fn aim(round: impl Fn(f32) -> f32, side: f32, row: Samples<'_>, ranks: &mut [u32], targets: &mut [u32]) {
    let count = ranks.len();
    let (disparity, reported) = (&row.disparity[..count], &row.reported[..count]);
    let targets = &mut targets[..count];
    #[expect(
        clippy::cast_possible_truncation,
        reason = "images are at most 2³² columns wide"
    )]
    let width = count as u32;
    let limit = width as f32;
    for x in 0..count {
        let shift = round(side * disparity[x]);
        // Not so where there is no sample.
        let is_near = shift.abs() <= limit;
        #[expect(
            clippy::cast_possible_truncation,
            reason = "columns, and whole numbers up to their count"
        )]
        let (column, shift) = (x as u32, if is_near { shift } else { 0.0 } as i32);
        let target = column.wrapping_add(shift.cast_unsigned());
        let lands = is_near & (target < width);
        ranks[x] = if lands {
            reported[x].to_bits() << 1
        } else {
            u32::NONE
        };
        targets[x] = if lands { target } else { column };
    }
}

/// Puts samples at their targets.
#[inline(always)]
fn scatter<K: Key>(last_wins: bool, ranks: &[u32], targets: &[u32], landed: &mut [K]) {
    landed.fill(K::NONE);
    let samples = || (0u32..).zip(ranks.iter().zip(targets));
    if last_wins {
        for (column, (&rank, &target)) in samples() {
            if let Some(place) = landed.get_mut(target as usize)
                && rank != u32::NONE
            {
                *place = K::new(rank, column);
            }
        }
        return;
    }
    for (column, (&rank, &target)) in samples() {
        if let Some(place) = landed.get_mut(target as usize) {
            *place = K::new(rank, column).min(*place);
        }
    }
}
