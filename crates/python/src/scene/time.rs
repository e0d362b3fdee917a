//! Animated stages.

use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicU64;
use std::sync::{Mutex, PoisonError, RwLock};

use oaktwin::camera::RigidTransform;
use oaktwin::render::{AnimatedScene, OpenOptions, SceneChange, SceneFile, SceneFileError};
use pyo3::prelude::*;

use super::cameras::cameras;
use super::parts::Stage;
use super::{Origin, Scene};
use crate::error::{reading, wrong};
use crate::finding;
use crate::progress::ProgressCallback;
use crate::threads;

/// A file that can be read at other times, with its rest at the present one.
pub(super) type Animation = (AnimatedScene, SceneFile);

/// The open stage, which is opened at the same time as the scene, to whose instances changes refer.
fn opened<'a>(
    animation: &'a mut Option<Animation>,
    path: &Path,
    options: &OpenOptions,
    mount: Option<&str>,
) -> Result<&'a mut Animation, SceneFileError> {
    match animation {
        Some(open) => Ok(open),
        empty => {
            let (stage, mut file) = SceneFile::open_animated(path, options, mount)?;
            let _ = file.take_scene();
            Ok(empty.insert((stage, file)))
        }
    }
}

impl Scene {
    /// Opens a file; a stage with a mount stays open.
    pub(super) fn read_file(
        py: Python<'_>,
        path: PathBuf,
        options: OpenOptions,
        mount: Option<String>,
    ) -> PyResult<Self> {
        let opened = threads::interruptible(py, ProgressCallback::default(), |_| match &mount {
            None => SceneFile::open(&path, &options).map(|file| (None, file)),
            Some(prim) => {
                SceneFile::open_animated(&path, &options, Some(prim)).map(|(stage, file)| (Some(stage), file))
            }
        })?;
        let (animated, mut file) = opened.map_err(|error| reading(&path, &error))?;
        let (cameras, odd) = cameras(&file);
        let mut findings = std::mem::take(&mut file.findings);
        findings.extend(odd);
        let scene = file.take_scene();
        // Allows unpickling in another working directory.
        let path = std::path::absolute(&path).unwrap_or(path);
        Ok(Self {
            stage: RwLock::new(Stage::new(scene, cameras, options.time)),
            next_frame: AtomicU64::new(0),
            origin: Origin::File { path, options, mount },
            animation: Mutex::new(animated.map(|animated| (animated, file))),
            findings,
        })
    }

    /// The pose of the mount, if there is one.
    pub(super) fn mounted(&self) -> Option<RigidTransform> {
        let animation = self.animation.lock().unwrap_or_else(PoisonError::into_inner);
        animation.as_ref()?.0.world_from_mount().copied()
    }

    /// The first and the last time code, and the time codes per second, of a stage that is animated.
    pub(super) fn timing(&self, py: Python<'_>) -> PyResult<Option<(f64, f64, f64)>> {
        let Origin::File { path, options, mount } = &self.origin else {
            return Ok(None);
        };
        if !SceneFile::is_stage(path) {
            return Ok(None);
        }
        let timing = py.detach(|| {
            let mut animation = self.animation.lock().unwrap_or_else(PoisonError::into_inner);
            Ok::<_, SceneFileError>(
                opened(&mut animation, path, options, mount.as_deref())?
                    .0
                    .timing()
                    .clone(),
            )
        });
        let timing = timing.map_err(|failed| reading(path, &failed))?;
        let (first, last) = timing.range.unwrap_or((0.0, f64::INFINITY));
        Ok(timing
            .is_animated
            .then_some((first, last, timing.time_codes_per_second)))
    }

    /// Reads the stage at another time.
    pub(super) fn go_to(&self, py: Python<'_>, time: Option<f64>) -> PyResult<()> {
        let Origin::File { path, options, mount } = &self.origin else {
            return Err(wrong(
                "time",
                "does not apply to a scene of meshes",
                "move them with set_pose",
            ));
        };
        if let Some(time) = time.filter(|time| !time.is_finite()) {
            return Err(wrong(
                "time",
                format_args!("is {time}"),
                "pass a finite time code",
            ));
        }
        let findings = py.detach(|| {
            // Locked until all is changed, so that threads do not mix times.
            let mut animation = self.animation.lock().unwrap_or_else(PoisonError::into_inner);
            let (stage, file) = opened(&mut animation, path, options, mount.as_deref())?;
            let (change, mut findings) = stage.at(time)?;
            findings.extend(time.and_then(|time| stage.timing().check(&[time])));
            let mut drawn = self.stage.write().unwrap_or_else(PoisonError::into_inner);
            match change {
                SceneChange::Moved(instances, cameras) => {
                    for (index, world_from_camera) in cameras {
                        file.cameras[index].world_from_camera = world_from_camera;
                    }
                    drawn.animate(instances);
                }
                SceneChange::Rebuilt(mut new) => {
                    *drawn = Stage::new(new.take_scene(), Ok(Vec::new()), time);
                    *file = *new;
                }
            }
            let (cameras, more) = cameras(file);
            findings.extend(more);
            drawn.cameras = cameras;
            drawn.time = time;
            Ok::<_, SceneFileError>(findings)
        });
        finding::warn(py, &findings.map_err(|failed| reading(path, &failed))?)
    }
}
