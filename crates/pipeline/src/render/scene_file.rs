//! Scene files of every kind.

use std::path::{Path, PathBuf};

use oaktwin_render::Clip;

use oaktwin_diagnostic::Finding;
use oaktwin_files::FileError;
use oaktwin_scene::import::{self, ImportError, ImportOptions, ImportedCamera};
use oaktwin_scene::{Scene, Up};
use oaktwin_usd::stage::{
    self, Attribute, Prim, RenderProduct, SceneCamera, SceneOptions, StageError, Value,
};

const USD: [&str; 4] = ["usd", "usda", "usdc", "usdz"];

/// How to read a scene file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct OpenOptions {
    /// The time code of a USD stage; by default the default values, and the first samples.
    pub time: Option<f64>,
    /// How often a USD stage's subdivision meshes are refined.
    pub subdivide: u32,
    /// Which axis of a mesh file points up; by default what its format says. A USD stage says it itself.
    pub up: Option<Up>,
    /// How many metres one unit of a mesh file is; by default 1. A USD stage says it itself.
    pub scale: Option<f64>,
}

/// What a scene file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneFile {
    /// The file.
    pub path: PathBuf,
    /// What is seen.
    pub scene: Scene,
    /// Its cameras.
    pub cameras: Vec<SceneCamera>,
    /// Its render products.
    pub products: Vec<RenderProduct>,
    /// What is missing or was left out.
    pub findings: Vec<Finding>,
}

/// Why a scene file could not be opened.
#[derive(Debug, thiserror::Error)]
pub enum SceneFileError {
    /// It is of no known kind, or an option does not go with its kind.
    #[error(transparent)]
    File(#[from] FileError),
    /// It is no USD stage.
    #[error(transparent)]
    Stage(#[from] StageError),
    /// It is no mesh file.
    #[error(transparent)]
    Import(#[from] ImportError),
}

impl SceneFile {
    /// Opens a USD stage (`usd`, `usda`, `usdc`, `usdz`), or a mesh file (`gltf`, `glb`, `obj`, `stl`, `ply`).
    ///
    /// # Errors
    /// A file that cannot be read, of an unknown kind, or with an option that its kind does not have. What is missing
    /// in it or not supported is no error but a finding.
    pub fn open(path: &Path, options: &OpenOptions) -> Result<Self, SceneFileError> {
        let extension = path
            .extension()
            .map(|extension| extension.to_string_lossy().to_lowercase())
            .unwrap_or_default();
        if USD.contains(&extension.as_str()) {
            Self::open_stage(path, options)
        } else if import::is_importable(path) {
            Self::import(path, options)
        } else {
            Err(unknown_kind(path, &extension).into())
        }
    }

    fn open_stage(path: &Path, options: &OpenOptions) -> Result<Self, SceneFileError> {
        for (given, name) in [(options.up.is_some(), "up"), (options.scale.is_some(), "scale")] {
            if given {
                let message = format!("is a USD stage, which says its {name} itself");
                return Err(FileError::new(path, message, format!("leave --{name} out")).into());
            }
        }
        let stage = stage::open_scene(
            path,
            &SceneOptions {
                time: options.time,
                subdivide: options.subdivide,
            },
        )?;
        Ok(Self {
            path: path.to_owned(),
            scene: stage.scene,
            cameras: stage.cameras,
            products: stage.products,
            findings: stage.findings,
        })
    }

    fn import(path: &Path, options: &OpenOptions) -> Result<Self, SceneFileError> {
        for (given, name) in [
            (options.time.is_some(), "time"),
            (options.subdivide > 0, "subdivide"),
        ] {
            if given {
                let message = format!("is no USD stage, and --{name} is for those");
                return Err(FileError::new(path, message, format!("leave --{name} out")).into());
            }
        }
        let imported = import::open(
            path,
            &ImportOptions {
                up: options.up,
                scale: options.scale.unwrap_or(1.0),
            },
        )?;
        let meters_per_unit = imported.scene.meters_per_unit.0;
        let cameras = imported.cameras.iter();
        Ok(Self {
            path: path.to_owned(),
            cameras: cameras.map(|camera| as_prim(camera, meters_per_unit)).collect(),
            scene: imported.scene,
            products: Vec::new(),
            findings: imported.findings,
        })
    }
}

/// A mesh file's camera as a prim would say it: the vertical field of view by a focal length for an aperture 10 high.
fn as_prim(camera: &ImportedCamera, meters_per_unit: f64) -> SceneCamera {
    const HEIGHT: f64 = 10.0;
    // Where the file leaves it to the viewer: that of an OAK's stereo cameras.
    let aspect = camera.aspect.unwrap_or(1.6);
    let clip = Clip::default();
    let attributes = [
        (
            "focalLength",
            Value::Float(HEIGHT / (2.0 * (camera.vfov / 2.0).tan())),
        ),
        ("horizontalAperture", Value::Float(HEIGHT * aspect)),
        ("verticalAperture", Value::Float(HEIGHT)),
        (
            "clippingRange",
            Value::Floats(vec![clip.near_m / meters_per_unit, clip.far_m / meters_per_unit]),
        ),
    ];
    let attributes = attributes.map(|(name, value)| {
        let attribute = Attribute {
            type_name: String::new(),
            value: Some(value),
            animated: false,
        };
        (name.to_owned(), attribute)
    });
    SceneCamera {
        prim: Prim {
            path: camera.path.clone(),
            type_name: "Camera".to_owned(),
            api_schemas: Vec::new(),
            attributes: attributes.into(),
        },
        world_from_camera: camera.world_from_camera,
    }
}

fn unknown_kind(path: &Path, extension: &str) -> FileError {
    if path.is_dir() {
        return FileError::new(path, "is a directory", "name a file in it");
    }
    let message = if extension.is_empty() {
        "has no extension that says what it is".to_owned()
    } else {
        format!("is no scene: .{extension} is not known")
    };
    FileError::new(
        path,
        message,
        "give a usd, usda, usdc, usdz, gltf, glb, obj, stl or ply file",
    )
}
