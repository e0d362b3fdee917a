//! Rendering of frames and writing of their files.

use std::ops::ControlFlow;

use oaktwin_camera::RigidTransform;
use oaktwin_render::Renderer;
use oaktwin_usd::stage::StageError;

use super::camera::CameraError;
use super::recorder::{FRAME_RATE, FrameRecorder};
use super::rig::{Rig, RigError};
use super::trajectory::{self, TimedPose};
use crate::progress::Watch;
use crate::recording::RecordingFileError;
use crate::write::{Producer, write_while};
use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_dataset::{WriteError, Writer};
use oaktwin_files::{FileError, OutputFiles, WrittenFile};

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
    Stage(#[from] StageError),
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

    /// The scene at this frame.
    fn renderer(&self) -> &Renderer;
}

/// A scene without motion, along a path.
struct Still<'a> {
    renderer: &'a Renderer,
    path: &'a [TimedPose],
    times_ns: Vec<u64>,
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
    let mut frames = Still {
        renderer,
        path,
        times_ns: times_ns(&trajectory::times_s(path)),
    };
    write(&mut frames, rig, is_strict, outputs, watch)
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
            let renderer = frames.renderer();
            let (mut shot, more) =
                rig.shoot_camera(renderer, index, pose.as_ref(), number as u64, &annotators)?;
            shot.time_ns = time_ns;
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
    for finding in more {
        if !findings.contains(&finding) {
            findings.push(finding);
        }
    }
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
