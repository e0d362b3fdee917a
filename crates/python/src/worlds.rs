//! Many worlds at once, for the environments of a simulator.

use std::sync::{PoisonError, RwLock};

use oaktwin::camera::RigidTransform;
use oaktwin::camera::math::DAffine3;
use oaktwin::render::{self, Backend, View};
use oaktwin::scene::Instance;
use pyo3::prelude::*;

use crate::arguments;
use crate::array::numbers;
use crate::camera::Camera;
use crate::choice::named;
use crate::error::{error, wrong};
use crate::images::room;
use crate::memory::check_free;
use crate::pose::{Of, pose};
use crate::progress::ProgressCallback;
use crate::scene::{Scene, path, unknown_part};
use crate::settings::{item_numbers, strings};
use crate::threads;

#[doc = "Worlds(scene, count)\n--\n"]
/// Many worlds with the geometry of one scene, in which parts have other poses: the environments of a simulator.
///
/// scene: the scene. Its geometry and its present poses are copied; later changes of the scene have no effect.
/// count: the number of worlds.
///
/// Meshes exist once for each thread, however many worlds there are. Thread-safe.
///
/// Raises oaktwin.Error for more worlds than fit in memory.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct Worlds {
    worlds: RwLock<render::Worlds>,
    /// The paths of the instances, with what a pose leaves of their transforms.
    parts: Vec<(String, DAffine3)>,
    count: usize,
}

/// The bytes of a moved part in a world.
const POSE_BYTES: u64 = size_of::<DAffine3>() as u64;

#[pymethods]
impl Worlds {
    #[new]
    #[pyo3(signature = (scene, count))]
    #[pyo3(text_signature = None)]
    fn new(
        py: Python<'_>,
        scene: &Scene,
        #[pyo3(from_py_with = arguments::count)] count: u64,
    ) -> PyResult<Self> {
        let stage = scene.read(py);
        let drawn = stage.renderer.scene();
        let parts: Vec<(String, DAffine3)> = stage
            .parts()
            .map(|(path, rest)| (path.to_owned(), rest))
            .collect();
        let needed = count
            .saturating_mul(parts.len() as u64)
            .saturating_mul(POSE_BYTES);
        check_free("count", needed, "make fewer worlds")?;
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        let worlds = threads::run(py, || render::Worlds::new(drawn, count))?;
        Ok(Self {
            worlds: RwLock::new(worlds),
            parts,
            count,
        })
    }

    /// Moves parts.
    ///
    /// names: the names or prim paths of P parts, as in `Scene.set_pose`.
    /// poses: (N, P, 4, 4) world_from_part, metres, for N worlds; or (P, 4, 4) for all of them.
    /// worlds: the numbers of the N worlds, or a mask; by default all.
    ///
    /// Raises oaktwin.Error for unknown names, with the nearest ones, other shapes, and matrices that are not poses. Nothing is moved then.
    #[pyo3(signature = (names, poses, *, worlds = None))]
    fn set_poses(
        &self,
        py: Python<'_>,
        names: &Bound<'_, PyAny>,
        poses: &Bound<'_, PyAny>,
        worlds: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let names = strings("names", names)?;
        let chosen = self.chosen(worlds)?;
        let instances = names
            .iter()
            .map(|name| self.find(name))
            .collect::<PyResult<Vec<_>>>()?;
        let (shape, array) = numbers("poses", poses)?;
        let each = match shape[..] {
            [parts, 4, 4] if parts == names.len() => 1,
            [count, parts, 4, 4] if parts == names.len() && count == chosen.len() => count,
            _ => {
                let is = format!(
                    "has shape {shape:?}, but there are {} worlds and {} names",
                    chosen.len(),
                    names.len()
                );
                let remedy = format!("pass ({}, {}, 4, 4)", chosen.len(), names.len());
                return Err(wrong("poses", is, remedy));
            }
        };
        let values = array.as_slice().map_err(error)?;
        let (matrices, _) = values.as_chunks::<16>();
        let mut placed = Vec::with_capacity(matrices.len());
        for (number, matrix) in matrices.iter().enumerate() {
            let part = number % names.len().max(1);
            let place = || match shape.len() {
                3 => format!("poses[{part}]"),
                _ => format!("poses[{}, {part}]", number / names.len()),
            };
            // The place is written only for an error: there may be many poses.
            let rigid = pose("poses", matrix).or_else(|_| pose(&place(), matrix))?;
            placed.push(Instance::placed(&rigid, self.parts[instances[part]].1));
        }
        if each == 1 && chosen.len() > 1 {
            placed = placed.repeat(chosen.len());
        }
        py.detach(|| {
            let mut worlds = self.worlds.write().unwrap_or_else(PoisonError::into_inner);
            worlds.set_poses(&chosen, &instances, &placed);
        });
        Ok(())
    }

