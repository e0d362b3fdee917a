//! Which files are a pair.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::input::name::Name;
use oaktwin_dataset::InputName;
use oaktwin_files::FileError;

/// What images are called.
const EXTENSIONS: [&str; 4] = ["png", "jpg", "jpeg", "npy"];

/// The images of one moment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PairFiles {
    /// Of the left camera.
    pub left: PathBuf,
    /// Of the right camera.
    pub right: PathBuf,
    /// What comes before the names of results.
    prefix: String,
    /// What comes after them.
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

    /// Whether another is of the same sequence.
    pub(super) fn goes_on(&self, before: &Self) -> bool {
        self.prefix == before.prefix && self.number.is_some() && before.number.is_some()
    }
}

/// The pairs of two files, or of two folders whose files have the same names but for the words `left` and `right`: in the
/// order of the numbers in them. One folder may hold both.
///
/// # Errors
/// A folder that cannot be read, has no images, or one without its partner.
pub fn pairs(left: &Path, right: &Path) -> Result<Vec<PairFiles>, FileError> {
    match (left.is_dir(), right.is_dir()) {
        (false, false) => return Ok(vec![PairFiles::new(left.to_owned(), right.to_owned())]),
        (true, true) => {}
        (true, false) => {
            return Err(FileError::new(
                right,
                "is no folder, and the left is",
                "give two folders",
            ));
        }
        (false, true) => {
            return Err(FileError::new(
                left,
                "is no folder, and the right is",
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
                "name the images of a moment alike",
            ));
        };
        pairs.push(PairFiles::new(left_file, right_file));
    }
    if let Some((_, alone)) = rights.pop_first() {
        let message = format!("has no partner in {}", left.display());
        return Err(FileError::new(
            &alone,
            message,
            "name the images of a moment alike",
        ));
    }
    pairs.sort_by(|a, b| (&a.prefix, a.number, &a.suffix).cmp(&(&b.prefix, b.number, &b.suffix)));
    Ok(pairs)
}

/// The images of a folder, those with a word in their names if one is asked for, by what is the same in both.
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
            let message = format!("is of the same moment as {}", other.display());
            return Err(FileError::new(&path, message, "leave one out"));
        }
    }
    if found.is_empty() {
        let of = word
            .map(|word| format!(" with {word} in its name"))
            .unwrap_or_default();
        let message = format!("holds no image{of}");
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

/// What is the same in the names of both.
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
