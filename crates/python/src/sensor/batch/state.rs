//! The sensors of the items in their episodes.

use std::collections::BTreeMap;
use std::sync::Arc;

use oaktwin::camera::ImageSize;
use oaktwin::diagnostic;
use oaktwin::sensor::Sensor;
use pyo3::prelude::*;
use rayon::prelude::*;

use super::{SensorBatch, in_item};
use crate::arguments::FrameNumber;
use crate::images::ImageShape;
use crate::sensor::items::{Item, Items};
use crate::sensor::sized::SizedSensor;
use crate::sensor::units::number;
use crate::threads;

/// The sensors for images of a size, in their present episodes.
#[derive(Default)]
pub(super) struct Episodes {
    pub(super) size: Option<ImageSize>,
    /// The sensor of each item, or of all, in episode 0.
    pub(super) first: Vec<Arc<Sensor>>,
    /// The sensors of items in other episodes.
    pub(super) later: BTreeMap<usize, Arc<Sensor>>,
    pub(super) clocks: Vec<Clock>,
    pub(super) findings: Vec<diagnostic::Finding>,
}

/// Where an item is in its sequence.
#[derive(Clone, Copy, Default, PartialEq)]
pub(super) struct Clock {
    pub(super) episode: u64,
    /// The number of its next frame.
    pub(super) frame: u64,
}

impl Episodes {
    /// Enters the present episode of an item, whose sensor is then in `later`.
    pub(super) fn enter(&mut self, item: usize) {
        let episode = self.clocks[item].episode;
        if episode == 0 {
            self.later.remove(&item);
        } else if let Some(first) = self.first.get(item).or(self.first.first()) {
            let sensor = Arc::new(first.in_episode(episode));
            self.later.insert(item, sensor);
        }
    }

    pub(super) fn sensor(&self, item: usize) -> &Arc<Sensor> {
        let later = self.later.get(&item);
        later.unwrap_or_else(|| &self.first[item.min(self.first.len() - 1)])
    }
}

impl SensorBatch {
    /// Works on the state for images of a size, with the interpreter released.
    pub(super) fn at_size<T: Send>(
        &self,
        py: Python<'_>,
        size: ImageSize,
        work: impl FnOnce(&mut Episodes) -> T + Send,
    ) -> PyResult<T> {
        let done = py.detach(|| {
            let mut state = self.locked();
            self.sized(&mut state, size)?;
            Ok(work(&mut state))
        });
        done.map_err(|(item, error): (usize, PyErr)| in_item(py, item, &error))
    }

    /// Makes the sensors for images of a size. Returns the first item that cannot be made, with its error.
    fn sized(&self, state: &mut Episodes, size: ImageSize) -> Result<(), (usize, PyErr)> {
        if state.size == Some(size) {
            return Ok(());
        }
        let make = |item: usize| {
            // A list has one for each item, or one for all.
            let source = &self.sources[item.min(self.sources.len() - 1)];
            let options = &self.options[item.min(self.options.len() - 1)];
            source
                .sized_with(Some(size), options)
                .map_err(|error| (item, error))
        };
        let count = self.sources.len().max(self.options.len());
        let make_all = || (0..count).into_par_iter().map(make).collect();
        let sensors: Vec<SizedSensor> =
            threads::install::<Result<_, _>>(make_all).map_err(|error| (0, error))??;
        state.findings.clear();
        state.first.clear();
        for sized in sensors {
            let new = sized
                .findings
                .into_iter()
                .filter(|one| !state.findings.contains(one));
            let new: Vec<_> = new.collect();
            state.findings.extend(new);
            state.first.push(sized.sensor);
        }
        state.later.clear();
        for item in 0..state.clocks.len() {
            state.enter(item);
        }
        state.size = Some(size);
        Ok(())
    }

    /// Returns the items for the next images of a size, and moves their clocks on, unless a frame is given.
    pub(super) fn next(&self, state: &mut Episodes, frame: Option<FrameNumber>) -> Items {
        let first = state.clocks[0];
        let is_uniform = state.first.len() == 1 && state.clocks.iter().all(|clock| *clock == first);
        let items = if is_uniform {
            Items::Same {
                sensor: Arc::clone(state.sensor(0)),
                frame: frame.map_or(first.frame, |frame| frame.0),
            }
        } else {
            let items = state.clocks.iter().enumerate().map(|(item, clock)| Item {
                sensor: Arc::clone(state.sensor(item)),
                number: number(item, self.has_own_seeds),
                frame: frame.map_or(clock.frame, |frame| frame.0),
            });
            Items::Own(items.collect())
        };
        if frame.is_none() {
            state.clocks.iter_mut().for_each(|clock| clock.frame += 1);
        }
        items
    }

    /// The shape of the results: filters may decimate.
    pub(super) fn out_shape(&self, py: Python<'_>, shape: ImageShape) -> PyResult<ImageShape> {
        let ImageSize { width, height } = shape.size;
        let out = |state: &mut Episodes| state.sensor(0).filters().size(width, height);
        let (width, height) = self.at_size(py, shape.size, out)?;
        Ok(shape.sized(ImageSize::new(width, height)))
    }
}
