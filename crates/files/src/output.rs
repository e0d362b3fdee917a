use std::collections::BTreeSet;
use std::fs;
use std::io::ErrorKind;
use std::panic::resume_unwind;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use crate::error::folder;
use crate::temporary::Temporary;
use crate::{AtomicFile, FileError, WrittenFile, make_folder, write};

/// The number of files that are written at the same time.
const AT_ONCE: usize = 4;

/// The files that a command writes: never over one of its inputs, and in folders that are created when they are needed.
/// Folders that were created and stay empty are removed when this value is dropped.
#[derive(Debug, Default)]
pub struct OutputFiles {
    root: PathBuf,
    /// Canonical paths.
    inputs: BTreeSet<PathBuf>,
    checked: BTreeSet<PathBuf>,
    /// Outermost first.
    created: Vec<PathBuf>,
    files: Vec<WrittenFile>,
    packed: Vec<PackedFiles>,
}

/// Files whose contents are in another file, too, which replaces them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackedFiles {
    /// The file with the contents.
    pub container: PathBuf,
    /// The files that it replaces.
    pub members: Vec<PathBuf>,
}

impl PackedFiles {
    /// Removes the files that are replaced, and their folders if these are empty.
    ///
    /// # Errors
    /// Returns an error if a file cannot be removed.
    pub fn remove_members(&self) -> Result<(), FileError> {
        for member in &self.members {
            match fs::remove_file(member) {
                Err(error) if error.kind() != ErrorKind::NotFound => {
                    return Err(FileError::writing(member, &error));
                }
                _ => {}
            }
        }
        let folders: BTreeSet<&Path> = self.members.iter().filter_map(|member| member.parent()).collect();
        for folder in folders {
            // Fails if the folder is not empty, as intended.
            let _ = fs::remove_dir(folder);
        }
        Ok(())
    }
}

impl OutputFiles {
    /// Files in a folder, which is created and checked to be writable.
    ///
    /// # Errors
    /// Returns an error if the folder cannot be created or written to, or if it is a file.
    pub fn in_folder(root: &Path) -> Result<Self, FileError> {
        let mut files = Self::default();
        root.clone_into(&mut files.root);
        files.check_folder(root)?;
        Ok(files)
    }

