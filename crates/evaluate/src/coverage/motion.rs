//! The coverage by an OAK on a robot, over the postures of a motion.

use std::collections::BTreeMap;

use oaktwin_base::diagnostic::{Finding, add_new};
use oaktwin_camera::RigidTransform;
use oaktwin_pipeline::progress::{Progress, Watch};
use oaktwin_pipeline::render::{Backend, Renderer};
use oaktwin_robot::PlacedRobot;
use serde::Serialize;

use super::assessment::{CandidateOutcomes, assess_points};
use super::measure::{Tally, ranking};
use super::report::{OwnRobot, SampledRegion, Selected};
use super::{Candidate, CandidateCoverage, CoverageError, CoverageOptions, Region, Samples, Shares};

/// A robot that moves through postures, and may carry an OAK.
#[derive(Clone, Copy, Debug)]
pub struct Carrier<'a> {
    /// The robot in the renderer's scene.
    pub robot: &'a PlacedRobot,
    /// The index of the link that carries the OAK; without one, the OAK stays in the world.
    pub link: Option<usize>,
    /// The position of each joint in each posture.
    pub postures: &'a [Vec<f64>],
}

/// The coverage of a region over a motion, by candidates for the pose on the robot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MotionCoverage {
    /// The surface.
    pub region: SampledRegion,
    /// The results in the order of the candidates.
    pub mounts: Vec<MountCoverage>,
    /// The indices of the mounts by the share that they measure over the whole motion, then by their median absolute error, best first.
    pub ranking: Vec<usize>,
    /// The renderer's findings, without duplicates.
    pub findings: Vec<Finding>,
    /// Whether the measurement was interrupted.
    #[serde(rename = "interrupted")]
    pub is_interrupted: bool,
}

/// The coverage by an OAK at one pose on a link.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MountCoverage {
    /// The name.
    pub name: String,
    /// The name of the model.
    pub model: String,
    /// The position of the body in the link.
    pub position_m: [f64; 3],
    /// The rotation of the body in the link as a quaternion `qx qy qz qw`.
    pub orientation: [f64; 4],
    /// The coverage by all postures together, as [`Coverage::together`](super::Coverage::together).
    pub together: Shares,
    /// The share of the pixels that show the robot, the mean over the postures.
    pub own_robot: f64,
    /// The coverage in each posture.
    pub postures: Vec<CandidateCoverage>,
    /// The postures that measure most together, as [`Coverage::selection`](super::Coverage::selection).
    pub selection: Vec<Selected>,
}

impl Carrier<'_> {
    /// Moves the robot in the renderer's scene, and returns a candidate in the world, whose own pose is relative to the link that carries it.
    ///
    /// # Panics
    /// Panics if there is no such posture.
    #[must_use]
    pub fn carry<'c>(&self, renderer: &mut Renderer, posture: usize, mount: &Candidate<'c>) -> Candidate<'c> {
        let links = self.robot.world_from_links(&self.postures[posture]);
        renderer.set_poses(self.robot.poses(&links));
        self.carried(&links, posture, mount)
    }

    fn carried<'c>(&self, links: &[RigidTransform], posture: usize, mount: &Candidate<'c>) -> Candidate<'c> {
        Candidate {
            rig: mount.rig,
            name: format!("posture {posture}"),
            world_from_body: match self.link {
                Some(link) => links[link] * mount.world_from_body,
                None => mount.world_from_body,
            },
        }
    }

    /// Returns the share of the pixels of a candidate's image that show the robot.
    #[must_use]
    pub fn own_share(&self, renderer: &Renderer, candidate: &Candidate<'_>) -> f64 {
        self.own_links(renderer, candidate).0
    }

    /// Returns the same with the share of each link.
    fn own_links(&self, renderer: &Renderer, candidate: &Candidate<'_>) -> (f64, Vec<(String, f64)>) {
        let hits = renderer.visibility(&candidate.view(), Backend::Auto).hits;
        let mut counts: BTreeMap<usize, u32> = BTreeMap::new();
        for hit in hits.pixels().iter().filter(|hit| !hit.is_miss()) {
            if let Some(link) = self.robot.link_of(hit.instance as usize) {
                *counts.entry(link).or_default() += 1;
            }
        }
        let share = |count: u32| f64::from(count) / hits.pixels().len().max(1) as f64;
        let mut links: Vec<(String, f64)> = (counts.iter())
            .map(|(&link, &count)| (self.robot.robot().links[link].name.clone(), share(count)))
            .collect();
        links.sort_by(|a, b| b.1.total_cmp(&a.1));
        (share(counts.values().sum()), links)
    }

    /// Returns what a candidate sees of the robot, and does not see because of it.
    fn own_robot(
        &self,
        renderer: &Renderer,
        candidate: &Candidate<'_>,
        assessed: &CandidateOutcomes,
    ) -> OwnRobot {
        let (share, links) = self.own_links(renderer, candidate);
        let hidden = assessed.occluders.iter();
        let hidden = hidden.filter(|&(&instance, _)| self.robot.link_of(instance as usize).is_some());
        let hidden: u32 = hidden.map(|(_, &count)| count).sum();
        OwnRobot {
            share,
            links,
            hides: f64::from(hidden) / assessed.outcomes.len().max(1) as f64,
        }
    }
}

