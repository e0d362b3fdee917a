use oaktwin::depth::parameters::{self as tables, Platform};
use pyo3::prelude::*;

use crate::choice;
use crate::error::error;
use crate::json;

/// The parameters of an engine, the imager or the filters, as dictionaries.
///
/// group: "stereo-noise", "stereo-matching", "time-of-flight", "single-view", "imager" or "filters".
/// platform: "rvc2" or "rvc4", whose defaults are returned.
///
/// Each dictionary has "name", "table", "type", "default" (a string), "unit", "min", "max", "platform" (if the parameter has
/// an effect on one platform only), "source" and "description", and "values" if "type" is "enum".
#[pyfunction]
#[pyo3(signature = (group, *, platform = "rvc2"))]
pub(crate) fn parameters<'py>(py: Python<'py>, group: &str, platform: &str) -> PyResult<Bound<'py, PyAny>> {
    let group = tables::group(group).map_err(error)?;
    json::to_python(py, &group.list(choice::named::<Platform>("platform", platform)?))
}
