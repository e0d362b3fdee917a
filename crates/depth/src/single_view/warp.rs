//! Computes the disparities of the samples of a row and moves the samples by them.

use oaktwin_simd as simd;

use super::assumptions::TargetRounding;
use super::plan::SingleViewPlan;
use crate::random::RandomPlane;

/// A sample that moved to a pixel; of several, the smallest wins.
pub(super) trait Key: Copy + Ord {
    /// No sample.
    const NONE: Self;
    fn new(rank: u32, column: u32) -> Self;
    /// Twice the bits of the reported depth, plus 1 if confidence is too low: nearer samples are smaller.
    fn rank(self) -> u32;
    /// The source column of the sample, if the key contains it.
    fn column(self) -> u32;
}

/// A key of the depth alone.
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

/// A key of the depth and the source column.
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

/// Returns the depth of a rank: 0 without a sample, or if confidence is too low.
#[inline(always)]
pub(super) fn depth(rank: u32) -> f32 {
    if rank & 1 == 0 {
        f32::from_bits(rank >> 1)
    } else {
        0.0
    }
}

/// The columns that are processed together: as many as a word has bits, so that loops have no remainder.
pub(super) const LANES: usize = 64;

pub(super) type Lanes<T> = [T; LANES];

/// The buffers of one row; their lengths are multiples of [`LANES`].
#[derive(Debug, Default)]
pub(super) struct RowBuffers {
    /// The disparity in px; infinite without a sample.
    pub(super) disparity: Vec<f32>,
    ranks: Vec<u32>,
    targets: Vec<u32>,
    /// Normal numbers: of the row's patches, then of its columns.
    patches: Vec<f32>,
    jitter: Vec<f32>,
    /// The row of patches in `jitter`.
    held: Option<u32>,
}

impl RowBuffers {
    pub(super) fn reset(&mut self, plan: &SingleViewPlan) {
        let padded = plan.width.next_multiple_of(LANES);
        self.disparity.resize(padded, 0.0);
        self.jitter.resize(padded, 0.0);
        self.ranks.resize(padded, 0);
        self.targets.resize(padded, 0);
        let patches = plan.patch_of.last().map_or(0, |&last| last as usize + 1);
        self.patches.resize(patches.next_multiple_of(LANES), 0.0);
        self.held = None;
    }

    /// Moves a row of depths and fills `landed`. `lacking` is 1 where confidence is too low, and empty if confidence is not
    /// used.
    #[inline(always)]
    pub(super) fn warp<K: Key>(
        &mut self,
        plan: &SingleViewPlan,
        random: &RandomPlane,
        y: usize,
        row: &[f32],
        lacking: &[u32],
        landed: &mut [K],
    ) {
        if plan.step_px > 0.0 && plan.sigma_px > 0.0 {
            self.draw(plan, random, y);
        }
        let samples = self.disparity.as_chunks_mut().0.iter_mut();
        let samples = samples.zip(self.jitter.as_chunks().0);
        let aims = self.ranks.as_chunks_mut().0.iter_mut();
        let aims = aims.zip(self.targets.as_chunks_mut().0);
        for (x, ((d, jitter), (ranks, targets))) in (0..).step_by(LANES).zip(samples.zip(aims)) {
            let mut last = [0.0; LANES];
            let rest = &row[x..];
            let z = rest.first_chunk().unwrap_or_else(|| {
                last[..rest.len()].copy_from_slice(rest);
                &last
            });
            let mut recomputed = [0.0; LANES];
            disparities(plan, z, d);
            if plan.step_px > 0.0 {
                quantize(plan, jitter, d);
            }
            if plan.recomputes {
                recompute(plan, d, &mut recomputed);
            }
            let samples = Samples {
                x,
                disparity: d,
                reported: if plan.recomputes { &recomputed } else { z },
            };
            match plan.assumptions.target_rounding {
                TargetRounding::Nearest => samples.aim(plan, f32::round_ties_even, ranks, targets),
                TargetRounding::Floor => samples.aim(plan, f32::floor, ranks, targets),
            }
        }
        for (rank, lacking) in self.ranks.iter_mut().zip(lacking) {
            *rank |= lacking;
        }
        scatter(plan.last_wins, &self.ranks, &self.targets, landed);
    }

