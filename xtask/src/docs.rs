//! `cargo xtask docs`: the manual of the Python package.

use std::fs;
use std::path::{Path, PathBuf};

use crate::python::{PACKAGE, build_wheel, install_wheel, isolated};
use crate::workspace::{self, output};

/// Builds the package as it is now and its manual; prints where that is.
pub(crate) fn run() -> Result<(), String> {
    let python = PACKAGE.ready()?;
    install_wheel(&python, &build_wheel(&python, "dev")?)?;
    let page = build(&python)?;
    println!("{}", page.display());
    Ok(())
}

/// Builds the manual in an environment that has the package; its start page. An error names every mistake in it.
pub(crate) fn build(python: &Path) -> Result<PathBuf, String> {
    let folder = workspace::target().join("docs-python");
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let mut command = isolated(python);
    command.current_dir(workspace::root());
    command.arg("docs/python/build.py").arg(&folder);
    output(&mut command)?;
    Ok(folder.join("index.html"))
}
