use std::collections::BTreeMap;
use std::path::PathBuf;

use oaktwin_files::{AtomicFile, OutputFiles};

use crate::file::{Content, write_all};
use crate::listing::list;
use crate::{Options, Shot, WriteError, Writer};

/// Names files after the [input](crate::InputName) that a frame was made from. The arrays of a batch become one file with a
/// leading axis, and its other files get the index of the image.
#[derive(Debug, Default)]
pub struct FlatWriter {
    options: Options,
    /// The arrays of a batch, which grow until the batch is complete.
    arrays: BTreeMap<PathBuf, AtomicFile>,
}

impl FlatWriter {
    /// Creates a writer.
    #[must_use]
    pub fn new(options: Options) -> Self {
        Self {
            options,
            arrays: BTreeMap::new(),
        }
    }
}

impl Writer for FlatWriter {
    fn write(&mut self, shot: &Shot, output: &mut OutputFiles) -> Result<(), WriteError> {
        let input = &shot.input;
        let mut whole = Vec::new();
        for file in list(shot, &self.options) {
            let Some((count, Content::Array(array))) = input.batch.map(|count| (count, &file.content)) else {
                let path = input.item_path(file.folder, &file.name, file.extension);
                whole.push((path, file));
                continue;
            };
            let path = input.path(file.folder, &file.name, file.extension);
            let growing = match self.arrays.remove(&path) {
                Some(growing) => growing,
                None => {
                    let mut growing = output.create(&path)?;
                    let shape: Vec<usize> = [count].into_iter().chain(array.shape.clone()).collect();
                    growing.append(&(array.begin)(&shape))?;
                    growing
                }
            };
            let growing = self.arrays.entry(path).or_insert(growing);
            growing.append(&(array.data)())?;
        }
        write_all(whole, output)
    }

    fn finish(&mut self, output: &mut OutputFiles) -> Result<(), WriteError> {
        for file in std::mem::take(&mut self.arrays).into_values() {
            output.finish(file)?;
        }
        Ok(())
    }
}
