mod annotate;
mod batch;
mod drifted;
mod image_camera;
mod items;
mod latency;
mod many;
mod memory;
mod sense;
mod shoot;
mod sized;
mod units;

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use oaktwin::align::AlignTo;
use oaktwin::camera::ImageSize;
use oaktwin::sense::{self as sensing, FieldOfView};
use oaktwin::sensor::{SensorOptions, depth_sensor};
use oaktwin::usd::asset::LensChoice;
use pyo3::prelude::*;
use pyo3::types::PyDict;

pub(crate) use batch::SensorBatch;
pub(crate) use drifted::_drift;
use image_camera::field_of_view;
use memory::Memory;
use shoot::{Light, Shooting};
use sized::{SensorSettings, SizedSensor};
use units::Units;

use crate::arguments::{self, Annotators, FrameNumber, Size};
use crate::camera::Camera;
use crate::choice::{maybe_named, named};
use crate::device::{self, Device};
use crate::engine::PythonEngine;
use crate::error::{error, wrong};
use crate::finding::{self, Finding, Notices};
use crate::parameters::by_name;
use crate::scene::Scene;
use crate::settings::{fresh_seed, item_numbers, keywords, sensor_options, whole};

#[doc = concat!(
    "DepthSensor(device, *, sensor=None, fx=None, hfov_deg=None, camera=None, name=None, ",
    include_str!("../generated/sensor_options.signature"),
    ")\n--\n"
)]
/// The depth sensor of a device: converts exact depth to the depth that the device would measure.
///
/// device: the device.
/// sensor: its depth sensor, "stereo", "tof" or a prim; by default time of flight if the device has it.
/// fx: the focal length of the images at their width, px; or hfov_deg: their horizontal field of view, degrees. Their
///     principal point is then in the centre. By default, images have the model's field of view, whatever their size.
/// camera: the Camera of the images, with their size. Its focal length and principal point are used by time of flight,
///     points and aligned depth. fx and hfov_deg must agree with it. Images are rectified: a lens with distortion
///     causes a finding.
/// name: the name of the camera, which distinguishes its noise from other cameras'; by default the sensor's
///     prim.
#[doc = include_str!("../generated/sensor_options.doc")]
///
/// Raises oaktwin.Error for an unknown or invalid engine, preset, filter or parameter, with the nearest names, and for
/// a camera whose field of view contradicts fx or hfov_deg.
///
/// A call, `sensor(depth, rgb=None, *, frame=None, seed=None, device_seed=None, out=None)`, returns the measurement of exact depth:
///
/// depth: one image (H, W), or a batch (N, H, W) of simultaneous images, such as the environments of a simulator, each
///     with its own noise; with or without a last dimension of 1. Floating-point metres along the optical axis (float32 is read without
///     a copy), or uint16 millimetres. Masked pixels are invalid. Values that are not finite or
///     not above 0 are invalid. NumPy arrays, or objects with the buffer protocol, DLPack or NumPy's array interface in
///     CPU memory; C-contiguous arrays are read without a copy.
/// rgb: the colour images of the same camera, uint8 sRGB, (H, W, 3 or 4) or (N, H, W, 3 or 4), used for the texture in
///     the confidence and for the brightness in filters. Three channels are copied.
/// frame: the number of the frame in the sequence. Noise differs between frames and is reproducible for each. By default,
///     the calls of a sensor without `frame` are numbered from 0 on; copies and pickles continue the numbering.
/// seed, device_seed: for a batch, a sequence of N seeds. Item i is measured like the image of a DepthSensor with `seed[i]`,
///     or by the unit with `device_seed[i]`. By default all items have the sensor's seeds, and their index distinguishes their
///     noise.
/// out: the output array: C-contiguous, with the shape of the result, float32 for metres or uint16 for millimetres, not
///     overlapping the depth.
///
/// Returns `out`, or a new NumPy array in the unit of the input: metres or millimetres, 0 where invalid. It has the
/// shape of the input; smaller if a filter decimates.
///
/// A temporal filter remembers the (H, W) images of earlier calls, and of batches the images of each item, until the image size
/// changes; see `reset()`.
///
/// Raises TypeError for an object that is not an array or has another dtype, oaktwin.Error for an invalid shape and for
/// a size that differs from the camera's.
///
/// Thread-safe; calls of one sensor with a temporal filter run one after another. Copies and pickles have the settings,
/// the device's calibration and the number of the next frame, but not the state of temporal filters.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct DepthSensor {
    device: Py<Device>,
    source: SensorSettings,
    camera: Option<Camera>,
    lens: LensChoice,
    sized: Mutex<SizedSensor>,
    /// The frame number of the next call without one.
    next_frame: AtomicU64,
    /// What temporal filters remember of batches.
    memory: Memory,
    notices: Notices,
    units: Units,
    /// The engine, if it is written in Python.
    engine: Option<Arc<PythonEngine>>,
    shooting: Shooting,
}

