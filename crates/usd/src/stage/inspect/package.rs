use std::collections::HashMap;
use std::ops::Range;

use oaktwin_base::diagnostic::{Finding, Level};

use super::{Problem, USE_ANOTHER_COPY};

const CODE: &str = "package-layout";
const REPACK: &str =
    "unpack it, and package its root layer again with OpenUSD: `usdzip --asset ROOT.usd NEW.usdz`";

/// The entries of a package.
#[derive(Debug, Default)]
pub(in crate::stage) struct Directory {
    /// The name of the first entry, which is the root layer.
    pub(in crate::stage) root: String,
    entries: HashMap<String, Range<usize>>,
}

impl Directory {
    /// Whether there is an entry of this name.
    pub(in crate::stage) fn contains(&self, name: &str) -> bool {
        self.entries.contains_key(name)
    }

    /// Returns the bytes of an entry of the package with the content `package`.
    pub(in crate::stage) fn entry<'a>(&self, package: &'a [u8], name: &str) -> Option<&'a [u8]> {
        package.get(self.entries.get(name)?.clone())
    }
}

/// Validates the directory of a USDZ package: entries must be uncompressed, inside the file and have names that stay
/// inside the package. Violations that only strict readers reject (alignment) are returned as findings.
pub(super) fn inspect(bytes: &[u8]) -> Result<(Directory, Vec<Finding>), Problem> {
    let end = end_record(bytes).ok_or_else(|| {
        Problem::new(
            "package",
            "has no directory at its end: it is truncated",
            USE_ANOTHER_COPY,
        )
    })?;
    let (count, length, start) = (
        u16_at(bytes, end + 10),
        u32_at(bytes, end + 12),
        u32_at(bytes, end + 16),
    );
    let (Some(count), Some(length), Some(start)) = (count, length, start) else {
        return Err(damaged("package", "its directory is truncated"));
    };
    if start.checked_add(length).is_none_or(|after| after > end) {
        return Err(damaged("package", "its directory is outside the file"));
    }
    let mut findings = Vec::new();
    let mut directory = Directory::default();
    let mut at = start;
    for index in 0..count {
        let entry =
            entry(bytes, at, start).map_err(|what| damaged(&format!("package entry {}", index + 1), what))?;
        let place = format!("package entry `{}`", entry.name);
        if index == 0 && !is_layer(&entry.name) {
            return Err(Problem::new(
                place,
                "is the first entry, which must be the root layer",
                REPACK,
            ));
        }
        if !stays_inside(&entry.name) {
            return Err(Problem::new(
                place,
                "has a name that points outside the package",
                "do not use this file; package the originals again",
            ));
        }
        if entry.method != 0 || entry.encrypted {
            return Err(Problem::new(
                place,
                "is compressed or encrypted, which USDZ forbids",
                REPACK,
            ));
        }
        if entry.data % 64 != 0 {
            findings.push(Finding::new(
                CODE,
                Level::Warning,
                place.clone(),
                "its data does not start at a multiple of 64 bytes, as USDZ requires",
                REPACK,
            ));
        }
        at = entry.next;
        if index == 0 {
            directory.root.clone_from(&entry.name);
        }
        let data = entry.data..entry.data + entry.size;
        if directory.entries.insert(entry.name, data).is_some() {
            return Err(damaged(&place, "appears twice"));
        }
    }
    if directory.entries.is_empty() {
        return Err(Problem::new("package", "is empty", REPACK));
    }
    Ok((directory, findings))
}

fn damaged(place: &str, what: &str) -> Problem {
    Problem::new(place, what, USE_ANOTHER_COPY)
}

struct Entry {
    name: String,
    method: usize,
    encrypted: bool,
    /// The offset of the data.
    data: usize,
    /// The size of the data, in bytes.
    size: usize,
    /// The offset of the next directory entry.
    next: usize,
}

/// Reads the directory entry at `at` and checks it against the local header.
fn entry(bytes: &[u8], at: usize, directory: usize) -> Result<Entry, &'static str> {
    const CUT: &str = "its directory entry is truncated";
    if bytes
        .get(at..)
        .is_none_or(|rest| !rest.starts_with(b"PK\x01\x02"))
    {
        return Err("is not a directory entry");
    }
    let word = |offset| u16_at(bytes, at + offset).ok_or(CUT);
    let long = |offset| u32_at(bytes, at + offset).ok_or(CUT);
    let (flags, method, stored, size) = (word(8)?, word(10)?, long(20)?, long(24)?);
    let (name_length, extra, comment, header) = (word(28)?, word(30)?, word(32)?, long(42)?);
    let name = bytes.get(at + 46..at + 46 + name_length).ok_or(CUT)?;
    let name = std::str::from_utf8(name)
        .map_err(|_| "its name is not valid UTF-8")?
        .to_owned();
    if bytes
        .get(header..)
        .is_none_or(|rest| !rest.starts_with(b"PK\x03\x04"))
    {
        return Err("its header is not at the offset in the directory");
    }
    let local_name = u16_at(bytes, header + 26).ok_or(CUT)?;
    let data = header + 30 + local_name + u16_at(bytes, header + 28).ok_or(CUT)?;
    if bytes.get(header + 30..header + 30 + local_name) != Some(name.as_bytes()) {
        return Err("has two different names");
    }
    if method == 0 && stored != size {
        return Err("is stored, but its two sizes differ");
    }
    if data.checked_add(stored).is_none_or(|after| after > directory) {
        return Err("claims more bytes than the file has");
    }
    Ok(Entry {
        name,
        method,
        encrypted: flags & 1 != 0,
        data,
        size: stored,
        next: at + 46 + name_length + extra + comment,
    })
}

fn is_layer(name: &str) -> bool {
    [".usd", ".usda", ".usdc"].iter().any(|end| name.ends_with(end))
}

fn stays_inside(name: &str) -> bool {
    !name.is_empty()
        && !name.starts_with('/')
        && !name.contains(['\\', ':', '\0', '[', ']'])
        && name.split('/').all(|part| part != "..")
}

/// Returns the offset of the end-of-directory record.
fn end_record(bytes: &[u8]) -> Option<usize> {
    let last = bytes.len().checked_sub(22)?;
    (last.saturating_sub(usize::from(u16::MAX))..=last)
        .rev()
        .find(|at| bytes[*at..].starts_with(b"PK\x05\x06"))
}

fn u16_at(bytes: &[u8], at: usize) -> Option<usize> {
    let bytes = bytes.get(at..at.checked_add(2)?)?;
    Some(usize::from(u16::from_le_bytes(bytes.try_into().ok()?)))
}

fn u32_at(bytes: &[u8], at: usize) -> Option<usize> {
    let bytes = bytes.get(at..at.checked_add(4)?)?;
    usize::try_from(u32::from_le_bytes(bytes.try_into().ok()?)).ok()
}
