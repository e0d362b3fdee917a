//! Reads OpenUSD files safely, as plain values for the linter or as a scene.
//!
//! This is the only module that uses the USD library. The library reads and composes text, binary and packaged layers,
//! but does not validate its input; so every layer is validated first (see `inspect`), the library runs on a thread of
//! its own with a large stack, and a panic becomes a [`StageError`] that names the file.

mod ancestry;
mod animated;
mod binding;
mod budget;
mod class_cycle;
mod closure;
mod composition;
mod error;
mod extract;
mod guard;
mod inspect;
mod limit;
mod motion;
mod opinion;
mod packages;
mod physics;
mod plain;
mod prim;
mod prim_opinions;
mod reader;
mod resolver;
mod scene;
mod stacks;
mod transform;
mod usda;
mod value;
mod walk;

use std::any::Any;
use std::path::Path;

use oaktwin_base::diagnostic::Finding;
use serde::Serialize;

pub use animated::{AnimatedStage, StageChange, StageContents, StageTiming};
pub use error::StageError;
pub use limit::SceneLimit;
pub use physics::{JointEnd, Physics, PhysicsBody, PhysicsJoint};
pub use prim::{Attribute, AttributeValue, Prim, RelationshipTarget, RenderProduct, SceneCamera};
pub use scene::{SceneOptions, StageScene};

/// The maximum size of a layer, in bytes. A text layer of this size has about 40 million quads.
pub const MAX_LAYER_BYTES: u64 = 2 << 30;

/// The cameras and sensors of a USD file, composed from sublayers, references, payloads and selected variants.
/// Attribute values are the default ones, or the first time sample if there is no default.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The file's path as given by the caller.
    pub file: String,
    /// The root layer's metadata.
    pub metadata: StageMetadata,
    /// All active, defined `Camera` prims, including those inside instances, in traversal order.
    pub cameras: Vec<SceneCamera>,
    /// All active, defined `RenderProduct` prims, in traversal order.
    pub products: Vec<RenderProduct>,
    /// The prims of other types with a sensor schema or a depth sensor's attributes.
    pub others: Vec<Prim>,
    /// The paths of overrides (`over`) with camera attributes but no definition: the file that defines them is missing.
    pub overridden_cameras: Vec<String>,
    /// Problems that do not prevent the stage from being read, such as missing references.
    pub findings: Vec<Finding>,
}

/// The metadata of a stage's root layer; `None` for unauthored fields.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct StageMetadata {
    /// `upAxis`: `Y` (OpenUSD's fallback) or `Z`.
    pub up_axis: Option<String>,
    /// `metersPerUnit`; OpenUSD's fallback is 0.01.
    pub meters_per_unit: Option<f64>,
    /// The name of the default prim.
    pub default_prim: Option<String>,
}

/// Opens a `.usd`, `.usda`, `.usdc` or `.usdz` file and extracts its cameras and sensors.
///
/// # Errors
/// Returns an error if the file is missing, not a regular file, empty, larger than [`MAX_LAYER_BYTES`], of another
/// format than its extension, damaged, not supported by the USD library, or composes more than `limit`. Unresolved references and payloads are
/// reported in [`Stage::findings`].
pub fn open(path: impl AsRef<Path>, limit: SceneLimit) -> Result<Stage, StageError> {
    contained(path.as_ref(), |name, utf8, layer| {
        extract::stage(name, utf8, layer, limit)
    })
}

/// Opens a `.usd`, `.usda`, `.usdc` or `.usdz` file and builds a scene of all active, defined and visible prims with the
/// purpose `default` or `render`, in metres and in the stage's own axes.
///
/// # Errors
/// Returns an error in the cases of [`open`]. Missing, invalid and unsupported prims are skipped and reported in
/// [`StageScene::findings`].
pub fn open_scene(path: impl AsRef<Path>, options: &SceneOptions) -> Result<StageScene, StageError> {
    contained(path.as_ref(), |name, utf8, layer| {
        extract::scene(name, utf8, layer, *options)
    })
}

/// Opens a stage like [`open_scene`], with the rigid bodies and joints of `UsdPhysics`.
///
/// # Errors
/// Returns an error in the cases of [`open`].
pub fn open_physics(
    path: impl AsRef<Path>,
    options: &SceneOptions,
) -> Result<(StageScene, Physics), StageError> {
    contained(path.as_ref(), |name, utf8, layer| {
        extract::physics(name, utf8, layer, *options)
    })
}

/// Validates a file and reads it on a thread whose panics are caught.
fn contained<T: Send>(
    path: &Path,
    read: impl FnOnce(&str, &str, inspect::Inspected) -> Result<T, StageError> + Send,
) -> Result<T, StageError> {
    guard::contained(|| inspected(path, read))
        .unwrap_or_else(|payload| Err(failure(&path.display().to_string(), payload.as_ref())))
}

/// Validates a file and reads it.
fn inspected<T>(
    path: &Path,
    read: impl FnOnce(&str, &str, inspect::Inspected) -> Result<T, StageError>,
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
    let layer = inspect::file(path)
        .map_err(|problem| StageError::new(&name, problem.place, problem.what, problem.remedy))?;
    read(&name, utf8, layer)
}

/// The error of a thread that could not be started, or ended with a panic.
fn failure(name: &str, payload: &(dyn Any + Send)) -> StageError {
    if let Some(guard::NoThread(error)) = payload.downcast_ref() {
        let is = format!("cannot be read: not enough memory for the stack of its reader, 256 MiB ({error})");
        let remedy = "raise the limit on memory (ulimit -v), or free some";
        return StageError::new(name, "", is, remedy);
    }
    budget::exceeded(name, payload).unwrap_or_else(|| {
        let panic = guard::message(payload);
        StageError::new(
            name,
            "",
            format!("the USD reader failed on damaged content ({panic})"),
            "rewrite the file with OpenUSD (`usdcat --out`), or use an undamaged copy",
        )
    })
}
