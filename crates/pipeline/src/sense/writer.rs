//! Results to files: whole or not at all, and never over an input.

use std::collections::BTreeSet;
use std::collections::btree_map::{BTreeMap, Entry};
use std::io::Write;
use std::path::{Path, PathBuf};

use super::plan::Results;
use super::product::{Body, Numbers, Product};
use super::{Output, SenseError};
use crate::render::OutputFolder;
use oaktwin_files::{FileError, InParts, WrittenFile};

pub(super) struct Writer<'a> {
    output: Output<'a>,
    /// Real paths.
    inputs: BTreeSet<PathBuf>,
    /// Those that were written into: empty ones that were made for it are gone at the end.
    folders: BTreeMap<PathBuf, OutputFolder>,
    pub(super) files: Vec<WrittenFile>,
}

/// Where the results of one depth file go.
pub(super) struct Place<'a> {
    pub(super) results: &'a Results,
    /// How many images, where it is a batch.
    pub(super) batch: Option<usize>,
    /// The arrays of a batch, which grow.
    arrays: BTreeMap<String, InParts>,
    has_begun: bool,
}

impl<'a> Place<'a> {
    pub(super) fn new(results: &'a Results, batch: Option<usize>) -> Self {
        Self {
            results,
            batch,
            arrays: BTreeMap::new(),
            has_begun: false,
        }
    }
}

impl<'a> Writer<'a> {
    pub(super) fn new<'b>(output: Output<'a>, inputs: impl Iterator<Item = &'b Path>) -> Self {
        Self {
            output,
            inputs: inputs.filter_map(|path| path.canonicalize().ok()).collect(),
            folders: BTreeMap::new(),
            files: Vec::new(),
        }
    }

    /// Writes the results of one image, the `item`th of its file.
    pub(super) fn put(
        &mut self,
        place: &mut Place<'_>,
        item: usize,
        products: Vec<Product>,
    ) -> Result<(), SenseError> {
        if let Output::Stream(stream) = &mut self.output {
            // The last depth: what is aligned, where it is asked for.
            let mut depth = products.into_iter().filter_map(|product| match product.body {
                Body::Numbers(numbers) if product.name.starts_with("depth_sensor_distance") => Some(numbers),
                _ => None,
            });
            let Some(Numbers { begin, shape, bytes }) = depth.next_back() else {
                return Ok(());
            };
            let mut out = Vec::new();
            if !place.has_begun {
                out = begin(&with_batch(place.batch, &shape));
                place.has_begun = true;
            }
            out.extend(bytes);
            return stream
                .write_all(&out)
                .and_then(|()| stream.flush())
                .map_err(SenseError::Stream);
        }
        for Product {
            annotator,
            name,
            body,
        } in products
        {
            match body {
                Body::File { extension, bytes } => {
                    let item = place.batch.map(|_| item);
                    let path = place.results.path(annotator, &name, item, extension);
                    self.prepare(&path)?;
                    oaktwin_files::write(&path, &bytes)?;
                    self.files.push(WrittenFile {
                        path,
                        bytes: bytes.len() as u64,
                    });
                }
                Body::Numbers(Numbers { begin, shape, bytes }) => {
                    if !place.arrays.contains_key(&name) {
                        let path = place.results.path(annotator, &name, None, "npy");
                        self.prepare(&path)?;
                        let mut parts = InParts::create(&path)?;
                        parts.write(&begin(&with_batch(place.batch, &shape)))?;
                        place.arrays.insert(name.clone(), parts);
                    }
                    if let Some(parts) = place.arrays.get_mut(&name) {
                        parts.write(&bytes)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// Ends the results of a file.
    pub(super) fn finish(&mut self, place: Place<'_>) -> Result<(), SenseError> {
        for parts in place.arrays.into_values() {
            let (path, bytes) = parts.finish()?;
            self.files.push(WrittenFile { path, bytes });
        }
        Ok(())
    }

    fn prepare(&mut self, path: &Path) -> Result<(), FileError> {
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
            _ => PathBuf::from("."),
        };
        if let Entry::Vacant(place) = self.folders.entry(folder) {
            let prepared = OutputFolder::prepare(place.key())?;
            place.insert(prepared);
        }
        let is_input = path.canonicalize().is_ok_and(|path| self.inputs.contains(&path));
        if is_input {
            return Err(FileError::new(
                path,
                "is an input of this command",
                "choose another place",
            ));
        }
        Ok(())
    }
}

fn with_batch(batch: Option<usize>, shape: &[usize]) -> Vec<usize> {
    batch.into_iter().chain(shape.iter().copied()).collect()
}
