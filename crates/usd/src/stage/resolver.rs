use std::cell::RefCell;
use std::collections::HashSet;
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

use oaktwin_files as files;
use openusd::ar::{self, Asset, DefaultResolver, ResolvedPath, Resolver};

use super::budget::Budget;
use super::inspect::{self, Content, Decoded, Inspected, Outline, unreadable};
use super::packages::Packages;
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
    budget: Rc<Budget>,
    packages: Rc<Packages>,
    /// The layers found to be valid, and counted.
    valid: RefCell<HashSet<String>>,
    /// The layer read last, initially the stage's own: the library opens a layer several times in a row, to detect its
    /// format and to read it.
    last: RefCell<(PathBuf, Arc<Decoded>)>,
}

/// A file in memory, shared by several readers.
struct Shared {
    file: Arc<Decoded>,
    at: u64,
}

impl Read for Shared {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut cursor = Cursor::new(self.file.bytes.as_slice());
        cursor.set_position(self.at);
        let count = cursor.read(buffer)?;
        self.at = cursor.position();
        Ok(count)
    }
}

impl Seek for Shared {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        let mut cursor = Cursor::new(self.file.bytes.as_slice());
        cursor.set_position(self.at);
        self.at = cursor.seek(to)?;
        Ok(self.at)
    }
}

impl Asset for Shared {
    fn size(&self) -> io::Result<u64> {
        Ok(self.file.bytes.len() as u64)
    }

    fn read_all(&mut self) -> io::Result<Vec<u8>> {
        Ok(self.file.bytes.clone())
    }
}

impl InspectingResolver {
    /// Creates the resolver of the stage in the file `root`.
    pub(super) fn new(root: &str, file: &Rc<Inspected>, budget: Rc<Budget>, packages: Rc<Packages>) -> Self {
        let path = PathBuf::from(root);
        let path = path.canonicalize().unwrap_or(path);
        let name = path.to_string_lossy().into_owned();
        let resolver = Self {
            inner: DefaultResolver::new(),
            budget,
            packages,
            valid: RefCell::default(),
            last: RefCell::new((path, file.decoded.clone())),
        };
        match &file.content {
            Content::Layer(outline) => resolver.count(&name, outline, file.decoded.bytes.len()),
            Content::Package(_) => resolver.packages.keep(name, file.clone()),
        }
        resolver
    }

    fn count(&self, layer: &str, outline: &Outline, bytes: usize) {
        if self.valid.borrow_mut().insert(layer.to_owned()) {
            let anchor = ResolvedPath::new(layer);
            let sublayers = outline.sublayers.iter().filter_map(|path| {
                let resolved = self.resolve(&self.inner.create_identifier(path, Some(&anchor)))?;
                Some(resolved.to_string_lossy().into_owned())
            });
            self.budget.layer(layer, sublayers.collect(), outline, bytes);
        }
    }

    /// Opens a `MaterialX` document as the text of a layer.
    fn materialx(&self, path: &str) -> Result<Box<dyn Asset>, inspect::Problem> {
        let bytes = match ar::split_package_relative_path_outer(path) {
            Some((package, entry)) => self.packages.entry(&package, &entry)?,
            None => files::read_regular(Path::new(path), MAX_DOCUMENT_BYTES)
                .map_err(|error| unreadable(&error))?,
        };
        let layer = materialx::to_layer(&bytes).map_err(|error| unreadable(&error))?;
        Ok(Box::new(Cursor::new(inspect::decode(layer.text().into_bytes())?)))
    }
}

impl Resolver for InspectingResolver {
    fn create_identifier(&self, asset_path: &str, anchor: Option<&ResolvedPath>) -> String {
        self.budget.arc(anchor.map(|anchor| &**anchor));
        self.inner.create_identifier(asset_path, anchor)
    }

    fn resolve(&self, asset_path: &str) -> Option<ResolvedPath> {
        let resolved = match ar::split_package_relative_path_outer(asset_path) {
            Some((package, entry)) => {
                let package = self.inner.resolve(&package)?;
                let package = package.to_string_lossy();
                let known = self.packages.open(&package).ok()?;
                known.directory().filter(|directory| directory.contains(&entry))?;
                ResolvedPath::new(ar::join_package_relative_path(&package, &entry))
            }
            None => self.inner.resolve(asset_path)?,
        };
        let name = resolved.to_string_lossy();
        if let Some(named) = as_text_layer(&name) {
            return Some(ResolvedPath::new(named));
        }
        // The library would read the whole package again to find its root layer.
        if name.to_ascii_lowercase().ends_with(".usdz")
            && let Ok(package) = self.packages.open(&name)
            && let Some(directory) = package.directory()
        {
            return Some(ResolvedPath::new(ar::join_package_relative_path(
                &name,
                &directory.root,
            )));
        }
        Some(resolved)
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
        if let Some((package, entry)) = ar::split_package_relative_path_outer(&text) {
            let bytes: Vec<u8> = self.packages.entry(&package, &entry).map_err(invalid_data)?;
            if !self.valid.borrow().contains(&text) {
                let layer = inspect::layer(&entry, bytes).map_err(invalid_data)?;
                match &layer.content {
                    Content::Layer(outline) => self.count(&text, outline, layer.decoded.bytes.len()),
                    Content::Package(_) => self.count(&text, &Outline::default(), layer.decoded.bytes.len()),
                }
                let file = layer.decoded;
                return Ok(Box::new(Shared { file, at: 0 }));
            }
            let bytes = inspect::decode(bytes).map_err(invalid_data)?;
            return Ok(Box::new(Cursor::new(bytes)));
        }
        let path: &Path = resolved;
        if self.last.borrow().0 != path {
            let file = inspect::file(path).map_err(invalid_data)?;
            if let Content::Layer(outline) = &file.content {
                self.count(&text, outline, file.decoded.bytes.len());
            }
            self.last.replace((path.to_owned(), file.decoded));
        }
        let file = self.last.borrow().1.clone();
        Ok(Box::new(Shared { file, at: 0 }))
    }
}
