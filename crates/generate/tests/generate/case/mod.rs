//! A folder with a recipe.
#![expect(clippy::unwrap_used, reason = "helpers of tests")]

use std::collections::BTreeMap;
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use oaktwin_catalog::Catalog;
use oaktwin_generate::recipe::RecipeFile;
use oaktwin_generate::{GenerateOptions, Generated, Generator};
use oaktwin_pipeline::progress::Progress;

/// The example recipes.
pub(crate) fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/recipes")
}

/// A folder with the scenes and objects of the examples, and a recipe.
pub(crate) struct Case {
    pub(crate) folder: tempfile::TempDir,
}

impl Case {
    pub(crate) fn new(recipe: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        for file in ["table.usda", "bin.usda"] {
            fs::copy(examples().join(file), folder.path().join(file)).unwrap();
        }
        fs::create_dir(folder.path().join("objects")).unwrap();
        for entry in fs::read_dir(examples().join("objects")).unwrap() {
            let entry = entry.unwrap();
            fs::copy(
                entry.path(),
                folder.path().join("objects").join(entry.file_name()),
            )
            .unwrap();
        }
        let case = Self { folder };
        case.write(recipe);
        case
    }

    pub(crate) fn write(&self, recipe: &str) {
        fs::write(self.folder.path().join("recipe.toml"), recipe).unwrap();
    }

    pub(crate) fn open(&self) -> Result<Generator, String> {
        let file =
            RecipeFile::read(&self.folder.path().join("recipe.toml")).map_err(|error| error.to_string())?;
        Generator::open(file, Catalog::builtin()).map_err(|error| error.to_string())
    }

    pub(crate) fn generate(&self, name: &str, options: &GenerateOptions) -> Result<Generated, String> {
        let root = self.folder.path().join(name);
        let watch = |_: Progress| ControlFlow::Continue(());
        self.open()?
            .generate(&root, options, &watch)
            .map_err(|error| error.to_string())
    }

    /// The bytes of all files of a data set.
    pub(crate) fn files(&self, name: &str) -> BTreeMap<PathBuf, Vec<u8>> {
        fn collect(root: &Path, folder: &Path, files: &mut BTreeMap<PathBuf, Vec<u8>>) {
            for entry in fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    collect(root, &path, files);
                } else {
                    files.insert(
                        path.strip_prefix(root).unwrap().to_owned(),
                        fs::read(&path).unwrap(),
                    );
                }
            }
        }
        let root = self.folder.path().join(name);
        let mut files = BTreeMap::new();
        collect(&root, &root, &mut files);
        files
    }
}

/// A recipe of five frames of objects on a table.
pub(crate) const TABLE: &str = "
frames = 5
frames_per_scene = 2
scene = 'table.usda'
[[objects]]
files = 'objects/'
count = { uniform = [2, 5] }
on = '/World/Table'
pose = 'resting'
look = { keep = 0.5 }
[light]
lamps = {}
projector = 1
[camera]
resolution = [160, 100]
";
