use std::fmt;

use oaktwin_image::CodecError;

/// A file that cannot be made.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DatasetError {
    /// Its format cannot hold the image.
    #[error("{path}: {source}")]
    Codec {
        /// The file, relative to the data set.
        path: String,
        /// What is wrong.
        source: CodecError,
    },
    /// Ids do not fit in the 16 bits of a grey PNG.
    #[error(
        "{path}: the id {id} does not fit in 16 bits; leave the segmentation colorized, which holds any number of ids"
    )]
    IdTooLarge {
        /// The file, relative to the data set.
        path: String,
        /// The first such id.
        id: u32,
    },
}

/// What can go wrong within a file, before its name is known.
pub(crate) enum Fault {
    Codec(CodecError),
    IdTooLarge(u32),
}

impl From<CodecError> for Fault {
    fn from(error: CodecError) -> Self {
        Self::Codec(error)
    }
}

type Encode<'a> = dyn Fn() -> Result<Vec<u8>, Fault> + Send + Sync + 'a;

/// One file of a data set, not encoded yet.
pub struct DatasetFile<'a> {
    path: String,
    encode: Box<Encode<'a>>,
}

impl<'a> DatasetFile<'a> {
    pub(crate) fn new(path: String, encode: impl Fn() -> Result<Vec<u8>, Fault> + Send + Sync + 'a) -> Self {
        Self {
            path,
            encode: Box::new(encode),
        }
    }

    /// Where it lies in the data set's folder; `/` between folders.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Encodes it: the same bytes at every call.
    ///
    /// # Errors
    /// Where the file's format cannot hold the image.
    pub fn bytes(&self) -> Result<Vec<u8>, DatasetError> {
        (self.encode)().map_err(|fault| {
            let path = self.path.clone();
            match fault {
                Fault::Codec(source) => DatasetError::Codec { path, source },
                Fault::IdTooLarge(id) => DatasetError::IdTooLarge { path, id },
            }
        })
    }
}

impl fmt::Debug for DatasetFile<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("DatasetFile")
            .field("path", &self.path)
            .finish_non_exhaustive()
    }
}
