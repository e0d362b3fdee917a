use std::path::PathBuf;
use std::sync::Arc;

use oaktwin_base::diagnostic::Message;
use oaktwin_catalog::UnknownModel;
use oaktwin_dataset::WriteError;
use oaktwin_files::FileError;
use oaktwin_files::memory::Shortage;
use oaktwin_pipeline::render::{CameraError, RigError, SceneFileError, UnknownAnnotator};
use oaktwin_pipeline::sensor::ParameterError;
use oaktwin_pipeline::unit::UnitError;

use crate::recipe::RecipeError;

/// An error that prevents a data set from being generated.
#[derive(Debug, thiserror::Error)]
pub enum GenerateError {
    /// The recipe is invalid.
    #[error(transparent)]
    Recipe(#[from] RecipeError),
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A frame cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// A scene or an object cannot be opened.
    #[error(transparent)]
    Scene(#[from] SceneFileError),
    /// An error that several frames have in common.
    #[error(transparent)]
    Shared(Arc<GenerateError>),
    /// A file has no triangles.
    #[error("{}: has no triangles; remove it, or name another file", file.display())]
    Empty {
        /// The file.
        file: PathBuf,
    },
    /// There is not enough memory for a file.
    #[error("{}: {}; {}", file.display(), shortage.what(), shortage.remedy())]
    Memory {
        /// The file.
        file: PathBuf,
        /// The missing memory.
        shortage: Shortage,
    },
    /// The camera model is unknown.
    #[error("{}: camera.model: {error}", recipe.display())]
    Model {
        /// The recipe.
        recipe: PathBuf,
        /// The problem.
        error: UnknownModel,
    },
    /// A value of the recipe does not fit the camera, the scene or another value.
    #[error("{}: {place}: {problem}; {remedy}", recipe.display())]
    Unfit {
        /// The recipe.
        recipe: PathBuf,
        /// The key.
        place: String,
        /// The problem.
        problem: Message,
        /// The remedy.
        remedy: Message,
    },
    /// Nothing of a rule could be placed.
    #[error("{}: {place}: frame {frame}: {problem}; {remedy}", recipe.display())]
    NoPlace {
        /// The recipe.
        recipe: PathBuf,
        /// The rule that failed.
        place: String,
        /// The frame.
        frame: u64,
        /// The number of failed attempts by reason.
        problem: String,
        /// The remedy.
        remedy: String,
    },
    /// The cameras of a model cannot be chosen.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// An annotator is unknown.
    #[error(transparent)]
    Annotator(#[from] UnknownAnnotator),
    /// The rig of the recipe cannot be created, or cannot measure.
    #[error(transparent)]
    Rig(#[from] RigError),
    /// A parameter of the depth sensor is invalid.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The calibration does not describe a unit of the model.
    #[error(transparent)]
    Unit(#[from] UnitError),
}
