use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::path::Path;
use std::rc::Rc;

use super::inspect::{self, Inspected, Problem, unreadable};

/// The maximum size of the packages kept in memory, in bytes, unless one alone is larger.
const MAX_KEPT_BYTES: usize = 512 << 20;

/// The packages of a stage, each read and validated once: the library opens a package for each of its files.
#[derive(Debug, Default)]
pub(super) struct Packages {
    kept: RefCell<HashMap<String, Rc<Inspected>>>,
    bytes: Cell<usize>,
}

impl Packages {
    /// Keeps a package that has been read.
    pub(super) fn keep(&self, path: String, package: Rc<Inspected>) {
        let mut kept = self.kept.borrow_mut();
        let mut bytes = self.bytes.get() + package.bytes.len();
        if bytes > MAX_KEPT_BYTES {
            kept.clear();
            bytes = package.bytes.len();
        }
        self.bytes.set(bytes);
        kept.insert(path, package);
    }

    /// Returns the package at `path`.
    pub(super) fn open(&self, path: &str) -> Result<Rc<Inspected>, Problem> {
        if let Some(known) = self.kept.borrow().get(path) {
            return Ok(known.clone());
        }
        let package = Rc::new(inspect::file(Path::new(path))?);
        self.keep(path.to_owned(), package.clone());
        Ok(package)
    }

    /// Returns the bytes of a file in the package at `path`.
    pub(super) fn entry<T: for<'a> From<&'a [u8]>>(&self, path: &str, name: &str) -> Result<T, Problem> {
        let package = self.open(path)?;
        let directory = package.directory();
        let bytes = directory.and_then(|directory| directory.entry(&package.bytes, name));
        bytes.map(T::from).ok_or_else(|| unreadable(&"no such entry"))
    }
}
