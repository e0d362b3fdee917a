use std::path::PathBuf;

use oaktwin::accuracy::{MeasuredOptics, REGION};
use oaktwin::fit::{self as fitting, FitError, FitOptions, Recordings, TargetImages};
use oaktwin::latency::{self, LONGEST_S, Track};
use oaktwin::sensor::SensorOption;
use pyo3::exceptions::PyFileNotFoundError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arguments::optional;
use crate::device::{self, Device};
use crate::error::{error, wrong};
use crate::finding;
use crate::json;
use crate::progress::ProgressCallback;
use crate::settings::sensor_options;
use crate::threads;

/// Filters and noise are not fitted.
fn is_offered(option: &SensorOption) -> bool {
    !["filters", "isaac", "seed", "device_seed", "drift"].contains(&option.name)
}

/// The arguments besides the options of the sensor.
const ARGUMENTS: [&str; 8] = [
    "sensor",
    "region",
    "depth_scale",
    "measured_from",
    "focal_px",
    "width_px",
    "fits_focal_length",
    "progress",
];

/// Wraps the report of `oaktwin fit --json` and its parameter file, for `oaktwin.fit`.
#[pyfunction]
#[pyo3(signature = (device, recordings, *, sensor = None, region = REGION, depth_scale = 0.001, measured_from = 0.0,
    focal_px = None, width_px = None, fits_focal_length = false, progress = ProgressCallback::default(), **options))]
#[expect(clippy::needless_pass_by_value, reason = "required by PyO3")]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
pub(crate) fn fit<'py>(
    py: Python<'py>,
    #[pyo3(from_py_with = device::argument::required)] device: Bound<'py, Device>,
    recordings: Recorded,
    sensor: Option<String>,
    region: f64,
    depth_scale: f64,
    measured_from: f64,
    focal_px: Option<f64>,
    #[pyo3(from_py_with = optional::width_px)] width_px: Option<u32>,
    fits_focal_length: bool,
    progress: ProgressCallback,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<(Bound<'py, PyAny>, String)> {
    let (device, recordings) = (device.get(), recordings.read()?);
    let options = FitOptions {
        sensor,
        engine: sensor_options("fit", &ARGUMENTS, options, is_offered)?,
        optics: MeasuredOptics {
            focal_length_px: focal_px,
            width_px,
        },
        region,
        depth_scale,
        from_m: measured_from,
        fits_focal_length,
    };
    let fitted = threads::interruptible(py, progress, |task| {
        let (fit, findings) = fitting::fit(&device.twin, recordings.recordings(), &options, &|progress| {
            task.watch(progress)
        })?;
        Ok::<_, FitError>((fit.report().clone(), findings))
    })?;
    let (report, findings) = fitted.map_err(error)?;
    finding::warn_caller(py, &findings)?;
    Ok((json::to_python(py, &report)?, report.toml()))
}

/// Estimates the latency of a camera, the time from the middle of an exposure until its image arrives, from a moving edge; what `oaktwin fit
/// --latency` does for files.
///
/// camera: the times at which images arrived in seconds, increasing, and the positions of the edge in them, such as in pixels.
/// reference: the times and positions of a reference that moves the edge, such as an encoder, on the same clock, in any unit, sampled densely.
/// longest: the longest latency that is searched, seconds; the reference has to begin so much earlier than the images that count.
///
/// Returns a dictionary: "latency_s" for `Stream(latency=)`, its "confidence_interval_95", "jitter_s" (the standard deviation from frame to
/// frame), "edge_noise", "correlation", "images", "seconds", "passed".
///
/// Issues an oaktwin.FindingWarning if several latencies explain the motion. Raises oaktwin.Error for times that do not increase, numbers
/// that are not finite, fewer than 20 images that count, and positions that do not follow each other.
#[pyfunction]
#[pyo3(signature = (camera, reference, *, longest = LONGEST_S))]
pub(crate) fn fit_latency<'py>(
    py: Python<'py>,
    camera: (Vec<f64>, Vec<f64>),
    reference: (Vec<f64>, Vec<f64>),
    longest: f64,
) -> PyResult<Bound<'py, PyAny>> {
    let estimate = || {
        let camera = Track::new("camera", camera.0, camera.1)?;
        let reference = Track::new("reference", reference.0, reference.1)?;
        latency::latency(&camera, &reference, longest)
    };
    let (report, findings) = py.detach(estimate).map_err(error)?;
    finding::warn_caller(py, &findings)?;
    json::to_python(py, &report)
}

/// Recordings: paths, or a mapping from distances to the bytes of NPY files.
#[derive(FromPyObject)]
pub(crate) enum Recorded {
    Paths(Vec<PathBuf>),
    Images(Vec<(f64, Vec<u8>)>),
}

/// Recordings that a fit reads.
enum Read {
    Paths(Vec<PathBuf>),
    Images(Vec<TargetImages>),
}

impl Recorded {
    fn read(self) -> PyResult<Read> {
        let read = match self {
            Self::Paths(paths) => Read::Paths(paths),
            Self::Images(images) => {
                let images = images.into_iter().map(|(distance_m, npy)| TargetImages {
                    distance_m,
                    npy: npy.into(),
                });
                Read::Images(images.collect())
            }
        };
        let is_empty = match &read {
            Read::Paths(paths) => paths.is_empty(),
            Read::Images(images) => images.is_empty(),
        };
        if is_empty {
            let remedy = "pass at least one folder or CSV file, or images by their distance";
            return Err(wrong("recordings", "is empty", remedy));
        }
        if let Read::Paths(paths) = &read
            && let Some(missing) = paths.iter().find(|path| !path.exists())
        {
            let text = format!(
                "{}: there is no such file or folder; check the path",
                missing.display()
            );
            return Err(PyFileNotFoundError::new_err(text));
        }
        Ok(read)
    }
}

impl Read {
    fn recordings(&self) -> Recordings<'_> {
        match self {
            Self::Paths(paths) => paths.into(),
            Self::Images(images) => Recordings::Images(images),
        }
    }
}
