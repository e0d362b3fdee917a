//! The files that span frames, and the manifest.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use oaktwin_base::diagnostic::add_new;
use oaktwin_dataset::WriteError;
use oaktwin_files::{AtomicFile, FileError, OutputFiles, PackedFiles};
use serde_json::json;

use super::store::{Container, FileRecord, FrameRecord, Store, checksum, pretty};
use super::{Generated, PlacedFormat};
use crate::GenerateError;
use crate::context::Context;
use crate::unit;

/// Writes the files that span frames, and the manifest.
pub(super) fn finish(
    context: &Context,
    store: &Store,
    formats: &[PlacedFormat],
    generated: &mut Generated,
) -> Result<(), GenerateError> {
    let frames = store.frames()?;
    generated.missing = context.file.recipe.frames.saturating_sub(frames.len() as u64);
    let (mut shared, mut findings) = (Vec::new(), Vec::new());
    let mut packed = Vec::new();
    for (index, (format, folder)) in formats.iter().enumerate() {
        let mut output = OutputFiles::in_folder(folder)?;
        let mut records = frames.iter().flat_map(|frame| match store.frame(*frame) {
            Ok(mut record) => {
                let records = record
                    .formats
                    .get_mut(index)
                    .map(std::mem::take)
                    .unwrap_or_default();
                records.into_iter().map(Ok).collect()
            }
            Err(error) => vec![Err(WriteError::from(error))],
        });
        findings.extend(format.finish(&mut records, &mut output)?);
        shared.extend(store.describe(output.files())?);
        packed.append(&mut output.take_packed());
        let samples = context.write_inertial(store, &frames, folder, context.formats[index].name)?;
        shared.extend(store.describe(samples.files())?);
    }
    write_manifest(
        context,
        store,
        &frames,
        shared,
        &containers(store, &packed)?,
        generated,
    )?;
    for files in packed {
        files.remove_members()?;
    }
    generated.findings.append(&mut findings);
    Ok(())
}

/// Returns the files that replace others, by the paths of these.
fn containers(store: &Store, packed: &[PackedFiles]) -> Result<BTreeMap<String, Container>, FileError> {
    let mut all = BTreeMap::new();
    for files in packed {
        let container = Container {
            path: store.relative(&files.container),
            bytes: fs::metadata(&files.container).map_or(0, |metadata| metadata.len()),
            sha256: Some(checksum(&files.container)?),
        };
        let members = files.members.iter().map(|member| store.relative(member));
        all.extend(members.map(|member| (member, container.clone())));
    }
    Ok(all)
}

/// Reads the record of a frame, in which files that others replace are noted.
fn packed_record(
    store: &Store,
    frame: u64,
    containers: &BTreeMap<String, Container>,
) -> Result<FrameRecord, FileError> {
    let mut record = store.frame(frame)?;
    let mut is_changed = false;
    for file in &mut record.files {
        let Some(container) = containers.get(&file.path) else {
            continue;
        };
        // The checksum of a file that was complete earlier stays: it may have been damaged since.
        let is_known = file
            .packed_in
            .as_ref()
            .is_some_and(|known| (&known.path, known.bytes) == (&container.path, container.bytes));
        if !is_known {
            file.packed_in = Some(container.clone());
            is_changed = true;
        }
    }
    if is_changed {
        store.add(&record)?;
    }
    Ok(record)
}

/// Writes the manifest, line by line, so that it does not have to fit into memory, and the units of its frames.
fn write_manifest(
    context: &Context,
    store: &Store,
    frames: &BTreeSet<u64>,
    mut shared: Vec<FileRecord>,
    containers: &BTreeMap<String, Container>,
    generated: &mut Generated,
) -> Result<(), GenerateError> {
    let mut file = AtomicFile::create(&store.root.join("manifest.json"))?;
    let mut recipe = serde_json::to_value(&context.file.recipe).unwrap_or_default();
    recipe["frames"] = json!(frames.len());
    let head = String::from_utf8(pretty(&recipe)).unwrap_or_default();
    let inputs = String::from_utf8(pretty(&store.inputs()?)).unwrap_or_default();
    file.append(
        format!(
            "{{\"recipe\": {},\n\"inputs\": {},\n\"files\": [\n",
            head.trim_end(),
            inputs.trim_end()
        )
        .as_bytes(),
    )?;
    let mut is_first = true;
    let mut add = |record: &FileRecord, file: &mut AtomicFile| -> Result<(), FileError> {
        let line = serde_json::to_string(record).unwrap_or_default();
        let separator = if std::mem::replace(&mut is_first, false) {
            ""
        } else {
            ",\n"
        };
        generated.files += 1;
        generated.bytes += record.bytes;
        file.append(format!("{separator}{line}").as_bytes())
    };
    let mut units = Vec::new();
    for frame in frames {
        let frame = packed_record(store, *frame, containers)?;
        for record in frame.files.iter().filter(|file| file.packed_in.is_none()) {
            add(record, &mut file)?;
        }
        add_new(&mut generated.findings, frame.findings);
        units.push((frame.frame, frame.unit));
    }
    let mut output = OutputFiles::in_folder(&store.root)?;
    unit::write(context, &units, &mut output)?;
    shared.extend(store.describe(output.files())?);
    for record in &shared {
        add(record, &mut file)?;
    }
    file.append(b"\n]}\n")?;
    file.finish()?;
    Ok(())
}
