//! Unreadable files are rejected with file, place and remedy; no claim in a file causes a panic, a hang or unbounded
//! allocation.
#![expect(clippy::unwrap_used, reason = "a test")]

use std::fs;
use std::path::{Path, PathBuf};

use oaktwin_usd::check::{CheckOptions, check};
use oaktwin_usd::stage::{self, SceneLimit};

fn fixture(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures").join(name)
}

/// Returns the text of the error or the findings, without absolute paths.
fn outcome(path: &Path) -> String {
    let text = match check(path, &CheckOptions::default()) {
        Ok(report) => report
            .findings
            .iter()
            .map(|finding| format!("{finding}\n"))
            .collect(),
        Err(error) => format!("{error}\n"),
    };
    let folder = path.parent().unwrap();
    let ours = fixture("").canonicalize().unwrap();
    text.replace(&format!("{}/", folder.display()), "…/")
        .replace(&format!("{}/", folder.canonicalize().unwrap().display()), "…/")
        .replace(ours.to_str().unwrap(), "…")
}

#[test]
fn reports_every_bad_file() {
    let mut files: Vec<PathBuf> = fs::read_dir(fixture("bad"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    let mut all = String::new();
    for path in files {
        let name = path.file_name().unwrap().to_str().unwrap();
        all += &format!("# {name}\n{}\n", outcome(&path));
    }
    insta::assert_snapshot!("bad", all);
}

#[cfg(unix)]
#[test]
fn rejects_missing_files_directories_and_devices() {
    let folder = tempfile::tempdir().unwrap();
    let error = |path: &Path| stage::open(path, SceneLimit::default()).unwrap_err().to_string();
    let nowhere = folder.path().join("nowhere.usd");
    assert!(
        error(&nowhere)
            .ends_with("nowhere.usd: cannot be read: No such file or directory (os error 2); check the path")
    );
    let directory = folder.path().join("folder.usd");
    fs::create_dir(&directory).unwrap();
    assert!(error(&directory).ends_with("folder.usd: is a directory; give the USD file inside it"));
    let error = stage::open("/dev/zero", SceneLimit::default()).unwrap_err();
    assert_eq!(error.what, "is not a regular file");
}

#[test]
fn rejects_large_garbage_by_its_first_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("large.usd");
    fs::write(&path, vec![0x5a; 100 << 20]).unwrap();
    assert_eq!(
        stage::open(&path, SceneLimit::default()).unwrap_err().place,
        "start"
    );
    // A text header followed by a single line of brackets.
    let mut text = b"#usda 1.0\n".to_vec();
    text.resize(100 << 20, b'(');
    fs::write(&path, text).unwrap();
    assert_eq!(
        stage::open(&path, SceneLimit::default()).unwrap_err().place,
        "line 2"
    );
}

#[cfg(unix)]
#[test]
fn follows_symlinks() {
    let folder = tempfile::tempdir().unwrap();
    let link = folder.path().join("link.usda");
    std::os::unix::fs::symlink(fixture("check/good.usda"), &link).unwrap();
    assert_eq!(
        stage::open(&link, SceneLimit::default()).unwrap().cameras.len(),
        1
    );
}

/// An entry of a package: its names in the header and in the directory, its claimed method and size, its data.
struct Entry<'a> {
    name: &'a str,
    directory_name: &'a str,
    method: u16,
    claimed: u32,
    data: &'a [u8],
}

impl<'a> Entry<'a> {
    fn new(name: &'a str, data: &'a [u8]) -> Self {
        Self {
            name,
            directory_name: name,
            method: 0,
            claimed: u32::try_from(data.len()).unwrap(),
            data,
        }
    }
}

/// Creates a zip archive whose entries have `padding` bytes between header and data.
fn package(entries: &[Entry<'_>], padding: u16) -> Vec<u8> {
    let mut out = Vec::new();
    let mut directory = Vec::new();
    for entry in entries {
        let offset = u32::try_from(out.len()).unwrap();
        let crc = crc32fast::hash(entry.data);
        let sizes = [
            crc.to_le_bytes(),
            entry.claimed.to_le_bytes(),
            entry.claimed.to_le_bytes(),
        ]
        .concat();
        let length = |name: &str| u16::try_from(name.len()).unwrap().to_le_bytes();
        out.extend(b"PK\x03\x04\x0a\x00\x00\x00");
        out.extend(entry.method.to_le_bytes());
        out.extend([0; 4]);
        out.extend(&sizes);
        out.extend(length(entry.name));
        out.extend(padding.to_le_bytes());
        out.extend(entry.name.as_bytes());
        out.extend(vec![0; usize::from(padding)]);
        out.extend(entry.data);
        directory.extend(b"PK\x01\x02\x0a\x00\x0a\x00\x00\x00");
        directory.extend(entry.method.to_le_bytes());
        directory.extend([0; 4]);
        directory.extend(&sizes);
        directory.extend(length(entry.directory_name));
        directory.extend([0; 12]);
        directory.extend(offset.to_le_bytes());
        directory.extend(entry.directory_name.as_bytes());
    }
    let start = u32::try_from(out.len()).unwrap();
    out.extend(&directory);
    out.extend(b"PK\x05\x06\x00\x00\x00\x00");
    let count = u16::try_from(entries.len()).unwrap().to_le_bytes();
    out.extend([count, count].concat());
    out.extend(u32::try_from(directory.len()).unwrap().to_le_bytes());
    out.extend(start.to_le_bytes());
    out.extend([0; 2]);
    out
}

#[test]
fn reports_malformed_packages() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("package.usdz");
    let layer = fs::read(fixture("check/good.usda")).unwrap();
    let good = Entry::new("good.usda", &layer);
    // 30 bytes of header, 9 of name: 25 more make 64.
    let aligned = package(&[good], 25);
    let cases: Vec<(&str, Vec<u8>)> = vec![
        ("aligned", aligned.clone()),
        ("not aligned", package(&[Entry::new("good.usda", &layer)], 0)),
        (
            "points outside",
            package(&[Entry::new("../good.usda", &layer)], 22),
        ),
        ("absolute", package(&[Entry::new("/tmp/good.usda", &layer)], 20)),
        (
            "two names",
            package(
                &[Entry {
                    directory_name: "evil.usda",
                    ..Entry::new("good.usda", &layer)
                }],
                25,
            ),
        ),
        (
            "compressed",
            package(
                &[Entry {
                    method: 8,
                    ..Entry::new("good.usda", &layer)
                }],
                25,
            ),
        ),
        (
            "claims more",
            package(
                &[Entry {
                    claimed: u32::MAX - 1,
                    ..Entry::new("good.usda", &layer)
                }],
                25,
            ),
        ),
        ("image first", package(&[Entry::new("good.png", &layer)], 26)),
        ("empty", package(&[], 0)),
        (
            "twice",
            package(&[Entry::new("a.usda", &layer), Entry::new("a.usda", &layer)], 28),
        ),
        ("cut in half", aligned[..aligned.len() / 2].to_vec()),
        ("without its end", aligned[..aligned.len() - 3].to_vec()),
    ];
    let mut all = String::new();
    for (name, bytes) in cases {
        fs::write(&path, bytes).unwrap();
        all += &format!("# {name}\n{}\n", outcome(&path));
    }
    insta::assert_snapshot!("packages", all);
}

