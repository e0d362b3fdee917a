mod source;

use std::sync::{Arc, Mutex, PoisonError};

use oaktwin::camera::{ImageSize, StereoGeometry};
use oaktwin::depth::imager::Recorded;
use oaktwin::depth::preset::Platform;
use oaktwin::depth::rectify::Method;
use oaktwin::depth::stereo_matching::RectifiedPair;
use oaktwin::image::Image;
use oaktwin::image::annotation::Annotator;
use oaktwin::sense::{FieldOfView, check_hfov};
use oaktwin::sensor::{Capture, EngineInput, FixedDisparity, SensorOptions};
use oaktwin::stereo::{MatchedPair, Matcher, StereoError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::camera::Camera;
use crate::choice::maybe_named;
use crate::device::{self, Device};
use crate::engine::{PythonEngine, away};
use crate::error::{error, wrong};
use crate::finding::{self, Finding};
use crate::grey::{Images, Stack, read, recorded};
use crate::images::array;
use crate::parameters::by_name;
use crate::settings::{engine as of_argument, item_numbers, keywords, sensor_options};
use crate::threads;
use source::PairSource;

#[doc = concat!(
    "StereoMatcher(device=None, *, sensor=None, raw=None, rectify=None, fx=None, hfov_deg=None, baseline=None, platform=None, engine=None, ",
    include_str!("generated/matcher_options.signature"),
    ")\n--\n"
)]
/// The stereo matcher of an OAK: a left and a right image in, depth out. Equivalent to `oaktwin stereo` for files.
///
/// device: the device that took the images, or None for another maker's rectified pair, with fx (or hfov_deg) and baseline.
/// sensor: the depth sensor whose pair took the images, by prim, such as "Camera_pseudo_depth_50mm" of the OAK-D LR; by default
///     the device's first pair.
/// raw: whether the images are unrectified and have to be rectified first, as on the device; by default True for a
///     calibrated device and for a fisheye lens.
/// rectify: the rectification method for raw images: "homography" (ignores lens distortion), "mesh" (a position every 16
///     pixels), "full" (a position for every pixel), "auto" (homography up to a field of view of 85 degrees, mesh above);
///     by default the device's.
/// fx: the focal length of the rectified images, px.
/// hfov_deg: alternatively their horizontal field of view, degrees.
/// baseline: the distance between the cameras, metres.
/// platform: the platform that determines defaults and presets, "rvc2" or "rvc4"; by default the device's, otherwise "rvc2".
/// engine: a callable that matches the rectified pairs instead, as for `DepthSensor`; by default "stereo-matching".
#[doc = include_str!("generated/matcher_options.doc")]
///
/// Raises oaktwin.Error for a device without a stereo pair or without calibrated extrinsics of the pair, and for an unknown
/// or invalid preset, filter or parameter, with the nearest names.
///
/// A call, `matcher(left, right)`, matches a pair, or a batch of pairs of the same size:
///
/// left, right: (H, W) or (N, H, W) uint8, or uint16 with 10 bits (0 to 1023), or colours (H, W, 3 or 4) or (N, H, W, 3 or 4)
///     uint8, which are converted to luma. NumPy arrays, or objects with the buffer protocol, DLPack or NumPy's array
///     interface in CPU memory.
///
/// Returns a dictionary. "depth": (H, W) float32 metres along the optical axis of the rectified left camera, 0 where invalid.
/// "disparity": (H, W) float32 px of the images, 0 where invalid. "confidence": (H, W) uint8, 255 is the highest. These three
/// are images of `camera`, and smaller than the images if a filter decimates. "rectified_left" and "rectified_right": the matched images. "findings": the problems of the images, a list of
/// Finding: "pair-swapped", "vertical-offset", "no-texture", "saturated", "range-beyond-image", "same-image", "unrelated".
/// For a batch, each array has a leading dimension N, and a finding's place begins with the index of its pair; the pairs are
/// matched in parallel.
///
/// Raises TypeError for an object that is not an array or has another dtype, oaktwin.Error for an invalid shape and for
/// images of different sizes or dtypes.
///
/// A temporal filter remembers the pairs of earlier calls, and of batches the pairs of each item, until the image size changes;
/// see `reset()`. Thread-safe; calls of one matcher run one after another. Copies and pickles have the settings and the device's
/// calibration, but not the state of temporal filters.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct StereoMatcher {
    source: PairSource,
    platform: Option<Platform>,
    options: SensorOptions,
    /// The engine, if it is written in Python.
    engine: Option<Arc<PythonEngine>>,
    matcher: Mutex<Matcher>,
}

