use std::sync::Arc;

use oaktwin::camera::ImageSize;
use oaktwin::image::ImageView;
use oaktwin::sensor::{Sensor, Shot};
use pyo3::prelude::*;
use rayon::prelude::*;

use super::DepthSensor;
use super::memory::Images;
use super::units::Items;
use crate::engine::away;
use crate::error::{error, wrong};
use crate::images::{DepthSlice, OutSlice, Shape, part};
use crate::threads;

/// The number of pixels of a batch between two checks for signals.
const PIXELS_AT_ONCE: usize = 1 << 23;

impl DepthSensor {
    /// Measures one image with a copy of the sensor, or with the sensor itself if it has memory.
    #[expect(clippy::too_many_arguments, reason = "an image and where it goes")]
    pub(super) fn image(
        &self,
        py: Python<'_>,
        sensor: Arc<Sensor>,
        depth: DepthSlice<'_>,
        rgb: Option<&[[u8; 4]]>,
        size: ImageSize,
        frame: u64,
        out: &mut OutSlice<'_>,
    ) -> PyResult<()> {
        let ImageSize { width, height } = size;
        if rgb.is_none() && sensor.measures_batches() {
            let mut measure = || {
                let shape = [1, height as usize, width as usize];
                let metres = depth.metres();
                out.fill(0, shape[1] * shape[2], |room| {
                    sensor.sense_batch(&metres, None, shape, frame, 0, room)
                })
            };
            // A change of threads takes longer than measuring a small image.
            let is_parallel = sensor.is_parallel(width, height);
            let measured = py.detach(|| {
                if is_parallel {
                    threads::install(measure)
                } else {
                    Ok(measure())
                }
            });
            return measured?.map_err(error);
        }
        away(py, self.engine.as_ref(), || {
            let metres = depth.metres();
            let view = ImageView::new(width, height, &metres[..])
                .ok_or_else(|| wrong("depth", "is smaller than its shape", "give whole arrays"))?;
            let mut shot = Shot::new(view);
            shot.frame = frame;
            if let Some(rgb) = rgb.and_then(|rgb| ImageView::new(width, height, rgb)) {
                shot = shot.with_rgb(rgb).map_err(error)?;
            }
            let capture = if sensor.remembers() {
                // The memory would be copied if the sensor were shared.
                drop(sensor);
                self.measure(size, |sensor, _| sensor.capture(shot, &[]))?
            } else {
                let mut sensor = Arc::unwrap_or_clone(sensor);
                threads::install(|| sensor.capture(shot, &[]))?
            };
            let distance = capture.map_err(error)?.distance;
            out.fill(0, distance.0.pixels().len(), |room| {
                room.copy_from_slice(distance.0.pixels());
                Ok(())
            })
        })
    }

    #[expect(clippy::too_many_arguments, reason = "a batch and where it goes")]
    pub(super) fn batch(
        &self,
        py: Python<'_>,
        items: &Items,
        depth: DepthSlice<'_>,
        rgb: Option<&[[u8; 4]]>,
        shape: Shape,
        frame: u64,
        out_pixels: usize,
        out: &mut OutSlice<'_>,
    ) -> PyResult<()> {
        let [count, height, width] = shape.of_batch();
        let pixels = shape.pixels();
        let at_once = (PIXELS_AT_ONCE / pixels).max(1);
        for first in (0..count).step_by(at_once) {
            py.check_signals()?;
            let many = at_once.min(count - first);
            let depth = depth.part(first * pixels, many * pixels);
            let rgb = rgb.map(|rgb| part(rgb, first * pixels, many * pixels));
            let item = u32::try_from(first).map_err(|_| {
                wrong(
                    "depth",
                    format_args!("has {count} images"),
                    "give fewer than 2^32 at once",
                )
            })?;
            if items.remember() || self.engine.is_some() {
                away(py, self.engine.as_ref(), || {
                    let metres = depth.metres();
                    let images = Images {
                        metres: &metres,
                        rgb,
                        size: shape.size,
                        frame,
                        first,
                        count: many,
                    };
                    out.fill(first * out_pixels, many * out_pixels, |room| {
                        self.memory.sense(items, &images, room)
                    })
                })?;
                continue;
            }
            threads::run(py, || {
                let metres = depth.metres();
                out.fill(first * out_pixels, many * out_pixels, |room| match items {
                    Items::Same(sensor) => {
                        sensor.sense_batch(&metres, rgb, [many, height, width], frame, item, room)
                    }
                    Items::Own(items) => {
                        let own = part(items, first, many)
                            .par_iter()
                            .zip(room.par_chunks_mut(out_pixels.max(1)));
                        own.enumerate().try_for_each(|(index, ((sensor, number), room))| {
                            let depth = part(&metres, index * pixels, pixels);
                            let rgb = rgb.map(|rgb| part(rgb, index * pixels, pixels));
                            sensor.sense_batch(depth, rgb, [1, height, width], frame, *number, room)
                        })
                    }
                })
            })?
            .map_err(error)?;
        }
        Ok(())
    }
}
