//! Rendering of frames and writing of their files.

use std::ops::ControlFlow;

use oaktwin_camera::RigidTransform;
use oaktwin_render::Renderer;

use super::camera::CameraError;
use super::recorder::{FRAME_RATE, FrameRecorder};
use super::rig::{Rig, RigError};
use super::scene_file::SceneFileError;
use super::shutter::{Moments, Twist};
use super::trajectory::{self, TimedPose};
use crate::progress::Watch;
use crate::recording::RecordingFileError;
use crate::write::{Producer, write_while};
use oaktwin_base::diagnostic::{Finding, Level, add_new, message, opt};
use oaktwin_dataset::{WriteError, Writer};
use oaktwin_files::{FileError, OutputFiles, WrittenFile};
use oaktwin_imu::Motion;

/// The outputs of rendered frames.
#[expect(missing_debug_implementations, reason = "writers have none")]
pub struct Outputs<'a> {
    /// The writer of a data set, and its folder.
    pub dataset: Option<(&'a mut dyn Writer, &'a mut OutputFiles)>,
    /// A recording of all frames.
    pub recorder: Option<FrameRecorder>,
}

/// The result of writing frames.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Written {
    /// The number of frames with the files of every camera.
    pub frames: usize,
    /// The recording, if it is complete.
    pub recording: Option<WrittenFile>,
    /// The renderer's findings, without duplicates.
    pub findings: Vec<Finding>,
    /// Whether the task was interrupted.
    pub is_interrupted: bool,
}

