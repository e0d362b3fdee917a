//! Files that were dropped onto the page, by their ids. Those that were dropped last are kept.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};

use crate::protocol::Failure;

/// A file that was read.
pub(crate) trait Keep {
    /// What the page knows about it.
    type Info: Clone;
    /// What the file is, in errors.
    const NAME: &'static str;
    /// The number of files that are kept.
    const COUNT: usize;

    /// Its id and what the page knows.
    fn known(&self) -> (&str, &Self::Info);
}

/// The files of a kind.
#[derive(Debug)]
pub(crate) struct Kept<T>(Mutex<VecDeque<Arc<T>>>);

impl<T> Default for Kept<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<T: Keep> Kept<T> {
    /// Keeps a file, in place of the same one.
    pub(crate) fn add(&self, file: T) -> T::Info {
        let (id, info) = file.known();
        let info = info.clone();
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known.retain(|other| other.known().0 != id);
        known.push_back(Arc::new(file));
        while known.len() > T::COUNT {
            known.pop_front();
        }
        info
    }

    pub(crate) fn get(&self, id: &str) -> Result<Arc<T>, Failure> {
        let known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let found = known.iter().find(|file| file.known().0 == id).cloned();
        found.ok_or_else(|| {
            let name = T::NAME;
            Failure::of(
                name,
                &format!("no {name} '{id}'; drop the file onto the page again"),
            )
        })
    }
}