    /// Protects these files, if they exist, from being overwritten.
    pub fn protect<'a>(&mut self, inputs: impl IntoIterator<Item = &'a Path>) {
        self.inputs
            .extend(inputs.into_iter().filter_map(|path| path.canonicalize().ok()));
    }

    /// The folder that paths are relative to; empty for the current directory.
    #[must_use]
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// The files that are complete, in the order of their completion.
    #[must_use]
    pub fn files(&self) -> &[WrittenFile] {
        &self.files
    }

    /// Returns the complete files since the last call, and forgets them.
    pub fn take_files(&mut self) -> Vec<WrittenFile> {
        std::mem::take(&mut self.files)
    }

    /// Forgets a complete file, relative to the root, that does not belong to those that are listed.
    pub fn forget(&mut self, path: &Path) {
        let path = self.root.join(path);
        self.files.retain(|file| file.path != path);
    }

    /// Lists a file, relative to the root, that is complete already.
    ///
    /// # Errors
    /// Returns an error if there is no such file.
    pub fn list(&mut self, path: &Path) -> Result<(), FileError> {
        let path = self.root.join(path);
        let metadata = fs::metadata(&path).map_err(|error| FileError::reading(&path, &error))?;
        let bytes = metadata.len();
        self.files.push(WrittenFile { path, bytes });
        Ok(())
    }

    /// Declares that a complete file replaces others; all are relative to the root. Whoever keeps account of the files removes these.
    pub fn pack(&mut self, container: &Path, members: impl IntoIterator<Item = PathBuf>) {
        self.packed.push(PackedFiles {
            container: self.root.join(container),
            members: members.into_iter().map(|member| self.root.join(member)).collect(),
        });
    }

    /// Returns the files that are replaced by others since the last call.
    pub fn take_packed(&mut self) -> Vec<PackedFiles> {
        std::mem::take(&mut self.packed)
    }

    /// Writes a whole file, relative to the root.
    ///
    /// # Errors
    /// Returns an error if the file is an input or cannot be written; nothing of it is left behind.
    pub fn write(&mut self, path: &Path, bytes: &[u8]) -> Result<(), FileError> {
        let path = self.prepare(path)?;
        write(&path, bytes)?;
        let bytes = bytes.len() as u64;
        self.files.push(WrittenFile { path, bytes });
        Ok(())
    }

    /// Writes whole files, relative to the root, a few at a time, so that one is encoded while another is synchronized with the
    /// disk. `put` writes the contents of the file with this index.
    ///
    /// # Errors
    /// Returns an error if a file is an input or cannot be written, and errors of `put`: the first one in the order of the files.
    /// Files that are complete by then stay.
    pub fn write_all<E: From<FileError> + Send>(
        &mut self,
        paths: &[&Path],
        put: impl Fn(usize, &mut AtomicFile) -> Result<(), E> + Sync,
    ) -> Result<(), E> {
        let mut prepared = Vec::with_capacity(paths.len());
        for path in paths {
            prepared.push(self.prepare(path)?);
        }
        let write = |index: usize| -> Result<WrittenFile, E> {
            let mut file = AtomicFile::create(&prepared[index])?;
            put(index, &mut file)?;
            let (path, bytes) = file.finish()?;
            Ok(WrittenFile { path, bytes })
        };
        for written in in_order(paths.len(), write) {
            self.files.push(written?);
        }
        Ok(())
    }

    /// Begins a file, relative to the root, that is written in parts and completed by [`finish`](Self::finish).
    ///
    /// # Errors
    /// Returns an error if the file is an input or cannot be written.
    pub fn create(&mut self, path: &Path) -> Result<AtomicFile, FileError> {
        let path = self.prepare(path)?;
        AtomicFile::create(&path)
    }

    /// Completes a file.
    ///
    /// # Errors
    /// Returns an error if it cannot be written.
    pub fn finish(&mut self, file: AtomicFile) -> Result<(), FileError> {
        let (path, bytes) = file.finish()?;
        self.files.push(WrittenFile { path, bytes });
        Ok(())
    }

    fn prepare(&mut self, path: &Path) -> Result<PathBuf, FileError> {
        let path = self.root.join(path);
        let folder = folder(&path);
        if !self.checked.contains(folder) {
            self.check_folder(folder)?;
        }
        let is_input = path.canonicalize().is_ok_and(|path| self.inputs.contains(&path));
        if is_input {
            return Err(FileError::new(
                &path,
                "is an input of this command",
                "choose another place",
            ));
        }
        Ok(path)
    }

    fn check_folder(&mut self, folder: &Path) -> Result<(), FileError> {
        let missing = folder
            .ancestors()
            .take_while(|folder| !folder.as_os_str().is_empty() && fs::symlink_metadata(folder).is_err());
        let mut missing: Vec<PathBuf> = missing.map(Path::to_owned).collect();
        missing.reverse();
        self.created.append(&mut missing);
        make_folder(folder)?;
        Temporary::beside(&folder.join("writable")).map_err(|error| {
            let message = format!("is not writable ({})", error.kind());
            FileError::new(folder, message, "choose another place")
        })?;
        self.checked.insert(folder.to_owned());
        Ok(())
    }
}

/// Runs a task for each index, at most [`AT_ONCE`] at a time, and returns the results in order. None begins after one has failed,
/// whose error is the last result.
fn in_order<T: Send, E: Send>(
    count: usize,
    task: impl Fn(usize) -> Result<T, E> + Sync,
) -> Vec<Result<T, E>> {
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                return done;
            }
            let result = task(index);
            if result.is_err() {
                next.store(count, Ordering::Relaxed);
            }
            done.push((index, result));
        }
    };
    let mut done = thread::scope(|scope| {
        let others: Vec<_> = (1..count.min(AT_ONCE)).map(|_| scope.spawn(work)).collect();
        let mut done = work();
        for other in others {
            done.extend(other.join().unwrap_or_else(|panic| resume_unwind(panic)));
        }
        done
    });
    done.sort_unstable_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