/// An error while frames are rendered or written. Files that are complete are kept.
#[derive(Debug, thiserror::Error)]
pub enum FramesError {
    /// A file cannot be encoded or written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// A recording cannot be written.
    #[error(transparent)]
    Recording(#[from] RecordingFileError),
    /// A depth sensor cannot measure a frame.
    #[error(transparent)]
    Rig(#[from] RigError),
    /// An animated scene cannot be read at a time.
    #[error(transparent)]
    Scene(#[from] SceneFileError),
    /// A camera of an animated scene cannot be rendered at a time.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// A warning, if those are errors.
    #[error("{0}")]
    Strict(Finding),
}

impl From<FileError> for FramesError {
    fn from(error: FileError) -> Self {
        Self::Write(error.into())
    }
}

/// What the frames of a data set see.
pub(super) trait Frames {
    /// The time of each frame, ns.
    fn times_ns(&self) -> &[u64];

    /// Goes on to a frame; frames are visited in order. Returns the pose of the rig if the frame moves it.
    fn advance(
        &mut self,
        number: usize,
        rig: &mut Rig,
        findings: &mut Vec<Finding>,
    ) -> Result<Option<RigidTransform>, FramesError>;

    /// Goes to a time, s after the current frame's own. Returns the pose of a camera's mount if the frames move it.
    fn shift(
        &mut self,
        number: usize,
        offset_s: f64,
        camera: usize,
    ) -> Result<Option<RigidTransform>, FramesError>;

    /// The scene at this frame.
    fn renderer(&self) -> &Renderer;
}

/// A scene without motion, along a path.
struct Still<'a> {
    renderer: &'a Renderer,
    path: &'a [TimedPose],
    times_ns: Vec<u64>,
    motion: Option<Motion>,
}

impl Frames for Still<'_> {
    fn times_ns(&self) -> &[u64] {
        &self.times_ns
    }

    fn advance(
        &mut self,
        number: usize,
        _: &mut Rig,
        _: &mut Vec<Finding>,
    ) -> Result<Option<RigidTransform>, FramesError> {
        Ok(self.path.get(number).map(|pose| pose.world_from_mount))
    }

    fn shift(
        &mut self,
        number: usize,
        offset_s: f64,
        _: usize,
    ) -> Result<Option<RigidTransform>, FramesError> {
        Ok(at(self.motion.as_ref(), &self.times_ns, number, offset_s))
    }

    fn renderer(&self) -> &Renderer {
        self.renderer
    }
}

/// Renders a frame of a fresh rig for each pose of `path`, or one at the cameras' own poses if `path` is empty, simulates the depth
/// sensors and writes the results. The first warning is an error if the task `is_strict`.
///
/// A data set has the files of a single camera in the folder itself, and the files of several cameras in folders by camera and
/// annotator. A recording is written as a whole or not at all.
///
/// # Errors
/// Returns an error if a file cannot be written, or for a warning if those are errors.
pub fn write_frames(
    renderer: &Renderer,
    rig: &Rig,
    path: &[TimedPose],
    is_strict: bool,
    outputs: Outputs<'_>,
    watch: &Watch<'_>,
) -> Result<Written, FramesError> {
    let times_ns = times_ns(&trajectory::times_s(path));
    if rig.shutter().is_some() && rig.twist().is_none() && path.len() < 2 {
        return Err(RigError::Option(message![
            opt("exposure"),
            " and ",
            opt("readout"),
            " require motion; give ",
            opt("trajectory"),
            " of at least two poses, ",
            opt("frames"),
            " or ",
            opt("velocity")
        ])
        .into());
    }
    let mut frames = Still {
        renderer,
        path,
        motion: motion(rig, path, &times_ns)?,
        times_ns,
    };
    write(&mut frames, rig, is_strict, outputs, watch)
}

/// Returns the motion along a path if the frames of a rig take time.
pub(super) fn motion(rig: &Rig, path: &[TimedPose], times_ns: &[u64]) -> Result<Option<Motion>, FramesError> {
    if !rig.takes_time() || path.len() < 2 {
        return Ok(None);
    }
    let timed = path.iter().zip(times_ns);
    #[expect(clippy::cast_precision_loss, reason = "nanoseconds of a trajectory")]
    let timed: Vec<_> = timed
        .map(|(pose, time_ns)| (*time_ns as f64 * 1e-9, pose.world_from_mount))
        .collect();
    let motion = Motion::new(&timed)
        .map_err(|error| RigError::Option(message![opt("trajectory"), format!(": {error}")]))?;
    Ok(Some(motion))
}

/// Returns the pose of a motion at a time after a frame's.
#[expect(clippy::cast_precision_loss, reason = "nanoseconds of a trajectory")]
pub(super) fn at(
    motion: Option<&Motion>,
    times_ns: &[u64],
    number: usize,
    offset_s: f64,
) -> Option<RigidTransform> {
    let (motion, first, own) = (motion?, times_ns.first()?, times_ns.get(number)?);
    let since_start_s = (own - first) as f64 * 1e-9 + offset_s;
    Some(motion.at(since_start_s).world_from_body)
}

/// The moments of one of several frames.
struct Around<'a> {
    frames: &'a mut dyn Frames,
    number: usize,
    /// The pose of each camera's mount, if the frames do not move it.
    own: Vec<RigidTransform>,
    twist: Twist,
}

impl Moments for Around<'_> {
    fn at(&mut self, offset_s: f64, camera: usize) -> Result<(&Renderer, RigidTransform), RigError> {
        let pose = self.frames.shift(self.number, offset_s, camera);
        let pose = pose.map_err(|error| RigError::Moment(error.to_string()))?;
        let pose = pose.unwrap_or_else(|| self.twist.after(&self.own[camera], offset_s));
        Ok((self.frames.renderer(), pose))
    }
}

/// Checks that every camera can take a frame in the time until the next.
fn check_periods(rig: &Rig, times_ns: &[u64]) -> Result<(), FramesError> {
    let Some(shutter) = rig.shutter() else {
        return Ok(());
    };
    let periods = times_ns.windows(2).map(|pair| pair[1].saturating_sub(pair[0]));
    let Some(shortest) = periods.min() else {
        return Ok(());
    };
    #[expect(clippy::cast_precision_loss, reason = "nanoseconds of a period")]
    let period_s = shortest as f64 * 1e-9;
    for camera in rig.cameras() {
        shutter.check_period(camera, period_s).map_err(RigError::Option)?;
    }
    Ok(())
}

