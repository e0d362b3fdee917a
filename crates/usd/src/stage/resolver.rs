use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::io::{self, Cursor, Read, Seek, SeekFrom};
use std::path::Path;
use std::rc::Rc;
use std::sync::Arc;

use oaktwin_files as files;
use openusd::ar::{self, Asset, DefaultResolver, ResolvedPath, Resolver};

use super::budget::Budget;
use super::inspect::{self, Content, Inspected, Outline, unreadable};
use super::packages::Packages;
use crate::materialx;

/// The suffix added to the names of text layers and `MaterialX` documents, so that the library, which selects readers by
/// name, reads what [`inspect`] makes of them as binary layers.
const AS_BINARY: &str = ".binary.usdc";
/// The maximum size of a document, in bytes.
const MAX_DOCUMENT_BYTES: u64 = 64 << 20;

/// Splits the closing bracket from the name of a package's entry.
fn without_bracket(path: &str) -> (&str, &str) {
    match path.strip_suffix(']') {
        Some(name) => (name, "]"),
        None => (path, ""),
    }
}

fn has_extension(name: &str, extension: &str) -> bool {
    name.to_ascii_lowercase().ends_with(extension)
}

/// Returns the name by which the library opens a layer.
fn library_name(path: &str) -> Option<String> {
    let (name, bracket) = without_bracket(path);
    let is_text = has_extension(name, ".usda") || has_extension(name, ".mtlx");
    is_text.then(|| format!("{name}{AS_BINARY}{bracket}"))
}

/// Returns the name of the file that the library opens by a name of [`library_name`]. Other names are returned unchanged.
fn file_name(path: &str) -> String {
    let (name, bracket) = without_bracket(path);
    let name = name.strip_suffix(AS_BINARY).unwrap_or(name);
    format!("{name}{bracket}")
}

/// OpenUSD's default resolver, with validation of every file before the library reads it.
pub(super) struct InspectingResolver {
    inner: DefaultResolver,
    budget: Rc<Budget>,
    packages: Rc<Packages>,
    /// The layers that are counted.
    counted: RefCell<HashSet<String>>,
    /// The layer read last, initially the stage's own: the library opens a layer several times in a row, to detect its
    /// format and to read it.
    last: RefCell<(String, Arc<Vec<u8>>)>,
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
    /// Creates the resolver of the stage in the file `root`.
    pub(super) fn new(root: &str, file: &Rc<Inspected>, budget: Rc<Budget>, packages: Rc<Packages>) -> Self {
        let path = Path::new(root);
        let path = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let name = path.to_string_lossy().into_owned();
        let resolver = Self {
            inner: DefaultResolver::new(),
            budget,
            packages,
            counted: RefCell::default(),
            last: RefCell::new((name.clone(), file.bytes.clone())),
        };
        match &file.content {
            Content::Layer(outline) => resolver.count(&name, outline, file.size),
            Content::Package(_) => resolver.packages.keep(name, file.clone()),
        }
        resolver
    }

    fn count(&self, layer: &str, outline: &Outline, bytes: usize) {
        if self.counted.borrow_mut().insert(layer.to_owned()) {
            let anchor = ResolvedPath::new(layer);
            let known = RefCell::new(HashMap::new());
            let resolve = |path: &str| -> Option<String> {
                let resolve = || {
                    let resolved = self.resolve(&self.inner.create_identifier(path, Some(&anchor)))?;
                    Some(file_name(&resolved.to_string_lossy()))
                };
                known
                    .borrow_mut()
                    .entry(path.to_owned())
                    .or_insert_with(resolve)
                    .clone()
            };
            self.budget.layer(layer, outline, bytes, resolve);
        }
    }

    /// Reads and validates a layer.
    fn read(&self, name: &str) -> Result<Inspected, inspect::Problem> {
        let entry = ar::split_package_relative_path_outer(name);
        if !has_extension(without_bracket(name).0, ".mtlx") {
            return match entry {
                Some((package, entry)) => inspect::layer(&entry, self.packages.entry(&package, &entry)?),
                None => inspect::file(Path::new(name)),
            };
        }
        let document = match entry {
            Some((package, entry)) => self.packages.entry(&package, &entry)?,
            None => files::read_regular(Path::new(name), MAX_DOCUMENT_BYTES)
                .map_err(|error| unreadable(&error))?,
        };
        let layer = materialx::to_layer(&document).map_err(|error| unreadable(&error))?;
        inspect::layer("document.usda", layer.text().into_bytes())
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
        let mut name = resolved.to_string_lossy().into_owned();
        // The library would read the whole package again to find its root layer.
        if has_extension(&name, ".usdz")
            && let Ok(package) = self.packages.open(&name)
            && let Some(directory) = package.directory()
        {
            name = ar::join_package_relative_path(&name, &directory.root);
        }
        Some(ResolvedPath::new(library_name(&name).unwrap_or(name)))
    }

    fn resolve_for_new_asset(&self, asset_path: &str) -> Option<ResolvedPath> {
        self.inner.resolve_for_new_asset(asset_path)
    }

    fn open_asset(&self, resolved: &ResolvedPath) -> io::Result<Box<dyn Asset>> {
        let name = file_name(&resolved.to_string_lossy());
        if self.last.borrow().0 != name {
            let layer = self
                .read(&name)
                .map_err(|problem| io::Error::new(io::ErrorKind::InvalidData, problem.to_string()))?;
            match &layer.content {
                Content::Layer(outline) => self.count(&name, outline, layer.size),
                Content::Package(_) => self.count(&name, &Outline::default(), layer.size),
            }
            self.last.replace((name, layer.bytes));
        }
        let bytes = self.last.borrow().1.clone();
        Ok(Box::new(Shared { bytes, at: 0 }))
    }
}
