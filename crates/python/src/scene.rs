use std::collections::BTreeMap;
use std::path::PathBuf;

use numpy::{PyArray1, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use oaktwin::camera::math::DAffine3;
use oaktwin::diagnostic;
use oaktwin::image::annotation::Annotator;
use oaktwin::pair::{PairCameras, PairError};
use oaktwin::render::{
    AnnotateOptions, Backend, CameraError, OpenOptions, PlacedCamera, Renderer, SceneCameraOptions,
    SceneFile, annotation_bytes, annotator, available_bytes, frame_bytes, gib, scene_cameras,
};
use oaktwin::scene::{self, Instance, Label, Mesh, Up};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use crate::array::{contiguous, view};
use crate::camera::Camera;
use crate::choice::choose;
use crate::device::Device;
use crate::error::{error, reading, wrong};
use crate::finding::{self, Finding};
use crate::frames::Frames;
use crate::pair::{self, PairSettings};
use crate::pose::{one_pose, poses, rows};
use crate::threads;

const UP: [(&str, Up); 2] = [("y", Up::Y), ("z", Up::Z)];

/// Triangles to be rendered on the CPU: `Scene.open(path)` or `Scene.from_triangles(vertices, faces)`.
///
/// The world's axes are the file's own; its unit is the metre, whatever the file's was. Safe to use from many threads. A
/// pickle opens the file again; triangles travel in it.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct Scene {
    renderer: Renderer,
    origin: Origin,
    cameras: Result<Vec<PlacedCamera>, CameraError>,
    findings: Vec<diagnostic::Finding>,
}

/// Where a scene comes from, which is what a pickle holds.
enum Origin {
    File { path: PathBuf, options: OpenOptions },
    Triangles,
}

/// The cameras of a file's own, and what is odd about them.
fn cameras(file: &SceneFile) -> (Result<Vec<PlacedCamera>, CameraError>, Vec<diagnostic::Finding>) {
    match scene_cameras(file, &SceneCameraOptions::default()) {
        Ok((cameras, findings)) => (Ok(cameras), findings),
        Err(CameraError::NoCamera { .. }) => (Ok(Vec::new()), Vec::new()),
        // Only of interest to whom asks for them.
        Err(error) => (Err(error), Vec::new()),
    }
}

#[pymethods]
impl Scene {
    /// Opens a USD stage (usd, usda, usdc, usdz) or a mesh file (gltf, glb, obj, stl, ply).
    ///
    /// path: the file.
    /// time: the time code of a USD stage; by default the default values, and the first samples.
    /// subdivide: how often a USD stage's subdivision meshes are refined.
    /// up: which axis of a mesh file points up, "y" or "z"; by default what its format says.
    /// scale: how many metres one unit of a mesh file is; by default 1.
    ///
    /// What is missing in it or not supported is in `findings`. Raises FileNotFoundError and other OSErrors for what cannot be
    /// read, oaktwin.Error for what is no scene, or an option that its kind does not have.
    #[staticmethod]
    #[pyo3(signature = (path, *, time = None, subdivide = 0, up = None, scale = None))]
    fn open(
        py: Python<'_>,
        path: PathBuf,
        time: Option<f64>,
        subdivide: u32,
        up: Option<&str>,
        scale: Option<f64>,
    ) -> PyResult<Self> {
        let options = OpenOptions {
            time,
            subdivide,
            up: up.map(|up| choose("up", up, &UP)).transpose()?,
            scale,
        };
        let opened = threads::interruptible(py, |_| SceneFile::open(&path, &options))?;
        let mut file = opened.map_err(|error| reading(&path, &error))?;
        let (cameras, odd) = cameras(&file);
        file.findings.extend(odd);
        // Where a pickle of the scene finds it again.
        let path = std::path::absolute(&path).unwrap_or(path);
        Ok(Self {
            renderer: Renderer::new(file.scene),
            origin: Origin::File { path, options },
            cameras,
            findings: file.findings,
        })
    }

