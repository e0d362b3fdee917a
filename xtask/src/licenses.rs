//! `cargo xtask licenses`: writes the licences that the wheel must contain.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::workspace;

/// The package whose dependencies are compiled into the wheel.
const PACKAGE: &str = "oaktwin-python";
/// Where the wheel's files are.
const FOLDER: &str = "crates/python";
const OWN: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];
const NOTICES: &str = "THIRD-PARTY-LICENSES.txt";
/// The starts of the names of files with licences, in lower case.
const NAMES: [&str; 6] = ["licen", "copying", "notice", "unlicense", "copyright", "authors"];

/// A crate of somebody else.
#[derive(Debug)]
struct Dependency {
    name: String,
    version: String,
    expression: String,
    source: String,
    texts: Vec<String>,
}

pub(crate) fn run() -> Result<(), String> {
    let folder = workspace::root().join(FOLDER);
    for name in OWN {
        let copied = fs::copy(workspace::root().join(name), folder.join(name));
        copied.map_err(|error| format!("{name}: {error}"))?;
    }
    let dependencies = dependencies()?;
    let path = folder.join(NOTICES);
    fs::write(&path, notices(&dependencies)).map_err(|error| format!("{}: {error}", path.display()))?;
    println!("wrote {} with {} crates", path.display(), dependencies.len());
    Ok(())
}

/// All crates that are compiled into the wheel on any platform, without this project's.
fn dependencies() -> Result<Vec<Dependency>, String> {
    let metadata = workspace::metadata(&[])?;
    let text = |value: &Value, name: &str| value[name].as_str().unwrap_or_default().to_owned();
    let list = |value: &Value, name: &str| value[name].as_array().cloned().unwrap_or_default();
    let nodes: BTreeMap<String, Value> = list(&metadata["resolve"], "nodes")
        .into_iter()
        .map(|node| (text(&node, "id"), node))
        .collect();
    let packages = list(&metadata, "packages");
    let root = packages.iter().find(|package| text(package, "name") == PACKAGE);
    let mut pending = vec![text(root.ok_or("the package is missing")?, "id")];
    let mut reached = BTreeSet::new();
    while let Some(id) = pending.pop() {
        if !reached.insert(id.clone()) {
            continue;
        }
        for dependency in list(&nodes[&id], "deps") {
            // Build and development dependencies are not compiled in.
            let is_compiled_in = list(&dependency, "dep_kinds")
                .iter()
                .any(|kind| kind["kind"].is_null());
            if is_compiled_in {
                pending.push(text(&dependency, "pkg"));
            }
        }
    }
    let mut found: Vec<Dependency> = packages
        .iter()
        .filter(|package| reached.contains(&text(package, "id")) && package["source"].is_string())
        .map(|package| Dependency {
            name: text(package, "name"),
            version: text(package, "version"),
            expression: text(package, "license"),
            source: text(package, "repository"),
            texts: Path::new(&text(package, "manifest_path"))
                .parent()
                .map(texts)
                .unwrap_or_default(),
        })
        .collect();
    found.sort_by(|a, b| (&a.name, &a.version).cmp(&(&b.name, &b.version)));
    Ok(found)
}

/// The licences and notices in a crate's folder, by file name.
fn texts(folder: &Path) -> Vec<String> {
    let mut files: Vec<_> = fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| {
            let name = path
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .to_lowercase();
            path.is_file() && NAMES.iter().any(|start| name.starts_with(start))
        })
        .collect();
    files.sort();
    files
        .iter()
        .filter_map(|path| fs::read_to_string(path).ok())
        .map(|text| text.replace("\r\n", "\n").trim().to_owned())
        .filter(|text| !text.is_empty())
        .collect()
}

/// The list of crates, then each text once with the crates that contain it.
fn notices(dependencies: &[Dependency]) -> String {
    let mut out = String::from(
        "The compiled module of this package contains the following Rust crates. Their licences and notices are below the list.\n\n",
    );
    let mut of_text: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for crate_ in dependencies {
        let title = format!("{} {}", crate_.name, crate_.version);
        let _ = writeln!(out, "{title}: {} ({})", crate_.expression, crate_.source);
        for text in &crate_.texts {
            of_text.entry(text).or_default().push(title.clone());
        }
    }
    let mut texts: Vec<_> = of_text.into_iter().collect();
    texts.sort_by(|a, b| a.1.cmp(&b.1).then(a.0.cmp(b.0)));
    for (text, crates) in texts {
        let _ = write!(out, "\n{}\n{}\n\n{text}\n", "=".repeat(80), crates.join(", "));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_texts_are_written_once() {
        let crate_ = |name: &str, texts: &[&str]| Dependency {
            name: name.into(),
            version: "1.0".into(),
            expression: "MIT".into(),
            source: "https://example.org".into(),
            texts: texts.iter().map(|&text| text.to_owned()).collect(),
        };
        let text = notices(&[crate_("a", &["one", "two"]), crate_("b", &["two"])]);
        assert!(text.contains("a 1.0: MIT (https://example.org)\nb 1.0: MIT"));
        assert!(text.contains("\na 1.0\n\none\n") && text.contains("\na 1.0, b 1.0\n\ntwo\n"));
        assert_eq!(text.matches("two").count(), 1);
    }
}
