use std::error::Error;

use oaktwin_files::{FileError, OutputFiles};

use crate::{BasicWriter, DatasetError, Options, Shot};

/// Writes frames in a layout of files, or into a recording.
pub trait Writer: Send {
    /// Writes one camera's frame.
    ///
    /// # Errors
    /// Returns an error if the frame cannot be encoded or a file cannot be written.
    fn write(&mut self, shot: &Shot, output: &mut OutputFiles) -> Result<(), WriteError>;

    /// Completes the files that span several frames. Files that are not completed are discarded.
    ///
    /// # Errors
    /// Returns an error if a file cannot be written.
    fn finish(&mut self, _output: &mut OutputFiles) -> Result<(), WriteError> {
        Ok(())
    }
}

/// A layout of rendered data sets.
#[derive(Debug)]
pub struct Layout {
    /// The name that a user chooses it by.
    pub name: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// Creates its writer.
    pub writer: fn(Options) -> Box<dyn Writer>,
}

/// All layouts of rendered data sets; the first is the default.
pub const LAYOUTS: &[Layout] = &[Layout {
    name: "basic",
    help: "Replicator's BasicWriter",
    writer: |options| Box::new(BasicWriter::new(options)),
}];

/// The error of a [`Writer`].
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// A file cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A frame cannot be encoded.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// Another output of the writer fails.
    #[error(transparent)]
    Other(Box<dyn Error + Send + Sync>),
}