    /// A scene of one mesh.
    ///
    /// vertices: (V, 3) numbers, metres in the world.
    /// faces: (F, 3) whole numbers: three vertices each, counter-clockwise seen from outside. Depth sees both sides.
    /// up: which axis of the world points up, "z" (default) or "y".
    /// label: the semantic class, if it has one.
    ///
    /// Raises oaktwin.Error for other shapes, vertices that are not finite, and faces of vertices that are not there.
    #[staticmethod]
    #[pyo3(signature = (vertices, faces, *, up = "z", label = None))]
    fn from_triangles(
        vertices: &Bound<'_, PyAny>,
        faces: &Bound<'_, PyAny>,
        up: &str,
        label: Option<String>,
    ) -> PyResult<Self> {
        let up = choose("up", up, &UP)?;
        let positions = triples::<f32>("vertices", vertices, "float32")?;
        let faces = triples::<i64>("faces", faces, "int64")?;
        if positions.as_flattened().iter().any(|number| !number.is_finite()) {
            return Err(wrong("vertices", "some are not finite", "leave those out"));
        }
        let count = u32::try_from(positions.len())
            .map_err(|_| wrong("vertices", "are too many", "give fewer than 2^32"))?;
        let corner = |index: i64| {
            u32::try_from(index)
                .ok()
                .filter(|index| *index < count)
                .ok_or_else(|| {
                    let is = format!("{index} is none of the {count} vertices");
                    wrong("faces", is, "count vertices from 0")
                })
        };
        let triangle = |[a, b, c]: &[i64; 3]| Ok([corner(*a)?, corner(*b)?, corner(*c)?]);
        let mesh = Mesh {
            triangles: faces.iter().map(triangle).collect::<PyResult<_>>()?,
            positions,
            ..Mesh::default()
        };
        let path = "/World/Mesh";
        let labels = label.map(|name| Label {
            prim: path.to_owned(),
            taxonomy: "class".to_owned(),
            name,
        });
        let scene = scene::Scene {
            meshes: vec![mesh],
            instances: vec![Instance {
                mesh: 0,
                path: path.to_owned(),
                world_from_mesh: DAffine3::IDENTITY,
                labels: labels.into_iter().collect(),
            }],
            up,
            ..scene::Scene::default()
        };
        Ok(Self {
            renderer: Renderer::new(scene),
            origin: Origin::Triangles,
            cameras: Ok(Vec::new()),
            findings: Vec::new(),
        })
    }

