//! Looks a layer over before the USD library reads it: the right kind of file, sizes that the file can justify,
//! nesting that a stack can bear, names that stay inside the package.

mod binary;
mod package;
mod text;
mod values;

use std::fmt;
use std::fs;
use std::io::Read;
use std::path::Path;
use std::sync::Arc;

use oaktwin_diagnostic::Finding;

use super::MAX_LAYER_BYTES;

/// A file that may be handed to the USD library.
#[derive(Debug)]
pub(super) struct Inspected {
    /// Its content.
    pub bytes: Arc<Vec<u8>>,
    /// Oddities that do not keep it from being read.
    pub findings: Vec<Finding>,
}

/// Why a file may not be handed to the USD library.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Problem {
    pub place: String,
    pub what: String,
    pub remedy: String,
}

impl Problem {
    fn new(place: impl Into<String>, what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self {
            place: place.into(),
            what: what.into(),
            remedy: remedy.into(),
        }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.place.is_empty() {
            write!(f, "{}: ", self.place)?;
        }
        write!(f, "{}", self.what)
    }
}

/// Deeper than people nest prims or dictionaries. The library's time grows with the cube of the depth.
const DEEPEST: usize = 256;
const TAKE_ANOTHER: &str = "take an undamaged copy";
const NOT_USD: &str = "give a .usd, .usda, .usdc or .usdz file";

/// Reads a file and looks it over.
pub(super) fn file(path: &Path) -> Result<Inspected, Problem> {
    let io_problem = |error: &std::io::Error| {
        let remedy = match error.kind() {
            std::io::ErrorKind::NotFound => "check the path",
            std::io::ErrorKind::PermissionDenied => "make the file readable",
            _ => "check the file and its disk",
        };
        Problem::new("", format!("cannot be read: {error}"), remedy)
    };
    let metadata = fs::metadata(path).map_err(|error| io_problem(&error))?;
    if metadata.is_dir() {
        return Err(Problem::new("", "is a directory", "give the USD file inside it"));
    }
    // A pipe or a device could deliver without end.
    if !metadata.is_file() {
        return Err(Problem::new("", "is not a regular file", NOT_USD));
    }
    if metadata.len() > MAX_LAYER_BYTES {
        return Err(Problem::new(
            "",
            format!(
                "has {} bytes, more than the {MAX_LAYER_BYTES} that are read",
                metadata.len()
            ),
            "split it into layers",
        ));
    }
    let mut opened = fs::File::open(path).map_err(|error| io_problem(&error))?;
    // The first bytes decide, so that a large file of another kind is not read whole.
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
    let findings = look_over(kind, &bytes)?;
    Ok(Inspected {
        bytes: Arc::new(bytes),
        findings,
    })
}

/// Looks over a layer that is in memory, an entry of a package.
pub(super) fn layer(name: &str, bytes: &[u8]) -> Result<(), Problem> {
    look_over(kind(name, bytes)?, bytes).map(drop)
}

/// The bytes of an entry of a package that was looked over.
pub(super) fn packaged<'a>(package: &'a [u8], name: &str) -> Option<&'a [u8]> {
    package::find(package, name)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Text,
    Binary,
    Package,
}

fn look_over(kind: Kind, bytes: &[u8]) -> Result<Vec<Finding>, Problem> {
    match kind {
        Kind::Text => text::inspect(bytes).map(|()| Vec::new()),
        Kind::Binary => binary::inspect(bytes).map(|()| Vec::new()),
        Kind::Package => package::inspect(bytes),
    }
}

/// What a file is by its first bytes; an error where that is not what its name says.
fn kind(name: &str, head: &[u8]) -> Result<Kind, Problem> {
    if head.is_empty() {
        return Err(Problem::new("", "is empty", "export the stage again"));
    }
    let extension = Path::new(name)
        .extension()
        .map(|extension| extension.to_string_lossy().to_ascii_lowercase())
        .unwrap_or_default();
    let kind = if head.starts_with(b"#usda") {
        Kind::Text
    } else if head.starts_with(b"PXR-USDC") {
        Kind::Binary
    } else if head.starts_with(b"PK\x03\x04") || head.starts_with(b"PK\x05\x06") {
        Kind::Package
    } else if head.starts_with(b"version https://git-lfs") {
        return Err(Problem::new(
            "",
            "is a Git LFS pointer, not the file itself",
            "run `git lfs pull` in its repository",
        ));
    } else {
        return Err(Problem::new(
            "start",
            "is no USD file: it begins neither with `#usda`, nor with `PXR-USDC`, nor as a package",
            NOT_USD,
        ));
    };
    let (is, should_be) = match kind {
        Kind::Text => ("USD text", "usda"),
        Kind::Binary => ("binary USD", "usdc"),
        Kind::Package => ("a package", "usdz"),
    };
    let fits = extension == should_be || (extension == "usd" && kind != Kind::Package);
    if fits {
        Ok(kind)
    } else {
        Err(Problem::new(
            "start",
            format!("holds {is}, which its name does not say"),
            format!("rename it to end in .{should_be}"),
        ))
    }
}
