//! The argument `device`.

use pyo3::prelude::*;

use super::Device;
use crate::settings::mistyped;

/// Reads `device`, for which a name is a usual mistake.
pub(crate) fn required<'py>(object: &Bound<'py, PyAny>) -> PyResult<Bound<'py, Device>> {
    object.cast().cloned().map_err(|_| {
        let model = object.extract::<String>();
        let model = model.as_deref().unwrap_or("OAK4-D");
        mistyped("device", object, &format!("oaktwin.Device(\"{model}\")"))
    })
}

/// Reads `device`, or None.
pub(crate) fn optional<'py>(object: &Bound<'py, PyAny>) -> PyResult<Option<Bound<'py, Device>>> {
    (!object.is_none()).then(|| required(object)).transpose()
}
