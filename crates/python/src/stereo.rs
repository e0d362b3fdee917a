use std::path::Path;
use std::sync::{Mutex, PoisonError};

use oaktwin::camera::ImageSize;
use oaktwin::catalog::{Origin, Role};
use oaktwin::depth::imager::Recorded;
use oaktwin::depth::preset::Platform;
use oaktwin::depth::rectify::{Method, RectifyOptions};
use oaktwin::depth::stereo_matching::Pair;
use oaktwin::image::Image;
use oaktwin::image::annotation::Annotator;
use oaktwin::sense::FieldOfView;
use oaktwin::sensor::{FixedDisparity, SensorOptions, platform};
use oaktwin::stereo::{Matcher, PairOf, Seen, StereoError, check_calibration};
use oaktwin::usd::asset::LensChoice;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

use crate::camera::Camera;
use crate::choice::choose;
use crate::device::Device;
use crate::error::{error, wrong};
use crate::finding::{self, Finding};
use crate::grey::{Images, Stack, read, recorded};
use crate::images::array;
use crate::settings::Settings;
use crate::threads;

const PLATFORMS: [(&str, Platform); 2] = [("rvc2", Platform::Rvc2), ("rvc4", Platform::Rvc4)];

const METHODS: [(&str, Method); 4] = [
    ("auto", Method::Auto),
    ("homography", Method::Homography),
    ("mesh", Method::Mesh),
    ("full", Method::Full),
];

/// What is looked at before there is a pair that is no device's.
const FIRST_SIZE: ImageSize = ImageSize {
    width: 1280,
    height: 800,
};

/// The stereo matcher of an OAK on a pair of images: left and right in, depth out. What `oaktwin stereo` does with files.
///
/// device: whose cameras took them; or None for any rectified pair, with fx (or hfov_deg) and baseline.
/// raw: whether the images are as the cameras take them and have to be rectified first, as the device does it; by default
///     those of a calibrated device are, and those of a fisheye lens.
/// rectify: how raw images are rectified: "homography" (leaves the lens's distortion), "mesh" (a position every 16
///     pixels), "full" (a position for each), "auto" (a homography up to 85 degrees of view, a mesh above); by default as
///     the device does it.
/// fx: the rectified images' focal length, px.
/// hfov_deg: or their horizontal field of view, degrees.
/// baseline: between the two cameras, metres.
/// platform: the processor whose defaults and presets hold, "rvc2" or "rvc4"; by default the device's, else "rvc2".
/// preset: one of DepthAI's for the platform: "default", "face", "robotics", ...: the mode and the filters.
/// filters: filters as text, first to last; they take the place of the preset's.
/// parameters: values of the matcher's parameters by name, a mapping; after everything else.
/// extended_disparity: find disparities up to 190 px instead of 95: nearer things.
///
/// Raises oaktwin.Error for a device without a pair, or whose calibration does not say how it is placed; for a preset,
/// filter or parameter that does not exist or is out of its range, with the nearest names.
///
/// A call, `matcher(left, right)`, matches one pair, or a batch of pairs of one size:
///
/// left, right: (H, W) or (N, H, W) uint8, or uint16 of 10 bits (0 to 1023), or colours (H, W, 3 or 4) or (N, H, W, 3 or 4)
///     uint8, of which the luma is taken. Any object with the buffer protocol, DLPack or NumPy's array interface in the
///     memory of the CPU.
///
/// Returns a dictionary. "depth": (H, W) float32 metres along the axis of the rectified left camera, 0 where nothing was
/// measured; smaller where a filter decimates. "disparity": (H, W) float32 px, 0 where nothing was measured. "confidence":
/// (H, W) uint8, 255 is surest. "rectified_left" and "rectified_right": what was matched. "findings": what is wrong with
/// the images, a list of Finding: "pair-swapped", "vertical-offset", "no-texture", "saturated", "range-beyond-image",
/// "same-image", "unrelated".
/// Of a batch each array begins with N, and a finding's place with the number of its pair; pairs are matched as by a matcher
/// that has seen none before, each on a thread of its own where there are enough.
///
/// Raises TypeError for what is no array or of another type, oaktwin.Error for another shape and for two images of two
/// sizes or kinds.
///
/// A temporal filter remembers the pairs of earlier calls, but for batches, until their size changes. Safe to use from many
/// threads; calls of one matcher wait for each other. A pickle has the settings, and a calibration with its device, but not what was seen.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct StereoMatcher {
    source: Source,
    platform: Option<Platform>,
    options: SensorOptions,
    matcher: Mutex<Matcher>,
}

