//! What a device consists of, and units of its model.

use std::path::{Path, PathBuf};

use oaktwin::calibration::{Calibration, Raw, nominal_calibration};
use oaktwin::camera::RigidTransform;
use oaktwin::catalog;
use oaktwin::diagnostic::suggest;
use oaktwin::population::Population;
use oaktwin::render::{OakOptions, oak_cameras};
use oaktwin::unit;
use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyBytes, PyDict};

use super::Device;
use crate::camera::Camera;
use crate::error::{error, reading, wrong};
use crate::export::export;
use crate::models::Models;
use crate::settings::mistyped;

/// The name of a calibration that is not a file.
const NO_FILE: &str = "calibration";

/// Reads a calibration: a path, text, bytes, a dictionary, or a `CalibrationHandler` of `DepthAI`.
pub(super) fn calibration(object: &Bound<'_, PyAny>) -> PyResult<Raw> {
    let py = object.py();
    let dump = |content: &Bound<'_, PyAny>| -> PyResult<String> {
        let text = py.import("json")?.call_method1("dumps", (content,));
        text.map_err(|cause| {
            let is = format!("cannot be written as JSON ({cause})");
            wrong(NO_FILE, is, "pass the content of DepthAI's file")
        })?
        .extract()
    };
    let text = if object.hasattr("eepromToJson")? {
        dump(&object.call_method0("eepromToJson")?)?.into_bytes()
    } else if object.hasattr("items")? {
        dump(object)?.into_bytes()
    } else if object.is_instance_of::<PyBytes>() || object.is_instance_of::<PyByteArray>() {
        object.extract::<Vec<u8>>()?
    } else if let Ok(text) = object.extract::<String>()
        && text.trim_start().starts_with('{')
    {
        text.into_bytes()
    } else {
        let kinds = "the path, the text or the content of a calibration, or a CalibrationHandler";
        let path: PathBuf = object.extract().map_err(|_| mistyped(NO_FILE, object, kinds))?;
        let read = unit::read_calibration(&path).map_err(|error| reading(&path, &error));
        return read.map(|(raw, _, _)| raw);
    };
    Raw::parse(&text, NO_FILE).map_err(error)
}

/// Returns the entry of a model. The name of a file is none.
pub(super) fn entry<'a>(models: &'a Models, name: &str) -> PyResult<&'a catalog::Device> {
    models.get().device(name).map_err(|unknown| {
        let is_json = Path::new(name)
            .extension()
            .is_some_and(|extension| extension.eq_ignore_ascii_case("json"));
        if is_json || Path::new(name).is_file() {
            let remedy = format!("use Device.from_calibration({name:?})");
            wrong(name, "is a file, not a model", remedy)
        } else {
            error(unknown)
        }
    })
}

/// The maximum number of units of a population.
const MAX_UNITS: u64 = 10_000;

impl Device {
    /// Returns the camera of a role, prim or depth sensor.
    pub(super) fn placed(&self, name: &str) -> PyResult<Camera> {
        let names = [name.to_owned()];
        let options = OakOptions {
            cameras: &names,
            lens: self.lens,
            size: None,
        };
        let (placed, _) = oak_cameras(&self.twin, &RigidTransform::IDENTITY, &options).map_err(error)?;
        let first = placed
            .first()
            .ok_or_else(|| wrong(name, "unknown camera", "see cameras"))?;
        Ok(Camera::placed(name, first))
    }

    pub(super) fn body_from(&self, name: &str) -> PyResult<RigidTransform> {
        let twin = &self.twin;
        let mut all = vec![("body", RigidTransform::IDENTITY)];
        all.extend(twin.body_from_imu.map(|pose| ("imu", pose)));
        for camera in &twin.cameras {
            all.push((camera.spec.role.as_str(), camera.body_from_camera));
        }
        let found = all.iter().find(|(known, _)| known.eq_ignore_ascii_case(name));
        found.map(|(_, pose)| *pose).ok_or_else(|| {
            let remedy = suggest(name, all.iter().map(|(name, _)| *name));
            wrong(
                &twin.device.name,
                format_args!("unknown camera or part '{name}'"),
                remedy,
            )
        })
    }

    pub(super) fn exported<'py>(
        &self,
        py: Python<'py>,
        format: oaktwin::calibration::export::Format,
    ) -> PyResult<Bound<'py, PyDict>> {
        let part = self.models.get().inertial_part_of(&self.twin.device);
        if let Some(own) = &self.calibration {
            return export(py, &own.raw, &own.calibration, format, part);
        }
        let raw = nominal_calibration(&self.twin);
        let (calibration, _) = Calibration::from_raw(&raw).map_err(error)?;
        export(py, &raw, &calibration, format, part)
    }

    /// Returns units of the factory population.
    pub(super) fn units(&self, count: u64, seed: u64) -> PyResult<Vec<Self>> {
        if self.calibration.is_some() {
            let remedy = "create the nominal device by its model";
            return Err(wrong(self.name(), "is the device of a calibration", remedy));
        }
        if !(1..=MAX_UNITS).contains(&count) {
            let problem = format!("{count} is out of range");
            return Err(wrong("count", problem, format_args!("give 1 to {MAX_UNITS}")));
        }
        let population = Population::new(&self.twin, seed);
        let unit = |number| {
            let unit = population.unit(number);
            let mut raw = population.calibration(&unit);
            raw.name = unit.file_name();
            let path = PathBuf::from(&raw.name);
            let models = self.models.clone();
            let mut device = Self::unit(models, raw, Some(self.name()), &path, false, self.choices)?;
            device.findings.push(population.finding());
            Ok(device)
        };
        (0..count).map(unit).collect()
    }
}
