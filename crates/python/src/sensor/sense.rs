//! The measurement of images, and its alignment.

use std::sync::Arc;

use oaktwin::align::{self, AlignTo};
use oaktwin::camera::ImageSize;
use oaktwin::image::ImageView;
use oaktwin::sensor::{DepthShot, Sensor};
use pyo3::prelude::*;

use super::DepthSensor;
use super::many::Batch;
use super::units::notice;
use crate::align::aligned;
use crate::arguments::FrameNumber;
use crate::engine::away;
use crate::error::{error, wrong};
use crate::images::{Depth, DepthSlice, Out, OutSlice, Pictures};
use crate::threads;

impl DepthSensor {
    /// Measures a depth image or a batch.
    pub(super) fn measured<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
        frame: Option<FrameNumber>,
        (seed, device_seed): (Option<&Bound<'py, PyAny>>, Option<&Bound<'py, PyAny>>),
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (depth, shape) = Depth::read("depth", depth)?;
        self.check_measures_depth()?;
        let pictures = rgb.map(|rgb| Pictures::read(rgb, shape)).transpose()?;
        let sensor = self.of_size(py, shape.size)?;
        let (width, height) = sensor.filters().size(shape.size.width, shape.size.height);
        let out_shape = shape.sized(ImageSize::new(width, height));
        let (result, mut out) = Out::of(py, out, out_shape, &depth)?;
        let values = depth.slice()?;
        let mut room = out.slice()?;
        let frame = self.frame(frame);
        let items = self.items(shape, &sensor, frame, seed, device_seed)?;
        let rgb = pictures.as_ref().map(Pictures::rgba).transpose()?;
        let rgb = rgb.as_deref();
        if shape.batch.is_some() {
            let batch = Batch {
                items: &items,
                memory: &self.memory,
                engine: self.engine.as_ref(),
                depth: values,
                rgb,
                shape,
            };
            batch.sense(py, out_shape.pixels(), &mut room)?;
        } else {
            drop(items);
            self.image(py, sensor, values, rgb, shape.size, frame, &mut room)?;
        }
        notice(&self.notices, py, values, shape, &room, rgb.is_some())?;
        Ok(result)
    }

    /// Reprojects the outputs of the sensor to another camera.
    pub(super) fn aligned_to<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        to: &AlignTo,
        out: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (depth, shape) = Depth::read("depth", depth)?;
        let sized = self.now(py, None)?;
        let seen = sized.camera.intrinsics.size;
        let filters = sized.sensor.filters();
        // The output of a decimating sensor belongs to larger images.
        let of_images = if filters.size(seen.width, seen.height) == (shape.size.width, shape.size.height) {
            seen
        } else {
            shape.size
        };
        let sized = self.source.sized(Some(of_images))?;
        let (twin, depth_sensor) = (&self.source.twin, &self.source.depth);
        let align = align::align_to(twin, depth_sensor, &sized.sensor, &sized.camera, to, self.lens);
        let align = align.map_err(error)?;
        aligned(py, &align, &depth, shape, out)
    }

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
            let mut shot = DepthShot::new(view);
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
}
