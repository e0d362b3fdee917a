//! Replays the corpora and the regressions of all targets.
#![allow(clippy::unwrap_used, reason = "a test")]

use std::collections::BTreeSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use oaktwin_fuzz::{FuzzTarget, TARGETS};

fn fuzz_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz")
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

fn names(folder: &str) -> BTreeSet<String> {
    let stems = files(&fuzz_folder().join(folder)).into_iter();
    stems
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect()
}

/// Runs an input, and names it if it breaks a promise.
fn replay(target: &FuzzTarget, name: &str, bytes: &[u8], broken: &mut Vec<String>) {
    if catch_unwind(AssertUnwindSafe(|| (target.check)(bytes))).is_err() {
        broken.push(format!("{}: {name}", target.name));
    }
}

#[test]
fn corpora_and_regressions_break_no_promise() {
    let mut broken = Vec::new();
    for target in TARGETS {
        for folder in ["corpus", "regressions"] {
            for path in files(&fuzz_folder().join(folder).join(target.name)) {
                replay(
                    target,
                    &path.display().to_string(),
                    &fs::read(&path).unwrap(),
                    &mut broken,
                );
            }
        }
        for (number, seed) in (target.seeds)().iter().enumerate() {
            replay(target, &format!("seed {number}"), seed, &mut broken);
        }
        replay(target, "no bytes", &[], &mut broken);
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

#[test]
fn every_target_has_a_corpus_and_a_binary() {
    let targets: BTreeSet<String> = TARGETS.iter().map(|target| target.name.to_owned()).collect();
    assert_eq!(names("fuzz_targets"), targets);
    assert_eq!(names("corpus"), targets);
    assert!(names("regressions").is_subset(&targets));
    let manifest = fs::read_to_string(fuzz_folder().join("Cargo.toml")).unwrap();
    for target in TARGETS {
        assert!(
            manifest.contains(&format!("name = {:?}\n", target.name)),
            "{}",
            target.name
        );
        let source =
            fs::read_to_string(fuzz_folder().join(format!("fuzz_targets/{}.rs", target.name))).unwrap();
        assert!(
            source.contains(&format!("check::{}, bytes)", target.name.replace('-', "_"))),
            "{source}"
        );
        let corpus = files(&fuzz_folder().join("corpus").join(target.name));
        assert!(!corpus.is_empty(), "{} has no corpus", target.name);
    }
}

#[test]
fn all_corpora_are_small() {
    let mut bytes = 0;
    for target in TARGETS {
        for folder in ["corpus", "regressions"] {
            for path in files(&fuzz_folder().join(folder).join(target.name)) {
                bytes += path.metadata().unwrap().len();
            }
        }
    }
    assert!(
        bytes < 2_000_000,
        "{bytes} bytes in the corpora; run cargo fuzz cmin"
    );
}

/// A short run without libFuzzer, from a fixed sequence of bytes.
#[test]
fn drawn_requests_of_the_page_break_no_promise() {
    let page = TARGETS.iter().find(|target| target.name == "page").unwrap();
    let mut broken = Vec::new();
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    for number in 0..1000 {
        let mut bytes = Vec::new();
        for _ in 0..40 {
            // Xorshift.
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            bytes.extend(state.to_le_bytes());
        }
        replay(page, &format!("{number}: {bytes:?}"), &bytes, &mut broken);
    }
    assert!(broken.is_empty(), "{broken:#?}");
}
