//! `cargo xtask release`: packages the published crates in order, checks the archives, and publishes them.

mod archive;
mod manifest;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::workspace::{self, check, output};
use archive::Archive;
use manifest::Package;

/// The manifest of the workspace.
const MANIFEST: &str = "Cargo.toml";
const CHANGELOG: &str = "CHANGELOG.md";

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Package the crates and check the archives, and publish nothing
    #[arg(long)]
    dry_run: bool,
    /// With --dry-run: also compile each crate from its archive
    #[arg(long, requires = "dry_run")]
    verify: bool,
    /// Publish this crate and those after it, where an earlier run stopped
    #[arg(long, value_name = "CRATE", conflicts_with = "dry_run")]
    from: Option<String>,
}

/// Packages and checks all published crates; without `--dry-run`, publishes them.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let metadata = workspace::metadata(&["--no-deps"])?;
    let packages = manifest::read(&metadata);
    let crates = manifest::order(&packages)?;
    let Some(version) = crates.first().map(|package| package.version.clone()) else {
        return Err(format!(
            "{MANIFEST}: no crate is published; remove `publish = false`"
        ));
    };
    if !args.dry_run {
        let missing = State::read(&version, &crates)?.missing();
        if !missing.is_empty() {
            return Err(format!(
                "{version} cannot be published yet:\n- {}",
                missing.join("\n- ")
            ));
        }
    }
    let mistakes = manifest_mistakes(&crates, &packages, &version)?;
    fail(&mistakes)?;
    package(&crates, args.verify)?;
    let archives: Vec<Archive> = crates
        .iter()
        .map(|package| Archive::unpack(&package.name, &package.version))
        .collect::<Result<_, _>>()?;
    for archive in &archives {
        println!("{archive}");
    }
    let licenses = archive::licenses()?;
    let mistakes: Vec<String> = archives
        .iter()
        .flat_map(|archive| archive.mistakes(&licenses))
        .collect();
    fail(&mistakes)?;
    println!("semver: {}", compare_with_earlier(&crates, &version)?);
    println!("{} crates of {version} can be published", crates.len());
    if args.dry_run {
        return Ok(());
    }
    publish(&crates, args.from.as_deref())
}

fn fail(mistakes: &[String]) -> Result<(), String> {
    match mistakes {
        [] => Ok(()),
        _ => Err(mistakes.join("\nerror: ")),
    }
}

fn manifest_mistakes(
    crates: &[&Package],
    packages: &[Package],
    version: &str,
) -> Result<Vec<String>, String> {
    let shared = read(&workspace::root().join(MANIFEST))?;
    let mut found = Vec::new();
    // Several crates use what the workspace pins.
    let mut pins = BTreeSet::new();
    for package in crates {
        found.extend(package.mistakes(packages, version));
        pins.extend(package.pins_without_reason(&[&shared, &read(&package.manifest)?]));
    }
    found.extend(pins);
    Ok(found)
}

/// Writes the archives of the crates below the target folder.
fn package(crates: &[&Package], verify: bool) -> Result<(), String> {
    let mut command = workspace::cargo();
    command.args(["package", "--locked", "--allow-dirty", "--quiet"]);
    if !verify {
        command.arg("--no-verify");
    }
    for package in crates {
        command.args(["--package", &package.name]);
    }
    check(&mut command)
}

/// Compares the interfaces with the newest earlier release, and returns a line about the outcome.
fn compare_with_earlier(crates: &[&Package], version: &str) -> Result<String, String> {
    let installed = Command::new("cargo")
        .args(["semver-checks", "--version"])
        .output();
    if !installed.is_ok_and(|output| output.status.success()) {
        let remedy = "run: cargo install --locked cargo-semver-checks";
        return Ok(format!("skipped: cargo-semver-checks is not installed; {remedy}"));
    }
    let tags = git(&["tag", "--list", "v*", "--sort=-version:refname"])?;
    let Some(earlier) = tags.lines().find(|tag| *tag != format!("v{version}")) else {
        return Ok("skipped: no earlier release is tagged".into());
    };
    let mut command = workspace::cargo();
    command.args(["semver-checks", "--baseline-rev", earlier]);
    for package in crates {
        command.args(["--package", &package.name]);
    }
    check(&mut command)?;
    Ok(format!("compared with {earlier}"))
}

fn publish(crates: &[&Package], from: Option<&str>) -> Result<(), String> {
    let start = match from {
        None => 0,
        Some(name) => crates
            .iter()
            .position(|package| package.name == name)
            .ok_or_else(|| format!("--from: no published crate is named {name}"))?,
    };
    for package in &crates[start..] {
        let mut command = workspace::cargo();
        command.args(["publish", "--locked", "--package", &package.name]);
        check(&mut command).map_err(|error| {
            format!(
                "{error}; when the cause is gone, go on with: cargo xtask release --from {}",
                package.name
            )
        })?;
    }
    Ok(())
}

fn git(arguments: &[&str]) -> Result<String, String> {
    output(Command::new("git").current_dir(workspace::root()).args(arguments))
}

fn read(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

/// What has to be right before anything is published.
struct State {
    version: String,
    /// Whether there are changes that are not committed.
    is_changed: bool,
    /// The tags of the current commit.
    tags: String,
    changelog: String,
    /// Whether the crates name their repository.
    has_repository: bool,
}

impl State {
    fn read(version: &str, crates: &[&Package]) -> Result<Self, String> {
        Ok(Self {
            version: version.to_owned(),
            is_changed: !git(&["status", "--porcelain"])?.is_empty(),
            tags: git(&["tag", "--points-at", "HEAD"])?,
            changelog: read(&workspace::root().join(CHANGELOG))?,
            has_repository: crates.iter().all(|package| package.has_repository),
        })
    }

    /// The steps that are still to do.
    fn missing(&self) -> Vec<String> {
        let Self { version, .. } = self;
        let tag = format!("v{version}");
        let heading = format!("## {version}");
        let is_heading = |line: &str| {
            line.strip_prefix(&heading)
                .is_some_and(|rest| rest.is_empty() || rest.starts_with(' '))
        };
        let steps = [
            (
                self.has_repository,
                "name the repository: python .github/links.py ADDRESS".to_owned(),
            ),
            (
                self.changelog.lines().any(is_heading),
                format!("{CHANGELOG}: no heading `{heading}`; move what is unreleased below it"),
            ),
            (
                !self.is_changed,
                "commit or remove the changes in the checkout".to_owned(),
            ),
            (
                self.tags.lines().any(|own| own == tag),
                format!("tag this commit: git tag -a {tag} -m {tag}"),
            ),
        ];
        let open = steps.into_iter().filter(|(is_done, _)| !is_done);
        open.map(|(_, step)| step).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ready() -> State {
        State {
            version: "0.1.0".into(),
            is_changed: false,
            tags: "good\nv0.1.0\n".into(),
            changelog: "# Changelog\n\n## 0.1.0 – 2026\n".into(),
            has_repository: true,
        }
    }

    #[test]
    fn a_complete_state_lacks_nothing() {
        assert!(ready().missing().is_empty());
    }

    #[test]
    fn lists_every_step_that_is_missing() {
        let state = State {
            is_changed: true,
            tags: "v0.1.0-rc1\n".into(),
            changelog: "## Unreleased\n## 0.1.01\n".into(),
            has_repository: false,
            ..ready()
        };
        let missing = state.missing().join("\n");
        for part in ["links.py", "`## 0.1.0`", "commit", "git tag -a v0.1.0"] {
            assert!(missing.contains(part), "{part}: {missing}");
        }
        assert_eq!(state.missing().len(), 4);
    }
}
