//! Bounded reads and atomic writes of the files that a user names, and the [memory] that the process may use.

mod atomic;
mod error;
pub mod memory;
mod named;
mod output;
mod temporary;

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

pub use atomic::{AtomicFile, write};
pub use error::FileError;
use error::or_current;
pub use named::{is_below, open_regular, read_regular};
pub use output::{OutputFiles, PackedFiles};
pub use temporary::abandon;

/// A file that was written.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct WrittenFile {
    /// The path.
    pub path: PathBuf,
    /// The length in bytes.
    pub bytes: u64,
}

/// Reads a whole file of at most `limit` bytes; `what` names its kind in the error (`a calibration`).
///
/// # Errors
/// Returns an error if the file is missing, a folder, unreadable or larger than the limit.
pub fn read(path: &Path, limit: u64, what: &str) -> Result<Vec<u8>, FileError> {
    let file = File::open(path).map_err(|e| FileError::reading(path, &e))?;
    let metadata = file.metadata().map_err(|e| FileError::reading(path, &e))?;
    if metadata.is_dir() {
        return Err(FileError::new(path, "is a directory", "name a file in it"));
    }
    let mut bytes = Vec::new();
    // One byte more than allowed, because the length of a pipe is unknown.
    file.take(limit + 1)
        .read_to_end(&mut bytes)
        .map_err(|e| FileError::reading(path, &e))?;
    if bytes.len() as u64 > limit {
        let message = format!("is larger than {} MiB, the limit for {what}", limit >> 20);
        return Err(FileError::new(path, message, "check that it is the right file"));
    }
    Ok(bytes)
}

/// Creates a folder and its parents.
///
/// # Errors
/// Returns an error if the folder cannot be created, or if a file has its name.
pub fn make_folder(path: &Path) -> Result<(), FileError> {
    fs::create_dir_all(path).map_err(|e| {
        if path.exists() {
            FileError::new(path, "is a file, not a folder", "name a folder")
        } else {
            FileError::writing(path, &e)
        }
    })
}

/// Returns the path of a file relative to `folder`, as USD layers reference it: `./x.usd`, `../y/x.usd`.
///
/// # Errors
/// Returns an error if an absolute path cannot be determined.
pub fn relative(folder: &Path, file: &Path) -> Result<String, FileError> {
    let absolute = |path: &Path| {
        let path = or_current(path);
        fs::canonicalize(path).or_else(|_| std::path::absolute(path))
    };
    let unknown = |_| FileError::new(file, "its absolute path cannot be determined", "check the path");
    let (folder, file) = (
        absolute(folder).map_err(unknown)?,
        absolute(file).map_err(unknown)?,
    );
    let common = folder
        .components()
        .zip(file.components())
        .take_while(|(a, b)| a == b)
        .count();
    let up = folder.components().skip(common).map(|_| "..".to_owned());
    let down = file
        .components()
        .skip(common)
        .map(|part| part.as_os_str().to_string_lossy().into_owned());
    let parts: Vec<String> = up.chain(down).collect();
    let path = parts.join("/");
    Ok(if path.starts_with("..") {
        path
    } else {
        format!("./{path}")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_relative_to_the_folder() {
        let root = tempfile::tempdir().unwrap();
        let base = root.path().join("vendor/a.usd");
        fs::create_dir_all(root.path().join("vendor")).unwrap();
        fs::write(&base, "").unwrap();
        fs::create_dir_all(root.path().join("mine/deep")).unwrap();
        assert_eq!(relative(&root.path().join("vendor"), &base).unwrap(), "./a.usd");
        assert_eq!(relative(root.path(), &base).unwrap(), "./vendor/a.usd");
        assert_eq!(
            relative(&root.path().join("mine/deep"), &base).unwrap(),
            "../../vendor/a.usd"
        );
    }

    #[test]
    fn limits_the_size_of_reads() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("big.json");
        fs::write(&path, vec![b' '; (1 << 20) + 1]).unwrap();
        assert!(
            read(&path, 1 << 20, "a calibration")
                .unwrap_err()
                .to_string()
                .contains("larger than 1 MiB")
        );
        assert!(
            read(folder.path(), 1 << 20, "a calibration")
                .unwrap_err()
                .to_string()
                .contains("is a directory")
        );
        let missing = read(&folder.path().join("x"), 1 << 20, "a calibration")
            .unwrap_err()
            .to_string();
        assert!(missing.contains("there is no such file"), "{missing}");
    }
}
