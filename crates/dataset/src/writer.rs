use std::error::Error;

use oaktwin_base::diagnostic::Finding;
use oaktwin_files::{FileError, OutputFiles};
use serde_json::Value;

use crate::{DatasetError, Shot};

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

    /// Returns the findings about the frames, once they are complete.
    fn findings(&mut self) -> Vec<Finding> {
        Vec::new()
    }
}

/// A format of data sets whose frames are made in any order, by any number of processes.
///
/// The files of one frame depend on that frame only. The files that describe several frames are made of the records of all frames
/// at the end, so that a data set can be interrupted, resumed and extended.
pub trait Format: Send + Sync {
    /// Writes the files of a camera's frame, and returns what the files of the whole data set need to know about it: `null` if
    /// that is nothing.
    ///
    /// # Errors
    /// Returns an error if the frame lacks something that the format requires, or if a file cannot be written.
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError>;

    /// Writes the files of the whole data set, and returns findings about it. The records describe all frames, by frame and
    /// camera.
    ///
    /// # Errors
    /// Returns an error if a record or a file cannot be read or written.
    fn finish(&self, records: &mut Records<'_>, output: &mut OutputFiles)
    -> Result<Vec<Finding>, WriteError>;
}

/// The records of all frames, in order.
pub type Records<'a> = dyn Iterator<Item = Result<Value, WriteError>> + 'a;

/// Writes frames in a [`Format`]: a whole data set in one process.
#[expect(missing_debug_implementations, reason = "formats have none")]
pub struct FormatWriter {
    format: Box<dyn Format>,
    records: Vec<Value>,
    findings: Vec<Finding>,
}

impl FormatWriter {
    /// Creates a writer.
    #[must_use]
    pub fn new(format: Box<dyn Format>) -> Self {
        Self {
            format,
            records: Vec::new(),
            findings: Vec::new(),
        }
    }
}

impl Writer for FormatWriter {
    fn write(&mut self, shot: &Shot, output: &mut OutputFiles) -> Result<(), WriteError> {
        let record = self.format.frame(shot, output)?;
        self.records.push(record);
        Ok(())
    }

    fn finish(&mut self, output: &mut OutputFiles) -> Result<(), WriteError> {
        let mut records = std::mem::take(&mut self.records).into_iter().map(Ok);
        self.findings = self.format.finish(&mut records, output)?;
        for packed in output.take_packed() {
            packed.remove_members()?;
            packed.members.iter().for_each(|member| output.forget(member));
        }
        Ok(())
    }

    fn findings(&mut self) -> Vec<Finding> {
        std::mem::take(&mut self.findings)
    }
}

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
