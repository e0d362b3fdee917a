//! Reading what people name and writing what they asked for: bounded reads, whole files or none.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use oaktwin_diagnostic::Message;
use oaktwin_image::CodecError;

/// A file that could not be read or written. Reads `FILE: what is wrong; what to do`.
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
    /// An error about `path`.
    pub fn new(path: &Path, message: impl Into<Message>, remedy: impl Into<Message>) -> Self {
        Self {
            path: path.to_owned(),
            message: message.into(),
            remedy: remedy.into(),
        }
    }

    /// That a file's bytes are not what they should be.
    #[must_use]
    pub fn codec(path: &Path, error: &CodecError) -> Self {
        let message = format!("{}: {}: {}", error.format, error.place, error.problem);
        Self::new(path, message, error.remedy)
    }

    fn reading(path: &Path, error: &io::Error) -> Self {
        let (message, remedy) = match error.kind() {
            io::ErrorKind::NotFound => ("there is no such file", "check the path"),
            io::ErrorKind::PermissionDenied => ("may not be read", "check its permissions"),
            io::ErrorKind::IsADirectory => ("is a directory", "name a file in it"),
            _ => return Self::new(path, format!("cannot be read ({error})"), "check the path"),
        };
        Self::new(path, message, remedy)
    }

    /// The error of writing to `path`.
    #[must_use]
    pub fn writing(path: &Path, error: &io::Error) -> Self {
        let (message, remedy) = match error.kind() {
            io::ErrorKind::NotFound => ("its folder does not exist", "make the folder first"),
            io::ErrorKind::PermissionDenied => ("may not be written", "choose another place"),
            io::ErrorKind::ReadOnlyFilesystem => ("is on a read-only file system", "choose another place"),
            io::ErrorKind::StorageFull => ("there is no space left", "free some, or choose another place"),
            io::ErrorKind::IsADirectory => ("is a directory", "name a file in it"),
            io::ErrorKind::NotADirectory => ("a part of its path is a file, not a folder", "check the path"),
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

/// A file that was written.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct WrittenFile {
    /// Where it is.
    pub path: PathBuf,
    /// Its length.
    pub bytes: u64,
}

/// Reads a whole file of at most `limit` bytes, of which `what` (`a calibration`) never has more.
///
/// # Errors
/// Where it is missing, not a file, not readable or larger than the limit.
pub fn read(path: &Path, limit: u64, what: &str) -> Result<Vec<u8>, FileError> {
    let file = File::open(path).map_err(|e| FileError::reading(path, &e))?;
    let metadata = file.metadata().map_err(|e| FileError::reading(path, &e))?;
    if metadata.is_dir() {
        return Err(FileError::new(path, "is a directory", "name a file in it"));
    }
    let mut bytes = Vec::new();
    // One byte more than allowed, since a pipe does not say its length.
    file.take(limit + 1)
        .read_to_end(&mut bytes)
        .map_err(|e| FileError::reading(path, &e))?;
    if bytes.len() as u64 > limit {
        let message = format!("is larger than {} MiB, which {what} never is", limit >> 20);
        return Err(FileError::new(path, message, "check that it is the right file"));
    }
    Ok(bytes)
}

/// Makes a folder and those above it.
///
/// # Errors
/// Where it cannot be made, or a file has its name.
pub fn make_folder(path: &Path) -> Result<(), FileError> {
    fs::create_dir_all(path).map_err(|e| {
        if path.exists() {
            FileError::new(path, "is a file, not a folder", "name a folder")
        } else {
            FileError::writing(path, &e)
        }
    })
}

/// Writes a whole file: beside its target first, then renamed over it, so that no reader ever sees a part. A
/// symbolic link is followed and stays; a device or pipe is written to directly.
///
/// # Errors
/// Where it cannot be written; nothing is left behind then.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    let mut parts = InParts::create(path)?;
    parts.write(bytes)?;
    parts.finish()?;
    Ok(())
}

/// A file that is written in parts, and is there whole or not at all: beside its target until [`InParts::finish`]. Links
/// and devices are as [`write()`] has them.
#[derive(Debug)]
pub struct InParts {
    path: PathBuf,
    // Closed before it is removed.
    file: File,
    /// `None` for a device.
    beside: Option<(Temporary, PathBuf)>,
    bytes: u64,
}

impl InParts {
    /// Begins a file.
    ///
    /// # Errors
    /// It cannot be written, or is a folder.
    pub fn create(path: &Path) -> Result<Self, FileError> {
        let failed = |e: io::Error| FileError::writing(path, &e);
        let target = match fs::symlink_metadata(path) {
            Ok(metadata) if metadata.is_symlink() => follow(path)?,
            _ => path.to_owned(),
        };
        let (file, beside) = match fs::metadata(&target) {
            Ok(metadata) if metadata.is_dir() => {
                return Err(FileError::new(path, "is a directory", "name a file in it"));
            }
            Ok(metadata) if !metadata.is_file() => (
                OpenOptions::new().write(true).open(&target).map_err(failed)?,
                None,
            ),
            Ok(metadata) if metadata.permissions().readonly() => {
                return Err(FileError::new(
                    path,
                    "is read-only",
                    "choose another place, or make it writable",
                ));
            }
            _ => {
                let temporary = Temporary::beside(&target);
                let file = OpenOptions::new()
                    .write(true)
                    .create_new(true)
                    .open(&temporary.path)
                    .map_err(failed)?;
                (file, Some((temporary, target)))
            }
        };
        Ok(Self {
            path: path.to_owned(),
            file,
            beside,
            bytes: 0,
        })
    }

