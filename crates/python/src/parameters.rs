use oaktwin::depth::parameters::{self as tables, Kind, Platform};
use oaktwin::depth::preset::{Preset, TIME_OF_FLIGHT_PRESETS};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyList, PyString};

use crate::choice;
use crate::error::error;
use crate::json;

/// The parameters of an engine, an imager or the filters, as dictionaries.
///
/// group: "stereo-noise", "stereo-matching", "time-of-flight", "single-view", "imager", "color-imager" or "filters".
/// platform: "rvc2" or "rvc4", whose defaults are returned.
///
/// Each dictionary has "name", "table", "type", "default" (a value of that type), "unit", "min", "max", "platform" (if the
/// parameter has an effect on one platform only), "source" and "description", and "values" if "type" is "enum".
#[pyfunction]
#[pyo3(signature = (group, *, platform = "rvc2"))]
pub(crate) fn parameters<'py>(py: Python<'py>, group: &str, platform: &str) -> PyResult<Bound<'py, PyAny>> {
    let group = tables::group(group).map_err(error)?;
    let listings = group.list(choice::named::<Platform>("platform", platform)?);
    let list = json::to_python(py, &listings)?.cast_into::<PyList>()?;
    for (entry, listing) in list.iter().zip(&listings) {
        entry.set_item("default", typed(py, listing.about.kind, &listing.default)?)?;
    }
    Ok(list.into_any())
}

/// The names of DepthAI's presets for a platform, in DepthAI's order, as `preset` accepts them.
///
/// platform: "rvc2", "rvc4" or "tof" (time of flight).
#[pyfunction]
#[pyo3(signature = (platform = "rvc2"))]
pub(crate) fn presets(platform: &str) -> PyResult<Vec<String>> {
    let all = [
        ("rvc2", Some(Platform::Rvc2)),
        ("rvc4", Some(Platform::Rvc4)),
        ("tof", None),
    ];
    let names = match choice::choose("platform", platform, &all)? {
        Some(platform) => Preset::names_on(platform),
        None => TIME_OF_FLIGHT_PRESETS.to_vec(),
    };
    // As the argument `preset` spells them.
    let spelled = |name: &str| name.to_lowercase().replace('_', "-");
    Ok(names.into_iter().map(spelled).collect())
}

/// The parameters of an engine by name, with values of their types.
pub(crate) fn by_name<'py, N: AsRef<str>>(
    py: Python<'py>,
    engine: &str,
    values: impl IntoIterator<Item = (N, String)>,
) -> PyResult<Bound<'py, PyDict>> {
    // Both platforms have these types.
    let known = tables::group(engine).map_err(error)?.list(Platform::Rvc2);
    let parameters = PyDict::new(py);
    for (name, value) in values {
        let name = name.as_ref();
        let listing = known.iter().find(|listing| listing.about.name == name);
        let kind = listing.map_or(Kind::Text(""), |listing| listing.about.kind);
        parameters.set_item(name, typed(py, kind, &value)?)?;
    }
    Ok(parameters)
}

/// Converts the text of a value to its type; text that is not of that type stays text.
fn typed<'py>(py: Python<'py>, kind: Kind, text: &str) -> PyResult<Bound<'py, PyAny>> {
    let integer = || match text.strip_prefix("0x") {
        Some(digits) => i64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    };
    let value = match kind {
        Kind::Flag => text
            .parse()
            .ok()
            .map(|flag| PyBool::new(py, flag).to_owned().into_any()),
        Kind::Integer => match integer() {
            Some(number) => Some(number.into_pyobject(py)?.into_any()),
            None => None,
        },
        Kind::Number => text
            .parse()
            .ok()
            .map(|number| PyFloat::new(py, number).into_any()),
        Kind::Choice(_) | Kind::Text(_) => None,
    };
    Ok(value.unwrap_or_else(|| PyString::new(py, text).into_any()))
}
