use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use ::gltf::json::{Root, deserialize};
use oaktwin_files as files;
use serde_json::Value;

use super::super::uri::{self, Folder, ResolvedUri};
use super::channel::Channel;
use super::placement::{Instancing, Placement, Skin};
use super::{compressed, glb, json};
use crate::import::MAX_BYTES;
use crate::import::error::Fault;

/// A glTF file with its buffers.
pub(super) struct Document {
    pub(super) root: Root,
    /// The names of all extensions in the file.
    pub(super) extensions: BTreeSet<String>,
    /// The placement of each node.
    pub(super) placements: Vec<Placement>,
    /// The nodes that place their mesh many times.
    pub(super) instancing: BTreeMap<usize, Instancing>,
    pub(super) skins: Vec<Skin>,
    /// The animated properties.
    pub(super) channels: Vec<Channel>,
    buffers: Vec<Vec<u8>>,
    pub(super) folder: Folder,
    /// The number of values that may still be read.
    allowance: Cell<u64>,
}

/// Meshes may share data; this limit on reads per byte prevents a small file from filling the memory.
const MAX_READS_PER_BYTE: u64 = 256;

impl Document {
    pub(super) fn open(mut bytes: Vec<u8>, path: &Path, folder: Folder) -> Result<Self, Fault> {
        let size = bytes.len() as u64;
        let (mut root, binary) = if bytes.starts_with(glb::MAGIC) {
            let (json, binary) = glb::chunks(&bytes)?;
            let root = json::parse(&bytes[json])?;
            // Reuses the file's memory for the buffer.
            let binary = binary.map(|range| {
                bytes.truncate(range.end);
                bytes.drain(..range.start);
                bytes
            });
            (root, binary)
        } else {
            if path
                .extension()
                .is_some_and(|extension| extension.eq_ignore_ascii_case("glb"))
            {
                return Err(Fault::damaged(
                    "header",
                    "is not a binary glTF file: it does not start with `glTF`",
                ));
            }
            (json::parse(&bytes)?, None)
        };
        let mut buffers = load_buffers(&root, &folder, binary)?;
        compressed::decode(&mut root, &mut buffers)?;
        let all: u64 = buffers.iter().map(|buffer| buffer.len() as u64).sum();
        let allowance = (size + all).saturating_mul(MAX_READS_PER_BYTE).max(1 << 20);
        let nodes = root
            .get("nodes")
            .and_then(Value::as_array)
            .map_or(&[][..], Vec::as_slice);
        let placements = nodes.iter().map(Placement::of).collect();
        let instancing = nodes.iter().map(Instancing::of).enumerate();
        let instancing = instancing.filter_map(|(node, of)| Some((node, of?))).collect();
        let extensions = json::extension_names(&root);
        let skins = Skin::take_all(&mut root);
        let channels = Channel::take_all(&mut root);
        let root =
            deserialize::from_value(root).map_err(|error| Fault::damaged("JSON", error.to_string()))?;
        Ok(Self {
            root,
            extensions,
            placements,
            instancing,
            skins,
            channels,
            buffers,
            folder,
            allowance: Cell::new(allowance),
        })
    }

    /// The bytes of a buffer view, and its stride if it has one.
    pub(super) fn view(&self, view: usize) -> Result<(&[u8], Option<usize>), String> {
        let missing = || format!("bufferViews[{view}] does not exist");
        let entry = self.root.buffer_views.get(view).ok_or_else(missing)?;
        let buffer = entry.buffer.value();
        let range = || {
            let start = usize::try_from(entry.byte_offset.unwrap_or_default().0).ok()?;
            let end = start.checked_add(usize::try_from(entry.byte_length.0).ok()?)?;
            self.buffers.get(buffer)?.get(start..end)
        };
        let bytes = range().ok_or_else(|| format!("bufferViews[{view}] exceeds buffers[{buffer}]"))?;
        Ok((bytes, entry.byte_stride.map(|stride| stride.0)))
    }

    /// Reserves that many numbers from the allowance.
    pub(super) fn allow(&self, numbers: u64) -> Result<(), String> {
        match self.allowance.get().checked_sub(numbers) {
            Some(left) => {
                self.allowance.set(left);
                Ok(())
            }
            None => Err("the decoded data is far larger than the file".into()),
        }
    }
}

fn load_buffers(root: &Value, folder: &Folder, mut binary: Option<Vec<u8>>) -> Result<Vec<Vec<u8>>, Fault> {
    let list = root.get("buffers").and_then(Value::as_array);
    let mut buffers = Vec::new();
    for (i, buffer) in list.into_iter().flatten().enumerate() {
        let place = format!("buffers[{i}]");
        if compressed::is_fallback(buffer) {
            buffers.push(Vec::new());
            continue;
        }
        let bytes = match buffer.get("uri").and_then(Value::as_str) {
            Some(uri) => match folder.resolve(uri) {
                ResolvedUri::Data(bytes) => bytes,
                ResolvedUri::File(file) => read_file(&file, &place)?,
                ResolvedUri::Outside(file) => {
                    return Err(Fault::new(place, uri::outside(&file), uri::inside()));
                }
                ResolvedUri::Unsupported(why) => {
                    return Err(Fault::new(place, why, "export it together with its buffers"));
                }
            },
            None if i == 0 => binary.take().unwrap_or_default(),
            None => Vec::new(),
        };
        let required = buffer.get("byteLength").and_then(Value::as_u64).unwrap_or(0);
        // Without data, the buffer reserves room for decoded data.
        let is_placeholder = i > 0 && bytes.is_empty() && compressed::has_compressed_views(root);
        if (bytes.len() as u64) < required && !is_placeholder {
            let message = format!("{required} bytes required, {} available", bytes.len());
            return Err(Fault::damaged(place, message));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

fn read_file(file: &Path, place: &str) -> Result<Vec<u8>, Fault> {
    files::read_regular(file, MAX_BYTES).map_err(|error| {
        let message = format!("{}: {error}", file.display());
        Fault::new(place, message, "put it beside the glTF file")
    })
}
