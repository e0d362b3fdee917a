use std::cell::Cell;
use std::fs;
use std::path::{Path, PathBuf};

use ::gltf::json;

use super::uri::{self, Target};
use crate::import::error::Fault;

/// A glTF file with its buffers.
pub(super) struct Document {
    pub(super) root: json::Root,
    buffers: Vec<Vec<u8>>,
    pub(super) folder: PathBuf,
    /// The number of values that may still be read.
    allowance: Cell<u64>,
}

const MAGIC: &[u8] = b"glTF";
const JSON: &[u8] = b"JSON";
const BINARY: &[u8] = b"BIN\0";
/// Meshes may share data; this limit on reads per byte prevents a small file from filling the memory.
const MAX_READS_PER_BYTE: u64 = 256;

impl Document {
    pub(super) fn open(mut bytes: Vec<u8>, path: &Path) -> Result<Self, Fault> {
        let size = bytes.len() as u64;
        let (root, binary) = if bytes.starts_with(MAGIC) {
            let (json, binary) = chunks(&bytes)?;
            let root = parse(json)?;
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
            (parse(&bytes)?, None)
        };
        if !root.asset.version.starts_with("2.") {
            return Err(Fault::new(
                "asset.version",
                format!("has version {}", root.asset.version),
                "convert it to glTF 2.0",
            ));
        }
        let mut document = Self {
            root,
            buffers: Vec::new(),
            folder: path.parent().unwrap_or(Path::new("")).to_path_buf(),
            allowance: Cell::new(0),
        };
        document.load_buffers(binary)?;
        let all: u64 = document.buffers.iter().map(|buffer| buffer.len() as u64).sum();
        document
            .allowance
            .set((size + all).saturating_mul(MAX_READS_PER_BYTE).max(1 << 20));
        Ok(document)
    }

    fn load_buffers(&mut self, mut binary: Option<Vec<u8>>) -> Result<(), Fault> {
        for (i, buffer) in self.root.buffers.iter().enumerate() {
            let place = format!("buffers[{i}]");
            let bytes = match &buffer.uri {
                Some(uri) => match uri::resolve(uri, &self.folder) {
                    Target::Data(bytes) => bytes,
                    Target::File(file) => read_file(&file, &place)?,
                    Target::Unsupported(why) => {
                        return Err(Fault::new(place, why, "export it together with its buffers"));
                    }
                },
                None if i == 0 => binary.take().unwrap_or_default(),
                None => Vec::new(),
            };
            if (bytes.len() as u64) < buffer.byte_length.0 {
                if self.uses("EXT_meshopt_compression") {
                    return Err(Fault::new(
                        place,
                        "is compressed by meshopt",
                        "export it without compression",
                    ));
                }
                let message = format!(
                    "{} bytes required, {} available",
                    buffer.byte_length.0,
                    bytes.len()
                );
                return Err(Fault::damaged(place, message));
            }
            self.buffers.push(bytes);
        }
        Ok(())
    }

    pub(super) fn uses(&self, extension: &str) -> bool {
        self.root.extensions_used.iter().any(|used| used == extension)
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

fn parse(json: &[u8]) -> Result<json::Root, Fault> {
    // Some exporters write a byte-order mark.
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    json::Root::from_slice(json).map_err(|error| Fault::damaged("JSON", error.to_string()))
}

fn read_file(file: &Path, place: &str) -> Result<Vec<u8>, Fault> {
    let remedy = "put it beside the glTF file";
    let fault = |error: std::io::Error| Fault::new(place, format!("{}: {error}", file.display()), remedy);
    if !fs::metadata(file).map_err(fault)?.is_file() {
        return Err(Fault::new(
            place,
            format!("{}: not a regular file", file.display()),
            remedy,
        ));
    }
    fs::read(file).map_err(fault)
}

/// The JSON chunk of a binary file, and the range of its binary chunk.
fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<std::ops::Range<usize>>), Fault> {
    let word = |at: usize| {
        let word = bytes.get(at..at.checked_add(4)?)?.first_chunk()?;
        usize::try_from(u32::from_le_bytes(*word)).ok()
    };
    let short = || Fault::damaged("header", "the file ends too early");
    if word(4).ok_or_else(short)? != 2 {
        return Err(Fault::new("header", "is not version 2", "convert it to glTF 2.0"));
    }
    if word(8).ok_or_else(short)? > bytes.len() {
        return Err(short());
    }
    let chunk = |at: usize| {
        let start = at.checked_add(8)?;
        let end = start.checked_add(word(at)?)?;
        bytes.get(start..end)?;
        Some((bytes.get(at + 4..start)?, start..end))
    };
    let (kind, json) = chunk(12).ok_or_else(short)?;
    if kind != JSON {
        return Err(Fault::damaged("header", "the first chunk is not JSON"));
    }
    let binary = chunk(json.end.next_multiple_of(4))
        .filter(|(kind, _)| *kind == BINARY)
        .map(|(_, range)| range);
    Ok((&bytes[json], binary))
}
