//! Stereo matching of any pair of images: from files to files ([`stereo`]), or from images to images ([`Matcher`]).
//!
//! Images are grey with 8 or 10 bits; colour images become luma. Raw images ([`PairOf::Twin`] with `is_raw`) are rectified as on
//! the device. Depth belongs to the rectified left image, in metres, 0 where nothing was measured.

mod files;
mod grey;
mod matcher;
mod run;

pub use files::{PairFiles, pairs};
pub use grey::{luma, read_pair};
pub use matcher::{MatchedPair, Matcher, PairOf};
pub use run::{MatchingResult, StereoOptions, StereoOutput, stereo};

use std::path::Path;

use crate::pair::PairError;
use crate::sensor::ParameterError;
use oaktwin_base::diagnostic::{Finding, Message};
use oaktwin_dataset::WriteError;
use oaktwin_depth::stereo_matching;
use oaktwin_files::FileError;

/// An error while pairs are matched. Files that are complete are kept.
#[derive(Debug, thiserror::Error)]
pub enum StereoError {
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A parameter of the matcher or the cameras is invalid.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// An invalid option: `OPTION: what is wrong; what to do`.
    #[error("{0}")]
    Option(Message),
    /// The cameras are not a stereo pair.
    #[error(transparent)]
    Cameras(#[from] PairError),
    /// The images are not a pair.
    #[error(transparent)]
    Pair(#[from] stereo_matching::RectifiedPairError),
    /// A result cannot be encoded or written.
    #[error(transparent)]
    Write(#[from] WriteError),
}

/// Rejects a calibration without the extrinsics of the stereo pair; `findings` are from reading it.
///
/// # Errors
/// Returns an error if the extrinsics are missing.
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
