//! Isaac Sim's annotators of the depth sensor as NumPy arrays.

use oaktwin::image::annotation::{Annotation, Annotator, Frame};
use oaktwin::render::{annotator, sense_frame};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use super::DepthSensor;
use super::units::notice_image;
use crate::arguments::{Annotators, FrameNumber};
use crate::engine::away;
use crate::error::{error, wrong};
use crate::images::{Depth, exact};
use crate::layers::{names, sensor_array};

impl DepthSensor {
    /// The outputs of annotators for one image.
    pub(super) fn annotated<'py>(
        &self,
        py: Python<'py>,
        depth: &Bound<'py, PyAny>,
        rgb: Option<&Bound<'py, PyAny>>,
        annotators: &Annotators,
        frame: Option<FrameNumber>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let asked = annotators.0.iter().map(|name| sensor_annotator(name));
        let asked = asked.collect::<PyResult<Vec<_>>>()?;
        let (depth, shape) = Depth::read("depth", depth)?;
        self.check_measures_depth()?;
        if shape.batch.is_some() {
            return Err(wrong("depth", "is a batch", "give one image (H, W)"));
        }
        let (distance_to_image_plane, colors) = exact(&depth, rgb, shape)?;
        let mut seen = Frame {
            distance_to_image_plane,
            rgb: colors,
            ..Frame::default()
        };
        let frame = self.frame(frame);
        away(py, self.engine.as_ref(), || {
            let missing = self.measure(shape.size, |sensor, camera| {
                sense_frame(sensor, camera, frame, None, &asked, &mut seen)
            });
            // What is missing is reported below.
            missing?.map(drop).map_err(error)
        })?;
        let distance = seen.depth_sensor_distance.as_ref();
        let is_lost = distance.is_some_and(|z| z.0.pixels().iter().all(|metres| *metres == 0.0));
        notice_image(&self.notices, py, depth.slice()?, is_lost, rgb.is_some())?;
        let all = PyDict::new(py);
        for annotator in asked {
            let data = seen.take(annotator).ok_or_else(|| not_made(annotator))?;
            if let Annotation::Reasons(reasons) = &data {
                all.set_item("depth_sensor_reason_names", names(py, reasons)?)?;
            }
            let image = sensor_array(py, data)?.ok_or_else(|| not_made(annotator))?;
            all.set_item(annotator.name(), image)?;
        }
        Ok(all)
    }
}

pub(super) fn not_made(annotator: Annotator) -> PyErr {
    let remedy = "give rgb=, or use the engine single-view";
    wrong(annotator.name(), "is not made of what was given", remedy)
}

/// Returns the depth sensor annotator with a name.
pub(super) fn sensor_annotator(name: &str) -> PyResult<Annotator> {
    let found = annotator(name).map_err(error)?;
    if found.is_depth_sensor() {
        return Ok(found);
    }
    let remedy = "render the scene with it";
    Err(wrong(name, "is not an annotator of a depth sensor", remedy))
}
