//! A stage that stays open, because its thread answers questions about other times.

use std::path::Path;
use std::sync::mpsc::{self, Receiver, Sender, SyncSender};
use std::thread::JoinHandle;

use oaktwin_base::diagnostic::{Finding, Level, suggest};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DAffine3;

use super::extract::Opened;
use super::guard::{self, Payload};
use super::inspect::Inspected;
use super::motion::Motion;
use super::{SceneOptions, StageError, StageScene, failure, inspected};

/// A stage that is read at any number of times, with one composition. Of a stage in which only transforms are animated, as robots are, just
/// the transforms are read again.
#[derive(Debug)]
pub struct AnimatedStage {
    name: String,
    timing: StageTiming,
    requests: Option<Sender<Option<f64>>>,
    changes: Receiver<Result<StageChange, StageError>>,
    thread: Option<JoinHandle<Result<(), Payload>>>,
}

/// The times of a stage.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StageTiming {
    /// The time codes per second: `timeCodesPerSecond`, else `framesPerSecond`, else 24.
    pub time_codes_per_second: f64,
    /// `startTimeCode` and `endTimeCode`, if the stage has them.
    pub range: Option<(f64, f64)>,
    /// Whether anything changes with time.
    pub is_animated: bool,
    /// What changes besides transforms, the path of a prim or an attribute: the whole scene is then read again for each time.
    pub deforms: Option<String>,
}

impl StageTiming {
    /// Returns a finding if some of these time codes are outside the range of the stage, or nothing changes with time.
    #[must_use]
    pub fn check(&self, times: &[f64]) -> Option<Finding> {
        let warn = |message: String, remedy: &'static str| {
            Finding::new("time", Level::Warning, "stage", message, remedy)
        };
        if !self.is_animated {
            return Some(warn("is not animated: all times show the same".to_owned(), ""));
        }
        let (start, end) = self.range?;
        let outside = times.iter().filter(|time| !(start..=end).contains(*time)).count();
        let message = match times {
            _ if outside == 0 => return None,
            [time] => format!("is animated from {start} to {end}; the time code {time} is outside"),
            times => format!(
                "is animated from {start} to {end}; {outside} of {} time codes are outside",
                times.len()
            ),
        };
        Some(warn(message, "choose time codes in the range of the stage"))
    }
}

/// What another time changes.
#[derive(Clone, Debug, PartialEq)]
pub struct StageChange {
    /// The contents of the stage.
    pub contents: StageContents,
    /// The pose of the prim that carries a device, in metres.
    pub world_from_mount: Option<RigidTransform>,
    /// What the transform of that prim contains at this time and a device cannot follow.
    pub mount_finding: Option<Finding>,
}

/// The contents of a stage at another time.
#[derive(Clone, Debug, PartialEq)]
pub enum StageContents {
    /// The scene of the first time, with these transforms.
    Moved {
        /// The instances that can move, by their indices in the scene: `world_from_mesh`.
        instances: Vec<(usize, DAffine3)>,
        /// The cameras that can move, by their indices in the list of cameras: `world_from_camera`.
        cameras: Vec<(usize, RigidTransform)>,
    },
    /// Another scene.
    Rebuilt(Box<StageScene>),
}

impl AnimatedStage {
    /// Opens a stage at the time of the options, and keeps it open. `mount` is the path of a prim that carries a device: its transform has no
    /// scale, shear or mirroring, or a finding says what is removed.
    ///
    /// # Errors
    /// Returns an error in the cases of [`open_scene`](super::open_scene), and if there is no such prim.
    pub fn open(
        path: impl AsRef<Path>,
        options: &SceneOptions,
        mount: Option<&str>,
    ) -> Result<(Self, StageScene, Option<RigidTransform>), StageError> {
        let name = path.as_ref().display().to_string();
        let (path, options) = (path.as_ref().to_owned(), *options);
        let (requests, asked) = mpsc::channel();
        let (answers, changes) = mpsc::sync_channel(1);
        let (first_timing, timing) = mpsc::channel();
        let mount = mount.map(str::to_owned);
        let work = move || {
            let answered = inspected(&path, |name, utf8, layer| {
                serve(
                    name,
                    utf8,
                    layer,
                    options,
                    mount.as_deref(),
                    &asked,
                    &answers,
                    &first_timing,
                )
            });
            if let Err(error) = answered {
                // Nobody waits for an answer that comes after the last question.
                let _ = answers.send(Err(error));
            }
        };
        let thread = guard::start(work).map_err(|payload| failure(&name, payload.as_ref()))?;
        let mut stage = Self {
            name,
            timing: StageTiming::default(),
            requests: Some(requests),
            changes,
            thread: Some(thread),
        };
        let first = stage.receive()?;
        stage.timing = timing.recv().unwrap_or_default();
        match first.contents {
            StageContents::Rebuilt(mut scene) => {
                scene.findings.extend(first.mount_finding);
                Ok((stage, *scene, first.world_from_mount))
            }
            StageContents::Moved { .. } => Err(stage.closed()),
        }
    }

