mod annotate;
mod eye;
mod image_camera;
mod sense;

use std::sync::{Arc, Mutex, PoisonError};

use oaktwin::camera::ImageSize;
use oaktwin::catalog::DepthKind;
use oaktwin::image::annotation::Frame;
use oaktwin::image::{Image, ZDepth};
use oaktwin::render::sense_frame;
use oaktwin::sense::{self as sensing, AlignTo, FieldOfView};
use oaktwin::sensor::{EngineInput, depth_sensor};
use oaktwin::usd::asset::LensChoice;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use annotate::{sensor_annotator, sensor_array};
use eye::{Eye, Source};
use image_camera::field_of_view;

use crate::align::{aligned, fill, role};
use crate::camera::Camera;
use crate::device::Device;
use crate::error::{error, wrong};
use crate::finding::{self, Finding};
use crate::images::{Depth, Out, Pictures};
use crate::settings::{Settings, isaac_name, kind};
use crate::threads;

/// The depth sensor of a device: exact depth in, what the device would have measured out.
///
/// device: whose.
/// sensor: which of its depth sensors, "stereo" or "tof"; by default time of flight where it has it.
/// engine: the model of the errors: "stereo-noise" (an OAK's stereo; the default of stereo), "time-of-flight" (the default
///     of time of flight) or "single-view" (Isaac Sim's DepthSensorDistance). For pairs of images see StereoMatcher.
/// preset: one of DepthAI's for the device's platform: "default", "face", "robotics", ...: the mode and the filters.
/// filters: filters as text, first to last, "spatial:alpha=0.5,delta=20"; they take the place of the preset's.
/// parameters: values of the engine's parameters by name, a mapping; after everything else.
/// seed: of the noise: the same seed, name, frame and item have the same noise.
/// device_seed: of the device's calibration error; None has none.
/// extended_disparity: find disparities up to 190 px instead of 95: nearer things.
/// isaac: whose defaults "single-view" has, "5.1" or "6".
/// fx: the images' focal length at their width, px; or hfov_deg: their horizontal field of view, degrees. Their principal
///     point is then in the middle. By default they have the model's field of view, whatever their size.
/// camera: what took the images, a Camera of their size: its focal length and principal point, which time of flight, points
///     and aligned depth look at. fx and hfov_deg beside it may say the same. Images are rectified: a lens that bends rays
///     is a finding.
/// name: the camera's name, which tells its noise from other cameras'; by default the sensor's prim.
///
/// Raises oaktwin.Error for an engine, preset, filter or parameter that does not exist or is out of its range, with the
/// nearest names; for a camera that has another field of view than fx or hfov_deg say.
///
/// A call, `sensor(depth, rgb=None, *, frame=0, out=None)`, is what the sensor reports of exact depth:
///
/// depth: one image (H, W), or a batch (N, H, W) of images of one moment, the environments of a simulator, each with
///     noise of its own. float32: metres along the optical axis; uint16: whole millimetres. What is not finite and above
///     0 is no surface. Any object with the buffer protocol, DLPack or NumPy's array interface in the memory of the CPU;
///     it is read where it is if it is C-contiguous, else copied.
/// rgb: the picture or pictures that the same camera took, uint8 sRGB, (H, W, 3 or 4) or (N, H, W, 3 or 4): texture for
///     the confidence, brightness for filters. Three channels are copied.
/// frame: the number in the sequence: noise is new in every frame, and the same for the same.
/// out: where to write: C-contiguous, of the result's shape, float32 for metres or uint16 for millimetres, and not the
///     depth itself.
///
/// Returns `out`, or a new NumPy array of depth's kind: metres or millimetres, 0 where nothing was measured. It has
/// depth's shape, less where a filter decimates.
///
/// A temporal filter remembers the (H, W) images of earlier calls; the images of a batch have no past.
///
/// Raises TypeError for what is no array or of another type, oaktwin.Error for another shape, or size than the camera's.
///
/// Safe to use from many threads; calls of one sensor with a temporal filter wait for each other. A pickle has the
/// settings, and a calibration with its device, but not the images that were seen.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct DepthSensor {
    device: Py<Device>,
    source: Source,
    camera: Option<Camera>,
    lens: LensChoice,
    eye: Mutex<Eye>,
}

