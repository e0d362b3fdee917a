//! Validates a layer before the USD library reads it: its format, the sizes it claims, the depth of nesting, and the
//! names in a package. Text layers become binary ones here.
//!
//! Needed because `openusd` 0.6.0 panics, allocates without bound or overflows the stack on damaged files.

mod binary;
mod cursor;
mod outline;
mod package;
mod text;
mod values;

use std::fmt;
use std::io::Read;
use std::path::Path;
use std::sync;

use oaktwin_base::diagnostic::Finding;
use oaktwin_files as files;

use super::MAX_LAYER_BYTES;
pub(super) use outline::{Arc, ArcKind, CLIPS_FIELD, Clips, Outline, SAMPLES_FIELD};
pub(super) use package::Directory;

/// A file that the USD library can read safely.
#[derive(Debug)]
pub(super) struct Inspected {
    /// The bytes for the library: a text layer in binary form, other files as they are.
    pub bytes: sync::Arc<Vec<u8>>,
    /// The size of the file, in bytes.
    pub size: usize,
    pub content: Content,
    /// Problems that do not prevent it from being read.
    pub findings: Vec<Finding>,
}

/// What validation has learned about a file.
#[derive(Debug)]
pub(super) enum Content {
    Layer(Outline),
    Package(Directory),
}

impl Inspected {
    /// Returns the directory of a package.
    pub(super) fn directory(&self) -> Option<&Directory> {
        match &self.content {
            Content::Package(directory) => Some(directory),
            Content::Layer(_) => None,
        }
    }
}

/// The reason why the USD library cannot read a file safely.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Problem {
    pub place: String,
    pub what: String,
    pub remedy: String,
}

impl Problem {
    pub(super) fn new(place: impl Into<String>, what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self {
            place: place.into(),
            what: what.into(),
            remedy: remedy.into(),
        }
    }
}

/// Returns the problem of a file that cannot be read for the reason `what`.
pub(super) fn unreadable(what: &dyn fmt::Display) -> Problem {
    Problem::new("", format!("cannot be read: {what}"), "")
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.place.is_empty() {
            write!(f, "{}: ", self.place)?;
        }
        write!(f, "{}", self.what)
    }
}

const TEXT_MAGIC: &[u8] = b"#usda";
const USE_ANOTHER_COPY: &str = "use an undamaged copy";
const NOT_USD: &str = "give a .usd, .usda, .usdc or .usdz file";

/// Reads and validates a file.
pub(super) fn file(path: &Path) -> Result<Inspected, Problem> {
    let io_problem = |error: &std::io::Error| {
        let remedy = match error.kind() {
            std::io::ErrorKind::IsADirectory => {
                return Problem::new("", "is a directory", "give the USD file inside it");
            }
            std::io::ErrorKind::Other => return Problem::new("", error.to_string(), NOT_USD),
            std::io::ErrorKind::NotFound => "check the path",
            std::io::ErrorKind::PermissionDenied => "make the file readable",
            _ => "check the file and its disk",
        };
        Problem::new("", format!("cannot be read: {error}"), remedy)
    };
    let mut opened = files::open_regular(path).map_err(|error| io_problem(&error))?;
    let length = opened.metadata().map_err(|error| io_problem(&error))?.len();
    if length > MAX_LAYER_BYTES {
        return Err(Problem::new(
            "",
            format!("has {length} bytes, more than the maximum of {MAX_LAYER_BYTES}"),
            "split it into layers",
        ));
    }
    // The first bytes determine the format, so that large files of other formats are not read.
    let mut bytes = Vec::new();
    opened
        .by_ref()
        .take(64)
        .read_to_end(&mut bytes)
        .map_err(|error| io_problem(&error))?;
    let name = path.to_string_lossy();
    let kind = kind(&name, &bytes)?;
    opened
        .take(MAX_LAYER_BYTES)
        .read_to_end(&mut bytes)
        .map_err(|error| io_problem(&error))?;
    validate(kind, bytes)
}

/// Validates a layer in memory, such as a package entry.
pub(super) fn layer(name: &str, bytes: Vec<u8>) -> Result<Inspected, Problem> {
    validate(kind(name, &bytes)?, bytes)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FileKind {
    Text,
    Binary,
    Package,
}

fn validate(kind: FileKind, bytes: Vec<u8>) -> Result<Inspected, Problem> {
    let size = bytes.len();
    let (bytes, content, findings) = match kind {
        FileKind::Text => {
            let (binary, outline) = text::to_binary(bytes)?;
            (binary, Content::Layer(outline), Vec::new())
        }
        FileKind::Binary => {
            let outline = binary::inspect(&bytes)?;
            (bytes, Content::Layer(outline), Vec::new())
        }
        FileKind::Package => {
            let (directory, findings) = package::inspect(&bytes)?;
            (bytes, Content::Package(directory), findings)
        }
    };
    Ok(Inspected {
        bytes: sync::Arc::new(bytes),
        size,
        content,
        findings,
    })
}

/// Detects a file's format from its first bytes; an error if its extension does not match.
fn kind(name: &str, head: &[u8]) -> Result<FileKind, Problem> {
    if head.is_empty() {
        return Err(Problem::new("", "is empty", "export the stage again"));
    }
    let extension = Path::new(name)
        .extension()
        .map(|extension| extension.to_string_lossy().to_ascii_lowercase())
        .unwrap_or_default();
    let kind = if head.starts_with(TEXT_MAGIC) {
        FileKind::Text
    } else if head.starts_with(b"PXR-USDC") {
        FileKind::Binary
    } else if head.starts_with(b"PK\x03\x04") || head.starts_with(b"PK\x05\x06") {
        FileKind::Package
    } else if head.starts_with(b"version https://git-lfs") {
        return Err(Problem::new(
            "",
            "is a Git LFS pointer, not the file itself",
            "run `git lfs pull` in its repository",
        ));
    } else {
        return Err(Problem::new(
            "start",
            "is not a USD file: it starts neither with `#usda` or `PXR-USDC` nor as a package",
            NOT_USD,
        ));
    };
    let (is, should_be) = match kind {
        FileKind::Text => ("USD text", "usda"),
        FileKind::Binary => ("binary USD", "usdc"),
        FileKind::Package => ("a package", "usdz"),
    };
    let fits = extension == should_be || (extension == "usd" && kind != FileKind::Package);
    if fits {
        Ok(kind)
    } else {
        Err(Problem::new(
            "start",
            format!("contains {is}, which does not match its extension"),
            format!("rename it to end in .{should_be}"),
        ))
    }
}