/// The positional arguments of the constructor.
type Arguments<'a> = (Option<&'a Py<Device>>,);

impl StereoMatcher {
    /// Runs work with the matcher of an image size, with the interpreter released.
    fn with_matcher<T: Send>(
        &self,
        py: Python<'_>,
        size: ImageSize,
        work: impl FnOnce(&mut Matcher) -> Result<T, StereoError> + Send,
    ) -> PyResult<T> {
        py.check_signals()?;
        away(py, self.engine.as_ref(), || {
            // Locked before entering the pool, so that the pool's threads never wait for the lock.
            let mut matcher = self.matcher.lock().unwrap_or_else(PoisonError::into_inner);
            let matcher = &mut *matcher;
            let done = threads::install(|| {
                if matcher.size() != size {
                    *matcher = self.source.matcher(self.platform, &self.options, size)?;
                }
                work(matcher)
            });
            done?.map_err(error)
        })
    }

    fn match_batch<'py>(&self, py: Python<'py>, left: Images, right: Images) -> PyResult<Bound<'py, PyDict>> {
        let (size, is_wide) = (left.size, left.is_wide);
        if (right.size, right.is_wide) != (size, is_wide) {
            let is = format!("{} has another size or dtype than left, {size}", right.size);
            return Err(wrong("right", is, "pass images of the same size and dtype"));
        }
        let own = (size.width, size.height);
        let (smaller, stereo) = self.with_matcher(py, size, |matcher| {
            let smaller = matcher.sensor().filters().size(size.width, size.height);
            Ok((smaller, geometry(matcher)))
        })?;
        let (mut depth, mut disparity) = (Stack::new(smaller), Stack::new(smaller));
        let mut confidence = Stack::new(smaller);
        let mut eight = [Stack::new(own), Stack::new(own)];
        let mut ten = [Stack::new(own), Stack::new(own)];
        let mut findings = Vec::new();
        // Signals are checked between groups of pairs that are matched in parallel.
        let at_once = threads::count()?;
        let mut pairs = left.images.into_iter().zip(right.images);
        for first in (0..).step_by(at_once) {
            let some: Vec<[Recorded; 2]> = pairs.by_ref().take(at_once).map(Into::into).collect();
            if some.is_empty() {
                break;
            }
            let seen: Vec<MatchedPair> =
                self.with_matcher(py, size, |matcher| matcher.match_pairs(some, first))?;
            for mut seen in seen {
                depth.push(&seen.capture.distance.0);
                disparity.push(&disparities(&mut seen.capture, stereo));
                confidence.push(&confidences(&mut seen.capture));
                for ((rectified, eight), ten) in seen.rectified.iter().zip(&mut eight).zip(&mut ten) {
                    match rectified {
                        Recorded::Eight(image) => eight.push(image),
                        Recorded::Ten(image) => ten.push(image),
                    }
                }
                findings.extend(seen.findings);
            }
        }
        let all = PyDict::new(py);
        all.set_item("depth", depth.array(py)?)?;
        all.set_item("disparity", disparity.array(py)?)?;
        all.set_item("confidence", confidence.array(py)?)?;
        for ((name, eight), ten) in ["rectified_left", "rectified_right"]
            .into_iter()
            .zip(eight)
            .zip(ten)
        {
            let images = if is_wide { ten.array(py)? } else { eight.array(py)? };
            all.set_item(name, images)?;
        }
        all.set_item("findings", finding::list(&findings))?;
        Ok(all)
    }

    /// Reads from the matcher of the most recent image size.
    fn ask<T: Send>(&self, py: Python<'_>, what: impl FnOnce(&mut Matcher) -> T + Send) -> T {
        py.detach(|| what(&mut self.matcher.lock().unwrap_or_else(PoisonError::into_inner)))
    }
}

/// The geometry at the width of the images.
fn geometry(matcher: &Matcher) -> StereoGeometry {
    StereoGeometry {
        focal_length_px: matcher.rectified_camera().intrinsics.fx,
        baseline_m: matcher.baseline_m(),
    }
}

/// The disparities of a capture, px; those of its depth if the engine is written in Python.
fn disparities(capture: &mut Capture, stereo: StereoGeometry) -> Image<f32> {
    #[expect(clippy::cast_possible_truncation, reason = "pixels are single precision")]
    let of_depth = |metres: &f32| match *metres > 0.0 {
        true => stereo.disparity(f64::from(*metres)) as f32,
        false => 0.0,
    };
    match capture.take::<FixedDisparity>(Annotator::Disparity) {
        Some(fixed) => fixed.to_px(),
        None => capture.distance.0.map(of_depth),
    }
}