/// Of Python's constructor, in their order.
type Arguments<'a> = (Option<&'a Py<Device>>,);

/// What takes the pairs.
enum Source {
    Device {
        device: Py<Device>,
        is_raw: bool,
        rectify: Option<Method>,
    },
    Any {
        field_of_view: FieldOfView,
        baseline_m: f64,
    },
}

impl Source {
    fn device(device: &Bound<'_, Device>, raw: Option<bool>, rectify: Option<&str>) -> PyResult<Self> {
        let own = device.get();
        let rectify = rectify
            .map(|name| choose("rectify", name, &METHODS))
            .transpose()?;
        if let Origin::Calibration { file_name, .. } = &own.twin.origin {
            check_calibration(Path::new(file_name), &own.findings).map_err(error)?;
        }
        let by_default = own.twin.origin != Origin::Nominal || own.lens == LensChoice::Fisheye;
        if raw == Some(false) && rectify.is_some() {
            let is = "images that are rectified are not rectified again";
            return Err(wrong("rectify", is, "leave it out, or raw=False"));
        }
        Ok(Self::Device {
            device: device.clone().unbind(),
            is_raw: raw.unwrap_or(by_default || rectify.is_some()),
            rectify,
        })
    }

    fn any(fx: Option<f64>, hfov_deg: Option<f64>, baseline: Option<f64>) -> PyResult<Self> {
        let field_of_view = match (fx, hfov_deg) {
            (Some(fx), None) => Some(FieldOfView::FocalLength(fx)),
            (None, Some(hfov)) => Some(FieldOfView::Degrees(hfov)),
            (None, None) => None,
            _ => return Err(wrong("fx, hfov_deg", "both say the same", "give one")),
        };
        match (field_of_view, baseline) {
            (Some(field_of_view), Some(baseline_m)) => Ok(Self::Any {
                field_of_view,
                baseline_m,
            }),
            _ => Err(wrong(
                "device",
                "nothing says what takes the images",
                "give a device, or fx (or hfov_deg) and baseline of a rectified pair",
            )),
        }
    }

    /// What a matcher is made for, until there is a pair.
    fn first_size(&self) -> ImageSize {
        match self {
            Self::Device { device, .. } => {
                let left = device.get().twin.camera(Role::Left);
                left.map_or(FIRST_SIZE, |left| left.intrinsics.size)
            }
            Self::Any { .. } => FIRST_SIZE,
        }
    }

    fn matcher(
        &self,
        chosen: Option<Platform>,
        options: &SensorOptions,
        size: ImageSize,
    ) -> Result<Matcher, StereoError> {
        let of = match self {
            Self::Device {
                device,
                is_raw,
                rectify,
            } => {
                let device = device.get();
                let own = chosen.or_else(|| platform(&device.twin));
                PairOf::Twin {
                    twin: &device.twin,
                    lens: device.lens,
                    is_raw: *is_raw,
                    rectify: rectify.map(|method| RectifyOptions {
                        method,
                        ..RectifyOptions::of(own.unwrap_or(Platform::Rvc4))
                    }),
                    platform: chosen,
                }
            }
            Self::Any {
                field_of_view,
                baseline_m,
            } => PairOf::Rectified {
                field_of_view: *field_of_view,
                baseline_m: *baseline_m,
                platform: chosen.unwrap_or(Platform::Rvc2),
            },
        };
        Matcher::new(&of, size, options)
    }
}

impl StereoMatcher {
    /// Uses the matcher of a size, the interpreter released.
    fn with_matcher<T: Send>(
        &self,
        py: Python<'_>,
        size: ImageSize,
        work: impl FnOnce(&mut Matcher) -> Result<T, StereoError> + Send,
    ) -> PyResult<T> {
        py.check_signals()?;
        let done = py.detach(|| {
            // Taken before the pool's threads are: they never wait for it.
            let mut matcher = self.matcher.lock().unwrap_or_else(PoisonError::into_inner);
            let matcher = &mut *matcher;
            threads::install(|| {
                if matcher.size() != size {
                    *matcher = self.source.matcher(self.platform, &self.options, size)?;
                }
                work(matcher)
            })
        })?;
        done.map_err(error)
    }

