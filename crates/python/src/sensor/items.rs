//! The images of a batch, and the sensor of each.

use std::sync::Arc;

use oaktwin::image::ImageView;
use oaktwin::sensor::{DepthShot, Sensor};
use pyo3::prelude::*;

use crate::error::{error, wrong};
use crate::images::{ImageShape, part};

/// One of the images that are measured together.
pub(super) struct Item {
    pub(super) sensor: Arc<Sensor>,
    /// Its number for the noise.
    pub(super) number: u32,
    /// The number of its frame.
    pub(super) frame: u64,
}

/// The items of a batch.
pub(super) enum Items {
    /// All with one sensor.
    Same { sensor: Arc<Sensor>, frame: u64 },
    /// Each with its own sensor.
    Own(Vec<Item>),
}

impl Items {
    /// The sensor of an item, its number and its frame.
    pub(super) fn of(&self, item: usize) -> Option<(&Sensor, u32, u64)> {
        match self {
            Self::Same { sensor, frame } => Some((sensor, u32::try_from(item).unwrap_or(u32::MAX), *frame)),
            Self::Own(items) => items.get(item).map(|own| (&*own.sensor, own.number, own.frame)),
        }
    }

    /// Whether the sensors have temporal filters.
    pub(super) fn remember(&self) -> bool {
        self.of(0).is_some_and(|(sensor, ..)| sensor.remembers())
    }
}

/// Some images of a batch, one after the other.
pub(super) struct Images<'a> {
    pub(super) metres: &'a [f32],
    pub(super) rgb: Option<&'a [[u8; 4]]>,
    pub(super) shape: ImageShape,
    /// The number of the first one in the batch, and how many there are.
    pub(super) first: usize,
    pub(super) count: usize,
}

impl Images<'_> {
    /// The shot of an item by its number among these images.
    pub(super) fn shot(&self, index: usize, item: u32, frame: u64) -> PyResult<DepthShot<'_>> {
        let (pixels, size) = (self.shape.pixels(), self.shape.size);
        let depth = ImageView::new(size.width, size.height, part(self.metres, index * pixels, pixels))
            .ok_or_else(|| wrong("depth", "is smaller than its shape", "give whole arrays"))?;
        let mut shot = DepthShot::new(depth);
        let rgb = self.rgb.map(|rgb| part(rgb, index * pixels, pixels));
        if let Some(rgb) = rgb.and_then(|rgb| ImageView::new(size.width, size.height, rgb)) {
            shot = shot.with_rgb(rgb).map_err(error)?;
        }
        (shot.frame, shot.item) = (frame, item);
        Ok(shot)
    }
}
