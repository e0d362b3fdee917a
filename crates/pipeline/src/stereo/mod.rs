//! The stereo matcher on any pair of images: files to files ([`stereo`]), or images to images ([`Matcher`]).
//!
//! Images are grey, 8 bits or 10; a picture of colours becomes its luma. They are as cameras take them ([`PairOf::Twin`] with
//! `is_raw`), and are rectified as the device does it, or they are rectified. Depth is in the rectified left image, metres, 0
//! where nothing was measured.

mod files;
mod grey;
mod matcher;
mod run;

pub use files::{PairFiles, pairs};
pub use grey::{luma, read_pair};
pub use matcher::{Matcher, PairOf, Seen};
pub use run::{Matched, StereoOptions, StereoOutput, stereo};

use std::path::Path;

use crate::pair::PairError;
use crate::sensor::ParameterError;
use oaktwin_dataset::WriteError;
use oaktwin_depth::stereo_matching;
use oaktwin_diagnostic::Finding;
use oaktwin_files::FileError;

/// Why a pair could not be matched. The files before it are whole, and stay.
#[derive(Debug, thiserror::Error)]
pub enum StereoError {
    /// A file that cannot be read, written or understood.
    #[error(transparent)]
    File(#[from] FileError),
    /// A parameter of the matcher, or of the cameras.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// Cameras that are no pair.
    #[error(transparent)]
    Cameras(#[from] PairError),
    /// Images that are not a pair.
    #[error(transparent)]
    Pair(#[from] stereo_matching::PairError),
    /// A result cannot be encoded or written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

/// Refuses a calibration that does not say how its pair is placed; `findings` are what was said when it was read.
///
/// # Errors
/// It does not.
pub fn check_calibration(path: &Path, findings: &[Finding]) -> Result<(), FileError> {
    match findings.iter().find(|finding| finding.code == "pair-nominal") {
        Some(finding) => Err(FileError::new(
            path,
            format!("{}: {}", finding.place, finding.message),
            "calibrate the stereo pair, or name a model without the file for nominal cameras",
        )),
        None => Ok(()),
    }
}
