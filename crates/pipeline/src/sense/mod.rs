//! Simulation of the depth sensor on existing depth images: arrays, PNG, EXR, PFM, folders of Replicator, or a stream.
//!
//! [`sense`] reads the images one by one, simulates the [sensor](crate::sensor) of a twin and writes its outputs. Values of an
//! image that are not finite and above 0 are invalid; a pixel of an output is 0 where nothing was measured.
//!
//! # Frames, sequences, batches
//! The number at the end of a file's name is its frame, by default 0. Noise differs between frames and is the same for the same
//! frame, independent of the other inputs and their order. Files whose names differ in that number only are a sequence, which
//! temporal filters process in order. The images of a batch `(N, H, W)` are simultaneous, like the environments of a simulator: each
//! has its index as its item and no history; as a [sequence](SenseOptions::is_sequence) they are frames instead.

mod camera;
mod image_sensor;
mod images;
mod options;
mod picture;
mod plan;
mod plausible;
mod run;
mod shot;
mod stream;

use std::io;
use std::path::PathBuf;

pub use crate::input::InputKind;
pub use camera::image_camera;
pub use image_sensor::{ImageSensor, Measured};
pub use oaktwin_dataset::CloudAxes;
pub use options::{FieldOfView, SenseOptions};
pub use plan::STANDARD_INPUT;
pub use plausible::{DepthUnit, check_hfov, check_measured, check_unit};
pub use run::{SenseOutput, Sensed, sense};

use crate::sensor::ParameterError;
use oaktwin_base::diagnostic::Message;
use oaktwin_dataset::{DatasetError, WriteError};
use oaktwin_files::FileError;

/// An input of the depth sensor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SenseInput {
    /// A folder in the layout of Replicator's `BasicWriter`.
    Folder {
        /// The folder.
        path: PathBuf,
        /// The folder for the results, in the same layout; it may be the input folder.
        output: PathBuf,
    },
    /// A file with one image or a batch.
    File {
        /// The file.
        path: PathBuf,
        /// The folder for the results.
        output: PathBuf,
        /// The colour images: one per depth image, an array of all, or none.
        rgb: Vec<PathBuf>,
    },
    /// Standard input, one file in any of the formats.
    StandardInput {
        /// The folder for the results, unless they are written to a stream.
        output: PathBuf,
        /// The colour images, as for a file.
        rgb: Vec<PathBuf>,
    },
}

/// An error while depth images are processed. Files that are complete are kept.
#[derive(Debug, thiserror::Error)]
pub enum SenseError {
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A parameter of the sensor is invalid.
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
