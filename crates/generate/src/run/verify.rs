//! The comparison of finished files with the checksums of their records.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::store::{FileRecord, Store, checksum};

/// Compares the contents of files, those that hold many others once.
pub(super) struct Verifier<'a> {
    store: &'a Store,
    containers: RefCell<BTreeMap<String, Option<String>>>,
}

impl<'a> Verifier<'a> {
    pub(super) fn new(store: &'a Store) -> Self {
        Self {
            store,
            containers: RefCell::default(),
        }
    }

    /// Whether all files of an intact frame have their contents.
    pub(super) fn is_unchanged(&self, frame: u64) -> bool {
        let record = self.store.frame(frame);
        record.is_ok_and(|record| record.files.iter().all(|file| self.has_contents(file)))
    }

    fn has_contents(&self, file: &FileRecord) -> bool {
        let sum = |path: &str| checksum(&self.store.root.join(path)).ok();
        let Some(container) = &file.packed_in else {
            return sum(&file.path).as_ref() == Some(&file.sha256);
        };
        let mut known = self.containers.borrow_mut();
        let found = known
            .entry(container.path.clone())
            .or_insert_with(|| sum(&container.path));
        *found == container.sha256
    }
}
