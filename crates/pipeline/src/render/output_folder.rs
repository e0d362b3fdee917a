//! The folder that frames go to.

use std::fs::{self, OpenOptions};
use std::path::{Path, PathBuf};

use oaktwin_files::{self as files, FileError};

/// A folder that can be written into. What was made for it and stayed empty is gone when this value is.
#[derive(Debug)]
pub struct OutputFolder {
    path: PathBuf,
    /// Outermost first.
    made: Vec<PathBuf>,
}

impl OutputFolder {
    /// Makes the folder and those above it, and tries whether it can be written into.
    ///
    /// # Errors
    /// It cannot be made or written, or a file has its name.
    pub fn prepare(path: &Path) -> Result<Self, FileError> {
        let mut folder = Self {
            path: path.to_owned(),
            made: Vec::new(),
        };
        folder.make(path)?;
        let probe = path.join(format!(".oaktwin.{}.part", std::process::id()));
        OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(&probe)
            .and_then(|_| fs::remove_file(&probe))
            .map_err(|error| {
                let message = format!("cannot be written into ({error})");
                FileError::new(path, message, "choose another place")
            })?;
        Ok(folder)
    }

    /// Its path.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a whole file below the folder; the path of the file.
    ///
    /// # Errors
    /// It cannot be written; nothing of it is left behind then.
    pub fn write(&mut self, relative: &Path, bytes: &[u8]) -> Result<PathBuf, FileError> {
        let path = self.path.join(relative);
        if let Some(parent) = relative.parent().filter(|parent| !parent.as_os_str().is_empty()) {
            let parent = self.path.join(parent);
            if !parent.is_dir() {
                self.make(&parent)?;
            }
        }
        files::write(&path, bytes)?;
        Ok(path)
    }

    fn make(&mut self, path: &Path) -> Result<(), FileError> {
        let missing = path
            .ancestors()
            .take_while(|folder| !folder.as_os_str().is_empty() && fs::symlink_metadata(folder).is_err());
        let mut missing: Vec<PathBuf> = missing.map(Path::to_owned).collect();
        missing.reverse();
        self.made.append(&mut missing);
        files::make_folder(path)
    }
}

impl Drop for OutputFolder {
    fn drop(&mut self) {
        for folder in self.made.iter().rev() {
            // Fails where something is in it, as it should.
            let _ = fs::remove_dir(folder);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn empty_folders_go_and_full_ones_stay() {
        let root = tempfile::tempdir().unwrap();
        let at = |name: &str| root.path().join(name);
        drop(OutputFolder::prepare(&at("a/b")).unwrap());
        assert!(!at("a").exists());
        fs::create_dir(at("mine")).unwrap();
        drop(OutputFolder::prepare(&at("mine")).unwrap());
        assert!(at("mine").is_dir());
        let mut folder = OutputFolder::prepare(&at("c/d")).unwrap();
        let written = folder.write(Path::new("left/x.npy"), b"x").unwrap();
        drop(folder);
        assert_eq!(written, at("c/d/left/x.npy"));
        assert_eq!(fs::read(written).unwrap(), b"x");
    }

    #[test]
    fn a_file_is_no_folder() {
        let root = tempfile::tempdir().unwrap();
        fs::write(root.path().join("file"), "kept").unwrap();
        for name in ["file", "file/below"] {
            assert!(OutputFolder::prepare(&root.path().join(name)).is_err(), "{name}");
        }
        assert_eq!(fs::read(root.path().join("file")).unwrap(), b"kept");
    }
}
