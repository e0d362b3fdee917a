//! The state shared by all commands: the catalog, models with or without a calibration, exit codes.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use oaktwin::catalog::{Catalog, Device, Twin};
use oaktwin::diagnostic::Finding;
use oaktwin::{render, unit};

use crate::args::{ImuFrameArgs, UnitArgs};

pub(crate) type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// The result of a command that completed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    Success,
    Findings,
    Error,
    Interrupted,
}

impl Exit {
    pub(crate) const fn code(self) -> u8 {
        match self {
            Self::Success => 0,
            Self::Findings => 1,
            Self::Error => 2,
            // Refined by the number of the signal.
            Self::Interrupted => 130,
        }
    }
}

pub(crate) struct Context {
    pub(crate) catalog: Cow<'static, Catalog>,
    /// The folder of additional models.
    #[cfg_attr(
        not(feature = "generate"),
        expect(dead_code, reason = "only `generate` starts other processes")
    )]
    pub(crate) catalog_folder: Option<PathBuf>,
}

impl Context {
    pub(crate) fn new(catalog: Option<&Path>) -> Result<Self> {
        Ok(Self {
            catalog: match catalog {
                Some(folder) => Cow::Owned(Catalog::with_dir(folder)?),
                None => Cow::Borrowed(Catalog::builtin()),
            },
            catalog_folder: catalog.map(Path::to_owned),
        })
    }

    pub(crate) fn device(&self, name: &str) -> Result<&Device> {
        Ok(self.catalog.device(name)?)
    }

    /// Returns the named models; by default the parameter sheet's and the user's.
    pub(crate) fn devices(&self, names: &[String]) -> Result<Vec<&Device>> {
        if names.is_empty() {
            let is_builtin =
                |device: &Device| Catalog::builtin().devices().iter().any(|own| own.id == device.id);
            let own = self.catalog.devices().iter().filter(|device| !is_builtin(device));
            return Ok(self.catalog.sheet().chain(own).collect());
        }
        names.iter().map(|name| self.device(name)).collect()
    }

    /// Returns the twin of a model or, with a calibration, of one unit, and the calibration's findings.
    pub(crate) fn twin(&self, model: &str, unit: &UnitArgs) -> Result<(Twin, Vec<Finding>)> {
        self.twin_with_axes(model, unit, &ImuFrameArgs { imu_frame: None })
    }

    /// Returns [`Self::twin`] with the axes of its inertial unit from a source.
    pub(crate) fn twin_with_axes(
        &self,
        model: &str,
        unit: &UnitArgs,
        axes: &ImuFrameArgs,
    ) -> Result<(Twin, Vec<Finding>)> {
        let own = self.device(model)?;
        let device = &own.with_imu_frame(axes.imu_frame.unwrap_or_default());
        let (twin, mut findings) = match &unit.calibration {
            Some(path) => unit::open(&self.catalog, device, path, unit.force)?,
            None => (self.catalog.nominal(device), Vec::new()),
        };
        findings.extend(own.stand_in(model));
        if axes.imu_frame.is_some() {
            findings.extend(unit::imu_frame_without_effect(&self.catalog, device, &twin));
        }
        render::check_lens(&twin, unit.lens)?;
        Ok((twin, findings))
    }
}
