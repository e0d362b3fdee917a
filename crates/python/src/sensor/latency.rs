use oaktwin::catalog::Connection;
use oaktwin::sensor;
use pyo3::prelude::*;

use super::DepthSensor;
use crate::json;

impl DepthSensor {
    /// The latency of the device in the mode of the engine.
    pub(super) fn latency_of<'py>(
        &self,
        py: Python<'py>,
        connection: Option<Connection>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let made = self.now(py, None)?.sensor;
        let (twin, depth) = (&self.source.twin, &self.source.depth);
        let engine = made.engine().as_ref();
        json::to_python(py, &sensor::latency(twin, depth, engine, connection))
    }
}
