use std::path::PathBuf;
use std::sync::Arc;

use oaktwin::catalog::{Catalog, Device};
use pyo3::prelude::*;

use crate::error::error;

/// The built-in catalog, optionally with a user's folder.
#[derive(Clone, Debug)]
pub(crate) struct Models(Option<(PathBuf, Arc<Catalog>)>);

impl Models {
    pub(crate) fn open(folder: Option<PathBuf>) -> PyResult<Self> {
        let open = |folder: PathBuf| {
            let catalog = Catalog::with_dir(&folder).map_err(error)?;
            // The absolute path, for pickles of the device.
            let folder = std::path::absolute(&folder).unwrap_or(folder);
            Ok::<_, PyErr>((folder, Arc::new(catalog)))
        };
        Ok(Self(folder.map(open).transpose()?))
    }

    pub(crate) fn get(&self) -> &Catalog {
        match &self.0 {
            Some((_, own)) => own,
            None => Catalog::builtin(),
        }
    }

    pub(crate) fn folder(&self) -> Option<&PathBuf> {
        self.0.as_ref().map(|(folder, _)| folder)
    }

    pub(crate) fn entry(&self, name: &str) -> PyResult<&Device> {
        self.get().device(name).map_err(error)
    }
}
