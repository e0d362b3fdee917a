//! Temporary files beside their targets, with which files appear whole or not at all.
//!
//! A temporary file has a random name, is created exclusively, and is locked while its writer lives. The lock, and not a
//! process number, shows that a file is in use: processes in different containers may have the same number. Files that a
//! killed program left behind are removed when a later one writes into the same folder.

use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::NamedTempFile;

use crate::error::folder;

/// What follows the name of the target, before and after random letters.
const MARK: &str = ".oaktwin-";
const SUFFIX: &str = ".part";
const RANDOM_LETTERS: usize = 8;
/// The maximum length of a file name on the file systems in use, bytes.
const MAX_NAME: usize = 255;

/// The temporary files of this process, and the folders that were searched for other processes' files.
#[derive(Default)]
struct Registry {
    files: BTreeSet<PathBuf>,
    searched: BTreeSet<PathBuf>,
}

static REGISTRY: Mutex<Option<Registry>> = Mutex::new(None);

fn registry() -> MutexGuard<'static, Option<Registry>> {
    REGISTRY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A temporary file, which is removed when it is dropped.
#[derive(Debug)]
pub(crate) struct Temporary(Option<NamedTempFile>);

impl Temporary {
    /// Creates a temporary file in the folder of `target`, with the permissions of a new file.
    pub(crate) fn beside(target: &Path) -> io::Result<Self> {
        let folder = folder(target);
        let prefix = prefix(target.file_name().unwrap_or_default());
        let mut builder = tempfile::Builder::new();
        builder.prefix(&prefix).rand_bytes(RANDOM_LETTERS).suffix(SUFFIX);
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut registry = registry();
        let registry = registry.get_or_insert_default();
        if registry.searched.insert(folder.to_owned()) {
            remove_abandoned(folder);
        }
        loop {
            let file = builder.tempfile_in(folder)?;
            // Some file systems have no locks; files abandoned there stay.
            let _ = file.as_file().lock();
            // Between its creation and the lock, another program may have taken the file for abandoned.
            if file.path().exists() {
                registry.files.insert(file.path().to_owned());
                return Ok(Self(Some(file)));
            }
        }
    }

    /// Writes the contents to the disk and moves the file to `target`, which it replaces.
    pub(crate) fn persist(mut self, target: &Path) -> io::Result<()> {
        let Some(file) = self.0.take() else { return Ok(()) };
        // Otherwise a computer that loses power may keep the name and lose the contents.
        file.as_file().sync_data()?;
        let mut registry = registry();
        let name = file.path().to_owned();
        let moved = file.persist(target);
        if let Some(registry) = registry.as_mut() {
            registry.files.remove(&name);
        }
        moved.map(drop).map_err(|error| error.error)
    }
}

impl Write for Temporary {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.as_mut().map_or(Ok(bytes.len()), |file| file.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.as_mut().map_or(Ok(()), Write::flush)
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let Some(file) = self.0.take() else { return };
        let mut registry = registry();
        if let Some(registry) = registry.as_mut() {
            registry.files.remove(file.path());
        }
        // Removes the file, while no other thread can exit the program.
        drop(file);
    }
}

/// Removes all temporary files of this process, whose other threads can neither complete nor begin one afterwards. To be
/// called before the process is ended while files are being written.
pub fn abandon() {
    let registry = registry();
    for file in registry.iter().flat_map(|registry| &registry.files) {
        // There is nobody left to tell.
        let _ = fs::remove_file(file);
    }
    std::mem::forget(registry);
}

/// Returns the start of the names of temporary files of a target: at most as long as a file name may be.
fn prefix(target: &OsStr) -> OsString {
    let room = MAX_NAME - 1 - MARK.len() - RANDOM_LETTERS - SUFFIX.len();
    let mut prefix = OsString::from(".");
    if target.len() <= room {
        prefix.push(target);
    } else {
        let name = target.to_string_lossy();
        prefix.push(&name[..name.floor_char_boundary(room)]);
    }
    prefix.push(MARK);
    prefix
}

/// Removes the temporary files in a folder whose writers have ended.
fn remove_abandoned(folder: &Path) {
    // An unreadable folder is reported by whoever writes into it.
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    for entry in entries.filter(|entry| is_temporary(&entry.file_name())) {
        if !entry.file_type().is_ok_and(|kind| kind.is_file()) {
            continue;
        }
        let Ok(file) = File::open(entry.path()) else {
            continue;
        };
        // The lock is held until the name is gone: a writer that waits for it to lock a new file then finds its name missing.
        if file.try_lock().is_ok() {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// Whether a file has the name of a temporary file.
fn is_temporary(name: &OsStr) -> bool {
    let name = name.to_string_lossy();
    let random = name
        .strip_suffix(SUFFIX)
        .and_then(|rest| rest.rsplit_once(MARK))
        .map(|(target, random)| (target.starts_with('.'), random));
    matches!(random, Some((true, random)) if random.len() == RANDOM_LETTERS
        && random.bytes().all(|letter| letter.is_ascii_alphanumeric()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recognizes_its_own_names_only() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.npy", "x", &"ü".repeat(127), &"n".repeat(255), ".hidden"] {
            let file = Temporary::beside(&folder.path().join(name)).unwrap();
            let path = file.0.as_ref().unwrap().path().to_owned();
            assert!(is_temporary(path.file_name().unwrap()), "{}", path.display());
        }
        for name in [
            ".a.npy.part",
            "a.oaktwin-abcdefgh.part",
            ".a.oaktwin-abcdefg.part",
            ".a.oaktwin-abcdef-h.part",
            ".a.oaktwin-abcdefgh.parts",
        ] {
            assert!(!is_temporary(OsStr::new(name)), "{name}");
        }
    }

    #[test]
    fn removes_abandoned_files_and_keeps_those_in_use() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let mine = Temporary::beside(&at("a.npy")).unwrap();
        let path = mine.0.as_ref().unwrap().path().to_owned();
        fs::write(at(".b.npy.oaktwin-ABCDEFGH.part"), "half").unwrap();
        fs::write(at(".b.npy.part"), "of another program").unwrap();
        remove_abandoned(folder.path());
        assert!(path.exists());
        assert!(!at(".b.npy.oaktwin-ABCDEFGH.part").exists());
        assert!(at(".b.npy.part").exists());
        drop(mine);
        assert!(!path.exists());
    }

    #[test]
    fn many_writers_of_one_name_leave_one_whole_file() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("a.bin");
        std::thread::scope(|scope| {
            for writer in 0..8_u8 {
                let target = &target;
                scope.spawn(move || {
                    for _ in 0..20 {
                        let mut file = Temporary::beside(target).unwrap();
                        file.write_all(&[writer; 1000]).unwrap();
                        remove_abandoned(target.parent().unwrap());
                        file.write_all(&[writer; 1000]).unwrap();
                        file.persist(target).unwrap();
                    }
                });
            }
        });
        let bytes = fs::read(&target).unwrap();
        assert!(bytes.len() == 2000 && bytes.iter().all(|byte| *byte == bytes[0]));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
