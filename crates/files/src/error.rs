use std::io;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::Message;

/// A file that cannot be read or written: `FILE: what is wrong; what to do`.
#[derive(Debug, thiserror::Error)]
#[error("{}: {message}; {remedy}", path.display())]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong.
    pub message: Message,
    /// What to do.
    pub remedy: Message,
}

impl FileError {
    /// Creates an error about `path`.
    pub fn new(path: &Path, message: impl Into<Message>, remedy: impl Into<Message>) -> Self {
        Self {
            path: path.to_owned(),
            message: message.into(),
            remedy: remedy.into(),
        }
    }

    /// Returns the error for a failed read of `path`.
    #[must_use]
    pub fn reading(path: &Path, error: &io::Error) -> Self {
        let (message, remedy) = match error.kind() {
            io::ErrorKind::NotFound => ("there is no such file", "check the path"),
            // Windows denies the permission to open a folder.
            io::ErrorKind::PermissionDenied if path.is_dir() => ("is a directory", "name a file in it"),
            io::ErrorKind::PermissionDenied => ("permission denied", "check its permissions"),
            io::ErrorKind::IsADirectory => ("is a directory", "name a file in it"),
            _ => return Self::new(path, format!("cannot be read ({error})"), "check the path"),
        };
        Self::new(path, message, remedy)
    }

    /// Returns the error for a failed write to `path`.
    #[must_use]
    pub fn writing(path: &Path, error: &io::Error) -> Self {
        // Where a file has the name of a folder, Windows finds nothing.
        if matches!(
            error.kind(),
            io::ErrorKind::NotADirectory | io::ErrorKind::NotFound
        ) && let Some(file) = path.ancestors().skip(1).find(|folder| folder.is_file())
        {
            return Self::new(file, "is a file, not a folder", "choose another folder");
        }
        let (message, remedy) = match error.kind() {
            io::ErrorKind::NotFound if folder(path).is_dir() => {
                ("cannot be created in its folder", "choose another place")
            }
            io::ErrorKind::NotFound => ("its folder does not exist", "make the folder first"),
            io::ErrorKind::PermissionDenied => ("permission denied", "choose another place"),
            io::ErrorKind::ReadOnlyFilesystem => ("is on a read-only file system", "choose another place"),
            io::ErrorKind::StorageFull => ("there is no space left", "free some, or choose another place"),
            io::ErrorKind::FileTooLarge => {
                let remedy = "raise the limit (ulimit -f), or choose another place";
                return Self::new(path, "would be larger than files may be here", remedy);
            }
            io::ErrorKind::QuotaExceeded => (
                "the disk quota is exceeded",
                "free some space, or choose another place",
            ),
            io::ErrorKind::IsADirectory => ("is a directory", "name a file in it"),
            io::ErrorKind::NotADirectory => ("is a file, not a folder", "choose another folder"),
            _ => {
                return Self::new(
                    path,
                    format!("cannot be written ({error})"),
                    "choose another place",
                );
            }
        };
        Self::new(path, message, remedy)
    }
}

/// Returns the folder of a file.
pub(crate) fn folder(path: &Path) -> &Path {
    or_current(path.parent().unwrap_or(Path::new("")))
}

/// Returns a folder, or `.` for an empty path.
pub(crate) fn or_current(folder: &Path) -> &Path {
    if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    }
}
