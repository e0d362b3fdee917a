//! Compares the findings for one small file per rule with snapshots.
#![expect(clippy::unwrap_used, reason = "a test")]

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_catalog::Catalog;
use oaktwin_usd::check::{CheckOptions, CheckReport, RULES, check};

fn fixtures() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/check");
    let mut files: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    files
}

/// Returns the findings, one per line, without absolute paths.
fn lines(report: &CheckReport) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).canonicalize().unwrap();
    let lines: Vec<String> = report.findings.iter().map(ToString::to_string).collect();
    lines.join("\n").replace(folder.to_str().unwrap(), "…")
}

#[test]
fn fixtures_cover_every_rule() {
    let mut seen: BTreeSet<&str> = BTreeSet::new();
    for path in fixtures() {
        let name = path.file_stem().unwrap().to_str().unwrap();
        let report = check(&path, &CheckOptions::default()).unwrap();
        insta::assert_snapshot!(name, lines(&report));
        for finding in &report.findings {
            let rule = RULES.iter().find(|rule| rule.code == finding.code);
            let rule = rule.unwrap_or_else(|| panic!("{} is not in RULES", finding.code));
            assert!(finding.level <= rule.level, "{name}: {finding}");
            seen.insert(rule.code);
        }
    }
    let unseen: Vec<&str> = RULES
        .iter()
        .map(|rule| rule.code)
        .filter(|code| !seen.contains(code))
        .collect();
    // Packages are built in tests/bad_input.rs.
    assert_eq!(unseen, ["package-layout"]);
}

#[test]
fn given_model_overrides_recognition() {
    let catalog = Catalog::builtin();
    let twin = catalog.nominal(catalog.device("OAK4-D Wide").unwrap());
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/check/good_oak_d_pro.usda");
    let report = check(
        path,
        &CheckOptions {
            catalog,
            model: Some(&twin),
            ..CheckOptions::default()
        },
    )
    .unwrap();
    insta::assert_snapshot!("good_oak_d_pro_as_oak4_d_wide", lines(&report));
}

#[test]
fn serializes_the_report_as_json() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures/check/offset_convention.usda");
    let mut report = check(path, &CheckOptions::default()).unwrap();
    report.file = "offset_convention.usda".into();
    insta::assert_snapshot!("json", serde_json::to_string_pretty(&report).unwrap());
}
