//! What the archives of published crates must contain.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::process::Command;

use crate::workspace::{self, output};

/// The largest archive: four times the largest crate of today, a tenth of what the registry accepts.
const MAX_BYTES: usize = 1 << 20;

const LICENSES: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];

/// Folders of tests, of their data, and of examples.
const FOLDERS_OF_TESTS: [&str; 7] = [
    "tests",
    "benches",
    "examples",
    "fixtures",
    "snapshots",
    "corpus",
    "proptest-regressions",
];

/// Extensions of files that no crate needs unless it includes them.
const DATA: [&str; 18] = [
    "png", "jpg", "jpeg", "webp", "gif", "exr", "hdr", "npy", "usd", "usda", "usdc", "usdz", "glb", "gltf",
    "obj", "ply", "stl", "snap",
];

/// The unpacked archive of a crate.
#[derive(Debug)]
pub(super) struct Archive {
    name: String,
    /// Of the packed archive.
    bytes: usize,
    /// The contents of the files by their path, with `/`.
    files: BTreeMap<String, Vec<u8>>,
}

/// The licences of the workspace by their file name.
pub(super) fn licenses() -> Result<BTreeMap<&'static str, Vec<u8>>, String> {
    let read = |name: &'static str| {
        let path = workspace::root().join(name);
        let text = fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        Ok((name, text))
    };
    LICENSES.into_iter().map(read).collect()
}

impl Archive {
    /// Unpacks what `cargo package` wrote.
    pub(super) fn unpack(name: &str, version: &str) -> Result<Self, String> {
        let packages = workspace::target().join("package");
        let title = format!("{name}-{version}");
        let archive = packages.join(format!("{title}.crate"));
        let folder = workspace::target().join("release");
        let unpacked = folder.join(&title);
        let failed = |path: &Path, error: &std::io::Error| format!("{}: {error}", path.display());
        if unpacked.exists() {
            fs::remove_dir_all(&unpacked).map_err(|error| failed(&unpacked, &error))?;
        }
        fs::create_dir_all(&folder).map_err(|error| failed(&folder, &error))?;
        // Every system that the project runs on has it.
        let mut tar = Command::new("tar");
        output(tar.arg("-xzf").arg(&archive).arg("-C").arg(&folder))?;
        let bytes = fs::metadata(&archive)
            .map_err(|error| failed(&archive, &error))?
            .len();
        let mut files = BTreeMap::new();
        read_into(&mut files, &unpacked, "").map_err(|error| failed(&unpacked, &error))?;
        Ok(Self {
            name: name.to_owned(),
            bytes: usize::try_from(bytes).unwrap_or(usize::MAX),
            files,
        })
    }

    /// What is wrong with the archive.
    pub(super) fn mistakes(&self, licenses: &BTreeMap<&str, Vec<u8>>) -> Vec<String> {
        let mut found = Vec::new();
        if self.bytes > MAX_BYTES {
            found.push(format!(
                "{} bytes, more than {MAX_BYTES}; leave out what is not needed",
                self.bytes
            ));
        }
        for (name, text) in licenses {
            match self.files.get(*name) {
                None => found.push(format!(
                    "no {name}; link the file of the workspace beside the manifest"
                )),
                Some(own) if own != text => found.push(format!("{name} differs from the workspace's")),
                Some(_) => {}
            }
        }
        if self.files.get("README.md").is_none_or(Vec::is_empty) {
            found.push("no README.md; set `readme` in its manifest".into());
        }
        let included = self.included();
        for path in &included {
            if !self.files.contains_key(path) {
                found.push(format!(
                    "{path} is included by the source, and missing; add it to `include`"
                ));
            }
        }
        for path in self.files.keys() {
            if is_for_tests(path) && !included.contains(path) {
                found.push(format!("{path} is not needed; remove it from `include`"));
            }
        }
        found
            .iter()
            .map(|mistake| format!("{}: {mistake}", self.name))
            .collect()
    }