    /// Appends a part.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn write(&mut self, bytes: &[u8]) -> Result<(), FileError> {
        self.write_all(bytes)
            .map_err(|e| FileError::writing(&self.path, &e))
    }

    /// Gives the file its name; its path and length.
    ///
    /// # Errors
    /// It cannot have it.
    pub fn finish(self) -> Result<(PathBuf, u64), FileError> {
        let Self {
            path,
            mut file,
            beside,
            bytes,
        } = self;
        file.flush().map_err(|e| FileError::writing(&path, &e))?;
        drop(file);
        if let Some((temporary, target)) = beside {
            fs::rename(&temporary.path, target).map_err(|e| FileError::writing(&path, &e))?;
        }
        Ok((path, bytes))
    }
}

impl Write for InParts {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes)?;
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// The end of a chain of symbolic links, which need not exist yet.
fn follow(path: &Path) -> Result<PathBuf, FileError> {
    let mut target = path.to_owned();
    for _ in 0..40 {
        match fs::read_link(&target) {
            Ok(next) => target = target.parent().unwrap_or(Path::new("")).join(next),
            Err(_) => return Ok(target),
        }
    }
    Err(FileError::new(
        path,
        "is a circle of symbolic links",
        "name the file itself",
    ))
}

/// A file that is gone when this value is, unless it was renamed away.
#[derive(Debug)]
struct Temporary {
    path: PathBuf,
}

impl Temporary {
    fn beside(target: &Path) -> Self {
        let mut name = std::ffi::OsString::from(".");
        name.push(target.file_name().unwrap_or_default());
        name.push(format!(".{}.part", std::process::id()));
        Self {
            path: target.with_file_name(name),
        }
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        // Gone already after the rename; where it is not, nothing better can be done than to try.
        let _ = fs::remove_file(&self.path);
    }
}

/// The path of an existing file as a layer in `folder` names it: `./x.usd`, `../y/x.usd`.
///
/// # Errors
/// An absolute path cannot be found.
pub fn relative(folder: &Path, file: &Path) -> Result<String, FileError> {
    let absolute = |path: &Path| {
        let path = if path.as_os_str().is_empty() {
            Path::new(".")
        } else {
            path
        };
        fs::canonicalize(path).or_else(|_| std::path::absolute(path))
    };
    let unknown = |_| FileError::new(file, "its absolute path cannot be found", "check the path");
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
    fn a_layer_names_its_base_relative_to_itself() {
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

    fn folder() -> tempfile::TempDir {
        tempfile::tempdir().unwrap()
    }

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(folder)
            .unwrap()
            .map(|e| e.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_file_is_replaced_whole() {
        let folder = folder();
        let path = folder.path().join("a.usd");
        write(&path, b"one").unwrap();
        write(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(names(folder.path()), ["a.usd"]);
    }

    #[test]
    fn parts_are_a_file_when_they_are_finished() {
        let folder = folder();
        let path = folder.path().join("a.npy");
        let mut parts = InParts::create(&path).unwrap();
        parts.write(b"on").unwrap();
        drop(parts);
        assert!(names(folder.path()).is_empty());
        let mut parts = InParts::create(&path).unwrap();
        parts.write(b"on").unwrap();
        parts.write(b"e").unwrap();
        assert_eq!(parts.finish().unwrap(), (path.clone(), 3));
        assert_eq!(fs::read(&path).unwrap(), b"one");
        assert_eq!(names(folder.path()), ["a.npy"]);
    }

    #[test]
    fn a_missing_folder_is_named() {
        let folder = folder();
        let error = write(&folder.path().join("no/a.usd"), b"x")
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("no/a.usd: its folder does not exist; make the folder first"),
            "{error}"
        );
    }

    #[cfg(unix)]
    #[test]
    fn a_symlink_stays_and_its_target_is_written() {
        let folder = folder();
        let (link, target) = (folder.path().join("link"), folder.path().join("target"));
        std::os::unix::fs::symlink("target", &link).unwrap();
        write(&link, b"x").unwrap();
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::read(&target).unwrap(), b"x");
        assert_eq!(names(folder.path()), ["link", "target"]);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_full_disk_is_told_and_a_device_survives() {
        let error = write(Path::new("/dev/full"), b"x").unwrap_err().to_string();
        assert!(error.contains("no space left"), "{error}");
        write(Path::new("/dev/null"), b"x").unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn parts_of_a_device_are_written_to_it() {
        let mut parts = InParts::create(Path::new("/dev/full")).unwrap();
        let error = parts.write(b"x").unwrap_err().to_string();
        assert!(error.contains("no space left"), "{error}");
        drop(parts);
        assert!(!fs::metadata("/dev/full").unwrap().is_file());
    }

    #[test]
    fn a_read_only_file_is_kept() {
        let folder = folder();
        let path = folder.path().join("a.usd");
        write(&path, b"one").unwrap();
        let mut permissions = fs::metadata(&path).unwrap().permissions();
        permissions.set_readonly(true);
        fs::set_permissions(&path, permissions).unwrap();
        assert!(
            write(&path, b"two")
                .unwrap_err()
                .to_string()
                .contains("read-only")
        );
        assert_eq!(fs::read(&path).unwrap(), b"one");
        assert_eq!(names(folder.path()), ["a.usd"]);
    }

    #[test]
    fn reads_are_bounded() {
        let folder = folder();
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
