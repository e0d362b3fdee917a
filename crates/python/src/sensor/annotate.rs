//! Isaac Sim's annotators of the depth sensor as NumPy arrays.

use numpy::{Element, PyArray1, PyArrayMethods};
use oaktwin::image::Image;
use oaktwin::image::annotation::{Annotation, Annotator};
use oaktwin::render::annotator;
use pyo3::prelude::*;

use crate::error::{error, wrong};
use crate::images::array;

/// Returns the depth sensor annotator with a name.
pub(super) fn sensor_annotator(name: &str) -> PyResult<Annotator> {
    let found = annotator(name).map_err(error)?;
    if found.is_depth_sensor() {
        return Ok(found);
    }
    let remedy = "render the scene with it";
    Err(wrong(name, "is not an annotator of a depth sensor", remedy))
}

/// Converts an annotation of a depth sensor to an array.
pub(super) fn sensor_array(py: Python<'_>, annotation: Annotation) -> PyResult<Option<Bound<'_, PyAny>>> {
    match annotation {
        Annotation::ZDepth(image) => array(py, image.0).map(Some),
        Annotation::Scalar(image) => array(py, image).map(Some),
        Annotation::Levels(image) => array(py, image).map(Some),
        Annotation::Reasons(reasons) => array(py, reasons.codes).map(Some),
        Annotation::PixelPoints(image) => vectors(py, image).map(Some),
        Annotation::Color(image) | Annotation::PixelColors(image) => vectors(py, image).map(Some),
        _ => Ok(None),
    }
}

fn vectors<T: Element>(py: Python<'_>, image: Image<[T; 4]>) -> PyResult<Bound<'_, PyAny>> {
    let dims = [image.height() as usize, image.width() as usize, 4];
    let values = image.into_pixels().into_flattened();
    Ok(PyArray1::from_vec(py, values).reshape(dims)?.into_any())
}