    /// The files that the source includes when it is compiled, outside of tests. One outside of the crate starts with `..`.
    fn included(&self) -> BTreeSet<String> {
        let mut found = BTreeSet::new();
        for (path, bytes) in &self.files {
            let is_test = path.ends_with("/tests.rs") || path.contains("/tests/");
            if !path.ends_with(".rs") || is_test {
                continue;
            }
            let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
            let text = String::from_utf8_lossy(bytes);
            for start in ["include_str!(\"", "include_bytes!(\""] {
                let rests = text.split(start).skip(1);
                let names = rests.filter_map(|rest| rest.split_once('"'));
                found.extend(names.map(|(name, _)| resolved(folder, name)));
            }
        }
        found
    }
}

/// Returns a path relative to a folder as one relative to the crate.
fn resolved(folder: &str, name: &str) -> String {
    let mut parts: Vec<String> = Vec::new();
    for part in PathBuf::from(folder).join(name).components() {
        let is_inside = parts.last().is_some_and(|last| last != "..");
        match part {
            Component::ParentDir if is_inside => {
                parts.pop();
            }
            Component::CurDir => {}
            other => parts.push(other.as_os_str().to_string_lossy().into_owned()),
        }
    }
    parts.join("/")
}

fn is_for_tests(path: &str) -> bool {
    let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
    let extension = file.rsplit_once('.').map_or("", |(_, extension)| extension);
    // The modules of unit tests belong to the source.
    let is_source = extension == "rs" && folder.starts_with("src");
    let in_tests = folder.split('/').any(|part| FOLDERS_OF_TESTS.contains(&part));
    (in_tests && !is_source) || DATA.contains(&extension)
}

fn read_into(files: &mut BTreeMap<String, Vec<u8>>, folder: &Path, prefix: &str) -> std::io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let name = format!("{prefix}{name}");
        if path.is_dir() {
            read_into(files, &path, &format!("{name}/"))?;
        } else {
            files.insert(name, fs::read(&path)?);
        }
    }
    Ok(())
}

impl fmt::Display for Archive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, bytes, files } = self;
        write!(
            f,
            "{name:<22} {:>4} files {:>5} kB",
            files.len(),
            bytes.div_ceil(1000)
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn archive(files: &[(&str, &str)]) -> Archive {
        let all = [("LICENSE-MIT", "mit"), ("README.md", "# a"), ("Cargo.toml", "")];
        let files = all.iter().chain(files);
        Archive {
            name: "a".into(),
            bytes: 1000,
            files: files
                .map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec()))
                .collect(),
        }
    }

    fn mistakes(archive: &Archive) -> String {
        archive
            .mistakes(&BTreeMap::from([("LICENSE-MIT", b"mit".to_vec())]))
            .join("\n")
    }

    #[test]
    fn a_good_archive_has_no_mistakes() {
        let source = "const A: &str = include_str!(\"../../fixtures/example.json\");";
        let files = [
            ("src/a/mod.rs", source),
            ("src/a/tests.rs", "include_str!(\"missing\")"),
            ("src/tests/more.rs", ""),
            ("fixtures/example.json", "{}"),
        ];
        assert_eq!(mistakes(&archive(&files)), "");
    }

    #[test]
    fn reports_what_is_missing_and_what_is_too_much() {
        let mut bad = archive(&[
            ("src/page.rs", "include_bytes!(\"../../../web/page.js\")"),
            ("src/snapshots/a.snap", ""),
            ("tests/cli.rs", ""),
            ("docs/a.png", ""),
        ]);
        bad.bytes = MAX_BYTES + 1;
        bad.files.remove("README.md");
        bad.files.insert("LICENSE-MIT".into(), b"../LICENSE-MIT".to_vec());
        let found = mistakes(&bad);
        let parts = [
            "bytes, more than",
            "LICENSE-MIT differs",
            "no README.md",
            "../../web/page.js is included",
            "src/snapshots/a.snap is not needed",
            "tests/cli.rs is not needed",
            "docs/a.png is not needed",
        ];
        assert_eq!(found.lines().count(), parts.len(), "{found}");
        for part in parts {
            assert!(found.contains(part), "{part}: {found}");
        }
        bad.files.remove("LICENSE-MIT");
        assert!(mistakes(&bad).contains("no LICENSE-MIT"));
    }
}
