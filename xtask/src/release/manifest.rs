//! What the manifests of published crates must say.

use std::collections::BTreeSet;
use std::path::PathBuf;

use serde_json::Value;

use crate::workspace::root;

/// A crate of the workspace.
#[derive(Clone, Debug, Default)]
pub(super) struct Package {
    pub(super) name: String,
    pub(super) version: String,
    pub(super) manifest: PathBuf,
    pub(super) has_repository: bool,
    is_published: bool,
    /// The keys of the manifest that a published crate needs and this one lacks.
    lacks: Vec<&'static str>,
    keywords: Vec<String>,
    dependencies: Vec<Dependency>,
}

#[derive(Clone, Debug, Default)]
struct Dependency {
    name: String,
    /// Its name in the manifest.
    key: String,
    requirement: String,
    is_of_workspace: bool,
    is_for_tests: bool,
}

impl Dependency {
    /// Whether the published manifest contains it: cargo removes those for tests that have no version.
    fn is_published(&self) -> bool {
        !self.is_for_tests || self.requirement != "*"
    }
}

/// Reads the crates from the output of `cargo metadata`.
pub(super) fn read(metadata: &Value) -> Vec<Package> {
    list(&metadata["packages"]).iter().map(package).collect()
}

fn package(value: &Value) -> Package {
    let strings = |key: &str| list(&value[key]).iter().map(text).collect::<Vec<_>>();
    let needed = ["description", "license", "readme", "documentation"];
    let mut lacks: Vec<_> = needed
        .into_iter()
        .filter(|&key| text(&value[key]).is_empty())
        .collect();
    lacks.extend(
        ["keywords", "categories"]
            .into_iter()
            .filter(|&key| strings(key).is_empty()),
    );
    Package {
        name: text(&value["name"]),
        version: text(&value["version"]),
        manifest: text(&value["manifest_path"]).into(),
        has_repository: value["repository"].is_string(),
        // An empty list of registries is `publish = false`.
        is_published: !value["publish"].is_array(),
        lacks,
        keywords: strings("keywords"),
        dependencies: list(&value["dependencies"]).iter().map(dependency).collect(),
    }
}

fn dependency(value: &Value) -> Dependency {
    let name = text(&value["name"]);
    Dependency {
        key: value["rename"]
            .as_str()
            .map_or_else(|| name.clone(), str::to_owned),
        name,
        requirement: text(&value["req"]),
        is_of_workspace: value["path"].is_string(),
        is_for_tests: value["kind"] == "dev",
    }
}

fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().to_owned()
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// Returns the published crates, each after those that it depends on.
pub(super) fn order(packages: &[Package]) -> Result<Vec<&Package>, String> {
    let mut left: Vec<&Package> = packages.iter().filter(|package| package.is_published).collect();
    left.sort_by(|a, b| a.name.cmp(&b.name));
    let mut ordered = Vec::new();
    while !left.is_empty() {
        let waiting: BTreeSet<&str> = left.iter().map(|package| package.name.as_str()).collect();
        let waits = |package: &&Package| {
            let mut published = package.dependencies.iter().filter(|used| used.is_published());
            published.any(|used| waiting.contains(used.name.as_str()))
        };
        let (later, ready): (Vec<&Package>, Vec<&Package>) = left.iter().copied().partition(waits);
        if ready.is_empty() {
            let names: Vec<&str> = waiting.into_iter().collect();
            return Err(format!(
                "{}: depend on each other; remove the version of a dependency for tests",
                names.join(", ")
            ));
        }
        ordered.extend(ready);
        left = later;
    }
    Ok(ordered)
}

impl Package {
    /// What is wrong in the manifest of a published crate, for a release of `version`.
    pub(super) fn mistakes(&self, packages: &[Package], version: &str) -> Vec<String> {
        let mut found = Vec::new();
        for key in &self.lacks {
            found.push(format!("package: no {key}; inherit it from the workspace"));
        }
        if self.version != version {
            found.push(format!(
                "package: version {}, but other crates have {version}",
                self.version
            ));
        }
        let is_bad = |keyword: &&String| keyword.len() > 20;
        if self.keywords.len() > 5 || self.keywords.iter().any(|keyword| is_bad(&keyword)) {
            found.push("package: more than 5 keywords, or one of more than 20 characters".into());
        }
        let internal = self.dependencies.iter().filter(|used| used.is_of_workspace);
        for used in internal.filter(|used| used.is_published()) {
            let is_published = packages
                .iter()
                .any(|package| package.name == used.name && package.is_published);
            let expected = format!("^{version}");
            if !is_published {
                found.push(format!("dependencies: {} is not published", used.name));
            } else if used.requirement != expected {
                found.push(format!(
                    "dependencies: {} has the requirement `{}`; write version = \"{version}\" beside its path",
                    used.name, used.requirement
                ));
            }
        }
        let place = self
            .manifest
            .strip_prefix(root())
            .unwrap_or(&self.manifest)
            .display();
        found
            .iter()
            .map(|mistake| format!("{place}: {mistake}"))
            .collect()
    }

