use std::collections::BTreeMap;

use oaktwin_base::diagnostic::{Finding, add_new, message, opt};
use oaktwin_pipeline::progress::{Progress, Watch};
use oaktwin_pipeline::render::Renderer;
use oaktwin_scene::Scene;

use super::assessment::{CandidateOutcomes, assess_points};
use super::report::{
    CandidateCoverage, Coverage, Occluder, OwnRobot, PointOutcomes, SampledRegion, Selected, Shares,
};
use super::{Candidate, CoverageError, Outcome, Region, Samples};

/// The default number of points: the standard error of a share is at most 0.5 %.
pub const SAMPLES: u32 = 10_000;

/// The maximum number of points.
pub const MAX_SAMPLES: u32 = 1_000_000;

/// The maximum number of candidates: about an hour.
pub const MAX_CANDIDATES: usize = 10_000;

/// The maximum number of selected candidates.
pub(super) const MAX_SELECTED: usize = 8;

/// The maximum number of outcomes that are kept, 5 bytes each.
const MAX_KEPT: usize = 100_000_000;

/// The maximum number of occluders in a report.
const MAX_OCCLUDERS: usize = 5;

/// The settings of a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoverageOptions {
    /// The number of points on the surface, up to [`MAX_SAMPLES`].
    pub samples: u32,
    /// The largest error of a point that counts as measured; `None` for any.
    pub tolerance_mm: Option<f64>,
    /// Whether the outcomes at each point are kept: [`Coverage::points`].
    pub keeps_points: bool,
}

impl Default for CoverageOptions {
    fn default() -> Self {
        Self {
            samples: SAMPLES,
            tolerance_mm: None,
            keeps_points: false,
        }
    }
}

impl CoverageOptions {
    pub(super) fn check(&self, candidates: usize) -> Result<(), CoverageError> {
        let wrong = |option, what: String| Err(message![opt(option), format!(": {what}")].into());
        if self.samples == 0 || self.samples > MAX_SAMPLES {
            let what = format!(
                "{} points are out of range; give 1 to {MAX_SAMPLES}",
                self.samples
            );
            return wrong("samples", what);
        }
        if let Some(tolerance) = self.tolerance_mm
            && !(tolerance > 0.0 && tolerance.is_finite())
        {
            let what = format!("{tolerance} mm is out of range; give more than 0");
            return wrong("tolerance", what);
        }
        if candidates == 0 {
            return wrong(
                "poses",
                "there are no candidates; give at least one pose".to_owned(),
            );
        }
        check_candidates(candidates)?;
        if self.keeps_points && candidates.saturating_mul(self.samples as usize) > MAX_KEPT {
            let what = format!(
                "the outcomes of {candidates} candidates at {} points each are too many to keep; give fewer points",
                self.samples
            );
            return wrong("samples", what);
        }
        Ok(())
    }
}

/// Returns an error if there are too many candidates.
pub(super) fn check_candidates(count: usize) -> Result<(), CoverageError> {
    if count <= MAX_CANDIDATES {
        return Ok(());
    }
    let what = format!(": {count} candidates are too many; give at most {MAX_CANDIDATES}");
    Err(message![opt("poses"), what].into())
}

