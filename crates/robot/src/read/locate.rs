//! The files that a URDF file names.

use std::path::{Path, PathBuf};

use super::document::{Element, XmlError};

/// Returns the path of the file that an element names as `package://NAME/PATH`, `model://NAME/PATH`, `file://PATH`, or a path relative to its own file.
pub(super) fn file(element: &Element, name: &str, packages: &[PathBuf]) -> Result<PathBuf, XmlError> {
    let folder = element.file().parent().unwrap_or(Path::new(""));
    let in_package = ["package://", "model://"]
        .into_iter()
        .find_map(|scheme| name.strip_prefix(scheme));
    if let Some(rest) = in_package {
        let (package, inside) = rest.split_once('/').unwrap_or((rest, ""));
        let found = candidates(package, folder, packages).find_map(|root| {
            let path = root.join(inside);
            path.is_file().then_some(path)
        });
        return found.ok_or_else(|| {
            element.wrong(
                format!("'{name}' is in no folder around the file"),
                format!("give the folder that contains {package} with --packages"),
            )
        });
    }
    let path = match name.strip_prefix("file://") {
        Some(path) => PathBuf::from(path),
        None if name.contains("://") => {
            let remedy = "name a file with package://, file:// or a relative path";
            return Err(element.wrong(format!("'{name}' is not a file"), remedy));
        }
        None => folder.join(name),
    };
    if path.is_file() {
        return Ok(path);
    }
    Err(element.wrong(
        format!("there is no file {}", path.display()),
        "copy it there, or correct the name",
    ))
}

/// The folders that may be a package: those that the user gives, those that contain the file, and those beside them.
fn candidates<'a>(
    package: &'a str,
    folder: &'a Path,
    packages: &'a [PathBuf],
) -> impl Iterator<Item = PathBuf> + 'a {
    let given = packages.iter().map(PathBuf::as_path);
    let is_package = move |root: &Path| root.file_name().is_some_and(|name| name == package);
    // The folder of a file without one is the current one.
    let folder = std::path::absolute(Path::new(".").join(folder)).unwrap_or_else(|_| folder.to_owned());
    let around: Vec<PathBuf> = folder.ancestors().map(Path::to_owned).collect();
    given.map(Path::to_owned).chain(around).flat_map(move |root| {
        let own = is_package(&root).then(|| root.clone());
        own.into_iter().chain([root.join(package)])
    })
}
