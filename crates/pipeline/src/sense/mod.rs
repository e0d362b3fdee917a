//! The sensor on depth images from anywhere: arrays, PNG, EXR, PFM, folders of Replicator's, a stream.
//!
//! [`sense`] reads images one after the other, shows them to the [sensor](crate::sensor) of a twin, and writes what that
//! reports. What is not finite and above 0 in an image is no surface; 0 in a result was not measured.
//!
//! # Frames, sequences, batches
//! The number at the end of a file's name is its frame, 0 where there is none: noise is new in every frame, and the same
//! for the same frame, whatever else is given and in whichever order. Files whose names differ in that number alone are a
//! sequence, seen in its order by filters that remember. The images of a batch `(N, H, W)` lie side by side in time, the
//! environments of a simulator: each has its number as its item, and none remembers another; as a
//! [sequence](SenseOptions::is_sequence) they are frames instead.

mod camera;
mod options;
mod picture;
mod plan;
mod rig;
mod run;
mod shot;
mod stream;

use std::io;
use std::path::PathBuf;

pub use crate::input::InputKind;
pub use camera::image_camera;
pub use oaktwin_dataset::CloudAxes;
pub use options::{AlignTo, FieldOfView, SenseOptions};
pub use plan::{STANDARD_INPUT, depth_sensor};
pub use rig::align_to;
pub use run::{Output, Sensed, sense};

use crate::sensor::ParameterError;
use oaktwin_dataset::{DatasetError, WriteError};
use oaktwin_diagnostic::Message;
use oaktwin_files::FileError;

/// What a sensor is to see.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Input {
    /// A folder in the layout of Replicator's `BasicWriter`.
    Folder {
        /// The folder.
        path: PathBuf,
        /// Where the results go, in the same layout: the folder itself, say.
        output: PathBuf,
    },
    /// A file of one image or of many.
    File {
        /// The file.
        path: PathBuf,
        /// The folder for the results.
        output: PathBuf,
        /// Its pictures: one an image, an array of as many, or none.
        rgb: Vec<PathBuf>,
    },
    /// The program's standard input, one file of any of the formats.
    StandardInput {
        /// The folder for the results; nothing is written there where the results are asked for as a stream.
        output: PathBuf,
        /// As of a file.
        rgb: Vec<PathBuf>,
    },
}

/// Why depth images could not be sensed. The files before it are whole, and stay.
#[derive(Debug, thiserror::Error)]
pub enum SenseError {
    /// A file that cannot be read, written or understood.
    #[error(transparent)]
    File(#[from] FileError),
    /// A sensor that cannot be.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// An invalid option: `OPTION: what is wrong; what to do`.
    #[error("{0}")]
    Option(Message),
    /// A frame cannot be encoded.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// The stream of results cannot be written.
    #[error(transparent)]
    Stream(io::Error),
}

impl From<WriteError> for SenseError {
    fn from(error: WriteError) -> Self {
        match error {
            WriteError::File(error) => error.into(),
            WriteError::Dataset(error) => error.into(),
            WriteError::Other(error) => Self::Stream(match error.downcast::<io::Error>() {
                Ok(error) => *error,
                Err(error) => io::Error::other(error),
            }),
        }
    }
}

impl SenseError {
    fn option(text: impl Into<Message>) -> Self {
        Self::Option(text.into())
    }
}