/// The arguments besides the options of the sensor.
const ARGUMENTS: [&str; 5] = ["sensor", "fx", "hfov_deg", "camera", "name"];

#[pymethods]
impl DepthSensor {
    #[new]
    #[pyo3(signature = (device, *, sensor = None, fx = None, hfov_deg = None, camera = None, name = None, **options))]
    #[pyo3(text_signature = None)]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn new(
        py: Python<'_>,
        #[pyo3(from_py_with = device::argument::required)] device: Bound<'_, Device>,
        sensor: Option<&str>,
        fx: Option<f64>,
        hfov_deg: Option<f64>,
        camera: Option<&Bound<'_, Camera>>,
        name: Option<String>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let entropy = fresh_seed(py, options)?;
        let mut options = SensorOptions {
            name,
            ..sensor_options("DepthSensor", &ARGUMENTS, options, |_| true)?
        };
        options.seed = entropy.unwrap_or(options.seed);
        let twin = &device.get().twin;
        let depth = depth_sensor(twin, sensor).map_err(error)?.clone();
        let camera = camera.map(|camera| camera.get().clone());
        let source = SensorSettings {
            twin: Arc::clone(twin),
            depth,
            seed: AtomicU64::new(options.seed),
            options,
            field_of_view: field_of_view(fx, hfov_deg, camera.as_ref())?,
        };
        let notices = Notices::default();
        notices.notice(py, hfov_deg.and_then(sensing::check_hfov))?;
        Ok(Self {
            lens: device.get().lens,
            device: device.unbind(),
            engine: PythonEngine::in_options(&source.options),
            shooting: Shooting::default(),
            // Reports invalid settings immediately.
            sized: Mutex::new(source.sized(None)?),
            source,
            camera,
            next_frame: AtomicU64::new(0),
            memory: Memory::default(),
            notices,
            units: Units::default(),
        })
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<((&Py<Device>,), Bound<'py, PyDict>)> {
        let own = &self.source.options();
        let options = keywords(py, own, |_| true)?;
        let (fx, hfov_deg) = match self.source.field_of_view {
            FieldOfView::Known | FieldOfView::Camera(_) => (None, None),
            FieldOfView::FocalLength(fx) => (Some(fx), None),
            FieldOfView::Degrees(hfov) => (None, Some(hfov)),
        };
        options.set_item("sensor", self.source.depth.spec.kind.as_str())?;
        options.set_item("fx", fx)?;
        options.set_item("hfov_deg", hfov_deg)?;
        options.set_item("camera", self.camera.clone())?;
        options.set_item("name", &own.name)?;
        Ok(((&self.device,), options))
    }

    /// The number of the next frame.
    fn __getstate__(&self) -> u64 {
        self.next_frame.load(Ordering::Relaxed)
    }

    fn __setstate__(&self, next_frame: u64) {
        self.next_frame.store(next_frame, Ordering::Relaxed);
    }

