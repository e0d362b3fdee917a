//! `cargo xtask docs`: the manual.

use std::path::{Path, PathBuf};

use crate::python::{PACKAGE, build_wheel, install_wheel, isolated};
use crate::workspace::{self, output};

/// Builds the current Python package and the manual, and prints the path of the manual's start page.
pub(crate) fn run() -> Result<(), String> {
    let python = PACKAGE.ready()?;
    install_wheel(&python, &build_wheel(&python, "dev")?)?;
    let page = build(&python)?;
    println!("{}", page.display());
    Ok(())
}

/// Builds the manual in an environment that has the package, and returns its start page. An error names every mistake in it.
pub(crate) fn build(python: &Path) -> Result<PathBuf, String> {
    let folder = workspace::target().join("docs");
    let mut command = isolated(python);
    command.current_dir(workspace::root());
    command
        .args(["-m", "mkdocs", "build", "--quiet", "--clean", "--site-dir"])
        .arg(&folder);
    output(&mut command)?;
    Ok(folder.join("index.html"))
}