#[pymethods]
impl DepthSensor {
    #[new]
    #[pyo3(signature = (device, *, sensor = None, engine = None, preset = None, filters = Vec::new(), parameters = None,
        seed = 0, device_seed = None, extended_disparity = false, isaac = "5.1", fx = None, hfov_deg = None, camera = None,
        name = None))]
    #[pyo3(
        text_signature = "(device, *, sensor=None, engine=None, preset=None, filters=(), parameters=None, seed=0, \
        device_seed=None, extended_disparity=False, isaac='5.1', fx=None, hfov_deg=None, camera=None, name=None)"
    )]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    fn new(
        device: &Bound<'_, Device>,
        sensor: Option<&str>,
        engine: Option<&str>,
        preset: Option<String>,
        filters: Vec<String>,
        parameters: Option<Bound<'_, PyAny>>,
        seed: u64,
        device_seed: Option<u64>,
        extended_disparity: bool,
        isaac: &str,
        fx: Option<f64>,
        hfov_deg: Option<f64>,
        camera: Option<&Bound<'_, Camera>>,
        name: Option<String>,
    ) -> PyResult<Self> {
        let settings = Settings {
            engine,
            preset,
            filters,
            parameters,
            extended_disparity,
            isaac,
            seed,
            device_seed,
            name,
        };
        let options = settings.options()?;
        let (whole, device) = (device, device.get());
        let twin = &device.twin;
        let sensor = kind(sensor)?.map(DepthKind::as_str);
        let depth = depth_sensor(twin, sensor).map_err(error)?.clone();
        let camera = camera.map(|camera| camera.get().clone());
        if let Some(engine) = options.engine.filter(|kind| kind.input == EngineInput::Pair) {
            let is = format!("{engine} requires a stereo pair, not depth");
            return Err(wrong("engine", is, "use StereoMatcher, or stereo-noise"));
        }
        let source = Source {
            twin: Arc::clone(twin),
            depth,
            options,
            field_of_view: field_of_view(fx, hfov_deg, camera.as_ref())?,
        };
        Ok(Self {
            device: whole.clone().unbind(),
            // So what is wrong is told now.
            eye: Mutex::new(source.eye(None)?),
            source,
            camera,
            lens: device.lens,
        })
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<((&Py<Device>,), Bound<'py, PyDict>)> {
        let (own, options) = (&self.source.options, PyDict::new(py));
        let (fx, hfov_deg) = match self.source.field_of_view {
            FieldOfView::Known | FieldOfView::Camera(_) => (None, None),
            FieldOfView::FocalLength(fx) => (Some(fx), None),
            FieldOfView::Degrees(hfov) => (None, Some(hfov)),
        };
        options.set_item("sensor", self.source.depth.spec.kind.as_str())?;
        options.set_item("engine", own.engine.map(|kind| kind.name))?;
        options.set_item("preset", &own.preset)?;
        options.set_item("filters", &own.filters)?;
        options.set_item("parameters", own.parameters.clone().into_py_dict(py)?)?;
        options.set_item("seed", own.seed)?;
        options.set_item("device_seed", own.device_seed)?;
        options.set_item("extended_disparity", own.extended_disparity)?;
        options.set_item("isaac", isaac_name(own.isaac))?;
        options.set_item("fx", fx)?;
        options.set_item("hfov_deg", hfov_deg)?;
        options.set_item("camera", self.camera.clone())?;
        options.set_item("name", &own.name)?;
        Ok(((&self.device,), options))
    }

    /// See the class.
    #[pyo3(signature = (depth, rgb = None, *, frame = 0, out = None))]
    fn __call__<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
        frame: u64,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (depth, shape) = Depth::read("depth", depth)?;
        let pictures = rgb.map(|rgb| Pictures::read(rgb, shape)).transpose()?;
        let sensor = self.now(py, Some(shape.size))?.sensor;
        let (width, height) = sensor.filters().size(shape.size.width, shape.size.height);
        let out_shape = shape.sized(ImageSize::new(width, height));
        let (result, mut out) = Out::of(py, out, out_shape, &depth)?;
        let values = depth.slice()?;
        let mut room = out.slice()?;
        room.check_apart(values)?;
        let rgb = pictures.as_ref().map(Pictures::rgba).transpose()?;
        let rgb = rgb.as_deref();
        if shape.batch.is_some() {
            self.batch(
                py,
                &sensor,
                values,
                rgb,
                shape,
                frame,
                out_shape.pixels(),
                &mut room,
            )?;
        } else {
            drop(sensor);
            self.image(py, values, rgb, shape.size, frame, &mut room)?;
        }
        Ok(result)
    }

    /// What Isaac Sim's annotators of the depth sensor report of one image, in one capture.
    ///
    /// depth: exact depth (H, W), as of a call.
    /// rgb: the picture, (H, W, 3 or 4) uint8, as of a call; the colours and the imager come from it.
    /// annotators: names of Isaac Sim's depth sensor annotators, such as "depth_sensor_distance"; see `annotators()`.
    /// frame: as of a call.
    ///
    /// Returns a dictionary by name: "depth_sensor_distance" (H, W) float32 metres, 0 where nothing was measured, the same
    /// as of a call; positions (H, W, 4) float32 metres in the camera's frame with USD's axes (x right, y up, z backward)
    /// and 1, colours (H, W, 4) uint8, both 0 where nothing was measured; the imager (H, W) float32, 0 to 1; the
    /// visualization (H, W, 4) uint8. The last two only "single-view" has.
    ///
    /// Raises oaktwin.Error for other names, for what the engine does not make, and for what needs a picture without one.
    #[pyo3(signature = (depth, rgb = None, *, annotators, frame = 0))]
    #[expect(clippy::needless_pass_by_value, reason = "what PyO3 hands over")]
    fn annotate<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
        annotators: Vec<String>,
        frame: u64,
    ) -> PyResult<Bound<'py, PyDict>> {
        let asked = annotators.iter().map(|name| sensor_annotator(name));
        let asked = asked.collect::<PyResult<Vec<_>>>()?;
        let (depth, shape) = Depth::read("depth", depth)?;
        if shape.batch.is_some() {
            return Err(wrong("depth", "is a batch", "give one image (H, W)"));
        }
        let pictures = rgb.map(|rgb| Pictures::read(rgb, shape)).transpose()?;
        let ImageSize { width, height } = shape.size;
        let mut seen = Frame {
            distance_to_image_plane: Image::new(width, height, depth.slice()?.metres().into_owned())
                .map(ZDepth),
            rgb: pictures
                .as_ref()
                .map(Pictures::rgba)
                .transpose()?
                .and_then(|rgb| Image::new(width, height, rgb.into_owned())),
            ..Frame::default()
        };
        py.detach(|| {
            let mut eye = self.eye.lock().unwrap_or_else(PoisonError::into_inner);
            let eye = self.look(&mut eye, shape.size)?;
            let sensor = Arc::make_mut(&mut eye.sensor);
            threads::install(|| sense_frame(sensor, &eye.camera, frame, None, &asked, &mut seen))
        })?;
        let all = PyDict::new(py);
        for annotator in asked {
            let data = seen.take(annotator).map(|data| sensor_array(py, data));
            let image = data.transpose()?.flatten().ok_or_else(|| {
                let is = "is not made of what was given";
                let remedy = "give rgb=, or take the engine single-view";
                wrong(annotator.name(), is, remedy)
            })?;
            all.set_item(annotator.name(), image)?;
        }
        Ok(all)
    }

    /// Forgets all earlier frames.
    fn reset(&self, py: Python<'_>) {
        py.detach(|| {
            let mut eye = self.eye.lock().unwrap_or_else(PoisonError::into_inner);
            Arc::make_mut(&mut eye.sensor).reset();
        });
    }

    /// Measured depth as another camera of the device sees it: the nearest measurement in each of its pixels.
    ///
    /// depth: what this sensor reported, (H, W) or (N, H, W), float32 metres or uint16 millimetres.
    /// to: the camera: "rgb", "left", "right", "tof".
    /// size: (width, height) of its image, by DepthAI's rule; by default the camera's own.
    /// fill: "footprint" (default): a sample goes into all pixels that it covers; "nearest": into the one it falls into.
    /// out: as of a call.
    ///
    /// Returns metres (or millimetres) along that camera's axis, 0 where nothing was measured.
    ///
    /// Raises oaktwin.Error for a camera that the device has not, TypeError for what is no array or of another type.
    #[pyo3(signature = (depth, to = "rgb", *, size = None, fill = "footprint", out = None))]
    fn align<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        to: &str,
        size: Option<(u32, u32)>,
        fill: &str,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let to = AlignTo {
            camera: role(to)?,
            size: size.map(|(width, height)| ImageSize::new(width, height)),
            fill: self::fill(fill)?,
        };
        let (depth, shape) = Depth::read("depth", depth)?;
        let eye = self.now(py, None)?;
        let seen = eye.camera.intrinsics.size;
        let filters = eye.sensor.filters();
        // What a decimating sensor reported is of images that are larger.
        let of_images = if filters.size(seen.width, seen.height) == (shape.size.width, shape.size.height) {
            seen
        } else {
            shape.size
        };
        let eye = self.source.eye(Some(of_images))?;
        let (twin, depth_sensor) = (&self.source.twin, &self.source.depth);
        let align = sensing::align_to(twin, depth_sensor, &eye.sensor, &eye.camera, &to, self.lens);
        let align = align.map_err(error)?;
        aligned(py, &align, &depth, shape, out)
    }

    /// "stereo-noise", "time-of-flight" or "single-view".
    #[getter]
    fn engine(&self, py: Python<'_>) -> PyResult<&'static str> {
        Ok(self.now(py, None)?.sensor.engine().kind().name)
    }

    /// The engine's parameters by name, as `parameters=` takes them, for images of the size that was looked at last.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let parameters = PyDict::new(py);
        let sensor = self.now(py, None)?.sensor;
        let engine = sensor.engine();
        for (name, value) in engine.parameters().into_iter().chain(engine.assumptions()) {
            parameters.set_item(name, value)?;
        }
        Ok(parameters)
    }

    /// The filters, as `filters=` takes them.
    #[getter]
    fn filters(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        let sensor = self.now(py, None)?.sensor;
        Ok(sensor
            .filters()
            .filters()
            .iter()
            .map(ToString::to_string)
            .collect())
    }

    /// What about the sensor is not as the device says, for images of the size that was looked at last.
    #[getter]
    fn findings(&self, py: Python<'_>) -> PyResult<Vec<Finding>> {
        Ok(finding::list(&self.now(py, None)?.findings))
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
            self.source.options.seed
        ))
    }
}
