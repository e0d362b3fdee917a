pub(crate) mod annotators;
mod cameras;
pub(crate) mod coverage;
mod lit;
mod parts;
mod time;
mod views;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, RwLock};

use numpy::PyArray2;
use oaktwin::diagnostic;
use oaktwin::pair::PairError;
use oaktwin::render::{AnnotateOptions, OpenOptions, Transparent, check_saved_name, save_usd};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use self::parts::{Parts, Stage};
pub(crate) use self::parts::{path, unknown_part};
use self::time::Animation;
use crate::arguments::{Annotators, FrameNumber, Size, optional, subdivide};
use crate::asset;
use crate::camera::Camera;
use crate::choice::{maybe_named, named};
use crate::device::{self, Device};
use crate::error::{error, writing};
use crate::finding::{self, Finding};
use crate::mesh::Mesh;
use crate::pair::{self, PairSettings};
use crate::pose::{Of, matrix, one_pose, rows};
use crate::settings::{drift, seed_or_entropy};
use crate::threads;

/// A scene to render on the CPU: `Scene.open(path)`, `Scene.from_meshes({name: mesh})` or
/// `Scene.from_triangles(vertices, faces)`.
///
/// The world keeps the file's axes; its unit is the metre, whatever the file's unit is. `set_pose` moves parts between renders.
/// Thread-safe. Unpickling opens the file again; meshes are stored in the pickle, and poses in both cases.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct Scene {
    stage: RwLock<Stage>,
    /// The frame number of the next pair without one.
    next_frame: AtomicU64,
    origin: Origin,
    /// The file, once it was read at another time.
    animation: Mutex<Option<Animation>>,
    findings: Vec<diagnostic::Finding>,
}

/// The origin of a scene, which is stored in a pickle.
enum Origin {
    File {
        path: PathBuf,
        options: OpenOptions,
        /// The path of the prim that carries a device.
        mount: Option<String>,
    },
    /// The meshes by name.
    Meshes(Vec<(String, Py<Mesh>)>),
}