    /// Measures a depth image or a batch; see the class.
    #[pyo3(name = "_call", signature = (depth, rgb = None, *, frame = None, seed = None, device_seed = None, out = None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn call<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
        frame: Option<FrameNumber>,
        seed: Option<&Bound<'py, PyAny>>,
        device_seed: Option<&Bound<'py, PyAny>>,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.measured(py, depth, rgb, frame, (seed, device_seed), out)
    }

    /// The outputs of Isaac Sim's depth sensor annotators for one image, from one measurement.
    ///
    /// depth: exact depth (H, W), as in a call.
    /// rgb: the colour image, (H, W, 3 or 4) uint8, as in a call; required for the colours and the imager.
    /// annotators: the names of Isaac Sim's depth sensor annotators, such as "depth_sensor_distance"; see
    ///     `annotators()`.
    /// frame: as in a call.
    ///
    /// Returns a dictionary by name. "depth_sensor_distance": (H, W) float32 metres, 0 where invalid, as returned by a
    /// call. Positions: (H, W, 4) float32 metres in the camera's frame with USD's axes (x right, y up, z backward),
    /// then 1. Colours: (H, W, 4) uint8. Positions and colours are 0 where invalid. The imager: (H, W) float32, 0 to 1.
    /// The visualization: (H, W, 4) uint8. Only "single-view" supports the imager and the visualization. "depth_sensor_confidence":
    /// (H, W) uint16, higher is better. "depth_sensor_reason": (H, W) uint8, 0 where a depth was measured, with the meaning of the
    /// codes in "depth_sensor_reason_names".
    ///
    /// Raises oaktwin.Error for unknown names, for outputs that the engine does not support, and for a missing colour
    /// image.
    #[pyo3(signature = (depth, rgb = None, *, annotators, frame = None))]
    #[expect(clippy::needless_pass_by_value, reason = "what PyO3 hands over")]
    fn annotate<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
        annotators: Annotators,
        frame: Option<FrameNumber>,
    ) -> PyResult<Bound<'py, PyDict>> {
        self.annotated(py, depth, rgb, &annotators, frame)
    }

    /// Renders a scene with the device at a pose, and measures it: exact depth and colours for engines that measure depth, the device's
    /// stereo pair for engines that match pairs.
    ///
    /// scene: the scene.
    /// world_from_body: the pose of the device's body, (4, 4), metres; x forward, y left, z up. See `Scene.look_at` with a device; a
    ///     `CameraPose` is rejected.
    /// size: (width, height) of the images in px, resized by DepthAI's rule; by default the sensor's own.
    /// projector: the intensity of a Pro's infrared dot projector, from 0 (default, off) to 1.
    /// ambient: the scale of the scene's lights; 0 is darkness.
    /// imager: a mapping of image sensor parameters by name, as in `Scene.render_pair`, for engines that match pairs.
    /// frame: as in a call.
    ///
    /// Returns a `Shot`, which has its images as attributes and, as a dictionary, by Replicator's names. A temporal filter remembers the
    /// shots of one size and light.
    ///
    /// Issues an oaktwin.FindingWarning for missing or unsupported contents. Raises oaktwin.Error for an invalid pose, a sensor with
    /// fx, hfov_deg or camera, which has images of its own, and images that do not fit in memory.
    #[pyo3(signature = (scene, world_from_body, *, size = None, projector = 0.0, ambient = 1.0, imager = None, frame = None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn shoot<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        world_from_body: &Bound<'py, PyAny>,
        size: Option<Size>,
        projector: f64,
        ambient: f64,
        imager: Option<&Bound<'py, PyAny>>,
        frame: Option<FrameNumber>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.shot(
            py,
            scene,
            world_from_body,
            size,
            &Light::new(projector, ambient, imager),
            frame,
        )
    }

    /// The sensors of `count` simultaneous images, such as the environments of a simulator, each with its own unit, parameters and episodes.
    ///
    /// count: the number of items.
    /// seeds, device_seeds: a seed for each item, as in a call.
    /// parameters: parameters of the engine that differ between items, by name, such as `{"jitter": array}`: an array with a value for each
    ///     item, or one value for all. They override the parameters of the sensor.
    /// drift: the same for the change of the stereo pair, such as `{"yaw": array}`.
    /// units: a `Device` for each item, such as `device.population(count)`: units of one model with their calibrations.
    ///
    /// Returns a `SensorBatch`, which has this sensor's settings, and numbers frames from 0 on.
    ///
    /// Raises oaktwin.Error for sequences of another length, and for values that the sensor would reject, with the number of the item.
    #[pyo3(signature = (count, *, seeds = None, device_seeds = None, parameters = None, drift = None, units = None))]
    fn batch(
        slf: &Bound<'_, Self>,
        #[pyo3(from_py_with = arguments::count)] count: u64,
        seeds: Option<&Bound<'_, PyAny>>,
        device_seeds: Option<&Bound<'_, PyAny>>,
        parameters: Option<&Bound<'_, PyAny>>,
        drift: Option<&Bound<'_, PyAny>>,
        units: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<SensorBatch> {
        let given = [
            ("seeds", seeds),
            ("device_seeds", device_seeds),
            ("parameters", parameters),
            ("drift", drift),
            ("units", units),
        ];
        SensorBatch::new(slf, count, given)
    }

    /// Starts a new sequence: temporal filters forget earlier images. The numbering of frames continues, so that no noise repeats.
    ///
    /// items: the numbers of the items of batches that start a new sequence, or a mask; the others, and the (H, W) images, go on.
    /// seed: the new noise seed, with which frames are numbered from 0 on. Equal seeds give equal noise: give each worker process
    ///     its own.
    #[pyo3(signature = (items = None, *, seed = None))]
    fn reset(
        &self,
        py: Python<'_>,
        items: Option<&Bound<'_, PyAny>>,
        seed: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        if let (Some(_), Some(_)) = (items, seed) {
            return Err(wrong("seed", "is for all items", "omit items"));
        }
        if let Some(items) = items {
            let items = item_numbers("items", items)?;
            py.detach(|| self.memory.reset(Some(&items)));
            return Ok(());
        }
        let seed = seed.map(|seed| whole::<u64>("seed", seed)).transpose()?;
        py.detach(|| self.restart(seed))
    }

    /// The noise seed; of a sensor with `seed=None`, the one that was drawn.
    #[getter]
    fn seed(&self) -> u64 {
        self.source.seed()
    }

    /// Reprojects measured depth to another camera of the device; the nearest measurement in each pixel wins.
    ///
    /// depth: the output of this sensor, (H, W) or (N, H, W), float32 metres or uint16 millimetres.
    /// to: the camera: "rgb", "left", "right", "tof".
    /// size: the (width, height) of its image, resized by DepthAI's rule; by default the camera's own.
    /// z: "geometric": along that camera's axis; "measured": as this sensor measured it; by default as on the device, which
    ///     is "measured" for stereo on RVC2 and otherwise "geometric", where the device's is unknown.
    /// fill: "footprint" (default) fills all pixels that a sample covers, "nearest" only the one that it falls into.
    /// out: as in a call.
    ///
    /// Returns metres (or millimetres), 0 where invalid.
    ///
    /// Raises oaktwin.Error for a camera that the device does not have, TypeError for an object that is not an array or
    /// has another dtype.
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    #[pyo3(signature = (depth, to = "rgb", *, size = None, z = None, fill = "footprint", out = None))]
    fn align<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        to: &str,
        size: Option<Size>,
        z: Option<&str>,
        fill: &str,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let to = AlignTo {
            camera: named("to", to)?,
            size: size.map(|Size(width, height)| ImageSize::new(width, height)),
            fill: named("fill", fill)?,
            z: z.map(|z| named("z", z)).transpose()?,
        };
        self.aligned_to(py, depth, &to, out)
    }

    /// The Camera that the outputs are images of, for the most recent image size: the images' camera, made smaller by a
    /// filter that decimates, with its pose on the device. Isaac Sim's sensor ("single-view") shows what its left imager
    /// sees, which is to the left of the images' camera by the baseline.
    #[getter]
    fn camera(&self, py: Python<'_>) -> PyResult<Camera> {
        self.output_camera(py)
    }

    /// The name of the engine: "stereo-noise", "stereo-matching", "time-of-flight", "single-view", or the name of an engine written in Python.
    #[getter]
    fn engine(&self, py: Python<'_>) -> PyResult<String> {
        Ok(self.now(py, None)?.sensor.engine().kind().name.to_string())
    }

    /// The engine's parameters by name, with values of their types, for the most recent image size; none of an engine written in Python.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let sensor = self.now(py, None)?.sensor;
        let engine = sensor.engine();
        let values = engine.parameters().into_iter().chain(engine.assumptions());
        if self.engine.is_some() {
            return Ok(PyDict::new(py));
        }
        by_name(py, &engine.kind().name, values)
    }

    /// The filters, in the format of `filters=`.
    #[getter]
    fn filters(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        let sensor = self.now(py, None)?.sensor;
        let filters = sensor.filters().filters().iter();
        Ok(filters.map(ToString::to_string).collect())
    }

    /// The time from the middle of an exposure until its depth is at the host, with its stages and their sources; see `Stream`. None
    /// where no source states it. connection: "usb" or "poe"; by default the device's.
    #[pyo3(signature = (connection = None))]
    fn latency<'py>(&self, py: Python<'py>, connection: Option<&str>) -> PyResult<Bound<'py, PyAny>> {
        self.latency_of(py, maybe_named("connection", connection)?)
    }

    /// Findings about the settings, for the most recent image size, and about the images measured so far: "depth-unit" (metres
    /// that look like millimetres, or the reverse), "nothing-measured" (an image all of whose pixels were lost),
    /// "field-of-view-unit" (degrees that look like radians). Those about images are also shown once as an
    /// oaktwin.FindingWarning.
    #[getter]
    fn findings(&self, py: Python<'_>) -> PyResult<Vec<Finding>> {
        let mut findings = self.now(py, None)?.findings;
        findings.extend(self.notices.all());
        Ok(finding::list(&findings))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let filters = self.filters(py)?;
        let filters = if filters.is_empty() {
            "no filters".to_owned()
        } else {
            filters.join(" ")
        };
        Ok(format!(
            "<oaktwin.DepthSensor {} {}: {}, {filters}, seed {}>",
            self.source.twin.device.name,
            self.source.depth.spec.prim,
            self.engine(py)?,
            self.source.seed()
        ))
    }
}
