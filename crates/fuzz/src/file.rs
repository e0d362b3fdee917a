//! Inputs that are read as files.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

thread_local! {
    /// A folder for each thread, because making and removing one takes longer than reading most inputs.
    static FOLDER: TempDir = tempfile::tempdir().unwrap_or_else(|error| panic!("{error}"));
}

/// Calls a function with the path of a file with these bytes, alone in its folder.
pub(crate) fn with<T>(name: &str, bytes: &[u8], check: impl FnOnce(&Path) -> T) -> T {
    FOLDER.with(|folder| {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap_or_else(|error| panic!("{error}"));
        let result = check(&path);
        fs::remove_file(&path).unwrap_or_else(|error| panic!("{error}"));
        result
    })
}
