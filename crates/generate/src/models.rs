use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin_dataset::Model;

/// The file of an object, as an index into the recipe's files, and the bits of its scale.
type Key = (usize, u64);

/// The models of a data set's objects, created on first use.
#[derive(Debug, Default)]
pub(crate) struct Models {
    known: Mutex<BTreeMap<Key, Arc<Model>>>,
}

impl Models {
    pub(crate) fn get(&self, key: Key, create: impl FnOnce() -> Model) -> Arc<Model> {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        known.entry(key).or_insert_with(|| Arc::new(create())).clone()
    }
}
