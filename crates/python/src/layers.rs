//! The images of a frame as arrays by the names of their annotators.

use numpy::{Element, PyArray1, PyArrayMethods};
use oaktwin::camera::ImageSize;
use oaktwin::image::Image;
use oaktwin::image::annotation::{Annotation, Annotator, Frame, Reasons};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::frames::Frames;
use crate::images::array;

/// Returns the arrays of a frame, those of its depth sensor last.
pub(crate) fn layers(py: Python<'_>, mut frame: Frame, size: ImageSize) -> PyResult<Bound<'_, PyDict>> {
    let present: Vec<Annotator> = frame.annotations().map(|(annotator, _)| annotator).collect();
    let (of_sensor, of_scene): (Vec<Annotator>, Vec<Annotator>) = present
        .into_iter()
        .partition(|annotator| annotator.is_depth_sensor());
    let of_sensor: Vec<(Annotator, Option<Annotation>)> =
        of_sensor.into_iter().map(|one| (one, frame.take(one))).collect();
    let mut frames = Frames::new(size, None);
    frames.put(py, 0, frame)?;
    let layers = frames.finish(py, &of_scene)?;
    for (annotator, data) in of_sensor {
        let Some(data) = data else { continue };
        if let Annotation::Reasons(reasons) = &data {
            layers.set_item("depth_sensor_reason_names", names(py, reasons)?)?;
        }
        if let Some(image) = sensor_array(py, data)? {
            layers.set_item(annotator.name(), image)?;
        }
    }
    Ok(layers)
}

/// The names of the codes of reasons.
pub(crate) fn names<'py>(py: Python<'py>, reasons: &Reasons) -> PyResult<Bound<'py, PyDict>> {
    let names = PyDict::new(py);
    for (code, label) in &reasons.legend {
        names.set_item(code, &label.name)?;
    }
    Ok(names)
}

/// Converts an annotation of a depth sensor to an array.
pub(crate) fn sensor_array(py: Python<'_>, annotation: Annotation) -> PyResult<Option<Bound<'_, PyAny>>> {
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
