//! Generation of a data set: frames in parallel, in any order, and the files that span them.

mod finish;
mod generation;
mod preview;
mod store;
mod verify;
mod workers;

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use oaktwin_base::diagnostic::Finding;
use oaktwin_catalog::Catalog;
use oaktwin_dataset::{Format, Shot};
use oaktwin_pipeline::progress::Watch;
use oaktwin_pipeline::sensor::EngineRef;
use serde_json::Value;

use crate::GenerateError;
use crate::context::Context;
use crate::frame::{FrameMaker, Shown};
use crate::recipe::RecipeFile;

pub use generation::Generation;
pub(crate) use store::Store;

/// A format with its folder in the data set.
type PlacedFormat = (Box<dyn Format>, PathBuf);

/// Options of the generation of a data set.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct GenerateOptions {
    /// The frames to make; by default all.
    pub frames: Option<Range<u64>>,
    /// Whether an existing data set is completed.
    pub resume: bool,
    /// Whether the contents of finished files are compared with their checksums, not only their lengths; frames with other
    /// contents are made again.
    pub verify: bool,
    /// The number of frames to make at once; by default one per processor, or fewer if memory is short.
    pub workers: Option<usize>,
    /// Whether only frames are made: another process has the lock, and completes the data set.
    pub only_frames: bool,
}

/// The result of a generation.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Generated {
    /// The number of frames that were made.
    pub made: u64,
    /// The number of frames that were complete already.
    pub skipped: u64,
    /// The number of frames of the recipe that are missing.
    pub missing: u64,
    /// The number of files of the data set.
    pub files: u64,
    /// Their size in bytes.
    pub bytes: u64,
    /// Findings, without duplicates.
    pub findings: Vec<Finding>,
    /// Whether the task was interrupted.
    pub is_interrupted: bool,
}

/// A recipe whose files are open.
#[derive(Debug)]
pub struct Generator {
    context: Arc<Context>,
    /// The arrangement of the last sample.
    shown: Mutex<Option<Shown>>,
}

impl Generator {
    /// Opens the base scenes of a recipe and lists its objects.
    ///
    /// # Errors
    /// Returns an error if a file cannot be read, or if a value does not fit the model or the scene.
    pub fn open(file: RecipeFile, catalog: &Catalog) -> Result<Self, GenerateError> {
        Ok(Self {
            context: Arc::new(Context::open(file, catalog)?),
            shown: Mutex::default(),
        })
    }

    /// Measures with another engine than the recipe's, such as one of another crate. The data set names it in its recipe.
    ///
    /// # Errors
    /// Returns an error if a file of the recipe cannot be read.
    pub fn open_with(file: RecipeFile, catalog: &Catalog, engine: EngineRef) -> Result<Self, GenerateError> {
        let mut file = file;
        file.recipe.sensor.engine = Some(engine.name.to_string());
        let mut context = Context::open(file, catalog)?;
        context.engine = Some(engine);
        Ok(Self {
            context: Arc::new(context),
            shown: Mutex::default(),
        })
    }

    /// The number of frames of the recipe.
    #[must_use]
    pub fn frames(&self) -> u64 {
        self.context.file.recipe.frames
    }

    /// Returns everything that is drawn at random for a frame.
    ///
    /// # Errors
    /// Returns an error if an object or the camera has no place.
    pub fn explain(&self, frame: u64) -> Result<Value, GenerateError> {
        FrameMaker::new(&self.context).explain(frame)
    }

    /// Makes a frame in memory: the shots of the cameras, which a data set has in its files, and the findings.
    ///
    /// # Errors
    /// Returns an error if the recipe does not have the frame, or it cannot be made.
    pub fn sample(&self, frame: u64) -> Result<(Vec<Shot>, Vec<Finding>), GenerateError> {
        let shown = || self.shown.lock().unwrap_or_else(PoisonError::into_inner);
        // Consecutive frames have their arrangement in common.
        let before = shown().take();
        let mut maker = FrameMaker::going_on(&self.context, before);
        let made = maker.make(frame);
        *shown() = maker.into_shown();
        made.map(|made| (made.shots, made.findings))
    }

    /// Generates the data set, or a part of it, in a folder.
    ///
    /// # Errors
    /// Returns an error if a frame cannot be made or a file cannot be written. What is complete remains, and can be resumed.
    pub fn generate(
        &self,
        root: &Path,
        options: &GenerateOptions,
        watch: &Watch<'_>,
    ) -> Result<Generated, GenerateError> {
        let mut generation = self.start(root, options)?;
        generation.make(options.workers, watch)?;
        generation.finish()
    }

    /// Opens a data set in a folder, which no other process can write until the result is dropped, unless only frames are made.
    ///
    /// # Errors
    /// Returns an error if the recipe does not have the frames, or if the folder has another data set or cannot be written.
    pub fn start(&self, root: &Path, options: &GenerateOptions) -> Result<Generation, GenerateError> {
        Generation::start(Arc::clone(&self.context), root, options)
    }
}