    /// What a camera sees.
    ///
    /// camera: a device's (`device.cameras["left"]`, `device.depth_camera()`) or your own.
    /// world_from_camera: where it stands: (4, 4), or (N, 4, 4) for a batch; its axes are OpenCV's (x right, y down, z
    ///     forward), metres. See `look_at`.
    /// annotators: names of Replicator's annotators, by default "distance_to_image_plane"; see `annotators()`.
    /// backend: "auto" (default), "raster" or "ray"; all see the same.
    /// smooth_edges: whether outlines are smooth in the colours.
    ///
    /// Returns a dictionary by name. Of one pose images are (H, W) or (H, W, C), of a batch (N, H, W) or (N, H, W, C):
    /// distances float32 metres, inf for a miss; "rgb" uint8 with coverage as its fourth channel; "normals" float32 in the
    /// world's axes, 0 for a miss; segmentations uint32, 0 for the background, with what ids mean in
    /// "instance_id_segmentation_prim_paths" and "semantic_segmentation_labels". Boxes (structured, as Replicator's) and
    /// "pointcloud" ((P, 3) float32 in the world) are one array of one pose, a list of arrays of a batch.
    ///
    /// Raises oaktwin.Error for poses that are none, names that are no annotator's, images that do not fit into the memory.
    #[pyo3(signature = (camera, world_from_camera, *, annotators = None, backend = "auto", smooth_edges = true))]
    fn render<'py>(
        &self,
        py: Python<'py>,
        camera: &Camera,
        world_from_camera: &Bound<'py, PyAny>,
        annotators: Option<Vec<String>>,
        backend: &str,
        smooth_edges: bool,
    ) -> PyResult<Bound<'py, PyDict>> {
        let backends = [
            ("auto", Backend::Auto),
            ("raster", Backend::Raster),
            ("ray", Backend::Ray),
        ];
        let backend = choose("backend", backend, &backends)?;
        let asked = match annotators {
            Some(names) => names
                .iter()
                .map(|name| scene_annotator(name))
                .collect::<PyResult<_>>()?,
            None => vec![Annotator::DistanceToImagePlane],
        };
        let (poses, is_batch) = poses("world_from_camera", world_from_camera)?;
        check_memory(camera, &asked, poses.len())?;
        let options = AnnotateOptions {
            smooth_edges,
            ..AnnotateOptions::default()
        };
        let mut frames = Frames::new(camera.camera.intrinsics.size, is_batch.then_some(poses.len()));
        for (number, world_from_camera) in poses.iter().enumerate() {
            py.check_signals()?;
            let view = oaktwin::render::View {
                camera: camera.camera,
                world_from_camera: *world_from_camera,
                clip: camera.clip,
            };
            let (frame, findings) =
                threads::run(py, || self.renderer.annotate(&view, &asked, backend, &options))?;
            if number == 0 {
                finding::warn(py, &findings)?;
            }
            frames.put(py, number, frame)?;
        }
        frames.finish(py, &asked)
    }

    /// What the stereo pair of a device records, and the same rectified as the device does it: for a `StereoMatcher`.
    ///
    /// device: whose pair; with its lens.
    /// world_from_body: where its body stands, (4, 4), metres; x forward, y left, z up. See `look_at` with frame="body".
    /// size: (width, height) of the images, by DepthAI's rule; by default the cameras' own.
    /// projector: the power of a Pro's infrared dot projector, 0 (default, off) to 1.
    /// ambient: the factor of the scene's own light; 0 is a dark room.
    /// imager: values of the image sensors' parameters by name, a mapping: {"bits": 10, "noise": False, ...}.
    /// seed: of the noise.
    /// device_seed: of the calibration's error, by which the right camera sees other than the device believes; None has
    ///     none.
    /// frame: the number in the sequence: noise is new in every frame, and the same for the same.
    ///
    /// Returns a dictionary by name: "left", "right", "rectified_left", "rectified_right", (H, W) uint8, or uint16 of 10
    /// bits, the rectified ones 0 where their camera does not see; "z", the truth in the rectified left camera, (H, W)
    /// float32 metres along its axis, inf for a miss.
    ///
    /// Warns with oaktwin.FindingWarning of what the pictures had to do without. Raises oaktwin.Error for a device without
    /// a pair or without the projector that is asked for, a pose that is none, values out of their range, images that do
    /// not fit into the memory.
    #[pyo3(signature = (device, world_from_body, *, size = None, projector = 0.0, ambient = 1.0, imager = None, seed = 0,
        device_seed = None, frame = 0))]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    fn render_pair<'py>(
        &self,
        py: Python<'py>,
        device: &Device,
        world_from_body: &Bound<'py, PyAny>,
        size: Option<(u32, u32)>,
        projector: f64,
        ambient: f64,
        imager: Option<&Bound<'py, PyAny>>,
        seed: u64,
        device_seed: Option<u64>,
        frame: u64,
    ) -> PyResult<Bound<'py, PyDict>> {
        let settings = PairSettings {
            size,
            projector,
            ambient,
            imager,
            seed,
            device_seed,
        };
        let options = settings.options(device)?;
        let world_from_body = one_pose("world_from_body", world_from_body)?;
        py.check_signals()?;
        let pair = threads::run(py, || {
            let cameras = PairCameras::new(&device.twin, &options)?;
            Ok::<_, PairError>(cameras.look(&self.renderer, &world_from_body, frame))
        })?;
        let pair = pair.map_err(error)?;
        finding::warn(py, &pair.findings)?;
        pair::arrays(py, pair)
    }

    /// The cameras of the file's own, those that `oaktwin render` renders: those of every depth sensor's product, else all.
    /// A dictionary from the prim's path to (camera, world_from_camera), the latter (4, 4) float64 metres, the camera's axes
    /// OpenCV's: `scene.render(*scene.cameras["/World/Camera"])`.
    ///
    /// One that cannot be rendered is left out and in `findings`; raises oaktwin.Error where none can be.
    #[getter]
    fn cameras<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let all = PyDict::new(py);
        for placed in self.cameras.as_ref().map_err(error)? {
            let world_from_camera = rows(py, &(placed.world_from_mount * placed.mount_from_camera))?;
            let camera = Camera::placed(&placed.path, placed);
            all.set_item(&placed.path, (camera, world_from_camera))?;
        }
        Ok(all)
    }

    /// A file is opened again where the pickle is; triangles travel in it.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let partial = py.import("functools")?.getattr("partial")?;
        let own = py.get_type::<Self>();
        let options = PyDict::new(py);
        match &self.origin {
            Origin::File { path, options: said } => {
                options.set_item("time", said.time)?;
                options.set_item("subdivide", said.subdivide)?;
                options.set_item("up", said.up.map(up_name))?;
                options.set_item("scale", said.scale)?;
                let open = partial.call((own.getattr("open")?,), Some(&options))?;
                Ok((open, PyTuple::new(py, [path])?))
            }
            Origin::Triangles => {
                let scene = self.renderer.scene();
                let mesh = scene
                    .meshes
                    .first()
                    .map(|mesh| (&mesh.positions, &mesh.triangles));
                let (positions, triangles) =
                    mesh.ok_or_else(|| wrong("scene", "has no mesh", "make it again"))?;
                let labels = scene.instances.iter().flat_map(|instance| &instance.labels);
                options.set_item("up", up_name(scene.up))?;
                options.set_item("label", labels.map(|label| &label.name).next())?;
                let vertices = PyArray1::from_slice(py, positions.as_flattened());
                let faces = PyArray1::from_slice(py, triangles.as_flattened());
                let arrays = [
                    vertices.reshape([positions.len(), 3])?.into_any(),
                    faces.reshape([triangles.len(), 3])?.into_any(),
                ];
                let make = partial.call((own.getattr("from_triangles")?,), Some(&options))?;
                Ok((make, PyTuple::new(py, arrays)?))
            }
        }
    }

    /// What is missing in the file or was left out.
    #[getter]
    fn findings(&self) -> Vec<Finding> {
        finding::list(&self.findings)
    }

    /// The axis of the world that points up, "y" or "z".
    #[getter]
    fn up(&self) -> &'static str {
        up_name(self.renderer.scene().up)
    }

    /// How many triangles are rendered: those of every instance.
    #[getter]
    fn triangle_count(&self) -> usize {
        let scene = self.renderer.scene();
        let of = |instance: &Instance| {
            let mesh = scene.meshes.get(instance.mesh as usize);
            mesh.map_or(0, |mesh| mesh.triangles.len())
        };
        scene.instances.iter().map(of).sum()
    }

    /// The corners of the box around everything, (2, 3) metres in the world; None where there is nothing.
    #[getter]
    fn bounds(&self) -> Option<[[f64; 3]; 2]> {
        let bounds = self.renderer.scene().bounds()?;
        Some([bounds.low.to_array(), bounds.high.to_array()])
    }

    fn __repr__(&self) -> String {
        let scene = self.renderer.scene();
        let origin = match &self.origin {
            Origin::File { path, .. } => path.file_name().unwrap_or_default().to_string_lossy(),
            Origin::Triangles => "from triangles".into(),
        };
        format!(
            "<oaktwin.Scene {}: {} meshes, {} instances, {} triangles, {} lights, {} up>",
            origin,
            scene.meshes.len(),
            scene.instances.len(),
            self.triangle_count(),
            scene.lights.len(),
            self.up()
        )
    }
}

