//! The arranged scenes of a data set as USD.

use std::path::{Path, PathBuf};

use oaktwin_files::FileError;
use oaktwin_pipeline::render::{ImageFiles, usd_files};

use crate::arrange::Stage;

/// The folder of the scenes in a data set.
const FOLDER: &str = "scenes";

/// Returns the files of an arrangement relative to the data set: `scenes/NUMBER.usda`, and its images beside it, so that a data set can be
/// moved.
pub(crate) fn scene_files(stage: &Stage, number: u64) -> Result<Vec<(PathBuf, Vec<u8>)>, FileError> {
    let file = format!("{number:06}.usda");
    let files = usd_files(stage.renderer().scene(), Path::new(&file), ImageFiles::Copied)?;
    let files = files.into_iter();
    Ok(files
        .map(|(path, bytes)| (Path::new(FOLDER).join(path), bytes))
        .collect())
}