impl Drop for OutputFiles {
    fn drop(&mut self) {
        for folder in self.created.iter().rev() {
            // Fails if the folder is not empty, as intended.
            let _ = fs::remove_dir(folder);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn removes_created_folders_that_stay_empty() {
        let root = tempfile::tempdir().unwrap();
        let at = |name: &str| root.path().join(name);
        drop(OutputFiles::in_folder(&at("a/b")).unwrap());
        assert!(!at("a").exists());
        fs::create_dir(at("mine")).unwrap();
        drop(OutputFiles::in_folder(&at("mine")).unwrap());
        assert!(at("mine").is_dir());
        let mut files = OutputFiles::in_folder(&at("c/d")).unwrap();
        files.write(Path::new("left/x.npy"), b"x").unwrap();
        assert_eq!(files.files()[0].path, at("c/d/left/x.npy"));
        drop(files);
        assert_eq!(fs::read(at("c/d/left/x.npy")).unwrap(), b"x");
    }

    #[test]
    fn files_are_listed_in_order_and_none_follows_an_error() {
        let root = tempfile::tempdir().unwrap();
        let mut files = OutputFiles::in_folder(root.path()).unwrap();
        let names: Vec<PathBuf> = (0..40).map(|i| format!("{}/{i}.bin", i % 3).into()).collect();
        let paths: Vec<&Path> = names.iter().map(PathBuf::as_path).collect();
        files
            .write_all(&paths, |index, file| file.append(&vec![7; index]))
            .unwrap();
        for (index, (file, name)) in files.take_files().iter().zip(&names).enumerate() {
            assert_eq!((&file.path, file.bytes), (&root.path().join(name), index as u64));
            assert_eq!(fs::read(&file.path).unwrap(), vec![7; index]);
        }
        let others: Vec<PathBuf> = (0..4000).map(|i| format!("x/{i}").into()).collect();
        let paths: Vec<&Path> = others.iter().map(PathBuf::as_path).collect();
        let error = files.write_all(&paths, |index, _| match index {
            0..5 => Ok(()),
            _ => Err(FileError::new(&names[0], format!("number {index}"), "")),
        });
        assert_eq!(&*error.unwrap_err().message, "number 5");
        let written = fs::read_dir(root.path().join("x")).unwrap().count();
        assert!((5..5 + 2 * AT_ONCE).contains(&written), "{written}");
        assert!(files.files().len() >= 5 && files.files().len() <= written);
        // A sole file that fails.
        assert!(
            files
                .write_all(&paths[..1], |_, _| Err(FileError::new(&names[0], "x", "")))
                .is_err()
        );
        assert!(files.write_all::<FileError>(&[], |_, _| unreachable!()).is_ok());
    }

    #[test]
    fn rejects_files_as_folders() {
        let root = tempfile::tempdir().unwrap();
        fs::write(root.path().join("file"), "kept").unwrap();
        for name in ["file", "file/below"] {
            assert!(OutputFiles::in_folder(&root.path().join(name)).is_err(), "{name}");
        }
        assert_eq!(fs::read(root.path().join("file")).unwrap(), b"kept");
    }

    #[test]
    fn protects_inputs() {
        let root = tempfile::tempdir().unwrap();
        let input = root.path().join("a.npy");
        fs::write(&input, "kept").unwrap();
        let mut files = OutputFiles::in_folder(root.path()).unwrap();
        files.protect([input.as_path()]);
        for error in [
            files.write(Path::new("a.npy"), b"x").unwrap_err(),
            files.create(Path::new("a.npy")).unwrap_err(),
        ] {
            assert_eq!(&*error.message, "is an input of this command");
        }
        assert_eq!(fs::read(&input).unwrap(), b"kept");
    }
}