/// Renders and writes frames.
pub(super) fn write(
    frames: &mut dyn Frames,
    rig: &Rig,
    is_strict: bool,
    outputs: Outputs<'_>,
    watch: &Watch<'_>,
) -> Result<Written, FramesError> {
    let Outputs {
        dataset,
        mut recorder,
    } = outputs;
    let mut no_files = OutputFiles::default();
    let mut writers: Vec<&mut dyn Writer> = Vec::new();
    let output = match dataset {
        Some((writer, output)) => {
            writers.push(writer);
            output
        }
        None => &mut no_files,
    };
    writers.extend(recorder.as_mut().map(|recorder| recorder as &mut dyn Writer));
    check_periods(rig, frames.times_ns())?;
    let mut findings = rig.cast_instead();
    let cameras = rig.cameras().len();
    let total = frames.times_ns().len() as u64 * cameras as u64;
    let written = write_while(&mut writers, output, total, watch, |producer| {
        render_all(frames, rig.clone(), is_strict, &mut findings, producer)
    })?;
    findings.extend(writers.iter_mut().flat_map(|writer| writer.findings()));
    Ok(Written {
        frames: usize::try_from(written.frames)
            .unwrap_or(usize::MAX)
            .checked_div(cameras)
            .unwrap_or(0),
        recording: recorder.and_then(FrameRecorder::into_written),
        findings,
        is_interrupted: written.is_interrupted,
    })
}

fn render_all(
    frames: &mut dyn Frames,
    mut rig: Rig,
    is_strict: bool,
    findings: &mut Vec<Finding>,
    producer: &mut Producer<'_>,
) -> Result<ControlFlow<()>, FramesError> {
    let annotators = rig.annotators().to_vec();
    let times_ns = frames.times_ns().to_vec();
    for (number, time_ns) in times_ns.into_iter().enumerate() {
        if producer.proceed().is_break() {
            return Ok(ControlFlow::Break(()));
        }
        let mut more = Vec::new();
        let pose = frames.advance(number, &mut rig, &mut more)?;
        note(more, is_strict, findings)?;
        for index in 0..rig.cameras().len() {
            if producer.proceed().is_break() {
                return Ok(ControlFlow::Break(()));
            }
            let (mut shot, more) = if rig.takes_time() {
                let mut around = Around {
                    own: (rig.cameras().iter())
                        .map(|camera| pose.unwrap_or(camera.world_from_mount))
                        .collect(),
                    frames: &mut *frames,
                    number,
                    twist: rig.twist().copied().unwrap_or_default(),
                };
                rig.expose_camera(&mut around, index, number as u64, &annotators)?
            } else {
                let renderer = frames.renderer();
                rig.shoot_camera(renderer, index, pose.as_ref(), number as u64, &annotators)?
            };
            shot.time_ns = time_ns.saturating_add(rig.offset_ns(index));
            note(more, is_strict, findings)?;
            if producer.write(shot).is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
    }
    Ok(producer.finish())
}

/// Keeps findings without duplicates; a warning is an error if the task is strict.
fn note(more: Vec<Finding>, is_strict: bool, findings: &mut Vec<Finding>) -> Result<(), FramesError> {
    let warning = more.iter().find(|one| one.level >= Level::Warning);
    if let Some(warning) = warning.filter(|_| is_strict) {
        return Err(FramesError::Strict(warning.clone()));
    }
    add_new(findings, more);
    Ok(())
}

/// The times of frames: their own, or 30 frames per second from 0 if a frame has none. Without any, there is a single frame.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "times of files; the cast saturates"
)]
pub(super) fn times_ns(times_s: &[Option<f64>]) -> Vec<u64> {
    let own: Option<Vec<f64>> = times_s.iter().copied().collect();
    let regular = || {
        (0..times_s.len())
            .map(|number| number as f64 / FRAME_RATE)
            .collect()
    };
    let times_s = own
        .filter(|times| !times.is_empty())
        .unwrap_or_else(|| if times_s.is_empty() { vec![0.0] } else { regular() });
    times_s
        .into_iter()
        .map(|time_s| (time_s * 1e9).round() as u64)
        .collect()
}
