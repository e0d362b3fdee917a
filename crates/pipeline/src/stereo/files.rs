//! Pairs of image files.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::input::name::Name;
use oaktwin_dataset::InputName;
use oaktwin_files::FileError;

/// The extensions of images.
const EXTENSIONS: [&str; 4] = ["png", "jpg", "jpeg", "npy"];

/// A pair of image files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PairFiles {
    /// The left image.
    pub left: PathBuf,
    /// The right image.
    pub right: PathBuf,
    /// The text before the name of a result.
    prefix: String,
    /// The text after the name of a result.
    suffix: String,
    number: Option<u64>,
}

impl PairFiles {
    fn new(left: PathBuf, right: PathBuf) -> Self {
        let name = Name::of(Path::new(&key(&left)));
        Self {
            prefix: name.prefix(),
            suffix: name.suffix(),
            number: name.number,
            left,
            right,
        }
    }

    /// The names of the results.
    pub(super) fn results(&self) -> InputName {
        InputName {
            prefix: self.prefix.clone(),
            suffix: self.suffix.clone(),
            ..InputName::default()
        }
    }

    /// Whether the pair continues the sequence of `before`.
    pub(super) fn goes_on(&self, before: &Self) -> bool {
        self.prefix == before.prefix && self.number.is_some() && before.number.is_some()
    }
}

/// Returns the pair of two files, or the pairs of two folders, whose file names are equal except for the words `left` and `right`,
/// in the order of the numbers in them. One folder may contain both.
///
/// # Errors
/// Returns an error if a folder cannot be read or has no images, or an image has no partner.
pub fn pairs(left: &Path, right: &Path) -> Result<Vec<PairFiles>, FileError> {
    match (left.is_dir(), right.is_dir()) {
        (false, false) => return Ok(vec![PairFiles::new(left.to_owned(), right.to_owned())]),
        (true, true) => {}
        (true, false) => {
            return Err(FileError::new(
                right,
                "is a file, but the left input is a folder",
                "give two folders",
            ));
        }
        (false, true) => {
            return Err(FileError::new(
                left,
                "is a file, but the right input is a folder",
                "give two folders",
            ));
        }
    }
    let is_one = left.canonicalize().ok() == right.canonicalize().ok();
    let lefts = images(left, is_one.then_some("left"))?;
    let mut rights = images(right, is_one.then_some("right"))?;
    let mut pairs = Vec::new();
    for (key, left_file) in lefts {
        let Some(right_file) = rights.remove(&key) else {
            let message = format!("has no partner in {}", right.display());
            return Err(FileError::new(
                &left_file,
                message,
                "give the images of a pair the same name except for left and right",
            ));
        };
        pairs.push(PairFiles::new(left_file, right_file));
    }
    if let Some((_, alone)) = rights.pop_first() {
        let message = format!("has no partner in {}", left.display());
        return Err(FileError::new(
            &alone,
            message,
            "give the images of a pair the same name except for left and right",
        ));
    }
    pairs.sort_by(|a, b| (&a.prefix, a.number, &a.suffix).cmp(&(&b.prefix, b.number, &b.suffix)));
    Ok(pairs)
}

/// The images of a folder by their key; with `word`, those that have it in their names.
fn images(folder: &Path, word: Option<&str>) -> Result<BTreeMap<String, PathBuf>, FileError> {
    let unreadable = |error: std::io::Error| {
        FileError::new(
            folder,
            format!("cannot be read ({error})"),
            "check its permissions",
        )
    };
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let extension = path.extension().unwrap_or_default().to_string_lossy();
        let is_image = EXTENSIONS
            .iter()
            .any(|known| extension.eq_ignore_ascii_case(known));
        if !is_image || !path.is_file() || word.is_some_and(|word| !has(&path, word)) {
            continue;
        }
        if let Some(other) = found.insert(key(&path), path.clone()) {
            let message = format!("has the same name as {}", other.display());
            return Err(FileError::new(&path, message, "remove one of them"));
        }
    }
    if found.is_empty() {
        let of = word
            .map(|word| format!(" with {word} in its name"))
            .unwrap_or_default();
        let message = format!("contains no images{of}");
        return Err(FileError::new(
            folder,
            message,
            "give a folder of PNG, JPEG or NPY",
        ));
    }
    Ok(found)
}

fn words(path: &Path) -> Vec<String> {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let words = stem.split(['_', '-', '.', ' ']);
    words.filter(|word| !word.is_empty()).map(str::to_owned).collect()
}

fn has(path: &Path, side: &str) -> bool {
    words(path).iter().any(|word| word.eq_ignore_ascii_case(side))
}

/// The part of a name that is the same for both images of a pair.
fn key(path: &Path) -> String {
    let is_side = |word: &String| {
        ["left", "right"]
            .iter()
            .any(|side| word.eq_ignore_ascii_case(side))
    };
    let mut words = words(path);
    words.retain(|word| !is_side(word));
    words.join("_")
}
