//! What Isaac Sim's annotators of the depth sensor are in Python.

use numpy::{Element, PyArray1, PyArrayMethods};
use oaktwin::image::Image;
use oaktwin::image::annotation::{Annotator, Frame};
use oaktwin::render::annotator;
use pyo3::prelude::*;

use crate::error::{error, wrong};
use crate::images::array;

/// One that a depth sensor has something to say to.
pub(super) fn sensor_annotator(name: &str) -> PyResult<Annotator> {
    let found = annotator(name).map_err(error)?;
    if found.is_of_depth_sensor() {
        return Ok(found);
    }
    let remedy = "render the scene with it";
    Err(wrong(name, "is no annotator of a depth sensor", remedy))
}

/// What was sensed for an annotator, as an array.
pub(super) fn sensed<'py>(
    py: Python<'py>,
    annotator: Annotator,
    frame: &mut Frame,
) -> PyResult<Option<Bound<'py, PyAny>>> {
    Ok(match annotator {
        Annotator::DepthSensorDistance => {
            let image = frame.depth_sensor_distance.take();
            image.map(|image| array(py, image.0)).transpose()?
        }
        Annotator::DepthSensorImager => {
            let image = frame.depth_sensor_imager.take();
            image.map(|image| array(py, image)).transpose()?
        }
        Annotator::DepthSensorPointCloudPosition => {
            let image = frame.depth_sensor_point_cloud_position.take();
            image.map(|image| colours(py, image)).transpose()?
        }
        Annotator::DepthSensorPointCloudColor => {
            let image = frame.depth_sensor_point_cloud_color.take();
            image.map(|image| colours(py, image)).transpose()?
        }
        Annotator::DepthSensorOutputVisualization => {
            let image = frame.depth_sensor_output_visualization.take();
            image.map(|image| colours(py, image)).transpose()?
        }
        _ => None,
    })
}

fn colours<T: Element>(py: Python<'_>, image: Image<[T; 4]>) -> PyResult<Bound<'_, PyAny>> {
    let dims = [image.height() as usize, image.width() as usize, 4];
    let values = image.into_pixels().into_flattened();
    Ok(PyArray1::from_vec(py, values).reshape(dims)?.into_any())
}