#[pymethods]
impl Scene {
    /// Opens a USD stage (usd, usda, usdc, usdz) or a mesh file (gltf, glb, dae, obj, stl, ply).
    ///
    /// path: the file.
    /// time: the time code of a USD stage; by default the default values, or the first time samples. See `set_time`.
    /// subdivide: the subdivision level of a USD stage's meshes; 0 (default) renders the polygons.
    /// up: the up axis of a mesh file, "y" or "z"; by default its format's.
    /// scale: the metres per unit of a mesh file; by default 1.
    /// scene_limit: a factor on the limits on a USD stage's prims, references and instances; by default 1.
    /// allow_outside: whether a glTF file may name buffers and images outside its folder; for trusted files only.
    /// micro_texture: whether surfaces without a texture get the fine one of paint, wood or cloth, by which stereo cameras match them.
    /// infrared: the reflectance at 940 nm, 0 to 1, of materials by name and of surfaces by label; by default it follows from the colours.
    /// mount: the path of a USD stage's prim that carries a device; see `world_from_mount`.
    ///
    /// Missing and unsupported contents are listed in `findings`. Raises FileNotFoundError or another OSError if the file cannot
    /// be read, oaktwin.Error for an invalid file, or an option that does not apply to its format.
    #[staticmethod]
    #[pyo3(signature = (path, *, time = None, subdivide = 0, up = None, scale = None, scene_limit = 1.0, allow_outside = false,
        micro_texture = false, infrared = None, mount = None))]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    fn open(
        py: Python<'_>,
        path: PathBuf,
        time: Option<f64>,
        #[pyo3(from_py_with = subdivide)] subdivide: u32,
        up: Option<&str>,
        scale: Option<f64>,
        scene_limit: f64,
        allow_outside: bool,
        micro_texture: bool,
        infrared: Option<BTreeMap<String, f64>>,
        mount: Option<String>,
    ) -> PyResult<Self> {
        let limit = asset::scene_limit(scene_limit)?;
        let options = OpenOptions {
            time,
            subdivide,
            limit,
            up: maybe_named("up", up)?,
            scale,
            allow_outside,
            texture_coordinates: false,
            micro_texture,
            infrared: infrared.unwrap_or_default(),
        };
        Self::read_file(py, path, options, mount)
    }

    /// Creates a scene of one mesh.
    ///
    /// vertices: (V, 3) numbers, metres in the world.
    /// faces: (F, 3) integers: the vertices of each triangle, counter-clockwise seen from outside. Depth contains both sides.
    /// up: the up axis of the world, "z" (default) or "y".
    /// label: the semantic class; by default none.
    ///
    /// Raises oaktwin.Error for invalid shapes, vertices that are not finite, and vertex indices that are out of range.
    #[staticmethod]
    #[pyo3(signature = (vertices, faces, *, up = "z", label = None))]
    fn from_triangles(
        vertices: &Bound<'_, PyAny>,
        faces: &Bound<'_, PyAny>,
        up: &str,
        label: Option<String>,
    ) -> PyResult<Self> {
        let py = vertices.py();
        let (name, mesh) = ("Mesh".to_owned(), Mesh::plain(py, vertices, faces)?);
        let parts = Parts {
            labels: label.map(|label| (name.clone(), label)).into_iter().collect(),
            meshes: vec![(name, Py::new(py, mesh)?)],
            poses: BTreeMap::new(),
        };
        Self::of_parts(parts, up)
    }

    /// Creates a scene of several meshes, which `set_pose` moves.
    ///
    /// meshes: a mapping from names to `Mesh`. Geometry that appears under several names is stored once.
    /// poses: a mapping from names to (4, 4) world_from_mesh, metres; by default the identity.
    /// labels: a mapping from names to semantic classes; by default none.
    /// up: the up axis of the world, "z" (default) or "y".
    ///
    /// The prim path of a name, in annotations and USD files, is /World/NAME; a name may have several elements: "arm/link_1".
    ///
    /// Raises oaktwin.Error for invalid names and poses, and for poses and labels of unknown names.
    #[staticmethod]
    #[pyo3(signature = (meshes, *, poses = None, labels = None, up = "z"))]
    fn from_meshes(
        meshes: &Bound<'_, PyAny>,
        poses: Option<&Bound<'_, PyAny>>,
        labels: Option<&Bound<'_, PyAny>>,
        up: &str,
    ) -> PyResult<Self> {
        let parts = Parts::read(meshes, poses, labels)?;
        Self::of_parts(parts, up)
    }

    /// Moves a part. Only what depends on its pose is computed again.
    ///
    /// name: its name or its prim path; for a mesh in a file, see `poses`.
    /// world_from_part: (4, 4), the new pose, metres; without scale: a scale in the file stays.
    ///
    /// Renders that other threads have started finish with the old pose. Raises oaktwin.Error for unknown names and invalid poses.
    fn set_pose(&self, py: Python<'_>, name: &str, world_from_part: &Bound<'_, PyAny>) -> PyResult<()> {
        let pose = one_pose("world_from_part", world_from_part)?;
        self.write(py, |stage| stage.place(&[(name.to_owned(), pose)]))
    }

    /// Moves several parts: a mapping from names to poses, as in `set_pose`. If one is invalid, none is moved.
    fn set_poses(&self, py: Python<'_>, poses: &Bound<'_, PyAny>) -> PyResult<()> {
        let poses = parts::poses(Some(poses))?;
        self.write(py, |stage| stage.place(&poses))
    }

    /// Goes to another time code of an animated USD stage, or with None to its default values. The file is opened once for all times, and of a
    /// stage in which only transforms are animated, only these are read again: the poses of parts that are animated, and the cameras.
    /// Otherwise, the whole scene is made again, and poses that were set are lost.
    ///
    /// Issues an oaktwin.FindingWarning for contents that cannot be read. Raises oaktwin.Error for other scenes.
    #[pyo3(signature = (time))]
    fn set_time(&self, py: Python<'_>, time: Option<f64>) -> PyResult<()> {
        self.go_to(py, time)
    }

    /// A number that changes whenever parts or the time do, by which programs find out whether an image is still true. It is not pickled.
    #[getter]
    fn version(&self, py: Python<'_>) -> u64 {
        self.read(py).version
    }

    /// The time code, if there is one.
    #[getter]
    fn time(&self, py: Python<'_>) -> Option<f64> {
        self.read(py).time
    }

    /// The first and the last time code of an animated USD stage, and its time codes per second; None for other scenes. Without a range
    /// in the stage, the first is 0 and the last infinity.
    ///
    /// Raises oaktwin.Error if the stage cannot be read again.
    #[getter]
    fn animation(&self, py: Python<'_>) -> PyResult<Option<(f64, f64, f64)>> {
        self.timing(py)
    }

    /// The pose at the present time of the prim that `open` was given as `mount`, (4, 4), metres; None without one. A device at a pose on the
    /// prim is at `scene.world_from_mount @ mount_from_body`.
    #[getter]
    fn world_from_mount<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray2<f64>>>> {
        self.mounted().map(|pose| rows(py, &pose)).transpose()
    }

    /// The poses of all parts, a dictionary from prim path to (4, 4) float64 world_from_part, metres. It finds parts by their names,
    /// too: `scene.poses["link"]` is `scene.poses["/World/link"]`.
    #[getter]
    fn poses<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let all = PyDict::new(py);
        let stage = self.read(py);
        for (path, pose) in stage.poses() {
            all.set_item(path, rows(py, &pose)?)?;
        }
        py.import("oaktwin._poses")?.getattr("Poses")?.call1((all,))
    }

    /// Writes the scene as a USD file, with its present poses, materials, lights and semantic labels.
    ///
    /// path: the file to write, *.usda or *.usd. Images of textures are written to a folder beside it, NAME_textures.
    ///
    /// Raises oaktwin.Error for another extension, and OSError if a file cannot be written.
    #[expect(clippy::needless_pass_by_value, reason = "required by PyO3")]
    fn save_usd(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        check_saved_name(&path).map_err(error)?;
        let stage = self.read(py);
        let scene = stage.renderer.scene();
        let written = py.detach(|| save_usd(scene, &path));
        written.map_err(|error| writing(&path, &error))
    }

    /// Returns the pose at a position that faces a target, upright in the world of the scene: a (4, 4) float64 matrix, metres.
    ///
    /// eye, target: the position and the point to face (3 values each), metres in the world.
    /// of: what is placed: a `Camera` for a `CameraPose`, or a `Device` for the `BodyPose` of its body. By default, a camera.
    ///
    /// Raises oaktwin.Error if eye and target are equal, or one is above the other: `oaktwin.look_at` takes another up direction.
    #[pyo3(signature = (eye, target, of = None))]
    fn look_at<'py>(
        &self,
        py: Python<'py>,
        eye: &Bound<'py, PyAny>,
        target: &Bound<'py, PyAny>,
        of: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.facing(py, eye, target, of)
    }

    /// Renders the ground truth of a camera.
    ///
    /// camera: a device's camera (`device.cameras["left"]`, `device.depth_camera()`) or any other `Camera`.
    /// world_from_camera: the camera's pose: (4, 4), or (N, 4, 4) for a batch; its axes are OpenCV's (x right, y down, z
    ///     forward), metres. See `look_at`.
    /// annotators: names of Replicator's annotators, by default "distance_to_image_plane"; see `annotators()`.
    /// backend: "auto" (default), "raster" or "ray"; depths agree within 3 ulp of float32 up to 75° of incidence.
    /// smooth_edges: whether outlines in colour images are antialiased.
    /// transparent: the ground truth of transparent surfaces: "surface" (default), or "through" for what lies behind the clear ones.
    ///
    /// Returns a dictionary by annotator. Images are (H, W) or (H, W, C) for one pose, (N, H, W) or (N, H, W, C) for a batch:
    /// distances float32 metres, inf for a miss; "rgb" uint8 with coverage as its fourth channel; "normals" float32 in the
    /// world frame, 0 for a miss; segmentations uint32, 0 for the background, with the meaning of the ids in
    /// "instance_id_segmentation_prim_paths" and "semantic_segmentation_labels". Bounding boxes (structured, with Replicator's
    /// fields) and "pointcloud" ((P, 3) float32 in the world, metres) are an array for one pose, a list of arrays for a batch.
    ///
    /// Raises oaktwin.Error for invalid poses, unknown annotators, and images that do not fit in memory.
    #[pyo3(signature = (camera, world_from_camera, *, annotators = None, backend = "auto", smooth_edges = true, transparent = "surface"))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn render<'py>(
        &self,
        py: Python<'py>,
        camera: &Camera,
        world_from_camera: &Bound<'py, PyAny>,
        annotators: Option<Annotators>,
        backend: &str,
        smooth_edges: bool,
        transparent: &str,
    ) -> PyResult<Bound<'py, PyDict>> {
        let options = AnnotateOptions {
            smooth_edges,
            transparent: named::<Transparent>("transparent", transparent)?,
            ..AnnotateOptions::default()
        };
        self.rendered(py, camera, world_from_camera, annotators, backend, &options)
    }

    /// Renders the images of a device's stereo pair, raw and rectified as on the device, for a `StereoMatcher`.
    ///
    /// device: the device with the stereo pair.
    /// world_from_body: the pose of its body, (4, 4), metres; x forward, y left, z up. See `look_at`; a `CameraPose` is rejected.
    /// sensor: the depth sensor with the pair, by prim, such as "Camera_pseudo_depth_50mm" of the OAK-D LR; by default the
    ///     device's first pair.
    /// size: (width, height) of the images in px, resized by DepthAI's rule; by default the cameras' own.
    /// projector: the intensity of a Pro's infrared dot projector, from 0 (default, off) to 1.
    /// ambient: the scale of the scene's lights; 0 is darkness.
    /// imager: a mapping of image sensor parameters by name: {"bits": 10, "noise": False, ...}.
    /// seed: the noise seed; None for one of fresh entropy.
    /// device_seed: the seed of the unit's calibration error, which displaces the right camera from its assumed pose; None
    ///     (default) for no error.
    /// drift: the change of the pair since the calibration to which its images are rectified, such as {"yaw": 0.3, "baseline": 50}; see
    ///     `DepthSensor`.
    /// frame: the frame number in the sequence, which determines the noise together with the seed. By default, the calls of a scene
    ///     without `frame` are numbered from 0 on; copies and pickles continue the numbering.
    ///
    /// Returns a dictionary: "left", "right", "rectified_left", "rectified_right", (H, W) uint8, or uint16 with 10 bits; the
    /// rectified images are 0 outside the camera's image; "z", the ground truth in the rectified left camera, (H, W) float32
    /// metres along its optical axis, inf for a miss; "camera", the rectified left camera; "baseline" of the rectified pair in metres;
    /// "frame" and "seed".
    ///
    /// Issues an oaktwin.FindingWarning for missing or unsupported contents. Raises oaktwin.Error for a device without a stereo
    /// pair or without the requested projector, an invalid pose, values out of range, and images that do not fit in memory.
    #[pyo3(signature = (device, world_from_body, *, sensor = None, size = None, projector = 0.0, ambient = 1.0, imager = None, seed = 0,
        device_seed = None, drift = None, frame = None))]
    #[expect(clippy::needless_pass_by_value, reason = "required by PyO3")]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn render_pair<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = device::argument::required)] device: Bound<'py, Device>,
        world_from_body: &Bound<'py, PyAny>,
        sensor: Option<&str>,
        size: Option<Size>,
        projector: f64,
        ambient: f64,
        imager: Option<&Bound<'py, PyAny>>,
        #[pyo3(from_py_with = seed_or_entropy)] seed: u64,
        #[pyo3(from_py_with = optional::device_seed)] device_seed: Option<u64>,
        drift: Option<&Bound<'py, PyAny>>,
        frame: Option<FrameNumber>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let settings = PairSettings {
            sensor,
            size: size.map(|Size(width, height)| (width, height)),
            projector,
            ambient,
            imager,
            seed,
            device_seed,
            drift: drift.map(|drift| self::drift("drift", drift)).transpose()?,
        };
        let device = device.get();
        let options = settings.options(device)?;
        let world_from_body = Of::Body.one("world_from_body", world_from_body)?;
        let frame = FrameNumber::or_next(frame, &self.next_frame);
        py.check_signals()?;
        let stage = self.read(py);
        let pair = threads::run(py, || {
            let (cameras, light) =
                stage
                    .lit
                    .pair(&stage.renderer, &device.twin, &options, &world_from_body)?;
            let pair = cameras.record(&light, frame);
            Ok::<_, PairError>((pair, pair::Rectified::of(&cameras)))
        })?;
        let (pair, rectified) = pair.map_err(error)?;
        finding::warn(py, &pair.findings)?;
        let all = pair::arrays(py, pair, rectified)?;
        all.set_item("frame", frame)?;
        all.set_item("seed", seed)?;
        Ok(all)
    }

    /// The cameras in the file that `oaktwin render` renders: the cameras of render products with a depth sensor, otherwise all. A
    /// dictionary from the prim's path to (camera, world_from_camera), the latter (4, 4) float64 metres with OpenCV's axes:
    /// `scene.render(*scene.cameras["/World/Camera"])`.
    ///
    /// A camera that cannot be rendered is skipped and listed in `findings`; raises oaktwin.Error if none can be rendered.
    #[getter]
    fn cameras<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        let stage = self.read(py);
        for placed in stage.cameras.as_ref().map_err(error)? {
            let world_from_camera =
                Of::Camera.array(py, &(placed.world_from_mount * placed.mount_from_camera))?;
            let camera = Camera::placed(&placed.path, placed);
            all.set_item(&placed.path, (camera, world_from_camera))?;
        }
        Ok(all)
    }

    /// Unpickling opens the file again; meshes are stored in the pickle.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<parts::Reduced<'py>> {
        parts::reduce(self, py)
    }

    fn __setstate__(&self, py: Python<'_>, state: (Bound<'_, PyDict>, u64)) -> PyResult<()> {
        let (poses, next_frame) = state;
        self.next_frame.store(next_frame, Ordering::Relaxed);
        self.set_poses(py, &poses)
    }

    /// Warnings about missing and unsupported contents of the file.
    #[getter]
    fn findings(&self) -> Vec<Finding> {
        finding::list(&self.findings)
    }

    /// The up axis of the world, "y" or "z".
    #[getter]
    fn up(&self, py: Python<'_>) -> &'static str {
        self.read(py).renderer.scene().up.name()
    }

    /// The number of rendered triangles, counting every instance.
    #[getter]
    fn triangle_count(&self, py: Python<'_>) -> u64 {
        self.read(py).renderer.scene().triangle_count()
    }

    /// The minimum and maximum corner of the bounding box, (2, 3) metres in the world; None if the scene is empty.
    #[getter]
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyArray2<f64>>>> {
        let bounds = self.read(py).renderer.scene().bounds();
        let bounds = bounds.map(|bounds| matrix(py, &[bounds.min.to_array(), bounds.max.to_array()]));
        bounds.transpose()
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let stage = self.read(py);
        let scene = stage.renderer.scene();
        let origin = match &self.origin {
            Origin::File { path, .. } => path.file_name().unwrap_or_default().to_string_lossy(),
            Origin::Meshes(_) => "from meshes".into(),
        };
        format!(
            "<oaktwin.Scene {}: {} meshes, {} instances, {} triangles, {} lights, {} up>",
            origin,
            scene.meshes.len(),
            scene.instances.len(),
            self.triangle_count(py),
            scene.lights.len(),
            scene.up.name()
        )
    }
}
