use std::cell::RefCell;
use std::collections::HashSet;
use std::fs;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use openusd::ar::{self, Asset, DefaultResolver, ResolvedPath, Resolver};

use super::inspect;
use crate::materialx;

/// The suffix added to the name of a `MaterialX` document so that the library, which selects readers by name and has
/// none for these, reads it as a text layer.
const AS_TEXT: &str = ".usda";
/// The maximum size of a document, in bytes.
const MAX_DOCUMENT_BYTES: u64 = 64 << 20;

/// Returns the name of a `MaterialX` document as a text layer; `None` for other files.
fn as_text_layer(path: &str) -> Option<String> {
    let (name, bracket) = match path.strip_suffix(']') {
        Some(name) => (name, "]"),
        None => (path, ""),
    };
    let is_document = name.to_ascii_lowercase().ends_with(".mtlx");
    is_document.then(|| format!("{name}{AS_TEXT}{bracket}"))
}

/// Returns the document of such a text layer.
fn materialx_document(path: &str) -> Option<String> {
    let (name, bracket) = match path.strip_suffix(']') {
        Some(name) => (name, "]"),
        None => (path, ""),
    };
    let document = name.strip_suffix(AS_TEXT)?;
    let is_document = document.to_ascii_lowercase().ends_with(".mtlx");
    is_document.then(|| format!("{document}{bracket}"))
}

/// OpenUSD's default resolver, with validation of every file before the library reads it.
pub(super) struct InspectingResolver {
    inner: DefaultResolver,
    /// The packages found to be valid: the library opens a package once for each of its files.
    packages: RefCell<HashSet<String>>,
    /// The layer validated last, initially the stage's own: the library opens a layer several times in a row, to detect
    /// its format and to read it.
    last: RefCell<(PathBuf, Arc<Vec<u8>>)>,
}

/// A file in memory, shared by several readers.
struct Shared {
    bytes: Arc<Vec<u8>>,
    at: u64,
}

impl Read for Shared {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut cursor = Cursor::new(self.bytes.as_slice());
        cursor.set_position(self.at);
        let count = cursor.read(buffer)?;
        self.at = cursor.position();
        Ok(count)
    }
}

impl Seek for Shared {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let mut cursor = Cursor::new(self.bytes.as_slice());
        cursor.set_position(self.at);
        self.at = cursor.seek(to)?;
        Ok(self.at)
    }
}

impl Asset for Shared {
    fn size(&self) -> io::Result<u64> {
        Ok(self.bytes.len() as u64)
    }

    fn read_all(&mut self) -> io::Result<Vec<u8>> {
        Ok(self.bytes.to_vec())
    }
}

impl InspectingResolver {
    /// Creates the resolver of the stage in the file `root` with content `bytes`.
    pub(super) fn new(root: &str, bytes: Arc<Vec<u8>>) -> Self {
        let root = PathBuf::from(root);
        Self {
            last: RefCell::new((root.canonicalize().unwrap_or(root), bytes)),
            inner: DefaultResolver::new(),
            packages: RefCell::default(),
        }
    }
}

impl InspectingResolver {
    /// Opens a `MaterialX` document as the text of a layer.
    fn materialx(&self, path: &str) -> Result<Box<dyn Asset>, inspect::Problem> {
        let unreadable = |what: &dyn std::fmt::Display| inspect::Problem {
            place: String::new(),
            what: format!("cannot be read: {what}"),
            remedy: String::new(),
        };
        let bytes = match ar::split_package_relative_path_outer(path) {
            Some((package, entry)) => {
                let package = inspect::file(Path::new(&package))?;
                let bytes =
                    inspect::packaged(&package.bytes, &entry).ok_or_else(|| unreadable(&"no such entry"))?;
                bytes.to_vec()
            }
            None => {
                let mut bytes = Vec::new();
                let file = fs::File::open(path).map_err(|error| unreadable(&error))?;
                file.take(MAX_DOCUMENT_BYTES)
                    .read_to_end(&mut bytes)
                    .map_err(|error| unreadable(&error))?;
                bytes
            }
        };
        let layer = materialx::to_layer(&bytes).map_err(|error| unreadable(&error))?;
        Ok(Box::new(Cursor::new(layer.text().into_bytes())))
    }
}

impl Resolver for InspectingResolver {
    fn create_identifier(&self, asset_path: &str, anchor: Option<&ResolvedPath>) -> String {
        self.inner.create_identifier(asset_path, anchor)
    }

    fn resolve(&self, asset_path: &str) -> Option<ResolvedPath> {
        // Resolving a path into a package opens the package.
        if let Some((package, _)) = ar::split_package_relative_path_outer(asset_path)
            && !self.packages.borrow().contains(&package)
        {
            inspect::file(Path::new(&package)).ok()?;
            self.packages.borrow_mut().insert(package);
        }
        let resolved = self.inner.resolve(asset_path)?;
        Some(match as_text_layer(&resolved.to_string_lossy()) {
            Some(named) => ResolvedPath::new(named),
            None => resolved,
        })
    }

    fn resolve_for_new_asset(&self, asset_path: &str) -> Option<ResolvedPath> {
        self.inner.resolve_for_new_asset(asset_path)
    }

    fn open_asset(&self, resolved: &ResolvedPath) -> io::Result<Box<dyn Asset>> {
        let invalid_data =
            |problem: inspect::Problem| io::Error::new(io::ErrorKind::InvalidData, problem.to_string());
        let text = resolved.to_string_lossy().into_owned();
        if let Some(document) = materialx_document(&text) {
            return self.materialx(&document).map_err(invalid_data);
        }
        if let Some((package, inner)) = ar::split_package_relative_path_outer(&text) {
            inspect::file(Path::new(&package)).map_err(invalid_data)?;
            let bytes = self.inner.open_asset(resolved)?.read_all()?;
            inspect::layer(&inner, &bytes).map_err(invalid_data)?;
            return Ok(Box::new(Cursor::new(bytes)));
        }
        let path: &Path = resolved;
        if self.last.borrow().0 != path {
            let bytes = inspect::file(path).map_err(invalid_data)?.bytes;
            self.last.replace((path.to_owned(), bytes));
        }
        let bytes = self.last.borrow().1.clone();
        Ok(Box::new(Shared { bytes, at: 0 }))
    }
}