    /// Renders the depth of a camera in each world.
    ///
    /// camera: the camera, as in `Scene.render`.
    /// world_from_camera: (N, 4, 4) poses of the camera, one for each of N worlds, or (4, 4) for all; the axes are OpenCV's, metres.
    /// worlds: the numbers of the N worlds, or a mask; by default all.
    /// backend: "auto" (default), "raster" or "ray", as in `Scene.render`.
    /// out: the output array: C-contiguous float32 (N, H, W).
    ///
    /// Returns `out`, or a new (N, H, W) array: float32 metres along the optical axis, inf for a miss. Each image has the bytes of
    /// `Scene.render` with the same backend.
    ///
    /// Raises oaktwin.Error for invalid poses, other numbers of poses than of worlds, and images that do not fit in memory.
    #[pyo3(signature = (camera, world_from_camera, *, worlds = None, backend = "auto", out = None))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        camera: &Camera,
        world_from_camera: &Bound<'py, PyAny>,
        worlds: Option<&Bound<'py, PyAny>>,
        backend: &str,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let backend: Backend = named("backend", backend)?;
        let chosen = self.chosen(worlds)?;
        let (poses, is_batch) = Of::Camera.several("world_from_camera", world_from_camera)?;
        if is_batch && poses.len() != chosen.len() {
            let is = format!("has {} poses, but there are {} worlds", poses.len(), chosen.len());
            return Err(wrong("world_from_camera", is, "pass one pose for each world"));
        }
        let view = |world_from_camera: &RigidTransform| View {
            camera: camera.camera,
            world_from_camera: *world_from_camera,
            clip: camera.clip,
        };
        let views: Vec<View> = (0..chosen.len())
            .filter_map(|number| poses.get(if is_batch { number } else { 0 }).map(view))
            .collect();
        let size = camera.camera.intrinsics.size;
        let dims = [chosen.len(), size.height as usize, size.width as usize];
        if out.is_none() {
            let bytes = dims
                .iter()
                .fold(4_u64, |bytes, side| bytes.saturating_mul(*side as u64));
            check_free(
                "world_from_camera",
                bytes,
                "render fewer worlds at once, or smaller images",
            )?;
        }
        let (result, mut images) = room::<f32>(py, out, &dims, &[])?;
        let images = images.as_slice_mut().map_err(error)?;
        threads::interruptible(py, ProgressCallback::default(), |task| {
            let worlds = self.worlds.read().unwrap_or_else(PoisonError::into_inner);
            worlds.depth(&chosen, &views, backend, images, &|| task.is_stopped());
        })?;
        Ok(result)
    }

    fn __len__(&self) -> usize {
        self.count
    }

    fn __repr__(&self) -> String {
        format!("<oaktwin.Worlds: {} of {} parts>", self.count, self.parts.len())
    }
}

impl Worlds {
    /// The worlds of an argument.
    fn chosen(&self, worlds: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<usize>> {
        let Some(worlds) = worlds else {
            return Ok((0..self.count).collect());
        };
        let chosen = item_numbers("worlds", worlds)?;
        match chosen.iter().find(|world| **world >= self.count) {
            Some(world) => Err(wrong(
                "worlds",
                format_args!("there is no world {world}"),
                format_args!("they are numbered from 0 to {}", self.count.saturating_sub(1)),
            )),
            None => Ok(chosen),
        }
    }

    fn find(&self, name: &str) -> PyResult<usize> {
        let path = path(name);
        let found = self.parts.iter().position(|(own, _)| *own == path);
        found.ok_or_else(|| unknown_part(name, self.parts.iter().map(|(path, _)| path.as_str())))
    }
}
