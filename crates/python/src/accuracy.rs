use std::path::PathBuf;

use oaktwin::accuracy::{
    AccuracyError, AccuracyOptions, Bench, CAPTURES, MeasuredOptics, REGION, measured, parse_distances,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use pyo3::{Borrowed, FromPyObject};

use crate::arguments::{captures, optional};
use crate::device::{self, Device};
use crate::engine::{PythonEngine, serve_all};
use crate::error::{error, reading, wrong};
use crate::finding;
use crate::json;
use crate::progress::ProgressCallback;
use crate::settings::{mistyped, sensor_options};

/// The arguments besides the options of the sensor.
const ARGUMENTS: [&str; 11] = [
    "sensor",
    "distances",
    "devices",
    "population",
    "captures",
    "region",
    "measured",
    "measured_from",
    "focal_px",
    "width_px",
    "progress",
];

/// Wraps the report of `oaktwin accuracy --json` as a dictionary, for `oaktwin.accuracy`.
#[pyfunction]
#[pyo3(signature = (device, *, sensor = None, distances = None, devices = None, population = false, captures = CAPTURES,
    region = REGION, measured = None, measured_from = 0.0, focal_px = None, width_px = None,
    progress = ProgressCallback::default(), **options))]
#[expect(clippy::needless_pass_by_value, reason = "required by PyO3")]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
pub(crate) fn accuracy<'py>(
    py: Python<'py>,
    #[pyo3(from_py_with = device::argument::required)] device: Bound<'py, Device>,
    sensor: Option<String>,
    distances: Option<Distances>,
    #[pyo3(from_py_with = optional::devices)] devices: Option<u32>,
    population: bool,
    #[pyo3(from_py_with = captures)] captures: u32,
    region: f64,
    measured: Option<PathBuf>,
    measured_from: f64,
    focal_px: Option<f64>,
    #[pyo3(from_py_with = optional::width_px)] width_px: Option<u32>,
    progress: ProgressCallback,
    options: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyAny>> {
    let options = AccuracyOptions {
        sensor,
        engine: sensor_options("accuracy", &ARGUMENTS, options, |_| true)?,
        distances_m: distances.map(Distances::metres).transpose()?,
        devices,
        population,
        captures,
        region,
        optics: MeasuredOptics {
            focal_length_px: focal_px,
            width_px,
        },
        from_m: measured_from,
    };
    let read = |path: &PathBuf| measured::read(path).map_err(|error| reading(path, &error));
    let curve = measured.as_ref().map(read).transpose()?;
    let (bench, findings) = Bench::new(&device.get().twin, &options).map_err(error)?;
    finding::warn_caller(py, &findings)?;
    let python = PythonEngine::in_options(&options.engine);
    let report = serve_all(py, python.as_slice(), progress, |task| {
        let measurement = bench.measure(measured.as_deref().zip(curve.as_ref()), &|progress| {
            task.watch(progress)
        })?;
        Ok::<_, AccuracyError>(measurement.report().clone())
    })?;
    json::to_python(py, &report.map_err(error)?)
}

/// True distances: numbers in metres, or the program's text syntax.
pub(crate) enum Distances {
    Text(String),
    Metres(Vec<f64>),
}

impl FromPyObject<'_, '_> for Distances {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(text) = object.extract() {
            return Ok(Self::Text(text));
        }
        let metres = object.extract().map(Self::Metres);
        metres.map_err(|_| {
            mistyped(
                "distances",
                &object,
                "a list of metres, or a range such as \"0.5:4:0.5\"",
            )
        })
    }
}

impl Distances {
    fn metres(self) -> PyResult<Vec<f64>> {
        match self {
            Self::Text(text) => parse_distances(&text).map_err(error),
            Self::Metres(metres) if metres.is_empty() => Err(wrong(
                "distances",
                "is empty",
                "pass at least one distance in metres",
            )),
            Self::Metres(metres) => Ok(metres),
        }
    }
}
