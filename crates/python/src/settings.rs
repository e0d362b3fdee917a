//! Conversion of Python arguments to sensor options.

use std::path::PathBuf;

use oaktwin::catalog::DepthKind;
use oaktwin::sensor::{ENGINES, ParameterFile, SensorOptions};
use oaktwin::usd::asset::IsaacVersion;
use pyo3::prelude::*;
use pyo3::types::PyBool;

use crate::choice::choose;
use crate::error::{error, reading, wrong};

pub(crate) const ISAAC: [(&str, IsaacVersion); 2] = [("5.1", IsaacVersion::V5_1), ("6", IsaacVersion::V6)];

/// Returns the value of `isaac=` for a version.
pub(crate) fn isaac_name(isaac: IsaacVersion) -> &'static str {
    let found = ISAAC.iter().find(|(_, version)| *version == isaac);
    found.map_or("5.1", |(name, _)| *name)
}

/// The options of a depth sensor.
pub(crate) struct Settings<'py> {
    pub(crate) engine: Option<&'py str>,
    pub(crate) preset: Option<String>,
    pub(crate) filters: Vec<String>,
    pub(crate) parameters: Option<Bound<'py, PyAny>>,
    pub(crate) params: Option<PathBuf>,
    pub(crate) extended_disparity: bool,
    pub(crate) isaac: &'py str,
    pub(crate) seed: u64,
    pub(crate) device_seed: Option<u64>,
    pub(crate) name: Option<String>,
}

impl Settings<'_> {
    pub(crate) fn options(self) -> PyResult<SensorOptions> {
        let mut options = SensorOptions {
            engine: self
                .engine
                .map(|name| choose("engine", name, &ENGINES.map(|kind| (kind.name, kind))))
                .transpose()?,
            preset: self.preset,
            filters: self.filters,
            parameters: match &self.parameters {
                Some(parameters) => assignments("parameters", parameters)?,
                None => Vec::new(),
            },
            extended_disparity: self.extended_disparity,
            isaac: choose("isaac", self.isaac, &ISAAC)?,
            image: None,
            name: self.name,
            seed: self.seed,
            device_seed: self.device_seed,
        };
        if let Some(path) = &self.params {
            let file = ParameterFile::read(path).map_err(|error| reading(path, &error))?;
            let applied = file.apply(&mut options);
            applied.map_err(|found| error(format!("{}: {found}", path.display())))?;
        }
        Ok(options)
    }
}

/// Converts a mapping from names to numbers, strings or booleans to the assignments of a command line.
pub(crate) fn assignments(option: &str, parameters: &Bound<'_, PyAny>) -> PyResult<Vec<(String, String)>> {
    let items = parameters
        .call_method0("items")
        .map_err(|_| wrong(option, "is no mapping", "give a dictionary from names to values"))?;
    let assignment = |item: PyResult<Bound<'_, PyAny>>| {
        let (name, value): (String, Bound<'_, PyAny>) = item?.extract()?;
        let text = value.str()?.to_string();
        let is_flag = value.is_instance_of::<PyBool>();
        Ok((name, if is_flag { text.to_lowercase() } else { text }))
    };
    items.try_iter()?.map(assignment).collect()
}

/// Parses the kind of a device's depth sensor.
pub(crate) fn kind(name: Option<&str>) -> PyResult<Option<DepthKind>> {
    let all = [DepthKind::Stereo, DepthKind::Tof].map(|kind| (kind.as_str(), kind));
    name.map(|name| choose("sensor", name, &all)).transpose()
}