    /// Returns the times of the stage.
    #[must_use]
    pub fn timing(&self) -> &StageTiming {
        &self.timing
    }

    /// Reads the stage at another time code, or at its default values.
    ///
    /// # Errors
    /// Returns an error if the stage cannot be read at this time.
    pub fn at(&mut self, time: Option<f64>) -> Result<StageChange, StageError> {
        let is_asked = self
            .requests
            .as_ref()
            .is_some_and(|requests| requests.send(time).is_ok());
        if is_asked {
            self.receive()
        } else {
            Err(self.closed())
        }
    }

    fn receive(&mut self) -> Result<StageChange, StageError> {
        self.changes.recv().unwrap_or_else(|_| Err(self.closed()))
    }

    /// The error of a stage whose thread has ended.
    fn closed(&mut self) -> StageError {
        self.requests = None;
        match self.thread.take().map(JoinHandle::join) {
            Some(Ok(Err(payload)) | Err(payload)) => failure(&self.name, payload.as_ref()),
            _ => StageError::new(
                &self.name,
                "",
                "is not open any more after an error",
                "open it again",
            ),
        }
    }
}

impl Drop for AnimatedStage {
    fn drop(&mut self) {
        self.requests = None;
        if let Some(thread) = self.thread.take() {
            // The error of a thread that has ended has been returned.
            let _ = thread.join();
        }
    }
}

/// Reads a stage at its first time, then at each time that is asked for.
#[expect(
    clippy::too_many_arguments,
    reason = "what the thread of a stage shares with its owner"
)]
fn serve(
    name: &str,
    utf8: &str,
    layer: Inspected,
    options: SceneOptions,
    mount: Option<&str>,
    asked: &Receiver<Option<f64>>,
    answers: &SyncSender<Result<StageChange, StageError>>,
    timing: &Sender<StageTiming>,
) -> Result<(), StageError> {
    let opened = Opened::new(name, utf8, layer, options)?;
    let mut motion = Motion::new(mount);
    let first = opened.scene(Some(&mut motion))?;
    if let Some((mount, known)) = motion.missing_mount() {
        let remedy = suggest(mount, known.iter().map(String::as_str));
        return Err(StageError::new(
            name,
            mount,
            "there is no such prim with a transform",
            remedy,
        ));
    }
    let moving = motion.finish(&first.scene);
    let _ = timing.send(StageTiming {
        is_animated: !moving.is_still(),
        deforms: moving.deforms.clone(),
        ..opened.timing()
    });
    let moved = moving.at(opened.reader());
    // A mesh that was made for a transform without an inverse belongs to one time.
    let mut is_rigid = moving.deforms.is_none()
        && moved.as_ref().is_some_and(|moved| {
            let is_same =
                |(index, pose): &(usize, DAffine3)| first.scene.instances[*index].world_from_mesh == *pose;
            moved.instances.iter().all(is_same)
        });
    let change = |contents| {
        let (world_from_mount, mount_finding) = moving.mount(opened.reader());
        StageChange {
            contents,
            world_from_mount,
            mount_finding,
        }
    };
    if answers
        .send(Ok(change(StageContents::Rebuilt(Box::new(first)))))
        .is_err()
    {
        return Ok(());
    }
    while let Ok(time) = asked.recv() {
        opened.reader().restart(time);
        let moved = is_rigid.then(|| moving.at(opened.reader())).flatten();
        is_rigid &= moved.is_some();
        let answer = match moved {
            Some(moved) => Ok(change(StageContents::Moved {
                instances: moved.instances,
                cameras: moved.cameras,
            })),
            None => opened
                .scene(None)
                .map(|scene| change(StageContents::Rebuilt(Box::new(scene)))),
        };
        if answers.send(answer).is_err() {
            break;
        }
    }
    Ok(())
}
