use std::ops::ControlFlow;
use std::sync::atomic::Ordering;

use oaktwin::accuracy::{AccuracyError, Bench, CAPTURES, Options, REGION, parse_distances};
use pyo3::prelude::*;

use crate::device::Device;
use crate::error::error;
use crate::finding;
use crate::json;
use crate::settings::Settings;
use crate::threads;

/// What `oaktwin.accuracy` wraps: the report of `oaktwin accuracy --json` as a dictionary.
#[pyfunction]
#[pyo3(signature = (device, *, sensor = None, distances = None, devices = None, captures = CAPTURES,
    region = REGION, engine = None, preset = None, filters = Vec::new(), parameters = None, seed = 0,
    device_seed = None, extended_disparity = false, isaac = "5.1"))]
#[expect(clippy::too_many_arguments, reason = "options of Python")]
pub(crate) fn accuracy<'py>(
    py: Python<'py>,
    device: &Device,
    sensor: Option<String>,
    distances: Option<Distances>,
    devices: Option<u32>,
    captures: u32,
    region: f64,
    engine: Option<&str>,
    preset: Option<String>,
    filters: Vec<String>,
    parameters: Option<Bound<'py, PyAny>>,
    seed: u64,
    device_seed: Option<u64>,
    extended_disparity: bool,
    isaac: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let settings = Settings {
        engine,
        preset,
        filters,
        parameters,
        extended_disparity,
        isaac,
        seed,
        device_seed,
        name: None,
    };
    let options = Options {
        sensor,
        engine: settings.options()?,
        distances_m: distances.map(Distances::metres).transpose()?,
        devices,
        captures,
        region,
        ..Options::default()
    };
    let (bench, findings) = Bench::new(&device.twin, &options).map_err(error)?;
    finding::warn(py, &findings)?;
    let report = threads::interruptible(py, |stop| {
        let watch = |_, _| {
            if stop.load(Ordering::Relaxed) {
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        };
        let measurement = bench.measure(None, &watch)?;
        Ok::<_, AccuracyError>(measurement.report().clone())
    })?;
    json::to_python(py, &report.map_err(error)?)
}

/// True distances: numbers, or the program's text.
#[derive(FromPyObject)]
pub(crate) enum Distances {
    Text(String),
    Metres(Vec<f64>),
}

impl Distances {
    fn metres(self) -> PyResult<Vec<f64>> {
        match self {
            Self::Text(text) => parse_distances(&text).map_err(error),
            Self::Metres(metres) => Ok(metres),
        }
    }
}
