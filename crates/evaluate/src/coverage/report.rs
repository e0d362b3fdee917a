//! The results, with units in their names.

use std::collections::BTreeMap;

use oaktwin_base::diagnostic::Finding;
use serde::Serialize;

use super::{Outcome, Samples};
use crate::measure::quantile;

/// The coverage of a region by candidates.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Coverage {
    /// The surface.
    pub region: SampledRegion,
    /// The results in the order of the candidates. After an interruption, only the first ones.
    pub candidates: Vec<CandidateCoverage>,
    /// The indices of the candidates by the share that they measure, then by their median absolute error, best first.
    pub ranking: Vec<usize>,
    /// The coverage by all candidates together: a point is measured if one of them measures it, otherwise lost for the reason of the one
    /// that is nearest to measuring it. The error of a point is the mean error of its measurements.
    pub together: Shares,
    /// The candidates that measure most together, chosen one after the other, each for what it adds: at most eight, as long as one
    /// adds more than the standard error.
    pub selection: Vec<Selected>,
    /// The renderer's findings, without duplicates.
    pub findings: Vec<Finding>,
    /// Whether the measurement was interrupted.
    #[serde(rename = "interrupted")]
    pub is_interrupted: bool,
    /// The outcomes at each point, if requested.
    #[serde(skip)]
    pub points: Option<PointOutcomes>,
}

/// The surface that is measured.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct SampledRegion {
    /// The paths of its prims; empty for everything.
    pub objects: Vec<String>,
    /// The minimum corner of its box in the world, if it has one.
    pub minimum_m: Option<[f64; 3]>,
    /// The maximum corner of the box.
    pub maximum_m: Option<[f64; 3]>,
    /// The area, of one side of each face.
    pub area_m2: f64,
    /// The number of points.
    pub samples: u32,
    /// The largest standard error of a share: for independent points at a share of a half.
    pub standard_error: f64,
}

/// The coverage of a region by one candidate.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CandidateCoverage {
    /// The name.
    pub name: String,
    /// The name of the model.
    pub model: String,
    /// The name of the engine, such as `stereo-noise`.
    pub engine: String,
    /// The position of the body in the world.
    pub position_m: [f64; 3],
    /// The rotation of the body (x forward, y left, z up) as a quaternion `qx qy qz qw`.
    pub orientation: [f64; 4],
    /// The height of the body along the scene's up axis.
    pub height_m: f64,
    /// The angle by which the optical axis points below the horizontal.
    pub tilt_deg: f64,
    /// The shares and errors.
    #[serde(flatten)]
    pub shares: Shares,
    /// The objects that hide the largest shares of the surface, at most five.
    pub occluders: Vec<Occluder>,
    /// What the image shows of the robot that carries the OAK, if there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub own_robot: Option<OwnRobot>,
}

/// What a depth sensor sees of the robot that carries it, and does not see because of it.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct OwnRobot {
    /// The share of the pixels that show the robot.
    pub share: f64,
    /// The share of each link that is in the image, the largest first.
    pub links: Vec<(String, f64)>,
    /// The share of the surface that the robot hides, as the nearest object on the line of sight.
    pub hides: f64,
}

/// Shares of the surface from 0 to 1, and errors.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Shares {
    /// The share that is visible, measured or not.
    pub seen: f64,
    /// The share that is measured.
    pub measured: f64,
    /// The median of measured minus true z; `None` if nothing is measured.
    pub median_error_mm: Option<f64>,
    /// The median of the absolute errors.
    pub median_absolute_error_mm: Option<f64>,
    /// The 95th percentile of the absolute errors.
    pub p95_absolute_error_mm: Option<f64>,
    /// The shares that are not measured, by the name of the [reason](super::reasons); those above 0.
    pub lost: BTreeMap<&'static str, f64>,
}

/// An object that hides a part of the surface.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Occluder {
    /// The path of the mesh.
    pub path: String,
    /// The share of the surface that it hides from the camera, as the nearest object on the line of sight.
    pub share: f64,
}

/// A candidate of the selection.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Selected {
    /// The index of the candidate.
    pub candidate: usize,
    /// The share that it and those before it measure together.
    pub measured: f64,
}

/// The outcomes at each point.
#[derive(Clone, Debug, PartialEq)]
pub struct PointOutcomes {
    /// The points.
    pub samples: Samples,
    /// The outcomes by candidate, then by point.
    pub outcomes: Vec<Vec<Outcome>>,
    /// Measured minus true z in metres, by candidate, then by point; NaN where nothing is measured.
    pub errors_m: Vec<Vec<f32>>,
}

impl Shares {
    /// Returns the shares that are not measured with the names of their reasons, the largest first.
    #[must_use]
    pub fn losses(&self) -> Vec<(&'static str, f64)> {
        let mut losses: Vec<(&'static str, f64)> =
            self.lost.iter().map(|(&name, &share)| (name, share)).collect();
        losses.sort_by(|a, b| b.1.total_cmp(&a.1));
        losses
    }

    /// The shares of the points with these outcomes and errors in metres, NaN where nothing is measured.
    pub(super) fn new(outcomes: &[Outcome], errors_m: impl Iterator<Item = f64>) -> Self {
        let count = outcomes.len().max(1) as f64;
        let share = |number: u32| f64::from(number) / count;
        let (mut seen, mut measured) = (0, 0);
        let mut lost: BTreeMap<&'static str, u32> = BTreeMap::new();
        for outcome in outcomes {
            seen += u32::from(outcome.is_seen());
            if *outcome == Outcome::MEASURED {
                measured += 1;
            } else {
                *lost.entry(outcome.name()).or_default() += 1;
            }
        }
        let errors_mm: Vec<f64> = errors_m
            .filter(|error| !error.is_nan())
            .map(|error| error * 1e3)
            .collect();
        let absolute: Vec<f64> = errors_mm.iter().map(|error| error.abs()).collect();
        Self {
            seen: share(seen),
            measured: share(measured),
            median_error_mm: quantile(&errors_mm, 0.5),
            median_absolute_error_mm: quantile(&absolute, 0.5),
            p95_absolute_error_mm: quantile(&absolute, 0.95),
            lost: lost
                .into_iter()
                .map(|(name, number)| (name, share(number)))
                .collect(),
        }
    }
}
