use std::io::{self, Write};
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::Message;
use oaktwin_files::{FileError, OutputFiles};
use oaktwin_image::npy::{self, NpyElement};
use oaktwin_image::{CodecError, Image};

use crate::WriteError;

/// An error that prevents a file from being encoded.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DatasetError {
    /// The format of the file cannot hold the image.
    #[error("{path}: {source}")]
    Codec {
        /// The file, relative to the data set.
        path: String,
        /// The error of the encoder.
        source: CodecError,
    },
    /// An id does not fit in the 16 bits of a grey PNG.
    #[error(
        "{path}: the id {id} does not fit in 16 bits; leave the segmentation colorized, which holds any number of ids"
    )]
    IdTooLarge {
        /// The file, relative to the data set.
        path: String,
        /// The first such id.
        id: u32,
    },
    /// The frame lacks something that the format requires.
    #[error("{format} requires {what}; {remedy}")]
    Missing {
        /// The format.
        format: &'static str,
        /// What the frame lacks.
        what: &'static str,
        /// What to do.
        remedy: Message,
    },
}

/// An error within a file, without its name.
pub(crate) enum Fault {
    Codec(CodecError),
    IdTooLarge(u32),
    Write(io::Error),
}

impl From<io::Error> for Fault {
    fn from(error: io::Error) -> Self {
        Self::Write(error)
    }
}

impl From<CodecError> for Fault {
    fn from(error: CodecError) -> Self {
        Self::Codec(error)
    }
}

impl Fault {
    pub(crate) fn at(self, path: &Path) -> WriteError {
        let name = path.display().to_string();
        match self {
            Self::Codec(source) => DatasetError::Codec { path: name, source }.into(),
            Self::IdTooLarge(id) => DatasetError::IdTooLarge { path: name, id }.into(),
            Self::Write(error) => FileError::writing(path, &error).into(),
        }
    }
}

type Encode<'a> = Box<dyn Fn() -> Result<Vec<u8>, Fault> + Send + Sync + 'a>;

/// One file of a frame, not encoded yet; a writer chooses its path.
pub(crate) struct DatasetFile<'a> {
    /// The folder, where annotators have folders.
    pub(crate) folder: &'static str,
    pub(crate) name: String,
    pub(crate) extension: &'static str,
    pub(crate) content: Content<'a>,
}

pub(crate) enum Content<'a> {
    Whole(Encode<'a>),
    Array(Array<'a>),
}

type Put<'a> = Box<dyn Fn(&mut dyn Write) -> io::Result<()> + Send + Sync + 'a>;

/// An NPY array, in parts that a batch needs.
pub(crate) struct Array<'a> {
    /// The header for a shape.
    pub(crate) begin: fn(&[usize]) -> Vec<u8>,
    pub(crate) shape: Vec<usize>,
    /// Writes the numbers.
    pub(crate) put: Put<'a>,
}

impl<'a> Array<'a> {
    /// An array of shape `(H, W)`.
    pub(crate) fn of_image<T: NpyElement + Sync>(image: &'a Image<T>) -> Self {
        let shape = vec![image.height() as usize, image.width() as usize];
        Self::new(shape, image.pixels())
    }

    /// An array of shape `(H, W, 4)`.
    pub(crate) fn of_vectors<T: NpyElement + Sync>(image: &'a Image<[T; 4]>) -> Self {
        let shape = vec![image.height() as usize, image.width() as usize, 4];
        Self::new(shape, image.pixels().as_flattened())
    }

    fn new<T: NpyElement + Sync>(shape: Vec<usize>, values: &'a [T]) -> Self {
        Self {
            begin: npy::begin::<T>,
            shape,
            put: Box::new(move |out| npy::write(values, out)),
        }
    }
}

impl Content<'_> {
    /// Writes the whole file.
    pub(crate) fn write(&self, out: &mut dyn Write) -> Result<(), Fault> {
        match self {
            Self::Whole(encode) => out.write_all(&encode()?)?,
            Self::Array(array) => {
                out.write_all(&(array.begin)(&array.shape))?;
                (array.put)(out)?;
            }
        }
        Ok(())
    }
}

/// Encodes and writes files, several at a time.
pub(crate) fn write_all(
    files: &[(PathBuf, DatasetFile<'_>)],
    output: &mut OutputFiles,
) -> Result<(), WriteError> {
    let paths: Vec<&Path> = files.iter().map(|(path, _)| path.as_path()).collect();
    output.write_all(&paths, |index, out| {
        let Some((path, file)) = files.get(index) else {
            return Ok(());
        };
        file.content.write(out).map_err(|fault| match fault {
            Fault::Write(error) => out.failed(&error).into(),
            fault => fault.at(path),
        })
    })
}
