//! Opening OpenUSD files safely: what the linter needs of a stage, as plain values.
//!
//! Only this module sees the USD library. It reads text, binary and packaged layers and composes them, but trusts
//! its input more than we do; so every layer is looked over before it (see `inspect`), it runs on a thread of its
//! own with a deep stack, and a panic inside becomes a [`StageError`] that names the file.

mod composition;
mod error;
mod extract;
mod guard;
mod inspect;
mod locate;
mod plain;
mod prim;
mod reader;
mod resolver;
mod scene;
mod transform;
mod value;
mod walk;

use std::path::Path;

use oaktwin_diagnostic::Finding;
use serde::Serialize;

pub use error::StageError;
pub use prim::{Attribute, Prim, RenderProduct, SceneCamera, Target, Value};
pub use scene::{SceneOptions, StageScene};

/// The largest layer that is read, bytes. A text layer this large holds some 40 million quads.
pub const MAX_LAYER_BYTES: u64 = 2 << 30;

/// What a USD file holds that concerns cameras and their sensors, composed over its sublayers, references, payloads
/// and selected variants. Attribute values are the default ones, or the first time sample where there is no default.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The file as the caller named it.
    pub file: String,
    /// What the root layer says about the whole.
    pub metadata: StageMetadata,
    /// Every active, defined `Camera`, those inside instances too, in the order of traversal.
    pub cameras: Vec<SceneCamera>,
    /// Every `RenderProduct`, likewise.
    pub products: Vec<RenderProduct>,
    /// Prims of other types that carry a sensor schema or a depth sensor's attributes.
    pub others: Vec<Prim>,
    /// Prims that are only overridden (`over`) here and look like cameras: the file that defines them is missing.
    pub overridden_cameras: Vec<String>,
    /// What went wrong on the way without making the stage useless: missing references and the like.
    pub findings: Vec<Finding>,
}

/// What the root layer says about the whole stage; absent where it says nothing.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct StageMetadata {
    /// `upAxis`: `Y` (OpenUSD's fallback) or `Z`.
    pub up_axis: Option<String>,
    /// `metersPerUnit`; OpenUSD's fallback is 0.01.
    pub meters_per_unit: Option<f64>,
    /// The name of the default prim.
    pub default_prim: Option<String>,
}

/// Opens a `.usd`, `.usda`, `.usdc` or `.usdz` file and extracts what concerns cameras.
///
/// # Errors
/// [`StageError`] where the file is missing, no file, empty, larger than [`MAX_LAYER_BYTES`], not what its name says,
/// damaged, or more than the USD library can read. A reference or payload that cannot be followed is no error but a
/// finding of [`Stage::findings`].
pub fn open(path: impl AsRef<Path>) -> Result<Stage, StageError> {
    contained(path.as_ref(), extract::stage)
}

/// Opens a `.usd`, `.usda`, `.usdc` or `.usdz` file and makes a scene of what it shows: everything active, defined and
/// visible whose purpose is `default` or `render`, in metres and in the stage's own axes.
///
/// # Errors
/// As [`open`]. What is missing, odd or not supported is a finding of [`StageScene::findings`], and the rest is there.
pub fn open_scene(path: impl AsRef<Path>, options: &SceneOptions) -> Result<StageScene, StageError> {
    contained(path.as_ref(), |name, utf8, layer| {
        extract::scene(name, utf8, layer, *options)
    })
}

/// Looks a file over and has it read where a panic does no harm.
fn contained<T: Send>(
    path: &Path,
    read: impl FnOnce(&str, &str, inspect::Inspected) -> Result<T, StageError> + Send,
) -> Result<T, StageError> {
    let name = path.display().to_string();
    let Some(utf8) = path.to_str() else {
        return Err(StageError::new(
            &name,
            "",
            "the file's name is not valid UTF-8",
            "rename it",
        ));
    };
    let read = || {
        let layer = inspect::file(path).map_err(|problem| StageError::from_problem(&name, problem))?;
        read(&name, utf8, layer)
    };
    guard::contained(read).unwrap_or_else(|panic| {
        Err(StageError::new(
            &name,
            "",
            format!("the USD reader gave up on damaged content ({panic})"),
            "write the file again with OpenUSD (`usdcat --out`), or take an undamaged copy",
        ))
    })
}
