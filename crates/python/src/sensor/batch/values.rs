//! Arguments with a value for each item.

use oaktwin::camera::StereoDrift;
use oaktwin::sensor::{Scalar, SensorOptions};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use super::in_item;
use crate::device::Device;
use crate::error::{error, wrong};
use crate::sensor::DepthSensor;
use crate::sensor::sized::SensorSettings;
use crate::settings::{assignments, mistyped};

/// What differs between the items.
pub(super) struct Values {
    pub(super) seeds: Option<Vec<u64>>,
    pub(super) device_seeds: Option<Vec<u64>>,
    pub(super) parameters: Option<Assigned>,
    pub(super) drift: Option<Assigned>,
}

/// The names and values that each item has.
pub(super) type Assigned = Vec<Vec<(String, Scalar)>>;

impl Values {
    /// Returns the options of each item, or those of all if nothing differs.
    pub(super) fn options(&self, common: &SensorOptions, count: usize) -> PyResult<Vec<SensorOptions>> {
        let is_uniform = self.seeds.is_none()
            && self.device_seeds.is_none()
            && self.parameters.is_none()
            && self.drift.is_none();
        let one = |item: usize| {
            let mut options = common.clone();
            if let Some(seeds) = &self.seeds {
                options.seed = seeds[item];
            }
            if let Some(seeds) = &self.device_seeds {
                options.device_seed = Some(seeds[item]);
            }
            if let Some(parameters) = &self.parameters {
                options.parameters.extend(parameters[item].iter().cloned());
            }
            if let Some(drift) = &self.drift {
                let all = drift[item].iter().map(|(name, value)| format!("{name}={value}"));
                let text = all.collect::<Vec<_>>().join(",");
                options.drift = Some(StereoDrift::parse(&text).map_err(error)?);
            }
            Ok(options)
        };
        (0..if is_uniform { 1 } else { count }).map(one).collect()
    }
}

/// The units of a batch: devices of the sensor's model, or that of the sensor.
pub(super) fn sources(
    sensor: &DepthSensor,
    units: Option<&Bound<'_, PyAny>>,
    count: usize,
) -> PyResult<Vec<SensorSettings>> {
    let Some(units) = units else {
        return Ok(vec![sensor.source.of_twin(&sensor.source.twin)?]);
    };
    let devices: Vec<Py<Device>> = units
        .try_iter()
        .and_then(|all| all.map(|one| Ok(one?.cast_into::<Device>()?.unbind())).collect())
        .map_err(|_| mistyped("units", units, "a sequence of Devices"))?;
    if devices.len() != count {
        let is = format!("has {} devices, but the batch {count} items", devices.len());
        return Err(wrong("units", is, "pass a device for each item"));
    }
    let sources = devices.iter().enumerate().map(|(item, device)| {
        let source = sensor.source.of_twin(&device.get().twin);
        source.map_err(|error| in_item(units.py(), item, &error))
    });
    sources.collect()
}

/// The names and values of a mapping for each item. Values are one for all items, or a sequence with one for each.
pub(super) fn of_items(
    argument: &str,
    mapping: Option<&Bound<'_, PyAny>>,
    count: usize,
) -> PyResult<Option<Assigned>> {
    let Some(mapping) = mapping else {
        return Ok(None);
    };
    let py = mapping.py();
    let kinds = "a mapping from names to values, or to arrays with a value for each item";
    let pairs = mapping
        .call_method0("items")
        .map_err(|_| mistyped(argument, mapping, kinds))?;
    let mut items = vec![Vec::new(); count];
    for pair in pairs.try_iter()? {
        let (name, values): (String, Bound<'_, PyAny>) =
            pair?.extract().map_err(|_| mistyped(argument, mapping, kinds))?;
        let values = if values.hasattr("tolist")? {
            values.call_method0("tolist")?
        } else {
            values
        };
        let is_one = values.is_instance_of::<PyString>() || values.try_iter().is_err();
        let values: Vec<Bound<'_, PyAny>> = if is_one {
            vec![values; count]
        } else {
            values.try_iter()?.collect::<PyResult<_>>()?
        };
        if values.len() != count {
            let is = format!("has {} values, but the batch {count} items", values.len());
            let place = format!("{argument}[{name:?}]");
            return Err(wrong(place, is, "pass one for each item, or one for all"));
        }
        let one = PyDict::new(py);
        for (item, value) in items.iter_mut().zip(values) {
            one.set_item(&name, value)?;
            item.append(&mut assignments(argument, &one)?);
        }
    }
    Ok(Some(items))
}
