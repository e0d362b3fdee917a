//! The state of a data set on disk: its recipe, the records of finished frames, and a lock.

use std::collections::{BTreeMap, BTreeSet};
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use oaktwin_base::diagnostic::Finding;
use oaktwin_files::{self as files, FileError, WrittenFile};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use sha2::{Digest, Sha256};

use crate::GenerateError;
use crate::recipe::{Recipe, RecipeFile};
use crate::unit::DrawnUnit;

/// The folder of the state, within the data set's folder.
const FOLDER: &str = ".oaktwin";
/// The maximum size of a record.
const MAX_BYTES: u64 = 256 << 20;

/// The state of a data set.
#[derive(Debug)]
pub(crate) struct Store {
    /// The folder of the data set.
    pub(crate) root: PathBuf,
    /// Held while this process writes the data set.
    _lock: Option<File>,
}

/// A finished frame.
#[derive(Debug, Deserialize, Serialize)]
pub(crate) struct FrameRecord {
    pub(crate) frame: u64,
    /// The unit that it was taken with.
    pub(crate) unit: DrawnUnit,
    #[serde(
        with = "oaktwin_base::diagnostic::stored",
        skip_serializing_if = "Vec::is_empty",
        default
    )]
    pub(crate) findings: Vec<Finding>,
    /// Its files, relative to the data set.
    pub(crate) files: Vec<FileRecord>,
    /// The records of each format, one for each camera.
    pub(crate) formats: Vec<Vec<Value>>,
}

/// A file with its checksum.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub(crate) struct FileRecord {
    pub(crate) path: String,
    pub(crate) bytes: u64,
    pub(crate) sha256: String,
    /// The file of the data set that has its contents, if it was removed.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub(crate) packed_in: Option<Container>,
}

/// A file with the contents of others.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub(crate) struct Container {
    pub(crate) path: String,
    pub(crate) bytes: u64,
    #[serde(default)]
    pub(crate) sha256: Option<String>,
}

impl Store {
    /// Opens or creates the state of a data set in a folder, of a recipe that names these files. A worker of another process, which
    /// holds the lock, does not lock and trusts it with the files.
    ///
    /// # Errors
    /// Returns an error if the folder has a data set that is not to be resumed, has another recipe or was made of other files, or if
    /// another process writes it.
    pub(crate) fn open(
        root: &Path,
        file: &RecipeFile,
        inputs: &[PathBuf],
        resume: bool,
        is_worker: bool,
    ) -> Result<Self, GenerateError> {
        let folder = root.join(FOLDER);
        let is_known = folder.join("recipe.json").exists();
        if is_known && !resume && !is_worker {
            return Err(FileError::new(
                root,
                "already has a data set",
                oaktwin_base::diagnostic::message![
                    "add to it with ",
                    oaktwin_base::diagnostic::opt("resume"),
                    ", or choose another folder"
                ],
            )
            .into());
        }
        files::make_folder(&folder.join("frames"))?;
        let lock = match is_worker {
            true => None,
            false => Some(lock(root, &folder.join("lock"))?),
        };
        let path = folder.join("recipe.json");
        let own = serde_json::to_value(&file.recipe).unwrap_or_default();
        if is_known {
            let bytes = read(&path)?;
            let known: Value = serde_json::from_slice(&bytes).map_err(|error| {
                let message = format!("is damaged ({error})");
                FileError::new(&path, message, "restore it, or choose another folder")
            })?;
            reject_change(root, &known, &own)?;
        }
        let store = Self {
            root: root.to_owned(),
            _lock: lock,
        };
        if !is_worker {
            store.check_inputs(file, inputs)?;
            files::write(&path, &pretty(&own))?;
        }
        Ok(store)
    }

    fn inputs_path(&self) -> PathBuf {
        self.root.join(FOLDER).join("inputs.json")
    }

