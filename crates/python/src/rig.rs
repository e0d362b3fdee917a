//! Rigs: a device whose cameras all see a scene at once.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use oaktwin::camera::ImageSize;
use oaktwin::camera::math::DVec3;
use oaktwin::depth::imager::ColorParameters;
use oaktwin::pair::PairOptions;
use oaktwin::render::{
    self, Backend, Passing, PlacedCamera, RigSpec, Shutter, Transparent, Twist, annotator,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arguments::{Annotators, FrameNumber, Size};
use crate::camera::Camera;
use crate::choice::named;
use crate::device::{self, Device};
use crate::engine::{PythonEngine, serve_all};
use crate::error::{error, wrong};
use crate::finding;
use crate::images::{Depth, exact};
use crate::json::{from_python, to_python};
use crate::layers::layers;
use crate::parameters::by_name;
use crate::pose::Of;
use crate::progress::ProgressCallback;
use crate::scene::Scene;
use crate::settings::{assignments, fresh_seed, keywords, sensor_options, strings};
use crate::shot::{OUTPUTS, shot};

/// The arguments besides the options of the sensor.
const ARGUMENTS: [&str; 9] = [
    "cameras",
    "size",
    "annotators",
    "pair",
    "rgb_imager",
    "backend",
    "transparent",
    "exposure_ms",
    "readout_ms",
];

#[doc = concat!(
    "Rig(device, *, cameras=None, size=None, annotators=None, pair=None, rgb_imager=None, backend='auto', ",
    "transparent='surface', exposure_ms=None, readout_ms=None, ",
    include_str!("generated/sensor_options.signature"),
    ")\n--\n"
)]
/// A device with its cameras and depth sensors: what the program's commands render and measure with.
///
/// device: the device.
/// cameras: the names of cameras: "rgb", "left", "right", "tof", or "depth" for the camera of every depth sensor; by default "depth".
/// size: (width, height) of the images in px, resized by DepthAI's rule; by default each camera's own.
/// annotators: the names of Replicator's annotators; by default "rgb", "distance_to_image_plane", and the depth, the reasons and the
///     confidence of the depth sensors. See `annotators()`.
/// pair: how the stereo pair is recorded and lit: a mapping with "projector" (the intensity of a Pro's dot projector, 0 to 1), "ambient" (the
///     scale of the scene's lights), "imager" (a mapping of image sensor parameters), "rectify" (a mapping with "method", "target" and
///     "edge_fill"), "lens" ("pinhole" or "fisheye") and "cameras" (the names of the two). The light changes what every engine measures.
/// rgb_imager: records "rgb" with the blur, the exposure and the noise of a colour camera: True, or a mapping of parameters by name
///     (`parameters("color-imager")`). By default colours are exact. Depth does not depend on it.
/// backend: "auto", "raster" or "ray".
/// transparent: the ground truth of transparent surfaces: "surface" (default), or "through" for what lies behind the clear ones.
/// exposure_ms: how long each row is exposed, ms, which blurs what moves in `shoot` with a velocity. By default frames are moments.
/// readout_ms: the readout time, ms: how much later sensors that roll expose the last row than the first; by default the sensor's own, if
///     there is an exposure.
#[doc = include_str!("generated/sensor_options.doc")]
///
/// Raises oaktwin.Error for a camera, a sensor or a pair that the device lacks, and for unknown or invalid options, with the nearest names.
///
/// Thread-safe; shots are taken one after another. Copies and pickles have the settings and the number of the next frame, but not the
/// state of temporal filters.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct Rig {
    device: Py<Device>,
    spec: RigSpec,
    /// The cameras of the rig, which threads read while others shoot.
    cameras: Vec<PlacedCamera>,
    /// Locked with the interpreter released only: an engine in Python needs the interpreter while the rig is locked.
    rig: Mutex<render::Rig>,
    /// Whether the rig forgets earlier images before the next one.
    is_reset: AtomicBool,
    next_frame: AtomicU64,
    /// The engine, if it is written in Python.
    engine: Option<Arc<PythonEngine>>,
}

