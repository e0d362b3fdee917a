//! The workflows in `.github`, checked with actionlint.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::report::TestReport;
use crate::web;
use crate::workspace::{self, output};

/// What names the checker and its dependencies, with their hashes.
const PINS: [&str; 2] = ["package.json", "package-lock.json"];

/// Checks the workflows, unless the checker can neither be found nor installed.
pub(crate) fn steps(report: &mut TestReport) {
    let name = "workflows";
    match checker() {
        Err(reason) => report.skip(name, format!("actionlint cannot be installed: {reason}")),
        Ok(folder) => {
            report.step(name, || lint(&folder));
        }
    }
}

fn source() -> PathBuf {
    workspace::root().join(".github")
}

fn lint(checker: &Path) -> Result<(), String> {
    let mut node = Command::new("node");
    output(node.arg(source().join("lint.mjs")).arg(checker)).map(drop)
}

/// Returns the folder of the installed checker. An error is one line.
fn checker() -> Result<PathBuf, String> {
    let folder = workspace::target().join("workflows");
    install(&source(), &folder, web::install_pinned)
        .map_err(|error| error.lines().collect::<Vec<_>>().join("; "))?;
    Ok(folder)
}

/// Copies the pins to a folder and installs there, unless that was done with the same pins.
fn install(
    pins: &Path,
    folder: &Path,
    install: impl FnOnce(&Path) -> Result<(), String>,
) -> Result<(), String> {
    let failed = |path: &Path, error: &std::io::Error| format!("{}: {error}", path.display());
    let read = |folder: &Path| -> Vec<_> { PINS.map(|name| fs::read(folder.join(name)).ok()).into() };
    let done = folder.join("done");
    if done.exists() && read(pins) == read(folder) {
        return Ok(());
    }
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(|error| failed(folder, &error))?;
    }
    fs::create_dir_all(folder).map_err(|error| failed(folder, &error))?;
    for name in PINS {
        let from = pins.join(name);
        fs::copy(&from, folder.join(name)).map_err(|error| failed(&from, &error))?;
    }
    install(folder)?;
    // Last, so that an interrupted installation is made anew.
    fs::write(&done, "").map_err(|error| failed(&done, &error))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn installs_again_only_after_a_failure_or_a_changed_pin() {
        let place = tempfile::tempdir().unwrap();
        let (pins, folder) = (place.path().join("pins"), place.path().join("made"));
        fs::create_dir(&pins).unwrap();
        for name in PINS {
            fs::write(pins.join(name), "1").unwrap();
        }
        let mut installs = 0;
        let mut run = |result: Result<(), String>| {
            let done = install(&pins, &folder, |_| {
                installs += 1;
                result
            });
            (done.is_ok(), installs)
        };
        assert_eq!(run(Err("no network".into())), (false, 1));
        assert_eq!(run(Ok(())), (true, 2));
        assert_eq!(run(Ok(())), (true, 2));
        fs::write(pins.join(PINS[1]), "2").unwrap();
        assert_eq!(run(Ok(())), (true, 3));
    }
}
