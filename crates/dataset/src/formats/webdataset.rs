use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::Finding;
use oaktwin_files::{FileError, OutputFiles};
use rayon::prelude::*;
use serde_json::{Value, json};
use tar::{Builder, EntryType, Header};

use super::common::{camera_matrix, distortion, matrix, number, text};
use crate::basic_writer::folder;
use crate::file::DatasetFile;
use crate::listing::list;
use crate::{Format, Records, Shot, WriteError, WriterOptions, json as files};

/// The blocks of zeros at the end of an archive, bytes.
const END: usize = 1024;

/// The layout of `WebDataset`: shards `shard-000000.tar` of a fixed number of consecutive frames. A sample has the files of
/// [`BasicWriter`](crate::BasicWriter), named `KEY.NAME.EXTENSION`, and `KEY.json` with the camera matrix (the first pixel's centre is at
/// 0), the distortion and the pose. The key is the frame's number, and the camera's name if there are several.
///
/// A frame has its own archive in `samples/` until its shard is complete.
#[derive(Debug)]
pub(super) struct WebDataset(pub(super) WriterOptions);

impl Format for WebDataset {
    fn frame(&self, shot: &Shot, output: &mut OutputFiles) -> Result<Value, WriteError> {
        let mut key = format!("{:08}", shot.number);
        if let Some(product) = &shot.render_product {
            // A key ends at its first dot.
            key = format!("{key}_{}", folder(product).replace('.', "_"));
        }
        let files = list(shot, &self.0);
        let encode = |file: &DatasetFile<'_>| {
            let mut bytes = Vec::new();
            file.content.write(&mut bytes).map(|()| bytes)
        };
        let encoded: Vec<_> = files.par_iter().map(encode).collect();
        let mut sample = Builder::new(Vec::new());
        append(
            &mut sample,
            &format!("{key}.json"),
            &files::encode(&described(shot)),
        )?;
        for (file, bytes) in files.iter().zip(encoded) {
            let name = format!("{key}.{}.{}", file.name.replace('.', "_"), file.extension);
            let bytes = bytes.map_err(|fault| fault.at(name.as_ref()))?;
            append(&mut sample, &name, &bytes)?;
        }
        let sample = sample
            .into_inner()
            .map_err(|error| WriteError::Other(error.into()))?;
        let path = format!("samples/{key}.tar");
        output.write(path.as_ref(), &sample)?;
        Ok(json!({"sample": path, "frame": shot.number, "bytes": sample.len()}))
    }

    fn finish(
        &self,
        records: &mut Records<'_>,
        output: &mut OutputFiles,
    ) -> Result<Vec<Finding>, WriteError> {
        let mut shards: BTreeMap<u64, Shard> = BTreeMap::new();
        for record in records {
            let record = record?;
            let frame = number(&record, "frame");
            let shard = shards.entry(frame / self.0.shard_frames).or_default();
            shard.frames.insert(frame);
            shard
                .samples
                .push((text(&record, "sample").into(), number(&record, "bytes")));
        }
        for (index, shard) in shards {
            let path = PathBuf::from(format!("shard-{index:06}.tar"));
            let is_full = shard.frames.len() as u64 == self.0.shard_frames.get();
            if !is_full || !shard.is_written(&path, output) {
                shard.write(&path, output)?;
            } else {
                output.list(&path)?;
            }
            if is_full {
                output.pack(&path, shard.samples.into_iter().map(|(sample, _)| sample));
            }
        }
        Ok(Vec::new())
    }
}

/// The frames of a shard.
#[derive(Default)]
struct Shard {
    frames: BTreeSet<u64>,
    /// The archives of the samples with their lengths.
    samples: Vec<(PathBuf, u64)>,
}

impl Shard {
    /// Whether the shard was completed earlier, and the removal of its samples has begun.
    fn is_written(&self, path: &Path, output: &OutputFiles) -> bool {
        let samples = self
            .samples
            .iter()
            .map(|(_, bytes)| bytes.saturating_sub(END as u64));
        let bytes = samples.sum::<u64>() + END as u64;
        let has_all = self
            .samples
            .iter()
            .all(|(sample, _)| output.root().join(sample).exists());
        !has_all && fs::metadata(output.root().join(path)).is_ok_and(|metadata| metadata.len() == bytes)
    }

    fn write(&self, path: &Path, output: &mut OutputFiles) -> Result<(), WriteError> {
        let mut file = output.create(path)?;
        for (sample, bytes) in &self.samples {
            let place = output.root().join(sample);
            let content = fs::read(&place).unwrap_or_default();
            let end = content.len().checked_sub(END);
            let Some(end) = end.filter(|_| content.len() as u64 == *bytes) else {
                let remedy = "resume the generation of all frames";
                return Err(
                    FileError::new(&place, "is missing, or not the sample that was written", remedy).into(),
                );
            };
            file.append(&content[..end])?;
        }
        file.append(&[0; END])?;
        Ok(output.finish(file)?)
    }
}

/// Appends a file without anything that differs between machines.
fn append(archive: &mut Builder<Vec<u8>>, name: &str, bytes: &[u8]) -> Result<(), WriteError> {
    let mut header = Header::new_ustar();
    header.set_entry_type(EntryType::Regular);
    header.set_mode(0o644);
    header.set_mtime(0);
    header.set_size(bytes.len() as u64);
    let appended = archive.append_data(&mut header, name, bytes);
    appended.map_err(|error| WriteError::Other(error.into()))
}

/// The numbers of a frame.
fn described(shot: &Shot) -> Value {
    let mut described = json!({"frame": shot.number, "sequence": shot.sequence, "time_ns": shot.time_ns});
    if let Some(view) = &shot.view {
        let size = view.camera.intrinsics.size;
        described["width"] = size.width.into();
        described["height"] = size.height.into();
        described["camera_matrix"] = json!(camera_matrix(&view.camera.intrinsics));
        described["distortion"] = distortion(&view.camera.lens);
        described["world_from_camera"] = json!(matrix(&view.world_from_camera));
    }
    described
}
