//! The measurement of many images, each with the sensor of its item.

use std::sync::Arc;

use oaktwin::image::Image;
use oaktwin::image::annotation::Annotator;
use oaktwin::sensor::Capture;
use pyo3::prelude::*;
use rayon::prelude::*;

use super::items::{Images, Items};
use super::memory::Memory;
use crate::engine::{PythonEngine, away};
use crate::error::{error, wrong};
use crate::images::{DepthSlice, ImageShape, OutSlice, part};
use crate::threads;

/// The number of pixels of a batch between two checks for signals.
const PIXELS_AT_ONCE: usize = 1 << 23;

/// What measures the images of a batch.
#[derive(Clone, Copy)]
pub(super) struct Batch<'a> {
    pub(super) items: &'a Items,
    pub(super) memory: &'a Memory,
    /// The engine, if it is written in Python.
    pub(super) engine: Option<&'a Arc<PythonEngine>>,
    pub(super) depth: DepthSlice<'a>,
    pub(super) rgb: Option<&'a [[u8; 4]]>,
    pub(super) shape: ImageShape,
}

impl Batch<'_> {
    /// Measures the images, each with `out_pixels` pixels.
    pub(super) fn sense(&self, py: Python<'_>, out_pixels: usize, out: &mut OutSlice<'_>) -> PyResult<()> {
        let [_, height, width] = self.shape.of_batch();
        let is_captured = self.items.remember() || self.engine.is_some();
        self.in_parts(py, |first, count, depth, rgb| {
            if is_captured {
                return away(py, self.engine, || {
                    let metres = depth.metres();
                    let images = self.images(&metres, rgb, first, count);
                    out.fill(first * out_pixels, count * out_pixels, |room| {
                        let rooms = room.chunks_mut(out_pixels.max(1)).collect();
                        self.memory
                            .capture(self.items, &images, &[], rooms, |captured, room| {
                                copy(&captured.distance.0, room);
                            })
                    })
                });
            }
            let measured = threads::run(py, || {
                let metres = depth.metres();
                out.fill(first * out_pixels, count * out_pixels, |room| match self.items {
                    Items::Same { sensor, frame } => {
                        // The number of images fits; see `in_parts`.
                        let item = u32::try_from(first).unwrap_or(u32::MAX);
                        sensor.sense_batch(&metres, rgb, [count, height, width], *frame, item, room)
                    }
                    Items::Own(items) => {
                        let pixels = self.shape.pixels();
                        let own = part(items, first, count)
                            .par_iter()
                            .zip(room.par_chunks_mut(out_pixels.max(1)));
                        own.enumerate().try_for_each(|(index, (item, room))| {
                            let depth = part(&metres, index * pixels, pixels);
                            let rgb = rgb.map(|rgb| part(rgb, index * pixels, pixels));
                            let shape = [1, height, width];
                            item.sensor
                                .sense_batch(depth, rgb, shape, item.frame, item.number, room)
                        })
                    }
                })
            })?;
            measured.map_err(error)
        })
    }

    /// Measures the images with further outputs, and hands each capture over with its place.
    pub(super) fn capture<P: Send>(
        &self,
        py: Python<'_>,
        layers: &[Annotator],
        places: Vec<P>,
        take: impl Fn(Capture, P) + Sync,
    ) -> PyResult<()> {
        let mut places = places.into_iter();
        self.in_parts(py, |first, count, depth, rgb| {
            let places = places.by_ref().take(count).collect();
            away(py, self.engine, || {
                let metres = depth.metres();
                let images = self.images(&metres, rgb, first, count);
                self.memory.capture(self.items, &images, layers, places, &take)
            })
        })
    }

    fn images<'b>(
        &self,
        metres: &'b [f32],
        rgb: Option<&'b [[u8; 4]]>,
        first: usize,
        count: usize,
    ) -> Images<'b> {
        Images {
            metres,
            rgb,
            shape: self.shape,
            first,
            count,
        }
    }

    /// Works through the images in parts, between which signals are handled: the first image, the count, their depth and colours.
    fn in_parts(
        &self,
        py: Python<'_>,
        mut work: impl FnMut(usize, usize, DepthSlice<'_>, Option<&[[u8; 4]]>) -> PyResult<()>,
    ) -> PyResult<()> {
        let (count, pixels) = (self.shape.count(), self.shape.pixels());
        if u32::try_from(count).is_err() {
            let is = format_args!("has {count} images");
            return Err(wrong("depth", is, "give fewer than 2^32 at once"));
        }
        let at_once = (PIXELS_AT_ONCE / pixels.max(1)).max(1);
        for first in (0..count).step_by(at_once) {
            py.check_signals()?;
            let many = at_once.min(count - first);
            let depth = self.depth.part(first * pixels, many * pixels);
            let rgb = self.rgb.map(|rgb| part(rgb, first * pixels, many * pixels));
            work(first, many, depth, rgb)?;
        }
        Ok(())
    }
}

/// Copies an image to its place.
pub(super) fn copy<T: Copy>(image: &Image<T>, room: &mut [T]) {
    if image.pixels().len() == room.len() {
        room.copy_from_slice(image.pixels());
    }
}
