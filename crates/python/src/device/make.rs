//! Makes devices, from models, calibrations and pickles.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use oaktwin::calibration::{Calibration, Raw};
use oaktwin::catalog::{ImuFrame, Twin};
use oaktwin::diagnostic;
use oaktwin::render::check_lens;
use oaktwin::unit;
use oaktwin::usd::asset::LensChoice;
use pyo3::prelude::*;

use super::Device;
use crate::choice::named;
use crate::error::{error, wrong};
use crate::models::Models;

#[derive(Debug)]
pub(super) struct Calibrated {
    pub(super) raw: Raw,
    pub(super) calibration: Calibration,
    pub(super) force: bool,
}

/// What a calibration does not determine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Choices {
    pub(super) lens: LensChoice,
    pub(super) imu_frame: ImuFrame,
}

impl Choices {
    pub(super) fn new(lens: &str, imu_frame: &str) -> PyResult<Self> {
        Ok(Self {
            lens: named("lens", lens)?,
            imu_frame: named("imu_frame", imu_frame)?,
        })
    }
}

impl Device {
    pub(super) fn new(
        twin: Twin,
        choices: Choices,
        models: Models,
        calibration: Option<Calibrated>,
        findings: Vec<diagnostic::Finding>,
    ) -> PyResult<Self> {
        let Choices { lens, imu_frame } = choices;
        check_lens(&twin, lens).map_err(error)?;
        Ok(Self {
            twin: Arc::new(twin),
            lens,
            imu_frame,
            models,
            calibration,
            findings,
        })
    }

    /// Creates the twin of a calibrated unit.
    pub(super) fn unit(
        models: Models,
        raw: Raw,
        model: Option<&str>,
        path: &Path,
        force: bool,
        choices: Choices,
    ) -> PyResult<Self> {
        let (calibration, _) = Calibration::from_raw(&raw).map_err(error)?;
        let device = match model {
            Some(model) => models.entry(model)?,
            None => {
                let board = &calibration.board;
                let device = models
                    .get()
                    .device_of_unit(&board.product_name, &board.board_name);
                device.map_err(|unknown| {
                    let place = format!("{}: productName", path.display());
                    wrong(place, unknown, "pass model=")
                })?
            }
        };
        let device = &device.with_imu_frame(choices.imu_frame);
        let (twin, mut findings) = unit::of_raw(models.get(), device, &raw, path, force).map_err(error)?;
        if choices.imu_frame != ImuFrame::default() {
            findings.extend(unit::imu_frame_without_effect(models.get(), device, &twin));
        }
        let calibrated = Calibrated {
            raw,
            calibration,
            force,
        };
        Self::new(twin, choices, models, Some(calibrated), findings)
    }
}

/// Restores the device of a pickle, which contains the text of the calibration.
#[pyfunction]
pub(crate) fn _device(
    py: Python<'_>,
    model: &str,
    choices: (String, String),
    catalog: Option<PathBuf>,
    calibration: Option<(String, String, bool)>,
) -> PyResult<Device> {
    let (lens, imu_frame) = choices;
    let Some((name, text, force)) = calibration else {
        return Device::py_new(py, model, &lens, &imu_frame, catalog);
    };
    let raw = Raw::parse(text.as_bytes(), &name).map_err(error)?;
    Device::unit(
        Models::open(catalog)?,
        raw,
        Some(model),
        Path::new(&name),
        force,
        Choices::new(&lens, &imu_frame)?,
    )
}
