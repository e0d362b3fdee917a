use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::FileError;
use crate::temporary::Temporary;

/// Writes a whole file: to a temporary file beside its target first, which replaces the target once it is on the disk, so that
/// no reader ever sees a part of it, not even after a loss of power. Symbolic links are followed and kept; a device or pipe is written to directly.
///
/// # Errors
/// Returns an error if the file cannot be written; nothing is left behind.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    let mut file = AtomicFile::create(path)?;
    file.append(bytes)?;
    file.finish()?;
    Ok(())
}

/// A file that appears under its name when it is complete ([`AtomicFile::finish`]), or not at all. Links and devices are
/// treated as by [`write()`].
#[derive(Debug)]
pub struct AtomicFile {
    path: PathBuf,
    output: Output,
    bytes: u64,
}

#[derive(Debug)]
enum Output {
    Device(File),
    Temporary { file: Temporary, target: PathBuf },
}

impl AtomicFile {
    /// Begins a file.
    ///
    /// # Errors
    /// Returns an error if the path is a folder or cannot be written.
    pub fn create(path: &Path) -> Result<Self, FileError> {
        let failed = |error: io::Error| FileError::writing(path, &error);
        let target = match fs::symlink_metadata(path) {
            Ok(metadata) if metadata.is_symlink() => follow(path)?,
            _ => path.to_owned(),
        };
        let output = match fs::metadata(&target) {
            Ok(metadata) if metadata.is_dir() => {
                return Err(FileError::new(path, "is a directory", "name a file in it"));
            }
            Ok(metadata) if !metadata.is_file() => {
                Output::Device(OpenOptions::new().write(true).open(&target).map_err(failed)?)
            }
            Ok(metadata) if metadata.permissions().readonly() => {
                let remedy = "choose another place, or make it writable";
                return Err(FileError::new(path, "is read-only", remedy));
            }
            _ => Output::Temporary {
                file: Temporary::beside(&target).map_err(failed)?,
                target,
            },
        };
        Ok(Self {
            path: path.to_owned(),
            output,
            bytes: 0,
        })
    }

    /// Appends bytes.
    ///
    /// # Errors
    /// Returns an error if they cannot be written.
    pub fn append(&mut self, bytes: &[u8]) -> Result<(), FileError> {
        self.write_all(bytes).map_err(|error| self.failed(&error))
    }

    /// Returns the error of a failed write.
    #[must_use]
    pub fn failed(&self, error: &io::Error) -> FileError {
        FileError::writing(&self.path, error)
    }

    /// Completes the file; returns its path and length.
    ///
    /// # Errors
    /// Returns an error if the target cannot be replaced.
    pub fn finish(mut self) -> Result<(PathBuf, u64), FileError> {
        let failed = |error: io::Error| FileError::writing(&self.path, &error);
        self.output.file().flush().map_err(failed)?;
        if let Output::Temporary { file, target } = self.output {
            file.persist(&target).map_err(|error| match error.kind() {
                io::ErrorKind::NotFound => FileError::new(
                    &self.path,
                    "another program removed it, or its folder, while it was written",
                    "run the command again",
                ),
                _ => failed(error),
            })?;
        }
        Ok((self.path, self.bytes))
    }
}

impl Output {
    fn file(&mut self) -> &mut dyn Write {
        match self {
            Self::Device(file) => file,
            Self::Temporary { file, .. } => file,
        }
    }
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.output.file().write(bytes)?;
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.output.file().flush()
    }
}

/// The end of a chain of symbolic links, which may not exist yet.
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
        "is a cycle of symbolic links",
        "name the file itself",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn replaces_whole_files() {
        let folder = folder();
        let path = folder.path().join("a.usd");
        write(&path, b"one").unwrap();
        write(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(names(folder.path()), ["a.usd"]);
    }

    #[test]
    fn appears_when_finished() {
        let folder = folder();
        let path = folder.path().join("a.npy");
        let mut parts = AtomicFile::create(&path).unwrap();
        parts.append(b"on").unwrap();
        drop(parts);
        assert!(names(folder.path()).is_empty());
        let mut parts = AtomicFile::create(&path).unwrap();
        parts.append(b"on").unwrap();
        parts.append(b"e").unwrap();
        assert_eq!(parts.finish().unwrap(), (path.clone(), 3));
        assert_eq!(fs::read(&path).unwrap(), b"one");
        assert_eq!(names(folder.path()), ["a.npy"]);
    }

    #[test]
    fn reports_missing_folders() {
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
    fn follows_and_keeps_symlinks() {
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
    fn reports_full_disks_and_keeps_devices() {
        let error = write(Path::new("/dev/full"), b"x").unwrap_err().to_string();
        assert!(error.contains("no space left"), "{error}");
        write(Path::new("/dev/null"), b"x").unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn writes_to_devices_directly() {
        let mut parts = AtomicFile::create(Path::new("/dev/full")).unwrap();
        let error = parts.append(b"x").unwrap_err().to_string();
        assert!(error.contains("no space left"), "{error}");
        drop(parts);
        assert!(!fs::metadata("/dev/full").unwrap().is_file());
    }

    #[test]
    fn keeps_read_only_files() {
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
}
