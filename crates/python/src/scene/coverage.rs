use numpy::{PyArray1, PyArray2, PyArrayMethods};
use oaktwin::camera::ImageSize;
use oaktwin::camera::math::DVec3;
use oaktwin::coverage::{
    Base, CoverageError, CoverageOptions, MeasuringRig, Outcome, PlacementSweep, PointOutcomes, Region,
    Samples, candidates, measure, reasons,
};
use oaktwin::render::RigSpec;
use oaktwin::scene::{self, Bounds};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use super::Scene;
use crate::arguments::{Size, optional, vector};
use crate::device::Device;
use crate::engine::{PythonEngine, serve_all};
use crate::error::{error, wrong};
use crate::finding;
use crate::json;
use crate::pair::PairSettings;
use crate::pose::Of;
use crate::progress::ProgressCallback;
use crate::settings::{mistyped, sensor_options, strings};

/// The arguments besides the options of the sensor.
const ARGUMENTS: [&str; 13] = [
    "region",
    "region_box",
    "height",
    "tilt_deg",
    "sensor",
    "size",
    "samples",
    "tolerance_mm",
    "points",
    "projector",
    "ambient",
    "imager",
    "progress",
];

/// Wraps the report of `oaktwin coverage --json` as a dictionary, and the outcomes by point, for `oaktwin.coverage`. Each device has the
/// name of its sensor and its options.
#[pyfunction]
#[pyo3(signature = (scene, devices, world_from_body, *, region = None, region_box = None, height = None, tilt_deg = None, size = None,
    samples = None, tolerance_mm = None, points = false, projector = None, ambient = 1.0, imager = None,
    progress = ProgressCallback::default()))]
#[expect(clippy::needless_pass_by_value, reason = "required by PyO3")]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
pub(crate) fn coverage<'py>(
    py: Python<'py>,
    scene: &Scene,
    devices: Vec<(PyRef<'py, Device>, Option<String>, Bound<'py, PyDict>)>,
    world_from_body: &Bound<'py, PyAny>,
    region: Option<&Bound<'py, PyAny>>,
    region_box: Option<&Bound<'py, PyAny>>,
    height: Option<&Bound<'py, PyAny>>,
    tilt_deg: Option<&Bound<'py, PyAny>>,
    size: Option<Size>,
    #[pyo3(from_py_with = optional::samples)] samples: Option<u32>,
    tolerance_mm: Option<f64>,
    points: bool,
    projector: Option<f64>,
    ambient: f64,
    imager: Option<&Bound<'py, PyAny>>,
    progress: ProgressCallback,
) -> PyResult<(Bound<'py, PyAny>, Option<Bound<'py, PyDict>>)> {
    let region = self::region(region, region_box)?;
    let mut rigs = Vec::new();
    let mut engines = Vec::new();
    for (device, sensor, options) in &devices {
        let engine = sensor_options("coverage", &ARGUMENTS, Some(options), |_| true)?;
        engines.extend(PythonEngine::in_options(&engine));
        let pair = PairSettings {
            sensor: None,
            size: size.map(|Size(width, height)| (width, height)),
            projector: 0.0,
            ambient,
            imager,
            seed: engine.seed,
            device_seed: engine.device_seed,
            drift: None,
        };
        let spec = RigSpec {
            sensor: engine.clone(),
            size: size.map(|Size(width, height)| ImageSize::new(width, height)),
            pair: pair.options(device)?,
            ..RigSpec::default()
        };
        let made = MeasuringRig::new(&device.twin, sensor.as_deref(), projector, &spec);
        let (rig, findings) = made.map_err(error)?;
        rig.check_memory().map_err(error)?;
        finding::warn(py, &findings)?;
        rigs.push(rig);
    }
    let base = Base::Poses(Of::Body.several("poses", world_from_body)?.0);
    let sweep = PlacementSweep {
        heights_m: List::numbers(List::of("height", height)?, |text| {
            Ok(PlacementSweep::parse(Some(text), None)?.heights_m)
        })?,
        tilts_deg: List::numbers(List::of("tilt_deg", tilt_deg)?, |text| {
            Ok(PlacementSweep::parse(None, Some(text))?.tilts_deg)
        })?,
    };
    let stage = scene.read(py);
    let renderer = &stage.renderer;
    let up = renderer.scene().up.direction();
    let placements = sweep.placements(&base, up).map_err(error)?;
    let candidates = candidates(&rigs, &placements);
    let options = CoverageOptions {
        samples: samples.unwrap_or(CoverageOptions::default().samples),
        tolerance_mm,
        keeps_points: points,
    };
    let measured = serve_all(py, &engines, progress, |task| {
        measure(renderer, &region, &candidates, &options, &|progress| {
            task.watch(progress)
        })
    })?;
    let measured = measured.map_err(error)?;
    finding::warn(py, &measured.findings)?;
    let report = json::to_python(py, &measured)?;
    let points = measured.points.map(|kept| arrays(py, renderer.scene(), &kept));
    Ok((report, points.transpose()?))
}

