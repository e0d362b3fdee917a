use std::fmt;
use std::path::PathBuf;

use oaktwin_base::diagnostic::{command, message};
use thiserror::Error;

/// An error in a TOML file: of a catalog, or of a recipe.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub struct CatalogError {
    /// The file or folder.
    pub file: PathBuf,
    /// The line, from 1, if the error is at a line.
    pub line: Option<usize>,
    /// The problem.
    pub problem: String,
    /// The remedy.
    pub remedy: String,
}

impl CatalogError {
    pub(crate) fn new(
        file: impl Into<PathBuf>,
        line: Option<usize>,
        problem: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self {
            file: file.into(),
            line,
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }
}

/// `mycam.toml:12: unknown key 'hfov_rad'; angles are in degrees here: use 'hfov_deg'`
impl fmt::Display for CatalogError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.file.display())?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        write!(f, ": {}", self.problem)?;
        if !self.remedy.is_empty() {
            write!(f, "; {}", self.remedy)?;
        }
        Ok(())
    }
}

/// An unknown model.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub struct UnknownModel {
    /// The requested name.
    pub name: String,
    /// The nearest names, best first; may be empty.
    pub nearest: Vec<String>,
}

/// `unknown model 'oak d tofu'; did you mean OAK-D ToF? 'models' lists all`, in the style of the front end.
impl fmt::Display for UnknownModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown model '{}'; ", self.name)?;
        if !self.nearest.is_empty() {
            write!(f, "did you mean {}? ", self.nearest.join(" or "))?;
        }
        write!(f, "{}", message![command("models"), " lists all"])
    }
}
