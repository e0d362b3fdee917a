//! The structure of the code that CONTRIBUTING.md promises: small files, and no cycles between modules.

#![expect(clippy::unwrap_used, reason = "helpers of tests")]

mod imports;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use imports::{Module, Modules};

const MAX_LINES: usize = 450;
const MAX_COMMAND_LINES: usize = 150;

/// Extensions of files that people write.
const SOURCES: [&str; 7] = ["rs", "py", "pyi", "ts", "tsx", "mjs", "css"];

/// Folders without files that people write.
const SKIPPED: [&str; 5] = ["target", "node_modules", "dist", "corpus", "regressions"];

/// Files that a program writes.
const MADE: [&str; 1] = ["protocol.ts"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy();
        if path.is_symlink() || name.starts_with('.') || SKIPPED.contains(&&*name) || MADE.contains(&&*name) {
            continue;
        }
        if path.is_dir() {
            files(&path, found);
        } else if path
            .extension()
            .is_some_and(|extension| SOURCES.iter().any(|source| extension == *source))
        {
            found.push(path);
        }
    }
}

#[test]
fn files_are_small() {
    let mut all = Vec::new();
    files(root(), &mut all);
    assert!(all.len() > 1000, "only {} files were found", all.len());
    let lines = |path: &PathBuf| fs::read_to_string(path).unwrap().lines().count();
    let large: Vec<String> = all
        .iter()
        .filter(|path| lines(path) > MAX_LINES)
        .map(|path| format!("{}: {} lines", path.display(), lines(path)))
        .collect();
    assert!(
        large.is_empty(),
        "split these files, each into its concepts:\n{}",
        large.join("\n")
    );
}

/// A command asks the library, and prints what it answers.
#[test]
fn commands_are_thin() {
    let mut all = Vec::new();
    files(&root().join("crates/cli/src/commands"), &mut all);
    assert!(all.len() > 50, "only {} files were found", all.len());
    for path in all {
        let lines = fs::read_to_string(&path).unwrap().lines().count();
        assert!(
            lines < MAX_COMMAND_LINES,
            "{}: {lines} lines; move what is not about arguments and text into a library",
            path.display()
        );
    }
}

/// Imports between a module and its ancestors are not counted.
#[test]
fn modules_have_no_cycles() {
    let mut imports = 0;
    let mut cycles = Vec::new();
    for crate_folder in fs::read_dir(root().join("crates")).unwrap() {
        let modules = Modules::read(&crate_folder.unwrap().path().join("src"));
        let arrows = modules.arrows();
        imports += arrows.values().map(BTreeSet::len).sum::<usize>();
        cycles.extend(cycle(&arrows).map(|cycle| modules.shown(&cycle)));
    }
    assert!(imports > 1000, "only {imports} imports were found");
    assert!(
        cycles.is_empty(),
        "these modules import each other; move what they share to a separate module:\n{}",
        cycles.join("\n")
    );
}

/// Returns the modules of a cycle in order, if there is one.
fn cycle(arrows: &BTreeMap<Module, BTreeSet<Module>>) -> Option<Vec<Module>> {
    let mut done = BTreeSet::new();
    arrows
        .keys()
        .find_map(|start| cycle_from(start, arrows, &mut Vec::new(), &mut done))
}

fn cycle_from(
    at: &Module,
    arrows: &BTreeMap<Module, BTreeSet<Module>>,
    path: &mut Vec<Module>,
    done: &mut BTreeSet<Module>,
) -> Option<Vec<Module>> {
    if let Some(first) = path.iter().position(|module| module == at) {
        return Some(path[first..].to_vec());
    }
    if !done.insert(at.clone()) {
        return None;
    }
    path.push(at.clone());
    let next = arrows.get(at).into_iter().flatten();
    let found = next
        .into_iter()
        .find_map(|next| cycle_from(next, arrows, path, done));
    path.pop();
    found
}

#[test]
fn cycles_are_found() {
    let module = |name: &str| vec![name.to_owned()];
    let arrows = |pairs: &[(&str, &str)]| {
        let mut arrows = BTreeMap::<Module, BTreeSet<Module>>::new();
        for (from, to) in pairs {
            arrows.entry(module(from)).or_default().insert(module(to));
        }
        arrows
    };
    assert_eq!(cycle(&arrows(&[("a", "b"), ("b", "c"), ("a", "c")])), None);
    assert_eq!(
        cycle(&arrows(&[("a", "b"), ("b", "c"), ("c", "d"), ("d", "b")])),
        Some([module("b"), module("c"), module("d")].to_vec())
    );
}
