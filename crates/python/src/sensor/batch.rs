//! The depth sensors of many environments.

mod state;
mod values;

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use numpy::{IntoPyArray, PyArray1, PyArrayMethods};
use oaktwin::camera::ImageSize;
use oaktwin::depth::ReasonCodes;
use oaktwin::image::Image;
use oaktwin::image::annotation::{Annotator, Reasons};
use oaktwin::sensor::{Capture, SensorOptions};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use state::{Clock, Episodes};
use values::{Values, of_items, sources};

use super::DepthSensor;
use super::annotate::{not_made, sensor_annotator};
use super::items::Items;
use super::many::{Batch, copy};
use super::memory::Memory;
use super::sized::SensorSettings;
use super::units::{notice, numbers_of};
use crate::arguments::{Annotators, FrameNumber};
use crate::engine::PythonEngine;
use crate::error::{Error, wrong};
use crate::finding::{self, Finding, Notices};
use crate::images::{Depth, DepthSlice, ImageShape, Out, OutSlice, Pictures};
use crate::layers::names;
use crate::settings::{item_numbers, whole};

/// The largest number of items.
const MAX_ITEMS: u64 = 1 << 20;

/// The outputs of a batch besides the distance.
const LAYERS: [Annotator; 2] = [Annotator::DepthSensorConfidence, Annotator::DepthSensorReason];

/// The depth sensors of simultaneous images, such as the environments of a simulator, made by `DepthSensor.batch`. Each item has its own unit,
/// parameters, memory of temporal filters, and episodes: frames are numbered from 0 on in each.
///
/// A call, `batch(depth, rgb=None, *, frame=None, out=None)`, measures an image of each item: `depth` (N, H, W), with the arguments and results
/// of a call of `DepthSensor`. Without `frame`, the images of an item are numbered from 0 on since its episode began.
///
/// The noise of an item is a function of the sensor's seed and name, the item's number or seed, its episode and the frame. So an item
/// repeats its noise if it repeats its episode, whatever the others do.
///
/// Thread-safe; calls with a temporal filter run one after another. Copies and pickles have the settings, and the numbers of the episodes and
/// of the next frames, but not the state of temporal filters.
#[pyclass(frozen, module = "oaktwin")]
pub(crate) struct SensorBatch {
    /// A copy of the sensor that the batch was made of, and the arguments, for pickles.
    sensor: Py<DepthSensor>,
    arguments: Py<PyDict>,
    /// The units: one for each item, or one for all.
    sources: Vec<SensorSettings>,
    /// The options of each item, or those of all.
    options: Vec<SensorOptions>,
    has_own_seeds: bool,
    state: Mutex<Episodes>,
    memory: Memory,
    notices: Notices,
    engine: Option<Arc<PythonEngine>>,
}

impl SensorBatch {
    pub(super) fn new<'py>(
        sensor: &Bound<'py, DepthSensor>,
        count: u64,
        given: [(&str, Option<&Bound<'py, PyAny>>); 5],
    ) -> PyResult<Self> {
        let py = sensor.py();
        if !(1..=MAX_ITEMS).contains(&count) {
            let is = format!("is {count}");
            return Err(wrong("count", is, format_args!("pass 1 to {MAX_ITEMS} items")));
        }
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        let arguments = PyDict::new(py);
        arguments.set_item("count", count)?;
        for (name, value) in given {
            if let Some(value) = value.filter(|value| !value.is_none()) {
                arguments.set_item(name, value)?;
            }
        }
        let own = sensor.get();
        let [seeds, device_seeds, parameters, drift, units] = given.map(|(_, value)| value);
        let values = Values {
            seeds: seeds.map(|seeds| numbers_of("seeds", seeds, count)).transpose()?,
            device_seeds: device_seeds
                .map(|seeds| numbers_of("device_seeds", seeds, count))
                .transpose()?,
            parameters: of_items("parameters", parameters, count)?,
            drift: of_items("drift", drift, count)?,
        };
        let batch = Self {
            sensor: py.import("copy")?.call_method1("copy", (sensor,))?.extract()?,
            arguments: arguments.unbind(),
            sources: sources(own, units, count)?,
            options: values.options(&own.source.options(), count)?,
            has_own_seeds: values.seeds.is_some(),
            state: Mutex::new(Episodes {
                clocks: vec![Clock::default(); count],
                ..Episodes::default()
            }),
            memory: Memory::default(),
            notices: Notices::default(),
            engine: PythonEngine::in_options(&own.source.options),
        };
        own.check_measures_depth()?;
        // Reports invalid settings immediately.
        let size = own.now(py, None)?.camera.intrinsics.size;
        batch.at_size(py, size, |_| ())?;
        Ok(batch)
    }

    /// The state, whose lock must not be held while Python runs.
    fn locked(&self) -> MutexGuard<'_, Episodes> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn count(&self) -> usize {
        self.locked().clocks.len()
    }