    /// Compares the files of the recipe with the ones that the data set was made of, and keeps their checksums.
    fn check_inputs(&self, file: &RecipeFile, inputs: &[PathBuf]) -> Result<(), GenerateError> {
        let folder = file.path.parent().unwrap_or(Path::new(""));
        let sums = inputs.iter().map(|path| {
            let name = path.strip_prefix(folder).unwrap_or(path);
            Ok((name.to_string_lossy().replace('\\', "/"), checksum(path)?))
        });
        let own: Inputs = sums.collect::<Result<_, FileError>>()?;
        let path = self.inputs_path();
        if path.exists() {
            let known: Inputs = serde_json::from_slice(&read(&path)?).map_err(|error| {
                let message = format!("is damaged ({error})");
                FileError::new(&path, message, "restore it, or choose another folder")
            })?;
            if let Some(change) = changed_input(&known, &own) {
                let message = format!("was generated from other files: {change}");
                return Err(
                    FileError::new(&self.root, message, "restore it, or choose another folder").into(),
                );
            }
        }
        Ok(files::write(&path, &pretty(&own))?)
    }

    /// Returns the checksums of the recipe's files by path.
    pub(crate) fn inputs(&self) -> Result<Inputs, GenerateError> {
        Ok(serde_json::from_slice(&read(&self.inputs_path())?).unwrap_or_default())
    }

    /// Returns the numbers of the frames that are complete.
    pub(crate) fn frames(&self) -> Result<BTreeSet<u64>, GenerateError> {
        let folder = self.root.join(FOLDER).join("frames");
        let entries = fs::read_dir(&folder).map_err(|error| FileError::reading(&folder, &error))?;
        let names = entries.flatten().map(|entry| entry.file_name());
        let number = |name: std::ffi::OsString| name.to_str()?.strip_suffix(".json")?.parse().ok();
        Ok(names.filter_map(number).collect())
    }

    /// Whether all files of a finished frame are there.
    pub(crate) fn is_intact(&self, frame: u64) -> bool {
        let has = |file: &FileRecord| {
            let (path, bytes) = match &file.packed_in {
                Some(container) => (&container.path, container.bytes),
                None => (&file.path, file.bytes),
            };
            fs::metadata(self.root.join(path)).is_ok_and(|metadata| metadata.len() == bytes)
        };
        self.frame(frame).is_ok_and(|record| record.files.iter().all(has))
    }

    /// Reads the record of a frame: a line of JSON, and one with its checksum.
    pub(crate) fn frame(&self, frame: u64) -> Result<FrameRecord, FileError> {
        let path = self.frame_path(frame);
        let damaged = |what: String| FileError::new(&path, what, "remove it, and resume");
        let bytes = read(&path)?;
        let mut lines = bytes.split(|byte| *byte == b'\n');
        let (record, sum) = (lines.next().unwrap_or_default(), lines.next().unwrap_or_default());
        if format!("\"{}\"", hex(&Sha256::digest(record))).as_bytes() != sum {
            return Err(damaged("is damaged: its checksum differs".to_owned()));
        }
        let record: FrameRecord =
            serde_json::from_slice(record).map_err(|error| damaged(format!("is not a record ({error})")))?;
        match record.frame == frame {
            true => Ok(record),
            false => Err(damaged(format!("is the record of frame {}", record.frame))),
        }
    }

    /// Writes the record of a frame, which is complete from then on.
    pub(crate) fn add(&self, record: &FrameRecord) -> Result<(), FileError> {
        let mut bytes = serde_json::to_vec(record).unwrap_or_default();
        let sum = hex(&Sha256::digest(&bytes));
        bytes.extend_from_slice(format!("\n\"{sum}\"\n").as_bytes());
        files::write(&self.frame_path(record.frame), &bytes)
    }

    fn frame_path(&self, frame: u64) -> PathBuf {
        self.root
            .join(FOLDER)
            .join("frames")
            .join(format!("{frame:08}.json"))
    }

    /// The path of a file relative to the data set.
    pub(crate) fn relative(&self, path: &Path) -> String {
        let path = path.strip_prefix(&self.root).unwrap_or(path);
        path.to_string_lossy().replace('\\', "/")
    }

    /// Describes files that were written, with their checksums.
    pub(crate) fn describe(&self, written: &[WrittenFile]) -> Result<Vec<FileRecord>, FileError> {
        let describe = |file: &WrittenFile| {
            Ok(FileRecord {
                path: self.relative(&file.path),
                bytes: file.bytes,
                sha256: checksum(&file.path)?,
                packed_in: None,
            })
        };
        written.iter().map(describe).collect()
    }
}