#[pymethods]
impl Rig {
    #[new]
    #[pyo3(signature = (device, *, cameras = None, size = None, annotators = None, pair = None, rgb_imager = None, backend = "auto", transparent = "surface", exposure_ms = None, readout_ms = None, **options))]
    #[pyo3(text_signature = None)]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn new(
        py: Python<'_>,
        #[pyo3(from_py_with = device::argument::required)] device: Bound<'_, Device>,
        cameras: Option<&Bound<'_, PyAny>>,
        size: Option<Size>,
        annotators: Option<Annotators>,
        pair: Option<&Bound<'_, PyAny>>,
        rgb_imager: Option<&Bound<'_, PyAny>>,
        backend: &str,
        transparent: &str,
        exposure_ms: Option<f64>,
        readout_ms: Option<f64>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let entropy = fresh_seed(py, options)?;
        let mut sensor = sensor_options("Rig", &ARGUMENTS, options, |_| true)?;
        sensor.seed = entropy.unwrap_or(sensor.seed);
        let own = PairOptions {
            lens: device.get().lens,
            ..PairOptions::default()
        };
        let pair = pair.map(|pair| pair_options(pair, own)).transpose()?;
        let names = annotators.map(|Annotators(names)| names.into_iter());
        let asked = names.map(|names| names.map(|name| annotator(&name).map_err(error)).collect());
        let spec = RigSpec {
            cameras: cameras
                .map(|names| strings("cameras", names))
                .transpose()?
                .unwrap_or_default(),
            size: size.map(|Size(width, height)| ImageSize::new(width, height)),
            // Annotators that the caller did not name may be missing.
            are_outputs_optional: asked.is_none(),
            is_sensor_optional: asked.is_none(),
            annotators: asked.transpose()?.unwrap_or_else(|| OUTPUTS.to_vec()),
            pair: pair.unwrap_or(own),
            sensor,
            rgb_imager: rgb_imager.map(color_parameters).transpose()?.flatten(),
            backend: named::<Backend>("backend", backend)?,
            transparent: named::<Transparent>("transparent", transparent)?,
            shutter: (exposure_ms.is_some() || readout_ms.is_some()).then(|| Shutter {
                exposure_ms: exposure_ms.unwrap_or(0.0),
                readout_ms,
            }),
            ..RigSpec::default()
        };
        let twin = Arc::clone(&device.get().twin);
        let (rig, findings) = py.detach(|| render::Rig::new(&twin, &spec)).map_err(error)?;
        rig.check_memory(false).map_err(error)?;
        finding::warn(py, &findings)?;
        Ok(Self {
            device: device.unbind(),
            engine: PythonEngine::in_options(&spec.sensor),
            cameras: rig.cameras().to_vec(),
            rig: Mutex::new(rig),
            is_reset: AtomicBool::new(false),
            next_frame: AtomicU64::new(0),
            spec,
        })
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<((&Py<Device>,), Bound<'py, PyDict>)> {
        let options = keywords(py, &self.spec.sensor, |_| true)?;
        if !self.spec.cameras.is_empty() {
            options.set_item("cameras", &self.spec.cameras)?;
        }
        options.set_item("size", self.spec.size.map(|size| (size.width, size.height)))?;
        if !self.spec.are_outputs_optional {
            let names: Vec<&str> = self.spec.annotators.iter().map(|one| one.name()).collect();
            options.set_item("annotators", names)?;
        }
        options.set_item("pair", to_python(py, &self.spec.pair)?)?;
        if let Some(imager) = &self.spec.rgb_imager {
            options.set_item("rgb_imager", color_settings(py, imager)?)?;
        }
        options.set_item("backend", self.spec.backend.name())?;
        options.set_item("transparent", self.spec.transparent.name())?;
        if let Some(shutter) = &self.spec.shutter {
            options.set_item("exposure_ms", shutter.exposure_ms)?;
            options.set_item("readout_ms", shutter.readout_ms)?;
        }
        Ok(((&self.device,), options))
    }

