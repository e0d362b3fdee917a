//! Bounded reads and atomic writes of the files that a user names, and the [memory] that the process may use.

mod atomic;
mod error;
pub mod memory;
mod named;
mod output;
mod temporary;
pub mod xml;

use std::fs::{self, File};
use std::io::{self, Read};
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

/// Returns a path as files name others on every system: with slashes, and without the `\\?\` that Windows puts before absolute
/// paths.
#[must_use]
pub fn with_slashes(path: &Path) -> String {
    let path = path.to_string_lossy();
    match std::path::MAIN_SEPARATOR {
        '/' => path.into_owned(),
        separator => plain(&path.replace(separator, "/")),
    }
}

fn plain(path: &str) -> String {
    match (path.strip_prefix("//?/UNC/"), path.strip_prefix("//?/")) {
        (Some(share), _) => format!("//{share}"),
        (None, path_on_drive) => path_on_drive.unwrap_or(path).to_owned(),
    }
}

/// Returns an absolute path whose existing part has no symbolic links.
fn absolute(path: &Path) -> io::Result<PathBuf> {
    let path = std::path::absolute(or_current(path))?;
    let mut folders = path.ancestors();
    let real =
        folders.find_map(|folder| Some(folder.canonicalize().ok()?.join(path.strip_prefix(folder).ok()?)));
    Ok(real.unwrap_or(path))
}

/// Returns the path of a file relative to `folder`, as USD layers reference it: `./x.usd`, `../y/x.usd`; an absolute one if the
/// file is on another drive.
///
/// # Errors
/// Returns an error if an absolute path cannot be determined.
pub fn relative(folder: &Path, file: &Path) -> Result<String, FileError> {
    let unknown = |_| FileError::new(file, "its absolute path cannot be determined", "check the path");
    let text = |path| Ok(with_slashes(&absolute(path).map_err(unknown)?));
    let (folder, file) = (text(folder)?, text(file)?);
    Ok(below_or_beside(&folder, &file))
}

/// Returns an absolute path with slashes relative to a folder.
fn below_or_beside(folder: &str, file: &str) -> String {
    fn parts(path: &str) -> Vec<&str> {
        path.trim_end_matches('/').split('/').collect()
    }
    let (folder, names) = (parts(folder), parts(file));
    let common = folder.iter().zip(&names).take_while(|(a, b)| a == b).count();
    let (up, down) = (folder.len() - common, names[common..].join("/"));
    match (common, up) {
        // The first part is the drive; it is empty on other systems than Windows.
        (0, _) => file.to_owned(),
        (_, 0) => format!("./{down}"),
        (_, up) => "../".repeat(up) + &down,
    }
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
    fn paths_on_drives_have_slashes() {
        assert_eq!(plain("//?/C:/a/b.usd"), "C:/a/b.usd");
        assert_eq!(plain("//?/UNC/server/share/b.usd"), "//server/share/b.usd");
        assert_eq!(plain("C:/a"), "C:/a");
        assert_eq!(below_or_beside("C:/a/b", "C:/a/c.usd"), "../c.usd");
        assert_eq!(below_or_beside("C:/", "C:/a/c.usd"), "./a/c.usd");
        assert_eq!(below_or_beside("/", "/a/c.usd"), "./a/c.usd");
        assert_eq!(below_or_beside("C:/a", "D:/a/c.usd"), "D:/a/c.usd");
    }

    #[cfg(unix)]
    #[test]
    fn folders_that_do_not_exist_yet_may_be_below_links() {
        let root = tempfile::tempdir().unwrap();
        let at = |name: &str| root.path().join(name);
        fs::create_dir_all(at("real/deep")).unwrap();
        fs::write(at("a.usd"), "").unwrap();
        std::os::unix::fs::symlink("real/deep", at("link")).unwrap();
        assert_eq!(relative(&at("link/new"), &at("a.usd")).unwrap(), "../../../a.usd");
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