/// The checksums of a recipe's files, by their paths relative to the recipe.
pub(crate) type Inputs = BTreeMap<String, String>;

/// Returns what happened to the first file, by name, that was changed, added or removed; `None` if all are the same.
fn changed_input(known: &Inputs, own: &Inputs) -> Option<String> {
    let names: BTreeSet<&String> = known.keys().chain(own.keys()).collect();
    names
        .into_iter()
        .find_map(|name| match (known.get(name), own.get(name)) {
            (Some(before), Some(now)) if before == now => None,
            (Some(_), Some(_)) => Some(format!("{name} has changed")),
            (Some(_), None) => Some(format!("{name} was removed")),
            (None, _) => Some(format!("{name} was added")),
        })
}

/// Returns the checksum of a file.
pub(super) fn checksum(path: &Path) -> Result<String, FileError> {
    let reading = |error: std::io::Error| FileError::reading(path, &error);
    let mut file = File::open(path).map_err(reading)?;
    let (mut digest, mut buffer) = (Sha256::new(), vec![0; 1 << 16]);
    loop {
        match file.read(&mut buffer).map_err(reading)? {
            0 => break,
            length => digest.update(&buffer[..length]),
        }
    }
    Ok(hex(&digest.finalize()))
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Reads a file of the state. A pipe in its place must not block.
fn read(path: &Path) -> Result<Vec<u8>, FileError> {
    files::read_regular(path, MAX_BYTES).map_err(|error| FileError::reading(path, &error))
}

fn lock(root: &Path, path: &Path) -> Result<File, GenerateError> {
    let file = File::create(path).map_err(|error| FileError::writing(path, &error))?;
    file.try_lock().map_err(|_| {
        FileError::new(
            root,
            "another process is writing this data set",
            "wait for it, or choose another folder",
        )
    })?;
    Ok(file)
}

pub(crate) fn pretty(value: &impl Serialize) -> Vec<u8> {
    let mut bytes = serde_json::to_vec_pretty(value).unwrap_or_default();
    bytes.push(b'\n');
    bytes
}

/// Rejects a recipe that differs from the data set's in more than the number of frames.
fn reject_change(root: &Path, known: &Value, own: &Value) -> Result<(), GenerateError> {
    let mut changes = Vec::new();
    differences("", known, own, &mut changes);
    changes.retain(|change| !change.starts_with("frames:"));
    if changes.is_empty() {
        return Ok(());
    }
    let shown = changes.iter().take(5).cloned().collect::<Vec<_>>().join("; ");
    let more = changes.len().saturating_sub(5);
    let more = if more > 0 {
        format!("; and {more} more")
    } else {
        String::new()
    };
    let message = format!("was generated from another recipe: {shown}{more}");
    Err(FileError::new(root, message, "restore the recipe, or choose another folder").into())
}

/// Collects the keys whose values differ, with both values.
fn differences(place: &str, old: &Value, new: &Value, changes: &mut Vec<String>) {
    let join = |key: &str| {
        if place.is_empty() {
            key.to_owned()
        } else {
            format!("{place}.{key}")
        }
    };
    match (old, new) {
        (Value::Object(old), Value::Object(new)) => {
            let keys: BTreeSet<&String> = old.keys().chain(new.keys()).collect();
            for key in keys {
                let of = |map: &serde_json::Map<String, Value>| map.get(key).cloned().unwrap_or_default();
                differences(&join(key), &of(old), &of(new), changes);
            }
        }
        (Value::Array(old), Value::Array(new)) if old.len() == new.len() => {
            for (index, (old, new)) in old.iter().zip(new).enumerate() {
                differences(&join(&index.to_string()), old, new, changes);
            }
        }
        _ if old == new => {}
        _ => changes.push(format!("{place}: {old} became {new}")),
    }
}

impl Recipe {
    /// Returns the keys in which another recipe differs, with both values.
    #[must_use]
    pub fn differences(&self, other: &Self) -> Vec<String> {
        let [old, new] = [self, other].map(|recipe| serde_json::to_value(recipe).unwrap_or_default());
        let mut changes = Vec::new();
        differences("", &old, &new, &mut changes);
        changes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn recipe(text: &str) -> RecipeFile {
        let path = PathBuf::from("r.toml");
        RecipeFile {
            recipe: Recipe::parse(&path, text).unwrap(),
            path,
        }
    }

    #[test]
    fn a_data_set_has_one_recipe_and_one_writer() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        let first = recipe("seed = 1");
        let store = Store::open(root, &first, &[], false, false).unwrap();
        let error = |file: &RecipeFile, resume| {
            Store::open(root, file, &[], resume, false)
                .unwrap_err()
                .to_string()
        };
        assert!(error(&first, false).contains("already has a data set"));
        assert!(error(&first, true).contains("another process is writing"));
        assert!(Store::open(root, &first, &[], true, true).is_ok());
        drop(store);
        assert!(Store::open(root, &recipe("seed = 1\nframes = 7"), &[], true, false).is_ok());
        let changed = recipe("seed = 2\n[camera]\nclearance_m = 0.2");
        let error = error(&changed, true);
        assert!(
            error.contains("camera.clearance_m: 0.1 became 0.2; seed: 1 became 2"),
            "{error}"
        );
    }

    #[test]
    fn a_data_set_is_made_of_the_same_files() {
        let folder = tempfile::tempdir().unwrap();
        let (root, cup) = (folder.path().join("set"), folder.path().join("cup.obj"));
        let mut file = recipe("seed = 1");
        file.path = folder.path().join("r.toml");
        fs::write(&cup, "v 0 0 0").unwrap();
        let open = |inputs: &[PathBuf]| Store::open(&root, &file, inputs, true, false);
        open(std::slice::from_ref(&cup)).unwrap();
        open(std::slice::from_ref(&cup)).unwrap();
        let error = open(&[]).unwrap_err().to_string();
        assert!(error.contains("cup.obj was removed"), "{error}");
        let mug = folder.path().join("mug.obj");
        fs::write(&mug, "v 1 0 0").unwrap();
        let error = open(&[cup.clone(), mug]).unwrap_err().to_string();
        assert!(error.contains("mug.obj was added"), "{error}");
        fs::write(&cup, "v 0 0 1").unwrap();
        let error = open(std::slice::from_ref(&cup)).unwrap_err().to_string();
        assert!(error.contains("cup.obj has changed"), "{error}");
    }

    #[test]
    fn frames_are_intact_while_their_files_are() {
        let folder = tempfile::tempdir().unwrap();
        let store = Store::open(folder.path(), &recipe("seed = 1"), &[], false, false).unwrap();
        let path = folder.path().join("a.txt");
        fs::write(&path, "abc").unwrap();
        let files = store
            .describe(&[WrittenFile {
                path: path.clone(),
                bytes: 3,
            }])
            .unwrap();
        assert_eq!(files[0].path, "a.txt");
        assert_eq!(
            files[0].sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"
        );
        let record = FrameRecord {
            frame: 12,
            unit: DrawnUnit::default(),
            findings: Vec::new(),
            files,
            formats: vec![vec![Value::Null]],
        };
        store.add(&record).unwrap();
        assert_eq!(store.frames().unwrap(), [12].into());
        assert!(store.is_intact(12) && !store.is_intact(13));
        // A record with the number of another frame, or with a flipped bit, is rejected.
        let bytes = fs::read(store.frame_path(12)).unwrap();
        fs::write(store.frame_path(13), &bytes).unwrap();
        let error = store.frame(13).unwrap_err().to_string();
        assert!(error.contains("is the record of frame 12"), "{error}");
        for place in [3, bytes.len() / 2, bytes.len() - 4] {
            let mut flipped = bytes.clone();
            flipped[place] ^= 1;
            fs::write(store.frame_path(12), &flipped).unwrap();
            assert!(!store.is_intact(12));
        }
        fs::write(store.frame_path(12), &bytes).unwrap();
        fs::write(&path, "ab").unwrap();
        assert!(!store.is_intact(12));
    }
}