/// Measures the coverage of a region over the postures of a robot by candidates, whose poses are relative to the link that carries them. The robot itself does not
/// belong to the region. If `watch` interrupts it, the result has the postures that are complete.
///
/// # Errors
/// Returns an error if the region is invalid or has no surface, or an option is out of range.
pub fn measure_motion(
    renderer: &mut Renderer,
    region: &Region,
    carrier: &Carrier<'_>,
    mounts: &[Candidate<'_>],
    options: &CoverageOptions,
    watch: &Watch<'_>,
) -> Result<MotionCoverage, CoverageError> {
    let count = mounts.len().saturating_mul(carrier.postures.len());
    options.check(count)?;
    let mut region = region.clone();
    region.without.push(carrier.robot.path().to_owned());
    let samples = Samples::new(renderer.scene(), &region, options.samples)?;
    let new = |_| Tally::new(samples.points.len(), false);
    let mut tallies: Vec<Tally> = mounts.iter().map(new).collect();
    let total = count as u64;
    let mut done = 0;
    let mut is_interrupted = false;
    'postures: for (posture, positions) in carrier.postures.iter().enumerate() {
        let links = carrier.robot.world_from_links(positions);
        renderer.set_poses(carrier.robot.poses(&links));
        for (mount, tally) in mounts.iter().zip(&mut tallies) {
            if watch(Progress { done, total }).is_break() {
                is_interrupted = true;
                break 'postures;
            }
            let candidate = carrier.carried(&links, posture, mount);
            let mut assessed = assess_points(renderer, &candidate, &samples.points)?;
            if let Some(tolerance) = options.tolerance_mm {
                assessed.reject_errors_above(tolerance * 1e-3);
            }
            let own = carrier.own_robot(renderer, &candidate, &assessed);
            tally.add(renderer.scene(), &candidate, assessed, Some(own));
            done += 1;
        }
    }
    if !is_interrupted {
        // Nothing is left to be interrupted.
        let _ = watch(Progress { done: total, total });
    }
    Ok(finish(&region, &samples, mounts, tallies, is_interrupted))
}

fn finish(
    region: &Region,
    samples: &Samples,
    mounts: &[Candidate<'_>],
    tallies: Vec<Tally>,
    is_interrupted: bool,
) -> MotionCoverage {
    let mut findings = Vec::new();
    let mut sampled = None;
    let mut measured = Vec::new();
    for (mount, tally) in mounts.iter().zip(tallies) {
        let coverage = tally.finish(region, samples.clone(), is_interrupted);
        add_new(&mut findings, coverage.findings);
        let own = (coverage.candidates.iter()).filter_map(|posture| posture.own_robot.as_ref());
        let own: f64 = own.map(|own| own.share).sum();
        measured.push(MountCoverage {
            name: mount.name.clone(),
            model: mount.rig.name().to_owned(),
            position_m: mount.world_from_body.translation.to_array(),
            orientation: mount.world_from_body.quaternion().to_array(),
            together: coverage.together,
            own_robot: own / coverage.candidates.len().max(1) as f64,
            postures: coverage.candidates,
            selection: coverage.selection,
        });
        sampled.get_or_insert(coverage.region);
    }
    let shares = |index: usize| &measured[index].together;
    MotionCoverage {
        ranking: ranking(measured.len(), shares),
        region: sampled.unwrap_or_default(),
        mounts: measured,
        findings,
        is_interrupted,
    }
}
