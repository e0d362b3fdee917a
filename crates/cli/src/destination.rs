//! Where an output goes, from what `-o` names.

use std::fs;
use std::path::{Path, PathBuf};

use oaktwin::files::{self, FileError};

/// The file for one of several outputs: `-o` names a folder, which is made.
pub(crate) fn in_folder(output: &Path, name: &str) -> Result<PathBuf, FileError> {
    files::make_folder(output)?;
    Ok(output.join(name))
}

/// The file for a single output: `-o` names it, or a folder for it. A path that ends in a separator, and one without
/// an extension where nothing is yet, is a folder.
pub(crate) fn file_or_folder(output: &Path, name: &str) -> Result<PathBuf, FileError> {
    if names_folder(output) {
        in_folder(output, name)
    } else {
        Ok(output.to_owned())
    }
}

/// Whether `-o` names a folder.
pub(crate) fn names_folder(output: &Path) -> bool {
    output.is_dir()
        || output
            .as_os_str()
            .to_string_lossy()
            .ends_with(std::path::is_separator)
        || (output.extension().is_none() && fs::symlink_metadata(output).is_err())
}

/// Refuses to write over an input.
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
            "choose another place with -o",
        )),
        None => Ok(()),
    }
}

/// The path of an existing file as a layer in `folder` names it: `./x.usd`, `../y/x.usd`.
pub(crate) fn relative(folder: &Path, file: &Path) -> Result<String, FileError> {
    let absolute = |path: &Path| {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        fs::canonicalize(path).or_else(|_| std::path::absolute(path))
    };
    let unknown = |_| FileError::new(file, "its absolute path cannot be found", "check the path");
    let (folder, file) = (absolute(folder).map_err(unknown)?, absolute(file).map_err(unknown)?);
    let common = folder.components().zip(file.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(common).map(|_| "..".to_owned());
    let down = file.components().skip(common).map(|part| part.as_os_str().to_string_lossy().into_owned());
    let parts: Vec<String> = up.chain(down).collect();
    let path = parts.join("/");
    Ok(if path.starts_with("..") { path } else { format!("./{path}") })
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
        assert_eq!(relative(&root.path().join("mine/deep"), &base).unwrap(), "../../vendor/a.usd");
    }

    #[test]
    fn what_names_a_folder() {
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
