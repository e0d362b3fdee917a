//! What a camera sees of a scene.

use oaktwin::image::annotation::Annotator;
use oaktwin::render::{AnnotateOptions, Backend};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::Scene;
use super::annotators::{check_memory, scene_annotator};
use crate::arguments::Annotators;
use crate::camera::Camera;
use crate::choice::named;
use crate::device::Device;
use crate::finding;
use crate::frames::Frames;
use crate::pose::{Of, facing};
use crate::settings::mistyped;
use crate::threads;

impl Scene {
    /// The upright pose of a camera, or of the body of a device, that faces a target.
    pub(super) fn facing<'py>(
        &self,
        py: Python<'py>,
        eye: &Bound<'py, PyAny>,
        target: &Bound<'py, PyAny>,
        of: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let of = match of {
            Some(device) if device.is_instance_of::<Device>() => Of::Body,
            Some(other) if !other.is_instance_of::<Camera>() => {
                return Err(mistyped("of", other, "a Camera or a Device"));
            }
            _ => Of::Camera,
        };
        let up = self.read(py).renderer.scene().up.direction();
        facing(py, eye, target, up, of)
    }

    /// Renders the ground truth of a camera at one pose or at several.
    pub(super) fn rendered<'py>(
        &self,
        py: Python<'py>,
        camera: &Camera,
        world_from_camera: &Bound<'py, PyAny>,
        annotators: Option<Annotators>,
        backend: &str,
        options: &AnnotateOptions,
    ) -> PyResult<Bound<'py, PyDict>> {
        let backend: Backend = named("backend", backend)?;
        let asked = match annotators {
            Some(Annotators(names)) => names
                .iter()
                .map(|name| scene_annotator(name))
                .collect::<PyResult<_>>()?,
            None => vec![Annotator::DistanceToImagePlane],
        };
        let (poses, is_batch) = Of::Camera.several("world_from_camera", world_from_camera)?;
        check_memory(camera, &asked, poses.len())?;
        let stage = self.read(py);
        let renderer = &stage.renderer;
        let mut frames = Frames::new(camera.camera.intrinsics.size, is_batch.then_some(poses.len()));
        for (number, world_from_camera) in poses.iter().enumerate() {
            py.check_signals()?;
            let view = oaktwin::render::View {
                camera: camera.camera,
                world_from_camera: *world_from_camera,
                clip: camera.clip,
            };
            let (frame, findings) = threads::run(py, || renderer.annotate(&view, &asked, backend, options))?;
            if number == 0 {
                finding::warn(py, &findings)?;
            }
            frames.put(py, number, frame)?;
        }
        frames.finish(py, &asked)
    }
}
