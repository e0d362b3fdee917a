//! Scenes from glTF, OBJ, STL and PLY files.
//!
//! The world's axes are the file's own. Which of them is up is y in glTF and OBJ and z in STL and PLY, unless
//! [`ImportOptions::up`] says otherwise; nothing is turned. A file's unit is taken to be the metre, times
//! [`ImportOptions::scale`].
//!
//! An image that is not there is a finding; a file that contradicts itself is an error. Files that a file refers to are
//! opened wherever they are, `..` and absolute paths included: these are local files of the user's own.

mod builder;
mod error;
mod gltf;
mod obj;
mod ply;
mod srgb;
mod stl;
mod text;
mod weld;

use std::fs;
use std::path::Path;

use oaktwin_camera::RigidTransform;
use oaktwin_diagnostic::Finding;

use builder::Builder;
use error::Fault;
pub use error::ImportError;

use crate::{Scene, Up};

/// What the file does not say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImportOptions {
    /// Which axis is up, if not the format's own.
    pub up: Option<Up>,
    /// How many metres one of the file's units is: positive and finite.
    pub scale: f64,
}

impl Default for ImportOptions {
    fn default() -> Self {
        Self { up: None, scale: 1.0 }
    }
}

/// What was in a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Imported {
    /// All that is seen.
    pub scene: Scene,
    /// Its cameras, in the order of their nodes.
    pub cameras: Vec<ImportedCamera>,
    /// What was odd or is not supported.
    pub findings: Vec<Finding>,
}

/// A perspective camera in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedCamera {
    /// Its node: `/Room/Camera`.
    pub path: String,
    /// From its optical frame (x right, y down, z forward) into the world, metres.
    pub world_from_camera: RigidTransform,
    /// Its vertical field of view, radians.
    pub vfov: f64,
    /// Its width by its height, if the file says.
    pub aspect: Option<f64>,
}

/// The extensions that [`open`] knows.
pub const EXTENSIONS: [&str; 5] = ["glb", "gltf", "obj", "ply", "stl"];

#[derive(Clone, Copy)]
enum Format {
    Gltf,
    Obj,
    Ply,
    Stl,
}

impl Format {
    fn of(path: &Path) -> Result<Self, Fault> {
        let extension = path
            .extension()
            .map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("glb" | "gltf") => Ok(Self::Gltf),
            Some("obj") => Ok(Self::Obj),
            Some("ply") => Ok(Self::Ply),
            Some("stl") => Ok(Self::Stl),
            extension => Err(Fault::new(
                "",
                match extension {
                    Some(extension) => format!("no importer for files that end in .{extension}"),
                    None => "its name has no extension that says what it is".into(),
                },
                "give a file that ends in .glb, .gltf, .obj, .ply or .stl",
            )),
        }
    }

    const fn up(self) -> Up {
        match self {
            Self::Gltf | Self::Obj => Up::Y,
            Self::Ply | Self::Stl => Up::Z,
        }
    }
}

/// Whether [`open`] is for files of that name.
#[must_use]
pub fn is_importable(path: &Path) -> bool {
    Format::of(path).is_ok()
}

/// Imports a file. Its extension says what it is.
///
/// # Errors
/// If it is not there or of no known kind, if it contradicts itself, if there is no triangle in it.
pub fn open(path: &Path, options: &ImportOptions) -> Result<Imported, ImportError> {
    import(path, options).map_err(|fault| fault.of(path))
}

fn import(path: &Path, options: &ImportOptions) -> Result<Imported, Fault> {
    let format = Format::of(path)?;
    if !(options.scale > 0.0 && options.scale.is_finite()) {
        return Err(Fault::new(
            "",
            format!("a scale of {} metres a unit", options.scale),
            "give a scale above zero",
        ));
    }
    let bytes = read(path)?;
    let up = options.up.unwrap_or(format.up());
    let mut builder = Builder::new(path, up, options.scale);
    match format {
        Format::Gltf => gltf::read(bytes, path, &mut builder)?,
        Format::Obj => obj::read(&bytes, path, &mut builder)?,
        Format::Ply => ply::read(&bytes, &mut builder)?,
        Format::Stl => stl::read(&bytes, &mut builder)?,
    }
    builder.finish()
}

fn read(path: &Path) -> Result<Vec<u8>, Fault> {
    let readable = |error: std::io::Error| {
        Fault::new(
            "",
            format!("cannot be read: {error}"),
            "check its name and that it may be read",
        )
    };
    // A pipe or a device would never end.
    if !fs::metadata(path).map_err(readable)?.is_file() {
        return Err(Fault::new("", "is no file", "give a file"));
    }
    let bytes = fs::read(path).map_err(readable)?;
    if bytes.is_empty() {
        return Err(Fault::new("", "is empty", "export it again"));
    }
    Ok(bytes)
}