    /// The number of the next frame.
    fn __getstate__(&self) -> u64 {
        self.next_frame.load(Ordering::Relaxed)
    }

    fn __setstate__(&self, next_frame: u64) {
        self.next_frame.store(next_frame, Ordering::Relaxed);
    }

    /// Renders a scene with the device at a pose, and measures it with its depth sensors.
    ///
    /// scene: the scene.
    /// world_from_body: the pose of the device's body, (4, 4), metres; x forward, y left, z up. See `Scene.look_at` with a device; a
    ///     `CameraPose` is rejected.
    /// velocity: (vx, vy, vz, wx, wy, wz): the velocity of the body in the world, m/s, and its angular velocity about its own axes, rad/s,
    ///     while the frame is taken; requires `exposure_ms` or `readout_ms` of the rig. The pose is that of the middle of the exposure.
    /// frame: the number of the frame. Noise differs between frames and is reproducible for each. By default, shots are numbered from 0 on.
    ///
    /// Returns a dictionary with a `Shot` for each camera: "rgb", "left", "right", "tof", and for the depth sensors "stereo_depth" and
    /// "tof_depth", or "stereo_1_depth" and so on if there are several of a kind.
    ///
    /// Issues an oaktwin.FindingWarning for missing or unsupported contents. Raises oaktwin.Error for an invalid pose.
    #[pyo3(signature = (scene, world_from_body, *, velocity = None, frame = None))]
    fn shoot<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        world_from_body: &Bound<'py, PyAny>,
        velocity: Option<[f64; 6]>,
        frame: Option<FrameNumber>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let world_from_body = Of::Body.one("world_from_body", world_from_body)?;
        let twist = velocity.map(|velocity| self.twist(velocity)).transpose()?;
        let number = FrameNumber::or_next(frame, &self.next_frame);
        let stage = scene.read(py);
        let renderer = &stage.renderer;
        let shots = serve_all(
            py,
            self.engine.as_slice(),
            ProgressCallback::default(),
            |_| match twist {
                Some(twist) => self.rig().expose(
                    &mut Passing {
                        renderer,
                        world_from_body,
                        twist,
                    },
                    number,
                ),
                None => self.rig().shoot(renderer, Some(&world_from_body), number),
            },
        )?;
        let (shots, findings) = shots.map_err(error)?;
        finding::warn(py, &findings)?;
        let by_camera = PyDict::new(py);
        for (camera, one) in self.cameras.iter().zip(shots) {
            let one = shot(py, one, &world_from_body, self.spec.sensor.seed, &findings)?;
            by_camera.set_item(name(camera), one)?;
        }
        Ok(by_camera)
    }

    /// Measures exact depth that was rendered elsewhere, with the first depth sensor.
    ///
    /// depth: (H, W), with the size of the depth camera: floating-point metres along the optical axis, or uint16 millimetres.
    /// rgb: the colour image of the same camera, (H, W, 3 or 4) uint8 sRGB.
    /// frame: as in `shoot`.
    ///
    /// Returns a dictionary of the sensor's outputs by the names of annotators, "depth_sensor_distance" in metres.
    ///
    /// Raises oaktwin.Error for images of another size, a device without a depth sensor, and an engine that matches pairs.
    #[pyo3(signature = (depth, rgb = None, *, frame = None))]
    fn measure<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
        frame: Option<FrameNumber>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (depth, shape) = Depth::read("depth", depth)?;
        if shape.batch.is_some() {
            return Err(wrong(
                "depth",
                "is a batch",
                "pass one image (H, W), or call a DepthSensor",
            ));
        }
        let (depth, rgb) = exact(&depth, rgb, shape)?;
        let depth = depth.ok_or_else(|| wrong("depth", "has no pixels", "pass an image (H, W)"))?;
        let number = FrameNumber::or_next(frame, &self.next_frame);
        let measured = serve_all(py, self.engine.as_slice(), ProgressCallback::default(), |_| {
            self.rig().measure(depth, rgb, number)
        })?;
        layers(py, measured.map_err(error)?, shape.size)
    }

    /// Starts a new sequence: temporal filters forget earlier images. The numbering of frames continues, so that no noise repeats.
    fn reset(&self) {
        self.is_reset.store(true, Ordering::Relaxed);
    }

    /// The Camera of each shot, on the device, by the name of the shot.
    #[getter]
    fn cameras<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let by_name = PyDict::new(py);
        for camera in &self.cameras {
            by_name.set_item(name(camera), Camera::placed("camera", camera))?;
        }
        Ok(by_name)
    }

    /// The specification as a dictionary of texts, numbers, lists and dictionaries, which JSON and TOML can hold. Rust's `RigSpec` reads it.
    #[getter]
    fn spec<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.spec)
    }

    /// The noise seed; of a rig with `seed=None`, the one that was drawn.
    #[getter]
    fn seed(&self) -> u64 {
        self.spec.sensor.seed
    }

    fn __repr__(&self) -> String {
        let names: Vec<&str> = self.cameras.iter().map(name).collect();
        format!(
            "<oaktwin.Rig {}: {}>",
            self.device.get().twin.device.name,
            names.join(", ")
        )
    }
}