fn up_name(up: Up) -> &'static str {
    match up {
        Up::Y => "y",
        Up::Z => "z",
    }
}

/// The annotators of scenes and depth sensors: a dictionary from name to description.
///
/// `Scene.render` takes all but "camera_params" and those whose names begin with "depth_sensor_", which
/// `DepthSensor.annotate` takes.
#[pyfunction]
pub(crate) fn annotators() -> BTreeMap<&'static str, &'static str> {
    Annotator::all().map(|one| (one.name(), one.doc())).collect()
}

/// Returns the annotator of a name, if it describes a scene and is an image or a list.
fn scene_annotator(name: &str) -> PyResult<Annotator> {
    let found = annotator(name).map_err(error)?;
    if found == Annotator::CameraParams {
        return Err(wrong(
            name,
            "is not an image",
            "use the camera's attributes K, distortion and size",
        ));
    }
    if found.is_depth_sensor() {
        let remedy = "pass distance_to_image_plane (and rgb) to DepthSensor.annotate";
        return Err(wrong(name, "is an output of a depth sensor", remedy));
    }
    Ok(found)
}

fn check_memory(camera: &Camera, annotators: &[Annotator], count: usize) -> PyResult<()> {
    let size = camera.camera.intrinsics.size;
    let results = annotation_bytes(size, annotators).saturating_mul(count as u64);
    let needed = results.saturating_add(frame_bytes(size, annotators));
    match available_bytes() {
        Some(available) if needed > available => {
            let is = format!("needs {} of memory, and {} are free", gib(needed), gib(available));
            Err(wrong(
                &camera.name,
                is,
                "render fewer poses at once, or smaller images",
            ))
        }
        _ => Ok(()),
    }
}

/// An array (N, 3).
fn triples<T: numpy::Element + Copy>(
    name: &str,
    object: &Bound<'_, PyAny>,
    dtype: &str,
) -> PyResult<Vec<[T; 3]>> {
    let array = view(name, object)?;
    let kind = array.getattr("dtype")?.getattr("kind")?.extract::<String>()?;
    let fits = if dtype.starts_with("int") { "iu" } else { "fiu" };
    if !fits.contains(&kind) || array.ndim() != 2 || array.shape().last() != Some(&3) {
        let is = format!(
            "has shape {:?} and type {}",
            array.shape(),
            array.getattr("dtype")?
        );
        let numbers = if dtype.starts_with("int") {
            "whole numbers"
        } else {
            "numbers"
        };
        return Err(wrong(name, is, format_args!("give {numbers} (N, 3)")));
    }
    let cast = array.call_method1("astype", (dtype,))?;
    let array = contiguous::<T>(name, cast.cast::<PyUntypedArray>()?)?;
    let (rows, _) = array.as_slice().map_err(error)?.as_chunks::<3>();
    Ok(rows.to_vec())
}