    fn match_batch<'py>(&self, py: Python<'py>, left: Images, right: Images) -> PyResult<Bound<'py, PyDict>> {
        let (size, is_wide) = (left.size, left.is_wide);
        if (right.size, right.is_wide) != (size, is_wide) {
            let is = format!("is {} of another kind than left, {size}", right.size);
            return Err(wrong("right", is, "give both in one size and type"));
        }
        let own = (size.width, size.height);
        let smaller = self.with_matcher(py, size, |matcher| {
            Ok(matcher.sensor().filters().size(size.width, size.height))
        })?;
        let (mut depth, mut disparity) = (Stack::new(smaller), Stack::new(smaller));
        let mut confidence = Stack::new(own);
        let mut eight = [Stack::new(own), Stack::new(own)];
        let mut ten = [Stack::new(own), Stack::new(own)];
        let mut findings = Vec::new();
        // As many as are matched at once, then signals are looked at.
        let at_once = threads::install(rayon::current_num_threads)?.max(1);
        let mut pairs = left.images.into_iter().zip(right.images);
        for first in (0..).step_by(at_once) {
            let some: Vec<[Recorded; 2]> = pairs.by_ref().take(at_once).map(Into::into).collect();
            if some.is_empty() {
                break;
            }
            let seen: Vec<Seen> = self.with_matcher(py, size, |matcher| matcher.look_all(some, first))?;
            for mut seen in seen {
                depth.push(&seen.capture.distance.0);
                if let Some(fixed) = seen.capture.take::<FixedDisparity>(Annotator::Disparity) {
                    disparity.push(&fixed.to_px());
                }
                if let Some(sure) = seen.capture.take::<Image<u8>>(Annotator::Confidence) {
                    confidence.push(&sure);
                }
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

    /// Asks the matcher of the size that was looked at last.
    fn ask<T: Send>(&self, py: Python<'_>, what: impl FnOnce(&mut Matcher) -> T + Send) -> T {
        py.detach(|| what(&mut self.matcher.lock().unwrap_or_else(PoisonError::into_inner)))
    }
}

#[pymethods]
impl StereoMatcher {
    #[new]
    #[pyo3(signature = (device = None, *, raw = None, rectify = None, fx = None, hfov_deg = None, baseline = None,
        platform = None, preset = None, filters = Vec::new(), parameters = None, extended_disparity = false))]
    #[pyo3(
        text_signature = "(device=None, *, raw=None, rectify=None, fx=None, hfov_deg=None, baseline=None, platform=None, \
        preset=None, filters=(), parameters=None, extended_disparity=False)"
    )]
    #[expect(clippy::too_many_arguments, reason = "options of Python")]
    fn new(
        py: Python<'_>,
        device: Option<&Bound<'_, Device>>,
        raw: Option<bool>,
        rectify: Option<&str>,
        fx: Option<f64>,
        hfov_deg: Option<f64>,
        baseline: Option<f64>,
        platform: Option<&str>,
        preset: Option<String>,
        filters: Vec<String>,
        parameters: Option<Bound<'_, PyAny>>,
        extended_disparity: bool,
    ) -> PyResult<Self> {
        let settings = Settings {
            engine: None,
            preset,
            filters,
            parameters,
            extended_disparity,
            isaac: "5.1",
            seed: 0,
            device_seed: None,
            name: None,
        };
        let options = settings.options()?;
        let of_any = fx.is_some() || hfov_deg.is_some() || baseline.is_some();
        let source = match device {
            Some(_) if of_any => {
                let remedy = "leave out fx, hfov_deg and baseline, or the device";
                return Err(wrong("device", "it says what its cameras are", remedy));
            }
            Some(device) => Source::device(device, raw, rectify)?,
            None if raw == Some(true) || rectify.is_some() => {
                let is = "only a device's images are rectified here";
                return Err(wrong("raw, rectify", is, "give a device, or rectified images"));
            }
            None => Source::any(fx, hfov_deg, baseline)?,
        };
        let platform = platform
            .map(|name| choose("platform", name, &PLATFORMS))
            .transpose()?;
        // So what is wrong is told now.
        let matcher = py.detach(|| source.matcher(platform, &options, source.first_size()));
        Ok(Self {
            matcher: Mutex::new(matcher.map_err(error)?),
            source,
            platform,
            options,
        })
    }

    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<(Arguments<'_>, Bound<'py, PyDict>)> {
        fn name<T: PartialEq>(all: &[(&'static str, T)], own: Option<&T>) -> Option<&'static str> {
            let found = all.iter().find(|(_, known)| Some(known) == own);
            found.map(|(name, _)| *name)
        }
        let (own, options) = (&self.options, PyDict::new(py));
        let device = match &self.source {
            Source::Device {
                device,
                is_raw,
                rectify,
            } => {
                options.set_item("raw", is_raw)?;
                options.set_item("rectify", name(&METHODS, rectify.as_ref()))?;
                Some(device)
            }
            Source::Any {
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
        options.set_item("platform", name(&PLATFORMS, self.platform.as_ref()))?;
        options.set_item("preset", &own.preset)?;
        options.set_item("filters", &own.filters)?;
        options.set_item("parameters", own.parameters.clone().into_py_dict(py)?)?;
        options.set_item("extended_disparity", own.extended_disparity)?;
        Ok(((device,), options))
    }

    /// See the class.
    fn __call__<'py>(
        &self,
        py: Python<'py>,
        left: &Bound<'py, PyAny>,
        right: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (mut left, mut right) = (read("left", left)?, read("right", right)?);
        let (left, right) = match (left.batch, right.batch) {
            (None, None) => match (left.images.pop(), right.images.pop()) {
                (Some(left), Some(right)) => (left, right),
                _ => return Err(wrong("left, right", "have no image", "give one")),
            },
            (count, other) if count == other => return self.match_batch(py, left, right),
            (count, other) => {
                let words = |count: Option<usize>| match count {
                    Some(count) => format!("a batch of {count}"),
                    None => "one image".to_owned(),
                };
                let is = format!("is {}, left {}", words(other), words(count));
                return Err(wrong("right", is, "give a right image for each left one"));
            }
        };
        // Before another size makes it forget.
        Pair::new(&left, &right).map_err(error)?;
        let size = ImageSize::new(left.width(), left.height());
        let mut seen = self.with_matcher(py, size, |matcher| matcher.look(left, right))?;
        let [left, right] = seen.rectified;
        let all = PyDict::new(py);
        let capture = &mut seen.capture;
        let (disparity, confidence) = (
            capture.take::<FixedDisparity>(Annotator::Disparity),
            capture.take::<Image<u8>>(Annotator::Confidence),
        );
        all.set_item("depth", array(py, seen.capture.distance.0)?)?;
        if let Some(disparity) = disparity {
            all.set_item("disparity", array(py, disparity.to_px())?)?;
        }
        if let Some(confidence) = confidence {
            all.set_item("confidence", array(py, confidence)?)?;
        }
        all.set_item("rectified_left", recorded(py, left)?)?;
        all.set_item("rectified_right", recorded(py, right)?)?;
        all.set_item("findings", finding::list(&seen.findings))?;
        Ok(all)
    }

    /// Forgets all earlier pairs.
    fn reset(&self, py: Python<'_>) {
        self.ask(py, Matcher::reset);
    }

    /// The rectified left camera, whose depth is measured, for images of the size that was looked at last; before that the
    /// device's own, of any pair 1280 x 800.
    #[getter]
    fn camera(&self, py: Python<'_>) -> Camera {
        self.ask(py, |matcher| {
            Camera::rectified(matcher.camera(), matcher.body_from_camera())
        })
    }

    /// Between the two cameras, metres.
    #[getter]
    fn baseline(&self, py: Python<'_>) -> f64 {
        self.ask(py, |matcher| matcher.baseline_m())
    }

    /// How images are rectified, "homography", "mesh" or "full"; None where they are.
    #[getter]
    fn rectify(&self, py: Python<'_>) -> Option<&'static str> {
        self.ask(py, |matcher| matcher.method().map(Method::name))
    }

    /// The matcher's parameters by name, as `parameters=` takes them, for images of the size that was looked at last.
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.ask(py, |matcher| matcher.sensor().engine().parameters())
            .into_py_dict(py)
    }

    /// The filters, as `filters=` takes them.
    #[getter]
    fn filters(&self, py: Python<'_>) -> Vec<String> {
        self.ask(py, |matcher| {
            let filters = matcher.sensor().filters().filters().iter();
            filters.map(ToString::to_string).collect()
        })
    }

    /// What about the matcher is not as the device says. What is wrong with images is in what a call returns.
    #[getter]
    fn findings(&self, py: Python<'_>) -> Vec<Finding> {
        self.ask(py, |matcher| finding::list(matcher.findings()))
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let whose = match &self.source {
            Source::Device { device, .. } => device.get().twin.device.name.clone(),
            Source::Any { .. } => "any pair".to_owned(),
        };
        let camera = self.ask(py, |matcher| matcher.camera());
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
