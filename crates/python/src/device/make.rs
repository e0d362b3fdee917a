//! Makes devices, from models, calibrations and pickles.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use oaktwin::calibration::{Calibration, Raw, Socket};
use oaktwin::catalog::{ImuFrame, Twin};
use oaktwin::depth::preset::Platform;
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
    /// Whether the calibration is of a rig.
    pub(super) is_rig: bool,
}

/// What a calibration does not determine.
#[derive(Clone, Copy, Debug)]
pub(super) struct Choices {
    pub(super) lens: LensChoice,
    pub(super) imu_frame: ImuFrame,
    /// The pair of a rig, which is of no model, and its processor.
    pub(super) pair: Option<(Socket, Socket)>,
    pub(super) platform: Option<Platform>,
}

impl Choices {
    pub(super) fn new(lens: &str, imu_frame: &str) -> PyResult<Self> {
        Ok(Self {
            lens: named("lens", lens)?,
            imu_frame: named("imu_frame", imu_frame)?,
            pair: None,
            platform: None,
        })
    }

    /// The choices for a rig: the names of its sockets and of its processor.
    pub(super) fn with_rig(self, pair: Option<(String, String)>, platform: Option<&str>) -> PyResult<Self> {
        let socket = |name: String| {
            Socket::from_name(&name).ok_or_else(|| {
                wrong(
                    "pair",
                    format_args!("'{name}' is not a socket"),
                    "pass names such as CAM_B",
                )
            })
        };
        let pair = pair.map(|(left, right)| Ok::<_, PyErr>((socket(left)?, socket(right)?)));
        Ok(Self {
            pair: pair.transpose()?,
            platform: platform.map(|name| named("platform", name)).transpose()?,
            ..self
        })
    }

    /// As the arguments of a pickle.
    pub(super) fn names(&self) -> ChoiceNames {
        let pair = self
            .pair
            .map(|(left, right)| (left.to_string(), right.to_string()));
        let platform = self.platform.map(|platform| platform.name().to_owned());
        let (lens, imu_frame) = (self.lens.name(), self.imu_frame.name());
        (lens.to_owned(), imu_frame.to_owned(), pair, platform)
    }
}

/// The lens, the frame of the inertial unit, and the pair and the processor of a rig.
pub(super) type ChoiceNames = (String, String, Option<(String, String)>, Option<String>);

impl Device {
    pub(super) fn new(
        twin: Twin,
        choices: Choices,
        models: Models,
        calibration: Option<Calibrated>,
        findings: Vec<diagnostic::Finding>,
    ) -> PyResult<Self> {
        check_lens(&twin, choices.lens).map_err(error)?;
        Ok(Self {
            twin: Arc::new(twin),
            lens: choices.lens,
            choices,
            models,
            calibration,
            findings,
        })
    }

    /// Creates the twin of a calibrated unit, or of a rig: of a calibration of no model, or whose pair is named.
    pub(super) fn unit(
        models: Models,
        raw: Raw,
        model: Option<&str>,
        path: &Path,
        force: bool,
        choices: Choices,
    ) -> PyResult<Self> {
        let (calibration, _) = Calibration::from_raw(&raw).map_err(error)?;
        let board = &calibration.board;
        let known = match (model, choices.pair) {
            (Some(_), Some(_)) => {
                let is = "is for rigs, which are of no model";
                return Err(wrong("pair", is, "omit model, or the pair"));
            }
            (Some(model), None) => Ok(models.entry(model)?),
            (None, _) => models
                .get()
                .device_of_unit(&board.product_name, &board.board_name),
        };
        let is_rig = choices.pair.is_some() || known.is_err();
        let (twin, findings) = match known {
            Ok(device) if !is_rig => {
                if choices.platform.is_some() {
                    let is = "is for rigs, which are of no model";
                    return Err(wrong("platform", is, "omit it; a model has its own"));
                }
                let device = &device.with_imu_frame(choices.imu_frame);
                let made = unit::of_raw(models.get(), device, &raw, path, force);
                let (twin, mut findings) = made.map_err(error)?;
                if choices.imu_frame != ImuFrame::default() {
                    findings.extend(unit::imu_frame_without_effect(models.get(), device, &twin));
                }
                (twin, findings)
            }
            known => {
                unit::rig_of_raw(&raw, path, choices.pair, choices.platform, known, force).map_err(error)?
            }
        };
        let calibrated = Calibrated {
            raw,
            calibration,
            force,
            is_rig,
        };
        Self::new(twin, choices, models, Some(calibrated), findings)
    }
}

/// Restores the device of a pickle, which contains the text of the calibration.
#[pyfunction]
pub(crate) fn _device(
    py: Python<'_>,
    model: Option<&str>,
    choices: ChoiceNames,
    catalog: Option<PathBuf>,
    calibration: Option<(String, String, bool)>,
) -> PyResult<Device> {
    let (lens, imu_frame, pair, platform) = choices;
    let Some((name, text, force)) = calibration else {
        return Device::py_new(py, model.unwrap_or_default(), &lens, &imu_frame, catalog);
    };
    let raw = Raw::parse(text.as_bytes(), &name).map_err(error)?;
    Device::unit(
        Models::open(catalog)?,
        raw,
        model,
        Path::new(&name),
        force,
        Choices::new(&lens, &imu_frame)?.with_rig(pair, platform.as_deref())?,
    )
}