/// Measures the coverage of a region of the renderer's scene by candidates. If `watch` interrupts it, the result has the candidates that
/// are complete.
///
/// # Errors
/// Returns an error if the region is invalid or has no surface, or an option is out of range.
pub fn measure(
    renderer: &Renderer,
    region: &Region,
    candidates: &[Candidate<'_>],
    options: &CoverageOptions,
    watch: &Watch<'_>,
) -> Result<Coverage, CoverageError> {
    options.check(candidates.len())?;
    let samples = Samples::new(renderer.scene(), region, options.samples)?;
    let mut tally = Tally::new(samples.points.len(), options.keeps_points);
    let total = candidates.len() as u64;
    let mut is_interrupted = false;
    for (candidate, done) in candidates.iter().zip(0..) {
        if watch(Progress { done, total }).is_break() {
            is_interrupted = true;
            break;
        }
        let mut assessed = assess_points(renderer, candidate, &samples.points)?;
        if let Some(tolerance) = options.tolerance_mm {
            assessed.reject_errors_above(tolerance * 1e-3);
        }
        tally.add(renderer.scene(), candidate, assessed, None);
    }
    if !is_interrupted {
        // Nothing is left to be interrupted.
        let _ = watch(Progress { done: total, total });
    }
    Ok(tally.finish(region, samples, is_interrupted))
}

/// The results so far.
pub(super) struct Tally {
    candidates: Vec<CandidateCoverage>,
    /// The best outcome at each point, and the sum and number of the errors.
    best: Vec<Outcome>,
    errors: Vec<(f64, u32)>,
    /// Whether each candidate measures each point.
    measured: Vec<Bits>,
    keeps_points: bool,
    outcomes: Vec<Vec<Outcome>>,
    errors_m: Vec<Vec<f32>>,
    findings: Vec<Finding>,
}

impl Tally {
    pub(super) fn new(points: usize, keeps_points: bool) -> Self {
        Self {
            candidates: Vec::new(),
            best: vec![Outcome::OUTSIDE_VIEW; points],
            errors: vec![(0.0, 0); points],
            measured: Vec::new(),
            keeps_points,
            outcomes: Vec::new(),
            errors_m: Vec::new(),
            findings: Vec::new(),
        }
    }

    pub(super) fn add(
        &mut self,
        scene: &Scene,
        candidate: &Candidate<'_>,
        assessed: CandidateOutcomes,
        own_robot: Option<OwnRobot>,
    ) {
        for (best, outcome) in self.best.iter_mut().zip(&assessed.outcomes) {
            *best = (*best).min(*outcome);
        }
        for ((sum, number), error) in self.errors.iter_mut().zip(&assessed.errors_m) {
            if !error.is_nan() {
                *sum += f64::from(*error);
                *number += 1;
            }
        }
        let (rig, pose) = (candidate.rig, &candidate.world_from_body);
        let up = scene.up.direction();
        let axis = rig.camera.view(pose).world_from_camera.rotation.z_axis;
        self.candidates.push(CandidateCoverage {
            name: candidate.name.clone(),
            model: rig.name().to_owned(),
            engine: rig.sensor.engine().kind().name.to_string(),
            position_m: pose.translation.to_array(),
            orientation: pose.quaternion().to_array(),
            height_m: pose.translation.dot(up),
            tilt_deg: (-axis.dot(up)).clamp(-1.0, 1.0).asin().to_degrees(),
            shares: Shares::new(
                &assessed.outcomes,
                assessed.errors_m.iter().copied().map(f64::from),
            ),
            occluders: occluders(scene, &assessed.occluders, assessed.outcomes.len()),
            own_robot,
        });
        self.measured.push(Bits::new(&assessed.outcomes));
        add_new(&mut self.findings, assessed.findings);
        if self.keeps_points {
            self.outcomes.push(assessed.outcomes);
            self.errors_m.push(assessed.errors_m);
        }
    }

    pub(super) fn finish(self, region: &Region, samples: Samples, is_interrupted: bool) -> Coverage {
        let count = u32::try_from(samples.points.len()).unwrap_or(u32::MAX);
        let mean = |&(sum, number): &(f64, u32)| {
            if number > 0 {
                sum / f64::from(number)
            } else {
                f64::NAN
            }
        };
        Coverage {
            region: SampledRegion {
                objects: region.objects.clone(),
                minimum_m: region.within.map(|within| within.min.to_array()),
                maximum_m: region.within.map(|within| within.max.to_array()),
                area_m2: samples.area_m2,
                samples: count,
                standard_error: 0.5 / f64::from(count.max(1)).sqrt(),
            },
            ranking: ranking(self.candidates.len(), |index| &self.candidates[index].shares),
            together: Shares::new(&self.best, self.errors.iter().map(mean)),
            selection: selection(&self.measured, count),
            candidates: self.candidates,
            findings: self.findings,
            is_interrupted,
            points: self.keeps_points.then_some(PointOutcomes {
                samples,
                outcomes: self.outcomes,
                errors_m: self.errors_m,
            }),
        }
    }
}

fn occluders(scene: &Scene, counts: &BTreeMap<u32, u32>, points: usize) -> Vec<Occluder> {
    let mut sorted: Vec<(u32, u32)> = counts
        .iter()
        .map(|(&instance, &count)| (count, instance))
        .collect();
    sorted.sort_by_key(|&(count, instance)| (u32::MAX - count, instance));
    sorted.truncate(MAX_OCCLUDERS);
    let path = |instance: u32| scene.instances.get(instance as usize).map(|one| one.path.clone());
    sorted
        .into_iter()
        .filter_map(|(count, instance)| {
            Some(Occluder {
                path: path(instance)?,
                share: f64::from(count) / points.max(1) as f64,
            })
        })
        .collect()
}

/// Sorts what has these shares by what it measures, best first, then by its errors.
pub(super) fn ranking<'a>(count: usize, shares: impl Fn(usize) -> &'a Shares) -> Vec<usize> {
    let mut ranking: Vec<usize> = (0..count).collect();
    let error = |index: usize| shares(index).median_absolute_error_mm.unwrap_or(f64::INFINITY);
    ranking.sort_by(|&a, &b| {
        let measured = |index: usize| shares(index).measured;
        measured(b)
            .total_cmp(&measured(a))
            .then(error(a).total_cmp(&error(b)))
    });
    ranking
}

/// Chooses candidates one after the other, each for the number of points that it adds, until none adds more than the standard error.
fn selection(measured: &[Bits], points: u32) -> Vec<Selected> {
    let mut together = Bits(vec![0; points.div_ceil(64) as usize]);
    let mut selection = Vec::new();
    let mut count = 0;
    while selection.len() < MAX_SELECTED {
        let gains = measured.iter().map(|bits| bits.count_beyond(&together));
        // Of several candidates with the same gain, the first is chosen.
        let best = gains
            .enumerate()
            .max_by_key(|&(index, gain)| (gain, usize::MAX - index));
        let is_enough = |gain: u32| f64::from(gain) > 0.5 * f64::from(points).sqrt();
        let Some((candidate, gain)) = best.filter(|(_, gain)| is_enough(*gain)) else {
            break;
        };
        together.unite(&measured[candidate]);
        count += gain;
        selection.push(Selected {
            candidate,
            measured: f64::from(count) / f64::from(points.max(1)),
        });
    }
    selection
}

/// A bit for each point.
struct Bits(Vec<u64>);

impl Bits {
    fn new(outcomes: &[Outcome]) -> Self {
        let word = |outcomes: &[Outcome]| {
            let bits = outcomes.iter().enumerate();
            bits.fold(0, |word, (i, outcome)| {
                word | u64::from(*outcome == Outcome::MEASURED) << i
            })
        };
        Self(outcomes.chunks(64).map(word).collect())
    }

    /// The number of bits that `others` lacks.
    fn count_beyond(&self, others: &Self) -> u32 {
        let words = self.0.iter().zip(&others.0);
        words.map(|(own, other)| (own & !other).count_ones()).sum()
    }

    fn unite(&mut self, others: &Self) {
        for (own, other) in self.0.iter_mut().zip(&others.0) {
            *own |= other;
        }
    }
}
