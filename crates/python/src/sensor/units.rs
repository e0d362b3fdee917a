//! The items of a call with a batch: each with the sensor of its own unit, or all with the same.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin::camera::ImageSize;
use oaktwin::sense::{self as sensing, DepthUnit};
use oaktwin::sensor::{Sensor, SensorOptions};
use pyo3::prelude::*;

use super::DepthSensor;
use super::items::{Item, Items};
use crate::arguments::FrameNumber;
use crate::error::wrong;
use crate::finding::Notices;
use crate::images::{DepthSlice, ImageShape, OutSlice};
use crate::settings::mistyped;

/// The sensors of units by seed and device seed, for one image size.
#[derive(Debug, Default)]
pub(super) struct Units(Mutex<(Option<ImageSize>, BySeeds)>);

type BySeeds = BTreeMap<(u64, Option<u64>), Arc<Sensor>>;

impl DepthSensor {
    /// Returns the frame number of a call.
    pub(super) fn frame(&self, given: Option<FrameNumber>) -> u64 {
        FrameNumber::or_next(given, &self.next_frame)
    }

    /// Returns the sensors of the items of a batch.
    pub(super) fn items(
        &self,
        shape: ImageShape,
        sensor: &Arc<Sensor>,
        frame: u64,
        seed: Option<&Bound<'_, PyAny>>,
        device_seed: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Items> {
        let read = |name: &str, seeds: &Bound<'_, PyAny>| match shape.batch {
            Some(count) => numbers_of(name, seeds, count),
            None => Err(wrong(name, "is for batches", "set it in the constructor")),
        };
        let seeds = seed.map(|seeds| read("seed", seeds)).transpose()?;
        let device_seeds = device_seed.map(|seeds| read("device_seed", seeds)).transpose()?;
        if seeds.is_none() && device_seeds.is_none() {
            return Ok(Items::Same {
                sensor: Arc::clone(sensor),
                frame,
            });
        }
        let mut items = Vec::with_capacity(shape.count());
        for item in 0..shape.count() {
            let own = &self.source.options;
            let seed = seeds.as_ref().map_or(self.source.seed(), |seeds| seeds[item]);
            let device_seed = device_seeds
                .as_ref()
                .map_or(own.device_seed, |seeds| Some(seeds[item]));
            items.push(Item {
                sensor: self.unit(shape.size, seed, device_seed)?,
                number: number(item, seeds.is_some()),
                frame,
            });
        }
        Ok(Items::Own(items))
    }

    /// Returns the sensor of a unit, which is kept for the next call.
    fn unit(&self, size: ImageSize, seed: u64, device_seed: Option<u64>) -> PyResult<Arc<Sensor>> {
        let mut units = self.units.0.lock().unwrap_or_else(PoisonError::into_inner);
        let (own_size, sensors) = &mut *units;
        if *own_size != Some(size) {
            sensors.clear();
            *own_size = Some(size);
        }
        if let Some(sensor) = sensors.get(&(seed, device_seed)) {
            return Ok(Arc::clone(sensor));
        }
        let options = SensorOptions {
            seed,
            device_seed,
            ..self.source.options.clone()
        };
        let sensor = self.source.sized_with(Some(size), &options)?.sensor;
        sensors.insert((seed, device_seed), Arc::clone(&sensor));
        Ok(sensor)
    }
}

/// Reports depth that is probably in another unit, and images that were lost.
pub(super) fn notice(
    notices: &Notices,
    py: Python<'_>,
    depth: DepthSlice<'_>,
    shape: ImageShape,
    out: &OutSlice<'_>,
    has_rgb: bool,
) -> PyResult<()> {
    let pixels = shape.pixels();
    let lost = out.first_empty(shape.count());
    let image = depth.part(lost.unwrap_or(0) * pixels, pixels);
    notice_image(notices, py, image, lost.is_some(), has_rgb)
}

/// Reports an image that is probably in another unit, or that was lost.
pub(super) fn notice_image(
    notices: &Notices,
    py: Python<'_>,
    depth: DepthSlice<'_>,
    is_lost: bool,
    has_rgb: bool,
) -> PyResult<()> {
    let unit = match depth {
        DepthSlice::Metres(_) => DepthUnit::Metres,
        DepthSlice::Millimetres(_) => DepthUnit::Millimetres,
    };
    if let Some(finding) = sensing::check_unit(&depth.sampled(), unit) {
        return notices.notice(py, Some(finding));
    }
    if is_lost {
        return notices.notice(py, sensing::check_measured(&depth.metres(), &[], has_rgb));
    }
    Ok(())
}

/// The number of an item for its noise. An item with its own seed is the only image of its sensor.
pub(super) fn number(item: usize, has_own_seed: bool) -> u32 {
    if has_own_seed {
        0
    } else {
        u32::try_from(item).unwrap_or(u32::MAX)
    }
}

/// Reads a number, such as a seed, for each item of a batch.
pub(super) fn numbers_of(name: &str, numbers: &Bound<'_, PyAny>, count: usize) -> PyResult<Vec<u64>> {
    let numbers: Vec<u64> = numbers
        .try_iter()
        .and_then(|all| all.map(|one| one?.extract()).collect())
        .map_err(|_| mistyped(name, numbers, "a sequence of whole numbers from 0 to 2**64 - 1"))?;
    if numbers.len() == count {
        return Ok(numbers);
    }
    let is = format!("has {} numbers for {count} images", numbers.len());
    Err(wrong(name, is, "pass one for each image"))
}
