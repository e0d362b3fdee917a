use std::path::PathBuf;
use std::sync::Arc;

use oaktwin::catalog::{Catalog, DepthFilter, Device};
use pyo3::exceptions::PyFileNotFoundError;
use pyo3::prelude::*;

use crate::choice::named;
use crate::error::{error, text};

/// Returns the names of all models for `Device`.
///
/// maker: only this manufacturer's, such as "Luxonis" or "Intel".
/// depth: only those with this kind of depth sensor: "stereo", "tof" or "none".
/// catalog: a folder with more models, see `Device`.
///
/// Raises oaktwin.Error for an unknown maker or kind, and for an invalid file, FileNotFoundError for a folder that does not exist.
#[pyfunction]
#[pyo3(signature = (*, maker = None, depth = None, catalog = None))]
pub(crate) fn models(
    maker: Option<&str>,
    depth: Option<&str>,
    catalog: Option<PathBuf>,
) -> PyResult<Vec<String>> {
    let catalog = Models::open(catalog)?;
    let depth = depth
        .map(|depth| named::<DepthFilter>("depth", depth))
        .transpose()?;
    let chosen = catalog.get().chosen(maker, depth).map_err(error)?;
    Ok(chosen.into_iter().map(|device| device.name.clone()).collect())
}

/// The built-in catalog, optionally with a user's folder.
#[derive(Clone, Debug)]
pub(crate) struct Models(Option<(PathBuf, Arc<Catalog>)>);

impl Models {
    pub(crate) fn open(folder: Option<PathBuf>) -> PyResult<Self> {
        let open = |folder: PathBuf| {
            let catalog = Catalog::with_dir(&folder).map_err(|cause| {
                if folder.exists() {
                    error(cause)
                } else {
                    PyFileNotFoundError::new_err(text(&cause))
                }
            })?;
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