/// Numbers, or the program's text syntax.
pub(crate) enum List {
    Text(String),
    Numbers(Vec<f64>),
}

impl List {
    /// Reads an argument that may be None.
    fn of(name: &str, object: Option<&Bound<'_, PyAny>>) -> PyResult<Option<Self>> {
        let Some(object) = object else {
            return Ok(None);
        };
        if let Ok(text) = object.extract() {
            return Ok(Some(Self::Text(text)));
        }
        let numbers = object.extract().map(Self::Numbers);
        let expected = "a list of numbers, or a range such as \"0.5:2:0.5\"";
        numbers.map(Some).map_err(|_| mistyped(name, object, expected))
    }

    fn numbers(
        list: Option<Self>,
        parse: impl FnOnce(&str) -> Result<Vec<f64>, CoverageError>,
    ) -> PyResult<Vec<f64>> {
        match list {
            None => Ok(Vec::new()),
            Some(Self::Text(text)) => parse(&text).map_err(error),
            Some(Self::Numbers(numbers)) => Ok(numbers),
        }
    }
}

fn region(objects: Option<&Bound<'_, PyAny>>, corners: Option<&Bound<'_, PyAny>>) -> PyResult<Region> {
    let objects = match objects {
        None => Vec::new(),
        Some(path) if path.is_instance_of::<PyString>() => vec![path.extract()?],
        Some(paths) => strings("region", paths)?,
    };
    let within = corners.map(|corners| {
        let pair: Vec<Bound<'_, PyAny>> = corners
            .try_iter()
            .and_then(Iterator::collect)
            .map_err(|_| mistyped("region_box", corners, "the minimum and the maximum corner"))?;
        match &pair[..] {
            [min, max] => Ok(Bounds {
                min: vector("region_box", min)?,
                max: vector("region_box", max)?,
            }),
            _ => Err(wrong(
                "region_box",
                format_args!("has {} items", pair.len()),
                "pass the minimum and the maximum corner",
            )),
        }
    });
    Ok(Region {
        objects,
        within: within.transpose()?,
        ..Region::default()
    })
}

/// The outcomes by point as arrays.
fn arrays<'py>(py: Python<'py>, scene: &scene::Scene, kept: &PointOutcomes) -> PyResult<Bound<'py, PyDict>> {
    let Samples { points, .. } = &kept.samples;
    let all = PyDict::new(py);
    let vectors = |of: &dyn Fn(usize) -> DVec3| -> PyResult<Bound<'py, PyArray2<f64>>> {
        let numbers = (0..points.len()).flat_map(|i| of(i).to_array());
        PyArray1::from_iter(py, numbers).reshape([points.len(), 3])
    };
    all.set_item("position", vectors(&|i| points[i].position)?)?;
    all.set_item("normal", vectors(&|i| points[i].normal)?)?;
    let instances = points.iter().map(|point| point.instance);
    all.set_item("instance", PyArray1::from_iter(py, instances))?;
    let paths: Vec<&str> = scene.instances.iter().map(|one| one.path.as_str()).collect();
    all.set_item("prim_paths", paths)?;
    let shape = [kept.outcomes.len(), points.len()];
    let outcomes = kept.outcomes.iter().flatten().map(|&Outcome(code)| code);
    all.set_item("outcome", PyArray1::from_iter(py, outcomes).reshape(shape)?)?;
    let errors = kept.errors_m.iter().flatten().copied();
    all.set_item("error_m", PyArray1::from_iter(py, errors).reshape(shape)?)?;
    let names = PyDict::new(py);
    for reason in reasons() {
        names.set_item(reason.code, &reason.name)?;
    }
    all.set_item("reasons", names)?;
    Ok(all)
}
