//! Importers for glTF, Collada, OBJ, STL and PLY files.
//!
//! The world keeps the file's axes. The up axis is y in glTF and OBJ, z in STL and PLY, and what the file says in Collada, unless
//! [`ImportOptions::up`] overrides it; nothing is rotated. The file's unit is the one that a Collada file states, and otherwise taken to be the
//! metre, times [`ImportOptions::scale`].
//!
//! A missing image is a finding; a file that contradicts itself is an error. Only regular files are opened. Files that
//! a glTF file names must be in its folder or below, unless [`ImportOptions::allow_outside`] is set: a buffer may have any
//! content, which would become coordinates. The images of a Collada file, and the images and material libraries of an OBJ file, may be anywhere.

mod builder;
mod dae;
mod error;
mod gltf;
mod obj;
mod origin;
mod ply;
mod stl;
mod text;
mod uri;
mod weld;

use std::path::Path;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::RigidTransform;
use oaktwin_files as files;

use builder::Builder;
use error::Fault;
pub use error::ImportError;

use crate::{Scene, Up};

/// Properties that the file formats do not define.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImportOptions {
    /// The up axis; `None` for the format's default.
    pub up: Option<Up>,
    /// The metres per unit of the file, or what the unit of a Collada file is multiplied by: positive and finite.
    pub scale: f64,
    /// Whether a glTF file may name buffers and images outside its folder.
    pub allow_outside: bool,
    /// The time of a glTF file's animations, s; without one, nodes and morph targets are as in the file.
    pub time_s: Option<f64>,
}

impl Default for ImportOptions {
    fn default() -> Self {
        Self {
            up: None,
            scale: 1.0,
            allow_outside: false,
            time_s: None,
        }
    }
}

/// The contents of an imported file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImportedScene {
    /// The meshes, materials and lights.
    pub scene: Scene,
    /// The cameras, in the order of their nodes.
    pub cameras: Vec<ImportedCamera>,
    /// Warnings about unusual or unsupported contents.
    pub findings: Vec<Finding>,
    /// The first and the last keyframe of a glTF file's animations, s; `None` of a file without any.
    pub animated_s: Option<(f64, f64)>,
}

/// A perspective camera.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedCamera {
    /// The path of the node: `/Room/Camera`.
    pub path: String,
    /// The transform from the optical frame (x right, y down, z forward) to the world, metres.
    pub world_from_camera: RigidTransform,
    /// The vertical field of view, radians.
    pub vfov: f64,
    /// The width divided by the height, if the file defines it.
    pub aspect: Option<f64>,
}

/// The maximum size of a file, and of the files that it names, in bytes.
const MAX_BYTES: u64 = 1 << 40;

/// The file name extensions that [`open`] supports.
pub const EXTENSIONS: [&str; 6] = ["dae", "glb", "gltf", "obj", "ply", "stl"];

#[derive(Clone, Copy)]
enum Format {
    Dae,
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
            Some("dae") => Ok(Self::Dae),
            Some("glb" | "gltf") => Ok(Self::Gltf),
            Some("obj") => Ok(Self::Obj),
            Some("ply") => Ok(Self::Ply),
            Some("stl") => Ok(Self::Stl),
            extension => Err(Fault::new(
                "",
                match extension {
                    Some(extension) => format!(".{extension} files are not supported"),
                    None => "the name has no extension".into(),
                },
                "use a file that ends in .dae, .glb, .gltf, .obj, .ply or .stl",
            )),
        }
    }

    /// The up axis of a file that does not state it.
    const fn up(self) -> Up {
        match self {
            Self::Dae | Self::Gltf | Self::Obj => Up::Y,
            Self::Ply | Self::Stl => Up::Z,
        }
    }
}

/// Whether [`open`] supports files with this name's extension.
#[must_use]
pub fn is_importable(path: &Path) -> bool {
    Format::of(path).is_ok()
}

/// Whether files with this name's extension state their unit.
#[must_use]
pub fn states_unit(path: &Path) -> bool {
    matches!(Format::of(path), Ok(Format::Dae))
}

/// Imports a file in the format of its extension.
///
/// # Errors
/// Returns an error if the file is missing, in an unsupported format, inconsistent, or without triangles.
pub fn open(path: &Path, options: &ImportOptions) -> Result<ImportedScene, ImportError> {
    import(path, options).map_err(|fault| fault.of(path))
}

/// Imports the bytes of a file. `path` is its name, whose extension selects the format, and files that it refers to are beside it.
///
/// # Errors
/// Returns the errors of [`open`], except that the file itself is not read.
pub fn from_bytes(
    bytes: Vec<u8>,
    path: &Path,
    options: &ImportOptions,
) -> Result<ImportedScene, ImportError> {
    let read = || {
        let format = Format::of(path)?;
        decode(bytes, format, path, options)
    };
    read().map_err(|fault| fault.of(path))
}

fn import(path: &Path, options: &ImportOptions) -> Result<ImportedScene, Fault> {
    let format = Format::of(path)?;
    decode(read(path)?, format, path, options)
}

fn decode(
    bytes: Vec<u8>,
    format: Format,
    path: &Path,
    options: &ImportOptions,
) -> Result<ImportedScene, Fault> {
    if !(options.scale > 0.0 && options.scale.is_finite()) {
        return Err(Fault::new(
            "",
            format!("invalid scale: {} metres per unit", options.scale),
            "use a finite scale above zero",
        ));
    }
    let up = options.up.unwrap_or(format.up());
    let mut builder = Builder::new(path, up, options.scale);
    match format {
        Format::Dae => dae::read(&bytes, path, options, &mut builder)?,
        Format::Gltf => gltf::read(bytes, path, options, &mut builder)?,
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
            "check its name and permissions",
        )
    };
    let bytes = files::read_regular(path, MAX_BYTES).map_err(readable)?;
    if bytes.is_empty() {
        return Err(Fault::new("", "is empty", "export it again"));
    }
    Ok(bytes)
}
