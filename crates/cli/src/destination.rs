//! Resolves the output path given with `-o`.

use std::fs;
use std::path::{Path, PathBuf};

use oaktwin::files::{self, FileError};

/// Returns the path of one of several outputs. `-o` names a folder, which is created.
pub(crate) fn in_folder(output: &Path, name: &str) -> Result<PathBuf, FileError> {
    files::make_folder(output)?;
    Ok(output.join(name))
}

/// Returns the path of a single output. `-o` names the file or a folder for it: a path that ends in a separator, or a
/// new one without an extension, is a folder.
pub(crate) fn file_or_folder(output: &Path, name: &str) -> Result<PathBuf, FileError> {
    if names_folder(output) {
        in_folder(output, name)
    } else {
        Ok(output.to_owned())
    }
}

/// Whether `-o` is a folder.
pub(crate) fn names_folder(output: &Path) -> bool {
    output.is_dir()
        || output
            .as_os_str()
            .to_string_lossy()
            .ends_with(std::path::is_separator)
        || (output.extension().is_none() && fs::symlink_metadata(output).is_err())
}

/// Rejects an output path that is an input.
pub(crate) fn spare_inputs<'a>(
    output: &Path,
    inputs: impl IntoIterator<Item = Option<&'a Path>>,
) -> Result<(), FileError> {
    let same =
        |a: &Path, b: &Path| matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b);
    match inputs.into_iter().flatten().find(|input| same(input, output)) {
        Some(input) => Err(FileError::new(
            input,
            "is an input of this command",
            "choose another output with -o",
        )),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recognises_folders() {
        let root = tempfile::tempdir().unwrap();
        let at = |name: &str| root.path().join(name);
        fs::write(at("file"), "").unwrap();
        assert!(names_folder(root.path()));
        assert!(names_folder(&at("new")));
        assert!(names_folder(&at("new.usd/")));
        assert!(!names_folder(&at("new.usd")));
        assert!(!names_folder(&at("file")));
    }
}