impl Rig {
    /// Checks a velocity.
    fn twist(&self, velocity: [f64; 6]) -> PyResult<Twist> {
        let remedy = "make the rig with exposure_ms or readout_ms";
        if self.spec.shutter.is_none() {
            return Err(wrong(
                "velocity",
                "has no effect on frames that take no time",
                remedy,
            ));
        }
        if !velocity.iter().all(|number| number.is_finite()) {
            return Err(wrong(
                "velocity",
                "has a number that is not finite",
                "pass finite numbers",
            ));
        }
        let [vx, vy, vz, wx, wy, wz] = velocity;
        Ok(Twist {
            velocity: DVec3::new(vx, vy, vz),
            angular_velocity: DVec3::new(wx, wy, wz),
        })
    }

    /// Locks the rig for the next image. Called with the interpreter released.
    fn rig(&self) -> MutexGuard<'_, render::Rig> {
        let mut rig = self.rig.lock().unwrap_or_else(PoisonError::into_inner);
        if self.is_reset.swap(false, Ordering::Relaxed) {
            rig.reset();
        }
        rig
    }
}

/// The name of a camera, and of its shots.
fn name(camera: &PlacedCamera) -> &str {
    camera.role.as_deref().unwrap_or(&camera.folder)
}

/// Reads how a pair is recorded; what the mapping leaves out is as given.
fn pair_options(pair: &Bound<'_, PyAny>, own: PairOptions) -> PyResult<PairOptions> {
    let read: PairOptions = from_python("pair", pair)?;
    let names_lens = pair.contains("lens")?;
    let lens = if names_lens { read.lens } else { own.lens };
    Ok(PairOptions { lens, ..read })
}

/// Reads the image sensor of colours; `None` if there is none.
fn color_parameters(value: &Bound<'_, PyAny>) -> PyResult<Option<ColorParameters>> {
    let mut parameters = ColorParameters::default();
    if let Ok(is_on) = value.extract::<bool>() {
        return Ok(is_on.then_some(parameters));
    }
    for (name, value) in assignments("rgb_imager", value)? {
        parameters
            .set(&name, &value)
            .map_err(|failed| error(format!("rgb_imager: {failed}")))?;
    }
    Ok(Some(parameters))
}

/// Returns the parameters by name.
fn color_settings<'py>(py: Python<'py>, parameters: &ColorParameters) -> PyResult<Bound<'py, PyDict>> {
    by_name(py, "color-imager", parameters.by_name())
}
