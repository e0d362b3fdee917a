use std::fmt;
use std::path::PathBuf;

use thiserror::Error;

/// A catalog file that cannot be used: where, what is wrong, what to do.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub struct CatalogError {
    /// The file or folder.
    pub file: PathBuf,
    /// The line, from 1, where one is to blame.
    pub line: Option<usize>,
    /// What is wrong.
    pub problem: String,
    /// What to do about it.
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

/// A model that the catalog does not have.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub struct UnknownModel {
    /// As asked for.
    pub name: String,
    /// The names of the models most like it, best first; may be empty.
    pub nearest: Vec<String>,
    /// The names of all models.
    pub known: Vec<String>,
}

/// `unknown model 'oak d tofu'; did you mean OAK-D ToF?`
impl fmt::Display for UnknownModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown model '{}'; ", self.name)?;
        if self.nearest.is_empty() {
            write!(f, "known models: {}", self.known.join(", "))
        } else {
            write!(f, "did you mean {}?", self.nearest.join(" or "))
        }
    }
}