    /// Fills the normal numbers for row `y`; they change at each row of patches.
    #[inline(always)]
    fn draw(&mut self, plan: &SingleViewPlan, random: &RandomPlane, y: usize) {
        let patch = plan.patch(y);
        if self.held == Some(patch) {
            return;
        }
        self.held = Some(patch);
        if plan.patch_px > 1.0 {
            random.normals_here(patch, &mut self.patches);
            for (jitter, &patch) in self.jitter.iter_mut().zip(&plan.patch_of) {
                *jitter = self.patches[patch as usize];
            }
        } else {
            random.normals_here(patch, &mut self.jitter);
        }
    }
}

#[inline(always)]
fn disparities(plan: &SingleViewPlan, depth: &Lanes<f32>, out: &mut Lanes<f32>) {
    let ([near, far], max) = (plan.looked_at, plan.max_disparity_px);
    let dropped_from = if plan.clamps { f32::INFINITY } else { max };
    for (out, &z) in out.iter_mut().zip(depth) {
        let d = plan.disparity_times_depth / z;
        // NaN is neither.
        let is_seen = (z > 0.0) & (z >= near) & (z <= far) & (d <= dropped_from);
        let d = if d < max { d } else { max };
        *out = if is_seen { d } else { f32::INFINITY };
    }
}

#[inline(always)]
fn quantize(plan: &SingleViewPlan, jitter: &Lanes<f32>, disparity: &mut Lanes<f32>) {
    let (step, sigma) = (plan.step_px, plan.sigma_px);
    let samples = disparity.iter_mut().zip(jitter);
    if plan.floors {
        samples.for_each(|(d, n)| *d = step * (*d / step).floor() + sigma * n);
    } else {
        samples.for_each(|(d, n)| *d = step * (*d / step).round_ties_even() + sigma * n);
    }
}

/// Computes depth from disparity. Lanes without a valid disparity get an infinite one, which marks them as invalid.
#[inline(always)]
fn recompute(plan: &SingleViewPlan, disparity: &mut Lanes<f32>, out: &mut Lanes<f32>) {
    for (d, out) in disparity.iter_mut().zip(out) {
        *out = plan.disparity_times_depth / *d;
        *d = if (*d > 0.0) & (*out <= f32::MAX) {
            *d
        } else {
            f32::INFINITY
        };
    }
}

/// The disparities and reported depths of the columns from `x`.
struct Samples<'a> {
    x: usize,
    disparity: &'a Lanes<f32>,
    reported: &'a Lanes<f32>,
}

impl Samples<'_> {
    /// Computes the ranks and targets of samples; a sample that leaves the image has no rank, and its own column as target.
    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "images are at most 2³² columns wide"
    )]
    fn aim(
        &self,
        plan: &SingleViewPlan,
        round: impl Fn(f32) -> f32,
        ranks: &mut Lanes<u32>,
        targets: &mut Lanes<u32>,
    ) {
        let width = plan.width as u32;
        let limit = width as f32;
        for lane in 0..LANES {
            let shift = round(plan.side * self.disparity[lane]);
            // False without a sample.
            let is_near = shift.abs() <= limit;
            let column = (self.x + lane) as u32;
            let shift = simd::saturating_trunc(if is_near { shift } else { 0.0 });
            let target = column.wrapping_add(shift.cast_unsigned());
            let lands = is_near & (target < width);
            ranks[lane] = if lands {
                self.reported[lane].to_bits() << 1
            } else {
                u32::NONE
            };
            targets[lane] = if lands { target } else { column };
        }
    }
}

/// Writes samples to their targets.
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
