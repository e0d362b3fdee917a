//! Truncated and corrupted files give an error or a scene, never a panic.

use proptest::prelude::*;

use crate::support::{Files, check};
use crate::{dae, gltf_builder, ply, stl};

fn whole_files() -> Vec<(&'static str, Vec<u8>)> {
    let obj = "o a\nv 0 0 0\nv 1 0 0 1 0 0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nusemtl x\nf 1/1/1 2/1/1 -1/1/1\ng b\nf 1 2 3 2\n";
    vec![
        ("a.stl", stl::binary("a")),
        ("b.stl", stl::text("b").into_bytes()),
        ("a.ply", ply::text().into_bytes()),
        ("b.ply", ply::binary(false)),
        ("c.ply", ply::binary(true)),
        ("a.obj", obj.into()),
        (
            "a.gltf",
            gltf_builder::Builder::everything().embedded().into_bytes(),
        ),
        ("a.dae", dae::everything().into_bytes()),
        ("a.glb", gltf_builder::Builder::everything().binary()),
    ]
}

fn open(name: &str, bytes: &[u8]) {
    if let Ok(imported) = Files::new().with(name, bytes).try_open(name) {
        check(&imported.scene);
    }
}

#[test]
fn whole_files_are_read() {
    for (name, bytes) in whole_files() {
        Files::new().with(name, bytes).open(name);
    }
}

#[test]
fn truncated_files_never_panic() {
    let files = Files::new();
    for (name, bytes) in whole_files() {
        // All lengths of small files, some of large ones.
        let step = 1 + bytes.len() / 500;
        for end in (1..bytes.len()).step_by(step) {
            std::fs::write(files.path(name), &bytes[..end]).unwrap();
            if let Ok(imported) = files.try_open(name) {
                check(&imported.scene);
            }
        }
    }
}

proptest! {
    // Each case writes a file.
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn changed_bytes_never_panic(file in 0..9_usize, changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6)) {
        let (name, mut bytes) = whole_files().swap_remove(file);
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        open(name, &bytes);
    }

    #[test]
    fn changed_digits_never_panic(file in 1..7_usize, changes in prop::collection::vec((any::<prop::sample::Index>(), "[-0-9e.]"), 1..8)) {
        let (name, mut bytes) = whole_files().swap_remove(file);
        let digits: Vec<usize> = (0..bytes.len()).filter(|&i| bytes[i].is_ascii_digit()).collect();
        for (at, byte) in changes {
            bytes[digits[at.index(digits.len())]] = byte.as_bytes()[0];
        }
        open(name, &bytes);
    }

    #[test]
    fn random_bytes_are_rejected(name in prop::sample::select(vec!["a.stl", "a.ply", "a.obj", "a.gltf", "a.glb"]), bytes in prop::collection::vec(any::<u8>(), 1..300)) {
        open(name, &bytes);
    }
}