/// The confidence of a capture; if the engine has none, it is full where there is depth.
fn confidences(capture: &mut Capture) -> Image<u8> {
    let own = capture.take(Annotator::Confidence);
    own.unwrap_or_else(|| {
        capture
            .distance
            .0
            .map(|metres| if *metres > 0.0 { 255 } else { 0 })
    })
}

/// The arguments besides the options of the sensor.
const ARGUMENTS: [&str; 8] = [
    "sensor", "raw", "rectify", "fx", "hfov_deg", "baseline", "platform", "engine",
];

#[pymethods]
impl StereoMatcher {
    #[new]
    #[pyo3(signature = (device = None, *, sensor = None, raw = None, rectify = None, fx = None, hfov_deg = None, baseline = None,
        platform = None, engine = None, **options))]
    #[pyo3(text_signature = None)]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
    fn new(
        py: Python<'_>,
        #[pyo3(from_py_with = device::argument::optional)] device: Option<Bound<'_, Device>>,
        sensor: Option<&str>,
        raw: Option<bool>,
        rectify: Option<&str>,
        fx: Option<f64>,
        hfov_deg: Option<f64>,
        baseline: Option<f64>,
        platform: Option<&str>,
        engine: Option<&Bound<'_, PyAny>>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let mut options = sensor_options("StereoMatcher", &ARGUMENTS, options, |option| {
            option.is_of_matcher
        })?;
        let of_depth = |options: &SensorOptions| {
            let engine = options.engine.as_ref();
            engine.filter(|kind| kind.input != EngineInput::Pair).cloned()
        };
        if let Some(other) = of_depth(&options) {
            let is = format!("are those of {other}");
            return Err(wrong("parameters", is, "pass those of stereo-matching"));
        }
        if let Some(engine) = engine {
            options.engine = Some(of_argument("engine", engine)?);
        }
        if let Some(other) = of_depth(&options) {
            let is = format!("{other} measures depth images and matches no pairs");
            return Err(wrong(
                "engine",
                is,
                "pass an engine with the parameters left and right",
            ));
        }
        let of_any = fx.is_some() || hfov_deg.is_some() || baseline.is_some();
        let source = match device {
            Some(_) if of_any => {
                let remedy = "omit fx, hfov_deg and baseline, or the device";
                return Err(wrong(
                    "device",
                    "conflicts with fx, hfov_deg and baseline",
                    remedy,
                ));
            }
            Some(device) => PairSource::device(&device, sensor, raw, rectify)?,
            None if raw == Some(true) || rectify.is_some() || sensor.is_some() => {
                let is = "require a device";
                return Err(wrong(
                    "sensor, raw, rectify",
                    is,
                    "pass a device, or rectified images",
                ));
            }
            None => PairSource::rectified(fx, hfov_deg, baseline)?,
        };
        let platform = maybe_named("platform", platform)?;
        finding::warn(py, hfov_deg.and_then(check_hfov).as_slice())?;
        // Reports invalid settings immediately.
        let matcher = py.detach(|| source.matcher(platform, &options, source.first_size()));
        Ok(Self {
            matcher: Mutex::new(matcher.map_err(error)?),
            source,
            platform,
            engine: PythonEngine::in_options(&options),
            options,
        })
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<(Arguments<'_>, Bound<'py, PyDict>)> {
        let options = keywords(py, &self.options, |option| option.is_of_matcher)?;
        let device = match &self.source {
            PairSource::Device {
                device,
                sensor,
                is_raw,
                rectify,
                ..
            } => {
                options.set_item("sensor", sensor)?;
                options.set_item("raw", is_raw)?;
                options.set_item("rectify", rectify.map(Method::name))?;
                Some(device)
            }
            PairSource::Rectified {
                field_of_view,
                baseline_m,
            } => {
                match field_of_view {
                    FieldOfView::FocalLength(fx) => options.set_item("fx", fx)?,
                    FieldOfView::Degrees(hfov) => options.set_item("hfov_deg", hfov)?,
                    FieldOfView::Known | FieldOfView::Camera(_) => {}
                }
                options.set_item("baseline", baseline_m)?;
                None
            }
        };
        options.set_item("platform", self.platform.map(Platform::name))?;
        if let Some(engine) = &self.engine {
            options.set_item("engine", &engine.object)?;
        }
        Ok(((device,), options))
    }

    /// Matches a pair or a batch of pairs; see the class.
    #[pyo3(name = "_call")]
    fn call<'py>(
        &self,
        py: Python<'py>,
        left: &Bound<'py, PyAny>,
        right: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (mut left, mut right) = (read("left", left)?, read("right", right)?);
        let (left, right) = match (left.batch, right.batch) {
            (None, None) => match (left.images.pop(), right.images.pop()) {
                (Some(left), Some(right)) => (left, right),
                _ => return Err(wrong("left, right", "contain no image", "pass an image")),
            },
            (count, other) if count == other => return self.match_batch(py, left, right),
            (count, other) => {
                let words = |count: Option<usize>| match count {
                    Some(count) => format!("a batch of {count}"),
                    None => "one image".to_owned(),
                };
                let is = format!("is {}, left {}", words(other), words(count));
                return Err(wrong("right", is, "pass a right image for each left one"));
            }
        };
        // An invalid pair must not reset the matcher by its size.
        RectifiedPair::new(&left, &right).map_err(error)?;
        let size = ImageSize::new(left.width(), left.height());
        let (mut seen, stereo) = self.with_matcher(py, size, |matcher| {
            let stereo = geometry(matcher);
            Ok((matcher.match_pair(left, right)?, stereo))
        })?;
        let [left, right] = seen.rectified;
        let all = PyDict::new(py);
        let disparity = disparities(&mut seen.capture, stereo);
        let confidence = confidences(&mut seen.capture);
        all.set_item("depth", array(py, seen.capture.distance.0)?)?;
        all.set_item("disparity", array(py, disparity)?)?;
        all.set_item("confidence", array(py, confidence)?)?;
        all.set_item("rectified_left", recorded(py, left)?)?;
        all.set_item("rectified_right", recorded(py, right)?)?;
        all.set_item("findings", finding::list(&seen.findings))?;
        Ok(all)
    }

    /// Starts a new sequence: temporal filters forget earlier pairs.
    ///
    /// items: the numbers of the items of batches that start a new sequence, or a mask; the others, and the (H, W) pairs, go on.
    #[pyo3(signature = (items = None))]
    fn reset(&self, py: Python<'_>, items: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        match items {
            None => self.ask(py, Matcher::reset),
            Some(items) => {
                let items = item_numbers("items", items)?;
                self.ask(py, |matcher| matcher.reset_rigs(&items));
            }
        }
        Ok(())
    }

    /// The camera that depth, disparity and confidence are images of, for the most recent image size; initially for the
    /// device's own size, or 1280 x 800 without a device. It is the rectified left camera, whose image is made smaller by a
    /// filter that decimates.
    #[getter]
    fn camera(&self, py: Python<'_>) -> Camera {
        self.ask(py, |matcher| {
            Camera::rectified(matcher.camera().camera, matcher.body_from_camera())
        })
    }

    /// The distance between the cameras, metres.
    #[getter]
    fn baseline(&self, py: Python<'_>) -> f64 {
        self.ask(py, |matcher| matcher.baseline_m())
    }

    /// The rectification method, "homography", "mesh" or "full"; None if the images are rectified already.
    #[getter]
    fn rectify(&self, py: Python<'_>) -> Option<&'static str> {
        self.ask(py, |matcher| matcher.method().map(Method::name))
    }

    /// The matcher's parameters by name, with values of their types, for the most recent image size.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let values = self.ask(py, |matcher| matcher.sensor().engine().parameters());
        by_name(py, "stereo-matching", values)
    }

    /// The filters, in the format of `filters=`.
    #[getter]
    fn filters(&self, py: Python<'_>) -> Vec<String> {
        self.ask(py, |matcher| {
            let filters = matcher.sensor().filters().filters().iter();
            filters.map(ToString::to_string).collect()
        })
    }

    /// Findings about the settings. Findings about images are returned by the call.
    #[getter]
    fn findings(&self, py: Python<'_>) -> Vec<Finding> {
        self.ask(py, |matcher| finding::list(matcher.findings()))
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let whose = match &self.source {
            PairSource::Device { device, .. } => device.get().twin.device.name.clone(),
            PairSource::Rectified { .. } => "any pair".to_owned(),
        };
        let camera = self.ask(py, |matcher| matcher.rectified_camera());
        let rectify = self.rectify(py).unwrap_or("rectified");
        let filters = self.filters(py);
        let filters = if filters.is_empty() {
            "no filters".to_owned()
        } else {
            filters.join(" ")
        };
        format!(
            "<oaktwin.StereoMatcher {whose}: {}, fx {:.2} px, baseline {:.3} mm, {rectify}, {filters}>",
            camera.intrinsics.size,
            camera.intrinsics.fx,
            self.baseline(py) * 1e3
        )
    }
}
