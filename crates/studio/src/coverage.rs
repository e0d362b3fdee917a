//! Which share of a surface OAKs measure.

use std::collections::BTreeMap;

use oaktwin::camera::math::DVec3;
use oaktwin::coverage::{
    self, Candidate, Carrier, CoverageError, CoverageOptions, MeasuringRig, PATCHES, Patches, Region, Shares,
};
use oaktwin::scene::Bounds;
use oaktwin::sensor::EngineInput;
use serde::{Deserialize, Serialize};

use crate::job::Job;
use crate::mesh;
use crate::pose::ORIGIN;
use crate::protocol::{Failure, OakState};
use crate::scene::LoadedScene;
use crate::size::check_memory;
use crate::studio::Studio;

/// The maximum number of OAKs and poses of a request.
const MAX_STATES: usize = 1000;
/// The maximum number of OAKs of a request that differ in more than their poses.
const MAX_RIGS: usize = 64;
/// The maximum number of triangles in a region.
const MAX_TRIANGLES: u64 = 20_000_000;

#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct CoverageRequest {
    scene: String,
    states: Vec<OakState>,
    /// A box in the world, or an object.
    region: RegionRequest,
    /// The largest error of a point that counts as measured; null for any.
    #[cfg_attr(test, ts(optional = nullable))]
    tolerance_mm: Option<f64>,
}

/// A box in the world, or the path of an object.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "CoverageRegion"))]
#[serde(untagged)]
pub(crate) enum RegionRequest {
    Box { minimum: [f64; 3], maximum: [f64; 3] },
    Object { object: String },
}

/// For each of the states, and for all of them together.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CoverageAnswer {
    poses: Vec<PoseCoverage>,
    together: PoseCoverage,
}

/// What is measured of a region's surface.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct PoseCoverage {
    /// The share of the surface that the camera sees, measured or not.
    seen: f64,
    /// The share that is measured.
    measured: f64,
    median_absolute_error_m: Option<f64>,
    /// The shares that are not measured, by the name of the reason.
    #[cfg_attr(test, ts(type = "Record<string, number>"))]
    lost: BTreeMap<&'static str, f64>,
    /// The share of the pixels that show the robot of the scene; null without a robot, and for all OAKs together.
    own_robot: Option<f64>,
}

impl RegionRequest {
    fn region(&self) -> Region {
        match self {
            Self::Object { object } => Region {
                objects: vec![object.clone()],
                ..Region::default()
            },
            Self::Box { minimum, maximum } => Region {
                within: Some(Bounds {
                    min: DVec3::from(*minimum),
                    max: DVec3::from(*maximum),
                }),
                ..Region::default()
            },
        }
    }
}

/// Asks for the surface of a region in small triangles. In the mesh, the object of a triangle is the code of its outcome in
/// `Catalog.outcomes`; the colours mean nothing.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
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
    let (rig, pose) = (rig(studio, &request.state)?, request.state.pose.transform()?);
    let candidate = Candidate::new(&rig, "1", pose);
    let region = within_budget(&scene, &request.region)?;
    let patches = Patches::new(&scene.renderer, &region, &candidate, PATCHES).map_err(failed)?;
    let outcomes = patches.outcomes.iter().map(|outcome| u32::from(outcome.0));
    Ok(mesh::of_triangles(patches.corners.iter().zip(outcomes)))
}

/// Returns the region, unless it has too many triangles for an answer in time.
pub(crate) fn within_budget(scene: &LoadedScene, request: &RegionRequest) -> Result<Region, Failure> {
    let failed = |error: CoverageError| Failure::of("region", &error);
    let mut region = request.region();
    let robot = scene.robot.iter();
    region
        .without
        .extend(robot.map(|robot| robot.placed.path().to_owned()));
    match region.triangles(scene.renderer.scene()).map_err(failed)? {
        count if count > MAX_TRIANGLES => {
            let error = format!("the region has {count} triangles; choose one with at most {MAX_TRIANGLES}");
            Err(Failure::of("region", &error))
        }
        _ => Ok(region),
    }
}

/// Returns the OAK of a state.
pub(crate) fn rig(studio: &Studio, state: &OakState) -> Result<MeasuringRig, Failure> {
    let twin = state.twin(studio)?;
    let (spec, sensor) = (state.spec(studio, None)?, Some(state.sensor_kind()));
    let made = MeasuringRig::new(&twin, sensor, Some(spec.pair.projector), &spec);
    let (rig, _) = made.map_err(|error| Failure::of("engine", &error))?;
    let is_matching = state.engine()?.input == EngineInput::Pair;
    check_memory(rig.camera().camera.intrinsics.size, is_matching)?;
    Ok(rig)
}

/// Returns the OAKs of states, each once, and the index of that of each state.
fn rigs(studio: &Studio, states: &[OakState], job: &Job) -> Result<(Vec<MeasuringRig>, Vec<usize>), Failure> {
    let (mut known, mut rigs, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    for state in states {
        let unplaced = OakState {
            pose: ORIGIN,
            ..state.clone()
        };
        let index = known.iter().position(|one| *one == unplaced);
        if index.is_none() && rigs.len() == MAX_RIGS {
            let error = format!("more than {MAX_RIGS} OAKs differ in more than their poses; choose fewer");
            return Err(Failure::of("states", &error));
        }
        indices.push(index.unwrap_or(rigs.len()));
        if index.is_none() {
            job.check()?;
            rigs.push(rig(studio, state)?);
            known.push(unplaced);
        }
    }
    Ok((rigs, indices))
}

/// Measures the coverage of the region by each state, until the client has left.
pub(crate) fn coverage(
    studio: &Studio,
    request: &CoverageRequest,
    job: &Job,
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
    let region = within_budget(&scene, &request.region)?;
    let (rigs, indices) = rigs(studio, &request.states, job)?;
    let candidates = (request.states.iter().zip(&indices))
        .zip(1..)
        .map(|((state, &index), number)| {
            let pose = state.pose.transform()?;
            Ok(Candidate::new(&rigs[index], number.to_string(), pose))
        });
    let candidates = candidates.collect::<Result<Vec<_>, Failure>>()?;
    let found = coverage::measure(
        &scene.renderer,
        &region,
        &candidates,
        &CoverageOptions {
            tolerance_mm: request.tolerance_mm,
            ..CoverageOptions::default()
        },
        &|_| job.watch(),
    )
    .map_err(failed)?;
    let own_robot = |candidate: &Candidate<'_>| {
        let robot = scene.robot.as_ref()?;
        let carrier = Carrier {
            robot: &robot.placed,
            link: None,
            postures: &[],
        };
        Some(carrier.own_share(&scene.renderer, candidate))
    };
    let poses = (found.candidates.into_iter().zip(&candidates))
        .map(|(found, candidate)| PoseCoverage::new(found.shares, own_robot(candidate)));
    Ok(CoverageAnswer {
        poses: poses.collect(),
        together: PoseCoverage::new(found.together, None),
    })
}

impl PoseCoverage {
    pub(crate) fn new(shares: Shares, own_robot: Option<f64>) -> Self {
        Self {
            seen: shares.seen,
            measured: shares.measured,
            median_absolute_error_m: shares.median_absolute_error_mm.map(|error| error * 1e-3),
            lost: shares.lost,
            own_robot,
        }
    }
}