    /// Returns what measures the images of a call.
    fn measuring<'a>(
        &'a self,
        items: &'a Items,
        depth: DepthSlice<'a>,
        rgb: Option<&'a [[u8; 4]]>,
        shape: ImageShape,
    ) -> Batch<'a> {
        Batch {
            items,
            memory: &self.memory,
            engine: self.engine.as_ref(),
            depth,
            rgb,
            shape,
        }
    }

    /// Reads the images of a call, one for each item.
    fn read<'py>(&self, depth: &Bound<'py, PyAny>) -> PyResult<(Depth<'py>, ImageShape)> {
        let (depth, shape) = Depth::read("depth", depth)?;
        let count = self.count();
        if shape.batch != Some(count) {
            let is = format!("has shape {:?}, but the batch {count} items", shape.dims());
            let ImageSize { width, height } = shape.size;
            let remedy = format!("pass an array of shape ({count}, {height}, {width})");
            return Err(wrong("depth", is, remedy));
        }
        Ok((depth, shape))
    }
}

/// An error with the number of its item.
fn in_item(py: Python<'_>, item: usize, error: &PyErr) -> PyErr {
    Error::new_err(format!("item {item}: {}", error.value(py)))
}

#[pymethods]
impl SensorBatch {
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let make = self.sensor.bind(py).getattr("batch")?;
        let partial = py.import("functools")?.getattr("partial")?;
        let make = partial.call((make,), Some(self.arguments.bind(py)))?;
        (make, PyTuple::empty(py), self.__getstate__()).into_pyobject(py)
    }

    /// The episode and the number of the next frame of each item.
    fn __getstate__(&self) -> Vec<(u64, u64)> {
        let state = self.locked();
        let clocks = state.clocks.iter();
        clocks.map(|clock| (clock.episode, clock.frame)).collect()
    }

    fn __setstate__(&self, clocks: Vec<(u64, u64)>) {
        let mut state = self.locked();
        for (item, (episode, frame)) in clocks.into_iter().enumerate().take(state.clocks.len()) {
            state.clocks[item] = Clock { episode, frame };
            state.enter(item);
        }
    }

    /// The number of items.
    fn __len__(&self) -> usize {
        self.count()
    }

    /// Measures an image of each item; see the class.
    #[pyo3(name = "_call", signature = (depth, rgb = None, *, frame = None, out = None))]
    fn call<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
        frame: Option<FrameNumber>,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (depth, shape) = self.read(depth)?;
        let pictures = rgb.map(|rgb| Pictures::read(rgb, shape)).transpose()?;
        let out_shape = self.out_shape(py, shape)?;
        let (result, mut out) = Out::of(py, out, out_shape, &depth)?;
        let items = self.at_size(py, shape.size, |state| self.next(state, frame))?;
        let rgb = pictures.as_ref().map(Pictures::rgba).transpose()?;
        let mut room = out.slice()?;
        let batch = self.measuring(&items, depth.slice()?, rgb.as_deref(), shape);
        batch.sense(py, out_shape.pixels(), &mut room)?;
        notice(&self.notices, py, batch.depth, shape, &room, rgb.is_some())?;
        Ok(result)
    }

    /// The outputs of Isaac Sim's depth sensor annotators for an image of each item, from one measurement.
    ///
    /// depth, rgb, frame: as in a call.
    /// annotators: of "depth_sensor_distance", "depth_sensor_confidence" and "depth_sensor_reason".
    ///
    /// Returns a dictionary by name, as `DepthSensor.annotate` does, with arrays (N, H, W).
    ///
    /// Raises oaktwin.Error for other annotators, and for outputs that the engine does not support.
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
        let asked = annotators.0.iter().map(|name| sensor_annotator(name));
        let asked = asked.collect::<PyResult<Vec<_>>>()?;
        let layers: Vec<Annotator> = LAYERS.into_iter().filter(|one| asked.contains(one)).collect();
        let other = |one: &&Annotator| **one != Annotator::DepthSensorDistance && !layers.contains(*one);
        if let Some(other) = asked.iter().find(other) {
            let remedy = "annotate single images with it";
            return Err(wrong(other.name(), "is not an output of batches", remedy));
        }
        let (depth, shape) = self.read(depth)?;
        let pictures = rgb.map(|rgb| Pictures::read(rgb, shape)).transpose()?;
        let out_shape = self.out_shape(py, shape)?;
        let items = self.at_size(py, shape.size, |state| self.next(state, frame))?;
        let rgb = pictures.as_ref().map(Pictures::rgba).transpose()?;
        let batch = self.measuring(&items, depth.slice()?, rgb.as_deref(), shape);
        let pixels = out_shape.pixels().max(1);
        let (mut distance, mut confidence, mut reasons) = (
            vec![0.0_f32; pixels * shape.count()],
            vec![0_u16; pixels * shape.count()],
            vec![0_u8; pixels * shape.count()],
        );
        let places = distance
            .chunks_mut(pixels)
            .zip(confidence.chunks_mut(pixels))
            .zip(reasons.chunks_mut(pixels))
            .collect();
        let legend = Mutex::new(None);
        let take = |mut captured: Capture,
                    ((distance, levels), codes): ((&mut [f32], &mut [u16]), &mut [u8])| {
            copy(&captured.distance.0, distance);
            if let Some(confidence) = captured.take::<Image<u16>>(Annotator::DepthSensorConfidence) {
                copy(&confidence, levels);
            }
            if let Some(made) = captured.take::<ReasonCodes>(Annotator::DepthSensorReason) {
                let made = Reasons::from(made);
                copy(&made.codes, codes);
                *legend.lock().unwrap_or_else(PoisonError::into_inner) = Some(made);
            }
        };
        batch.capture(py, &layers, places, take)?;
        let room = OutSlice::Metres(&mut distance);
        notice(&self.notices, py, batch.depth, shape, &room, rgb.is_some())?;
        let legend = legend.into_inner().unwrap_or_else(PoisonError::into_inner);
        let all = PyDict::new(py);
        for annotator in asked {
            let values = match annotator {
                Annotator::DepthSensorConfidence => shaped(py, std::mem::take(&mut confidence), out_shape)?,
                Annotator::DepthSensorReason => {
                    let legend = legend.as_ref().ok_or_else(|| not_made(annotator))?;
                    all.set_item("depth_sensor_reason_names", names(py, legend)?)?;
                    shaped(py, std::mem::take(&mut reasons), out_shape)?
                }
                _ => shaped(py, std::mem::take(&mut distance), out_shape)?,
            };
            all.set_item(annotator.name(), values)?;
        }
        Ok(all)
    }

    /// Starts new sequences: temporal filters forget earlier images.
    ///
    /// items: the numbers of the items, or a mask; by default all. The others go on.
    /// episode: the number of the episode that begins, or one for each of these items: frames are numbered from 0 on, with the noise of that
    ///     episode. By default, the numbering continues, so that no noise repeats. Episode 0 is the one that every item begins with.
    #[pyo3(signature = (items = None, *, episode = None))]
    fn reset(
        &self,
        py: Python<'_>,
        items: Option<&Bound<'_, PyAny>>,
        episode: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let count = self.count();
        let items = match items {
            Some(items) => item_numbers("items", items)?,
            None => (0..count).collect(),
        };
        if let Some(item) = items.iter().find(|item| **item >= count) {
            let is = format!("item {item} is not in the batch");
            return Err(wrong("items", is, format_args!("pass numbers below {count}")));
        }
        let episodes = episode.map(|episode| match whole::<u64>("episode", episode) {
            Ok(one) => Ok(vec![one; items.len()]),
            Err(error) if episode.try_iter().is_err() => Err(error),
            Err(_) => numbers_of("episode", episode, items.len()),
        });
        let episodes = episodes.transpose()?;
        py.detach(|| {
            self.memory.reset(Some(&items));
            let mut state = self.locked();
            for (item, episode) in items.into_iter().zip(episodes.into_iter().flatten()) {
                state.clocks[item] = Clock { episode, frame: 0 };
                state.enter(item);
            }
        });
        Ok(())
    }

    /// The number of the present episode of each item, (N,) uint64.
    #[getter]
    fn episodes<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u64>> {
        let episodes: Vec<u64> = self.locked().clocks.iter().map(|clock| clock.episode).collect();
        episodes.into_pyarray(py)
    }

    /// The number of the next frame of each item, (N,) uint64.
    #[getter]
    fn frames<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u64>> {
        let frames: Vec<u64> = self.locked().clocks.iter().map(|clock| clock.frame).collect();
        frames.into_pyarray(py)
    }

    /// Findings about the settings of all items, and about the images measured so far, as `DepthSensor.findings`.
    #[getter]
    fn findings(&self) -> Vec<Finding> {
        let mut findings = self.locked().findings.clone();
        findings.extend(self.notices.all());
        finding::list(&findings)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let sensor: String = self.sensor.bind(py).repr()?.extract()?;
        Ok(format!("<oaktwin.SensorBatch of {}: {sensor}>", self.count()))
    }
}

fn shaped<T: numpy::Element>(
    py: Python<'_>,
    values: Vec<T>,
    shape: ImageShape,
) -> PyResult<Bound<'_, PyAny>> {
    Ok(PyArray1::from_vec(py, values).reshape(shape.rows())?.into_any())
}
