//! Which share of a surface OAKs measure.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};

use oaktwin::camera::RigidTransform;
use oaktwin::camera::math::DVec3;
use oaktwin::coverage::{self, Candidate, CoverageError, MeasuringRig, Options, PATCHES, Patches, Region};
use oaktwin::scene::Bounds;
use serde::{Deserialize, Serialize};

use crate::mesh;
use crate::protocol::{Failure, OakState};
use crate::studio::Studio;

/// The maximum number of OAKs and poses of a request.
const MAX_STATES: usize = 1000;

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CoverageRequest {
    scene: String,
    states: Vec<OakState>,
    region: RegionRequest,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
enum RegionRequest {
    Box { minimum: [f64; 3], maximum: [f64; 3] },
    Object { object: String },
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct CoverageAnswer {
    poses: Vec<PoseCoverage>,
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
struct PoseCoverage {
    seen: f64,
    measured: f64,
    median_absolute_error_m: Option<f64>,
    lost: BTreeMap<&'static str, f64>,
}

impl RegionRequest {
    fn region(&self) -> Region {
        match self {
            Self::Object { object } => Region {
                objects: vec![object.clone()],
                within: None,
            },
            Self::Box { minimum, maximum } => Region {
                objects: Vec::new(),
                within: Some(Bounds {
                    min: DVec3::from(*minimum),
                    max: DVec3::from(*maximum),
                }),
            },
        }
    }
}

/// A region with the state that is assessed on its surface.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SurfaceRequest {
    scene: String,
    state: OakState,
    region: RegionRequest,
}

/// Returns the surface of the region as a mesh. The object of each triangle is the code of its outcome.
pub(crate) fn surface(studio: &Studio, request: &SurfaceRequest) -> Result<Vec<u8>, Failure> {
    let failed = |error: CoverageError| Failure::of("region", &error);
    let scene = studio.scenes.get(&request.scene)?;
    let (rig, pose) = rig(studio, &request.state)?;
    let candidate = Candidate::new(&rig, "1", pose);
    let region = request.region.region();
    let patches = Patches::new(&scene.renderer, &region, &candidate, PATCHES).map_err(failed)?;
    let outcomes = patches.outcomes.iter().map(|outcome| u32::from(outcome.0));
    Ok(mesh::of_triangles(patches.corners.iter().zip(outcomes)))
}

/// Returns the OAK of a state, and its pose.
fn rig(studio: &Studio, state: &OakState) -> Result<(MeasuringRig, RigidTransform), Failure> {
    let twin = state.twin(studio)?;
    let (spec, sensor) = (state.spec(None)?, Some(state.sensor_kind()));
    let made = MeasuringRig::new(&twin, sensor, Some(state.projector), &spec);
    let (rig, _) = made.map_err(|error| Failure::of("engine", &error))?;
    Ok((rig, state.pose.transform()?))
}

/// Measures the coverage of the region by each state, until the client has left.
pub(crate) fn coverage(
    studio: &Studio,
    request: &CoverageRequest,
    has_left: &AtomicBool,
) -> Result<CoverageAnswer, Failure> {
    if request.states.len() > MAX_STATES {
        let error = format!(
            "{} poses are too many; choose at most {MAX_STATES}",
            request.states.len()
        );
        return Err(Failure::of("states", &error));
    }
    let failed = |error: CoverageError| Failure::of("region", &error);
    let scene = studio.scenes.get(&request.scene)?;
    let rigs = request.states.iter().map(|state| rig(studio, state));
    let rigs = rigs.collect::<Result<Vec<_>, Failure>>()?;
    let candidates: Vec<Candidate<'_>> = rigs
        .iter()
        .zip(1..)
        .map(|((rig, pose), number)| Candidate::new(rig, number.to_string(), *pose))
        .collect();
    let watch = |_| match studio.is_stopped() || has_left.load(Ordering::Relaxed) {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    };
    let region = request.region.region();
    let found = coverage::measure(&scene.renderer, &region, &candidates, &Options::default(), &watch)
        .map_err(failed)?;
    let poses = found.candidates.into_iter().map(|candidate| {
        let shares = candidate.shares;
        PoseCoverage {
            seen: shares.seen,
            measured: shares.measured,
            median_absolute_error_m: shares.median_absolute_error_mm.map(|error| error * 1e-3),
            lost: shares.lost,
        }
    });
    Ok(CoverageAnswer {
        poses: poses.collect(),
    })
}
