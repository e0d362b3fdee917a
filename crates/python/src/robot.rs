use std::path::{Path, PathBuf};

use oaktwin::catalog::{Catalog, Twin};
use oaktwin::robot::{self, Attachment, Format};
use pyo3::prelude::*;

use crate::choice::named;
use crate::error::{error, writing};
use crate::finding;

/// Returns the attachment that the arguments of Python describe.
pub(crate) fn attachment(
    name: &str,
    parent: Option<String>,
    mount: &str,
    (xyz, rpy): (Option<[f64; 3]>, Option<[f64; 3]>),
) -> PyResult<Attachment> {
    Ok(Attachment {
        name: name.to_owned(),
        parent,
        mount: named("mount", mount)?,
        parent_from_mount: Attachment::pose(xyz.unwrap_or_default(), rpy.unwrap_or_default())
            .map_err(error)?,
    })
}

/// Writes the description of a twin into a folder, and returns the paths of its files.
pub(crate) fn write(
    py: Python<'_>,
    (catalog, twin): (&Catalog, &Twin),
    attachment: &Attachment,
    format: Format,
    folder: &Path,
) -> PyResult<Vec<PathBuf>> {
    let made = robot::export(catalog, twin, attachment, format).map_err(error)?;
    let written = py
        .detach(|| made.write(folder))
        .map_err(|error| writing(folder, &error))?;
    finding::warn(py, &made.findings)?;
    Ok(written)
}
