use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};

use oaktwin_files::FileError;
use oaktwin_scene::import;

use super::asset::Asset;
use crate::GenerateError;
use crate::recipe::{RecipeFile, Texts};

/// The maximum number of files that a recipe may name.
const MAX_FILES: usize = 100_000;

/// The maximum depth of folders.
const MAX_DEPTH: usize = 16;

/// All objects of a recipe, read when they are first used.
#[derive(Debug)]
pub(crate) struct ObjectFiles {
    pub(crate) entries: Vec<Entry>,
    /// The entries of each rule.
    pub(crate) of_rule: Vec<std::ops::Range<usize>>,
}

/// An object file.
#[derive(Debug)]
pub(crate) struct Entry {
    pub(crate) path: PathBuf,
    /// The name of the file without its extension.
    pub(crate) name: String,
    pub(crate) label: String,
    rule: usize,
    asset: OnceLock<Result<Arc<Asset>, Arc<GenerateError>>>,
}

impl ObjectFiles {
    /// Lists the files of all rules.
    pub(crate) fn new(file: &RecipeFile) -> Result<Self, GenerateError> {
        let (mut entries, mut of_rule) = (Vec::new(), Vec::new());
        for (rule, objects) in file.recipe.objects.iter().enumerate() {
            let first = entries.len();
            for path in files_of(file, &objects.files, "objects", is_object)? {
                let name = path
                    .file_stem()
                    .unwrap_or_default()
                    .to_string_lossy()
                    .into_owned();
                entries.push(Entry {
                    label: objects.label.clone().unwrap_or_else(|| name.clone()),
                    path,
                    name,
                    rule,
                    asset: OnceLock::new(),
                });
            }
            of_rule.push(first..entries.len());
        }
        Ok(Self { entries, of_rule })
    }

    /// Returns the labels of all objects, sorted.
    pub(crate) fn labels(&self) -> Vec<String> {
        let labels: BTreeSet<&str> = self.entries.iter().map(|entry| entry.label.as_str()).collect();
        labels.into_iter().map(ToOwned::to_owned).collect()
    }

    /// Returns an object, which is read on first use.
    pub(crate) fn asset(&self, file: &RecipeFile, entry: usize) -> Result<Arc<Asset>, GenerateError> {
        let entry = &self.entries[entry];
        let open = || {
            let up = file.recipe.objects[entry.rule].up;
            Asset::open(&entry.path, up).map(Arc::new).map_err(Arc::new)
        };
        entry
            .asset
            .get_or_init(open)
            .clone()
            .map_err(GenerateError::Shared)
    }
}

fn is_object(path: &Path) -> bool {
    let extension = path
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase();
    ["usd", "usda", "usdc", "usdz"].contains(&extension.as_str()) || import::is_importable(path)
}

/// Whether a file is an image that the renderer can read.
pub(crate) fn is_image(path: &Path) -> bool {
    let extension = path
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase();
    ["png", "jpg", "jpeg", "bmp", "tga", "webp", "hdr", "exr"].contains(&extension.as_str())
}

/// Returns the files that texts of a recipe name, and those in folders, which are sorted by name.
///
/// # Errors
/// Returns an error for a file that does not exist, and for a folder without suitable files.
pub(crate) fn files_of(
    file: &RecipeFile,
    texts: &Texts,
    what: &str,
    is_suitable: fn(&Path) -> bool,
) -> Result<Vec<PathBuf>, GenerateError> {
    let mut found = Vec::new();
    for text in &texts.0 {
        let path = file.resolve(text);
        if !path.is_dir() {
            fs::metadata(&path).map_err(|error| FileError::reading(&path, &error))?;
            found.push(path);
            continue;
        }
        let before = found.len();
        collect(&path, is_suitable, 0, &mut found)?;
        if found.len() == before {
            let message = format!("the folder has no {what}");
            return Err(FileError::new(&path, message, "name another folder, or add files").into());
        }
    }
    Ok(found)
}

fn collect(
    folder: &Path,
    is_suitable: fn(&Path) -> bool,
    depth: usize,
    found: &mut Vec<PathBuf>,
) -> Result<(), GenerateError> {
    let listed = fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let mut entries = listed.map_err(|error| FileError::reading(folder, &error))?;
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let path = entry.path();
        let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
        // Symbolic links to folders are not followed, so that there are no cycles.
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_hidden || depth > MAX_DEPTH {
            continue;
        }
        if is_folder {
            collect(&path, is_suitable, depth + 1, found)?;
        } else if is_suitable(&path) {
            if found.len() >= MAX_FILES {
                let message = format!("there are more than {MAX_FILES} files");
                return Err(FileError::new(folder, message, "name a smaller folder").into());
            }
            found.push(path);
        }
    }
    Ok(())
}