/// Returns a binary layer that OpenUSD 26.11 wrote from `check/good_oak_d_pro.usda`, with a dictionary, time samples and arrays.
fn binary() -> Vec<u8> {
    fs::read(fixture("binary.usdc")).unwrap()
}

#[test]
fn reports_binary_layers_with_wrong_sizes() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("binary.usdc");
    let good = binary();
    fs::write(&path, &good).unwrap();
    assert_eq!(
        stage::open(&path, SceneLimit::default()).unwrap().cameras.len(),
        4
    );

    let toc = usize::try_from(u64::from_le_bytes(good[16..24].try_into().unwrap())).unwrap();
    let mut all = String::new();
    let mut report = |name: &str, bytes: &[u8]| {
        fs::write(&path, bytes).unwrap();
        all += &format!("# {name}\n{}\n", outcome(&path));
    };
    let with = |at: usize, value: u64| {
        let mut bytes = good.clone();
        bytes[at..at + 8].copy_from_slice(&value.to_le_bytes());
        bytes
    };
    report("table of contents beyond the end", &with(16, 1 << 60));
    report("2^40 sections", &with(toc, 1 << 40));
    report("cut in half", &good[..good.len() / 2]);
    report("future version", &with(8, 0x0000_0000_0000_6300));
    let sections = u64::from_le_bytes(good[toc..toc + 8].try_into().unwrap());
    for section in 0..usize::try_from(sections).unwrap() {
        let at = toc + 8 + 32 * section;
        let name = String::from_utf8(good[at..at + 16].to_vec()).unwrap();
        let name = name.trim_end_matches('\0');
        report(&format!("{name}: 2^50 bytes"), &with(at + 24, 1 << 50));
        let start = usize::try_from(u64::from_le_bytes(good[at + 16..at + 24].try_into().unwrap())).unwrap();
        report(&format!("{name}: 2^45 entries"), &with(start, 1 << 45));
        report(
            &format!("{name}: 2^45 bytes in its first block"),
            &with(start + 8, 1 << 45),
        );
    }
    insta::assert_snapshot!("binary", all);
}

/// A deterministic pseudo-random generator.
struct Noise(u64);

impl Noise {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        usize::try_from((self.0 >> 33) % u64::try_from(limit).unwrap()).unwrap()
    }
}

#[test]
fn damaged_layers_never_panic() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read(fixture("check/catalog_value.usda")).unwrap();
    let packaged = package(&[Entry::new("good.usda", &text)], 25);
    let mut noise = Noise(20_261_121);
    let (mut rejected, mut read) = (0, 0);
    for (extension, good, rounds) in [
        ("usda", &text, 300),
        ("usdc", &binary(), 900),
        ("usdz", &packaged, 300),
    ] {
        let path = folder.path().join(format!("damaged.{extension}"));
        for round in 0..rounds {
            let mut bytes = good.clone();
            match round % 4 {
                0 => bytes.truncate(noise.below(good.len())),
                1 => bytes[noise.below(good.len())] ^= 1 << noise.below(8),
                2 => {
                    for _ in 0..8 {
                        bytes[noise.below(good.len())] = u8::try_from(noise.below(256)).unwrap();
                    }
                }
                // Overwrites what may be a count.
                _ => {
                    let at = noise.below(good.len() - 8);
                    let value = [u64::MAX, 1 << 40, 1 << 33, 1 << 47][noise.below(4)];
                    bytes[at..at + 8].copy_from_slice(&value.to_le_bytes());
                }
            }
            fs::write(&path, bytes).unwrap();
            match check(&path, &CheckOptions::default()) {
                Ok(_) => read += 1,
                Err(error) => {
                    assert!(!error.to_string().contains('\n'), "{error}");
                    rejected += 1;
                }
            }
        }
    }
    assert!(rejected > 300 && read > 100, "{rejected} rejected, {read} read");
}
