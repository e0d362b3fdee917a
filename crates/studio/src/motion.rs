//! The coverage over the postures of a robot.

use std::sync::Arc;

use axum::body::Bytes;
use futures_util::Stream;
use futures_util::stream::unfold;
use oaktwin::coverage::{
    self, Base, Carrier, CoverageError, CoverageOptions, MotionCoverage, MountCoverage, PlacementSweep,
    measure_motion,
};
use oaktwin::progress::Progress;
use oaktwin::render::Renderer;
use oaktwin::scene::Up;
use serde::{Deserialize, Serialize};
use tokio::sync::{OwnedSemaphorePermit, mpsc};

use crate::coverage::{PoseCoverage, RegionRequest, rig, within_budget};
use crate::job::{self, Job};
use crate::pose::pose_of;
use crate::postures::{positions, robot_of};
use crate::protocol::{Failure, OakState, Pose};
use crate::robot::SceneRobot;
use crate::snippet;
use crate::studio::Studio;

/// Asks for the coverage of a region over a list of postures, by an OAK on a link or, without one, in the world.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct MotionRequest {
    /// The scene, with the robot in the posture to which the pose of the state belongs.
    pub(crate) scene: String,
    pub(crate) motion: String,
    pub(crate) mount: Option<String>,
    pub(crate) state: OakState,
    pub(crate) region: RegionRequest,
    /// The largest error of a point that counts as measured; null for any.
    pub(crate) tolerance_mm: Option<f64>,
}

/// A line of the answer to a [`MotionRequest`]: how many postures are done, and at last the result or an error.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "MotionLine"))]
#[serde(tag = "type", rename_all = "lowercase")]
pub(crate) enum Line {
    Progress { done: u64, total: u64 },
    Answer(Box<MotionAnswer>),
    Error(Failure),
}

#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct MotionAnswer {
    postures: Vec<PostureCoverage>,
    /// By all postures together: a point is measured if it is in one of them.
    together: PoseCoverage,
    /// `coverage.csv` as the command writes it.
    csv: String,
}

/// The coverage in a posture.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
struct PostureCoverage {
    #[serde(flatten)]
    #[cfg_attr(test, ts(flatten))]
    coverage: PoseCoverage,
    /// The share of the surface that the robot hides.
    hidden_by_robot: f64,
    /// The links in the image, with the share of the pixels that show each, the largest first.
    links: Vec<(String, f64)>,
}

/// The index of the link that carries the OAK, if one does, and the OAK's pose in its frame or else in the world.
pub(crate) fn mounted(
    robot: &SceneRobot,
    mount: Option<&str>,
    state: &OakState,
) -> Result<(Option<usize>, Pose), Failure> {
    let Some(mount) = mount else {
        return Ok((None, state.pose));
    };
    let link = robot.placed.mount(mount);
    let link = link.map_err(|error| Failure::of("mount", &error))?;
    let world_from_link = robot.placed.world_from_links(&robot.positions)[link];
    let link_from_body = world_from_link.inverse() * state.pose.transform()?;
    Ok((Some(link), pose_of(&link_from_body)))
}

/// Returns the command that measures the same.
pub(crate) fn command(studio: &Studio, request: &MotionRequest) -> Result<String, Failure> {
    let scene = studio.scenes.get(&request.scene)?;
    let robot = robot_of(&scene)?;
    let motion = studio.motions.get(&request.motion)?;
    let (_, pose) = mounted(robot, request.mount.as_deref(), &request.state)?;
    snippet::coverage(studio, request, &scene, (&motion, pose))
}

/// Measures the coverage, until the client has left.
fn measure(
    studio: &Studio,
    request: &MotionRequest,
    job: &Job,
    say: &mpsc::UnboundedSender<Progress>,
) -> Result<MotionAnswer, Failure> {
    let failed = |error: CoverageError| Failure::of("region", &error);
    let scene = studio.scenes.get(&request.scene)?;
    let robot = robot_of(&scene)?;
    let motion = studio.motions.get(&request.motion)?;
    let postures = positions(robot, &motion.info.name, &motion.bytes)?.positions;
    let region = within_budget(&scene, &request.region)?;
    let rigs = [rig(studio, &request.state)?];
    let (link, pose) = mounted(robot, request.mount.as_deref(), &request.state)?;
    // Named as by the command.
    let placements =
        PlacementSweep::default().placements(&Base::Poses(vec![pose.transform()?]), Up::Z.direction());
    let mounts = coverage::candidates(&rigs, &placements.map_err(failed)?);
    let carrier = Carrier {
        robot: &robot.placed,
        link,
        postures: &postures,
    };
    let options = CoverageOptions {
        tolerance_mm: request.tolerance_mm,
        ..CoverageOptions::default()
    };
    let watch = |progress: Progress| {
        // Nobody may listen any more, which `watch` finds out.
        let _ = say.send(progress);
        job.watch()
    };
    // The scene of other requests stays as it is.
    let mut renderer = Renderer::new(scene.renderer.scene().clone());
    let measured = job.in_full(|| {
        measure_motion(&mut renderer, &region, &carrier, &mounts, &options, &watch).map_err(failed)
    });
    answer(measured?)
}

fn answer(measured: MotionCoverage) -> Result<MotionAnswer, Failure> {
    let csv = measured.to_csv();
    let nothing = || Failure::from("nothing was measured; please report this".to_owned());
    let mount: MountCoverage = measured.mounts.into_iter().next().ok_or_else(nothing)?;
    let posture = |posture: coverage::CandidateCoverage| {
        let own = posture.own_robot.unwrap_or_default();
        PostureCoverage {
            coverage: PoseCoverage::new(posture.shares, Some(own.share)),
            hidden_by_robot: own.hides,
            links: own.links,
        }
    };
    Ok(MotionAnswer {
        postures: mount.postures.into_iter().map(posture).collect(),
        together: PoseCoverage::new(mount.together, Some(mount.own_robot)),
        csv,
    })
}

/// Measures the coverage: lines of JSON, each a [`Line`]. The measurement ends when the stream is dropped.
pub(crate) fn lines(
    studio: Arc<Studio>,
    request: MotionRequest,
    permit: OwnedSemaphorePermit,
) -> impl Stream<Item = Result<Bytes, std::convert::Infallible>> {
    let (say, said) = mpsc::unbounded_channel();
    let running = Box::pin(async move {
        // Counts as a request until its answer is complete.
        let _permit = permit;
        let made = move |studio: &Studio, job: &Job| measure(studio, &request, job, &say);
        match job::run(&studio, job::COVERAGE, made).await {
            Ok(answer) => Line::Answer(Box::new(answer)),
            Err(failure) => Line::Error(failure),
        }
    });
    unfold(Some((running, said)), async |state| {
        let (mut running, mut said) = state?;
        tokio::select! {
            biased;
            Some(Progress { done, total }) = said.recv() => {
                Some((text(&Line::Progress { done, total }), Some((running, said))))
            }
            last = &mut running => Some((text(&last), None)),
        }
    })
}

fn text(line: &Line) -> Result<Bytes, std::convert::Infallible> {
    // Numbers and texts are always valid.
    let mut text = serde_json::to_vec(line).unwrap_or_default();
    text.push(b'\n');
    Ok(text.into())
}
