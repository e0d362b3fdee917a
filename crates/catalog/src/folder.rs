//! Folders of user-defined sensors and devices.

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::catalog::SourceFile;
use crate::{Catalog, CatalogError};

/// The maximum size of a catalog file, bytes. Typical files have a few kilobytes.
const MAX_FILE_BYTES: u64 = 1 << 20;

/// The maximum number of files.
const MAX_FILES: usize = 1000;

impl Catalog {
    /// Loads the built-in catalog and a folder: `DIR/sensors/*.toml`, `DIR/imus/*.toml`, `DIR/devices/*.toml` and `DIR/*.toml`. An entry replaces a
    /// built-in one with the same id.
    ///
    /// # Errors
    /// Returns an error if the folder cannot be read or contains no TOML file, or a file is not a valid sensor or device.
    pub fn with_dir(dir: impl AsRef<Path>) -> Result<Self, CatalogError> {
        let dir = dir.as_ref();
        let paths = toml_files(dir)?;
        let texts = paths
            .iter()
            .map(|path| read(path))
            .collect::<Result<Vec<_>, _>>()?;
        let files: Vec<SourceFile<'_>> = paths
            .iter()
            .zip(&texts)
            .map(|(file, text)| SourceFile { file, text })
            .collect();
        Self::builtin().clone().with_files(&files)
    }
}

/// Returns the TOML files of a folder, sorted.
fn toml_files(dir: &Path) -> Result<Vec<PathBuf>, CatalogError> {
    let mut paths = Vec::new();
    for (folder, required) in [
        (dir.to_owned(), true),
        (dir.join("sensors"), false),
        (dir.join("imus"), false),
        (dir.join("devices"), false),
    ] {
        if !required && !folder.is_dir() {
            continue;
        }
        let failed = |cause: std::io::Error| {
            CatalogError::new(
                &folder,
                None,
                format!("cannot list the folder: {cause}"),
                "pass a folder of TOML files",
            )
        };
        for entry in fs::read_dir(&folder).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            if path.extension().is_some_and(|extension| extension == "toml") {
                paths.push(path);
            }
            if paths.len() > MAX_FILES {
                let problem = format!("more than {MAX_FILES} TOML files");
                return Err(CatalogError::new(
                    &folder,
                    None,
                    problem,
                    "pass a folder that contains only sensors and devices",
                ));
            }
        }
    }
    if paths.is_empty() {
        return Err(CatalogError::new(
            dir,
            None,
            "the folder contains no TOML file",
            "add sensors and devices to it or to its subfolders 'sensors', 'imus' and 'devices'",
        ));
    }
    paths.sort();
    Ok(paths)
}

fn read(path: &Path) -> Result<String, CatalogError> {
    let error = |problem: String, remedy: &str| CatalogError::new(path, None, problem, remedy);
    let unreadable = |cause: std::io::Error| {
        error(
            format!("cannot be read: {cause}"),
            "check the file and its permissions",
        )
    };
    let metadata = fs::metadata(path).map_err(unreadable)?;
    if !metadata.is_file() {
        return Err(error(
            "not a file".to_owned(),
            "rename it to an extension other than .toml, or remove it",
        ));
    }
    let too_large = || {
        error(
            "larger than 1 MiB".to_owned(),
            "files of sensors and devices have a few kilobytes",
        )
    };
    if metadata.len() > MAX_FILE_BYTES {
        return Err(too_large());
    }
    let mut bytes = Vec::new();
    let file = fs::File::open(path).map_err(unreadable)?;
    // The file may have grown since.
    file.take(MAX_FILE_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    if bytes.len() as u64 > MAX_FILE_BYTES {
        return Err(too_large());
    }
    String::from_utf8(bytes).map_err(|cause| {
        let line = cause
            .as_bytes()
            .iter()
            .take(cause.utf8_error().valid_up_to())
            .filter(|b| **b == b'\n')
            .count()
            + 1;
        CatalogError::new(path, Some(line), "not UTF-8 text", "save the file as UTF-8")
    })
}
