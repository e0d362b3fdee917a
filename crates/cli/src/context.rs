//! The context of every command: the catalog, a model with or without a calibration, and exit codes.

use std::borrow::Cow;
use std::path::Path;

use oaktwin::catalog::{Catalog, Device, Twin};
use oaktwin::diagnostic::Finding;
use oaktwin::{render, unit};

use crate::args::UnitArgs;

pub(crate) type Result<T> = std::result::Result<T, Box<dyn std::error::Error>>;

/// The exit status of a command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    Good,
    Findings,
    Error,
    Interrupted,
}

impl Exit {
    pub(crate) const fn code(self) -> u8 {
        match self {
            Self::Good => 0,
            Self::Findings => 1,
            Self::Error => 2,
            // The code of a program that Ctrl-C ended, as in a shell.
            Self::Interrupted => 130,
        }
    }
}

pub(crate) struct Context {
    pub(crate) catalog: Cow<'static, Catalog>,
}

impl Context {
    pub(crate) fn new(catalog: Option<&Path>) -> Result<Self> {
        Ok(Self {
            catalog: match catalog {
                Some(folder) => Cow::Owned(Catalog::with_dir(folder)?),
                None => Cow::Borrowed(Catalog::builtin()),
            },
        })
    }

    pub(crate) fn device(&self, name: &str) -> Result<&Device> {
        Ok(self.catalog.device(name)?)
    }

    /// The named models, or all if none is named.
    pub(crate) fn devices(&self, names: &[String]) -> Result<Vec<&Device>> {
        if names.is_empty() {
            return Ok(self.catalog.devices().iter().collect());
        }
        names.iter().map(|name| self.device(name)).collect()
    }

    /// The twin of a model, or of a unit with a calibration; the findings are the calibration's.
    pub(crate) fn twin(&self, model: &str, unit: &UnitArgs) -> Result<(Twin, Vec<Finding>)> {
        let device = self.device(model)?;
        let (twin, findings) = match &unit.calibration {
            Some(path) => unit::open(&self.catalog, device, path, unit.force)?,
            None => (self.catalog.nominal(device), Vec::new()),
        };
        render::check_lens(&twin, unit.lens.into())?;
        Ok((twin, findings))
    }
}