    /// The dependencies of users that are pinned to one version, and have no comment with the reason in any of the manifests.
    pub(super) fn pins_without_reason<'a>(
        &'a self,
        manifests: &'a [&str],
    ) -> impl Iterator<Item = String> + 'a {
        let pins = self
            .dependencies
            .iter()
            .filter(|used| !used.is_for_tests && used.requirement.starts_with('='));
        pins.filter(|used| !manifests.iter().any(|text| has_reason(text, &used.key)))
            .map(|used| {
                let pin = format!("{} is pinned to `{}`", used.name, used.requirement);
                format!("Cargo.toml: dependencies: {pin}; widen it, or give the reason in a comment")
            })
    }
}

/// Whether a comment stands behind the pin of a dependency, or above the block of pins that contains it.
fn has_reason(manifest: &str, key: &str) -> bool {
    let is_pin = |line: &str| line.contains("= \"=");
    let lines: Vec<&str> = manifest.lines().map(str::trim).collect();
    let is_its = |line: &str| {
        let rest = line.strip_prefix(key).map(str::trim_start);
        is_pin(line) && rest.is_some_and(|rest| rest.starts_with('='))
    };
    let Some(at) = lines.iter().position(|line| is_its(line)) else {
        return false;
    };
    let above = lines[..at].iter().rev().find(|line| !is_pin(line));
    lines[at].contains(" # ") || above.is_some_and(|line| line.starts_with('#'))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn workspace() -> Vec<Package> {
        let complete = |name: &str, dependencies: Value| {
            json!({
                "name": name, "version": "0.1.0", "manifest_path": format!("{name}/Cargo.toml"), "publish": null,
                "description": "x", "license": "MIT", "readme": "README.md", "documentation": "x",
                "keywords": ["depth"], "categories": ["simulation"], "dependencies": dependencies,
            })
        };
        let used = |name: &str, req: &str, kind: Value| json!({ "name": name, "req": req, "kind": kind, "path": name });
        let mut kit = complete("kit", json!([]));
        kit["publish"] = json!([]);
        let top = json!([
            used("base", "^0.1.0", Value::Null),
            used("kit", "*", json!("dev")),
            { "name": "gltf", "req": "=1.4.1", "kind": null, "rename": "glb" },
        ]);
        read(&json!({ "packages": [
            complete("a-top", top), complete("base", json!([])), kit,
        ]}))
    }

    #[test]
    fn orders_published_crates_by_dependency() {
        let packages = workspace();
        let names: Vec<_> = order(&packages)
            .unwrap()
            .iter()
            .map(|package| &package.name)
            .collect();
        assert_eq!(names, ["base", "a-top"]);
    }

    #[test]
    fn reports_crates_that_depend_on_each_other() {
        let mut packages = workspace();
        packages[1].dependencies.push(Dependency {
            name: "a-top".into(),
            requirement: "^0.1.0".into(),
            is_for_tests: true,
            ..Dependency::default()
        });
        let error = order(&packages).unwrap_err();
        assert!(error.starts_with("a-top, base: "), "{error}");
        packages[1].dependencies[0].requirement = "*".into();
        assert!(order(&packages).is_ok());
    }

    #[test]
    fn a_complete_manifest_has_no_mistakes() {
        let packages = workspace();
        for package in order(&packages).unwrap() {
            assert_eq!(package.mistakes(&packages, "0.1.0"), [""; 0]);
        }
    }

    #[test]
    fn reports_what_a_manifest_lacks() {
        let mut packages = workspace();
        packages[0].lacks.push("readme");
        packages[0].keywords.push("more than twenty characters".into());
        packages[0].dependencies[0].requirement = "*".into();
        packages[0].dependencies[1].is_for_tests = false;
        let found = packages[0].mistakes(&packages, "0.1.0").join("\n");
        for part in [
            "no readme",
            "20 characters",
            "base has the requirement `*`",
            "kit is not published",
        ] {
            assert!(found.contains(part), "{part}: {found}");
        }
        assert!(
            packages[0]
                .mistakes(&packages, "0.2.0")
                .join("\n")
                .contains("version 0.1.0")
        );
    }

    #[test]
    fn a_pin_requires_a_reason() {
        let packages = workspace();
        let with = |manifest: &str| packages[0].pins_without_reason(&["", manifest]).count();
        assert_eq!(with("glb = { version = \"=1.4.1\" }"), 1);
        assert_eq!(
            with("# Its patches change bytes.\nother = \"=1\"\nglb = \"=1.4.1\"\n"),
            0
        );
        assert_eq!(with("glb = \"=1.4.1\" # Its patches change bytes."), 0);
        assert_eq!(with("# Readers.\nother = \"1\"\nglb = \"=1.4.1\"\n"), 1);
        let found = packages[0].pins_without_reason(&[]).next().unwrap();
        assert!(found.contains("gltf is pinned to `=1.4.1`"), "{found}");
    }
}
