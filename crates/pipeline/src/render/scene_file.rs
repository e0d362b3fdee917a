//! Scene files.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use oaktwin_render::Clip;

use oaktwin_base::diagnostic::{Finding, message, opt};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DAffine3;
use oaktwin_files::FileError;
use oaktwin_scene::import::{self, ImportError, ImportOptions, ImportedCamera};
use oaktwin_scene::{InfraredError, Instance, MicroTexture, Scene, Up};
use oaktwin_usd::stage::{
    self, AnimatedStage, Attribute, AttributeValue, Prim, RenderProduct, SceneCamera, SceneLimit,
    SceneOptions, StageContents, StageError, StageScene, StageTiming,
};

const USD: [&str; 4] = ["usd", "usda", "usdc", "usdz"];

/// The options of reading a scene file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OpenOptions {
    /// The time code of a USD stage; by default its default values, else the first time samples.
    pub time: Option<f64>,
    /// The subdivision level of a USD stage's meshes.
    pub subdivide: u32,
    /// The factor on the limits of what a USD stage may compose.
    pub limit: SceneLimit,
    /// The up axis of a mesh file; by default its format's. A USD stage has its own.
    pub up: Option<Up>,
    /// The metres per unit of a mesh file; by default 1. A USD stage has its own.
    pub scale: Option<f64>,
    /// Whether a glTF file may name buffers and images outside its folder.
    pub allow_outside: bool,
    /// Whether the meshes of a USD stage without a texture keep their texture coordinates, for materials that are given to them
    /// later. Mesh files always keep them.
    pub texture_coordinates: bool,
    /// Whether surfaces without a texture get the fine one of ordinary surfaces ([`MicroTexture::ordinary`]), by which stereo cameras
    /// match them.
    pub micro_texture: bool,
    /// The reflectance at 940 nm, 0 to 1, of materials by name and of surfaces by semantic label ([`Scene::set_infrared`]). Others reflect
    /// infrared light as their colours say.
    pub infrared: BTreeMap<String, f64>,
}

/// The contents of a scene file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneFile {
    /// The file.
    pub path: PathBuf,
    /// The geometry, materials and lights.
    pub scene: Scene,
    /// The cameras.
    pub cameras: Vec<SceneCamera>,
    /// The render products.
    pub products: Vec<RenderProduct>,
    /// Findings about missing or unsupported contents.
    pub findings: Vec<Finding>,
}

/// An error that prevents a scene file from being opened.
#[derive(Debug, thiserror::Error)]
pub enum SceneFileError {
    /// The kind of file is unknown, or an option does not apply to it.
    #[error(transparent)]
    File(#[from] FileError),
    /// The file is not a valid USD stage.
    #[error(transparent)]
    Stage(#[from] StageError),
    /// The file is not a valid mesh file.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// The scene has no such reflectance.
    #[error("{}: {}", file.display(), message![opt("infrared"), format!(" {error}")])]
    Infrared {
        /// The file.
        file: PathBuf,
        /// What is wrong.
        error: InfraredError,
    },
}

impl SceneFile {
    /// Opens a USD stage (`usd`, `usda`, `usdc`, `usdz`), or a mesh file (`gltf`, `glb`, `dae`, `obj`, `stl`, `ply`).
    ///
    /// # Errors
    /// Returns an error if the file cannot be read, its kind is unknown or an option does not apply to it. Missing or
    /// unsupported contents are findings.
    pub fn open(path: &Path, options: &OpenOptions) -> Result<Self, SceneFileError> {
        let extension = extension(path);
        let opened = if USD.contains(&extension.as_str()) {
            let stage = stage::open_scene(path, &stage_options(path, options)?)?;
            Ok(Self::of_stage(path, stage))
        } else if import::is_importable(path) {
            Self::import(path, options)
        } else {
            Err(unknown_kind(path, &extension).into())
        }?;
        opened.with_surfaces(options)
    }

    /// Opens a USD stage, or a glTF file, at the time of the options, and keeps it open for other times. `mount` is the path of a stage's prim
    /// that carries a device.
    ///
    /// # Errors
    /// Returns an error in the cases of [`SceneFile::open`], for a file of another kind, and if there is no such prim.
    pub fn open_animated(
        path: &Path,
        options: &OpenOptions,
        mount: Option<&str>,
    ) -> Result<(AnimatedScene, Self), SceneFileError> {
        if is_gltf(path) && mount.is_none() {
            let (scene, range) = Self::imported(path, options)?;
            let scene = scene.with_surfaces(options)?;
            let timing = StageTiming {
                time_codes_per_second: 1.0,
                range,
                is_animated: range.is_some(),
                deforms: None,
            };
            let animated = AnimatedScene {
                path: path.to_owned(),
                options: options.clone(),
                source: Animated::Gltf(Box::new(Nodes {
                    first: scene.scene.clone(),
                    is_rigid: true,
                    timing,
                })),
                world_from_mount: None,
            };
            return Ok((animated, scene));
        }
        if !Self::is_stage(path) {
            let message = match mount {
                Some(_) => message![opt("mount"), " requires a USD stage"],
                None => message!["is not animated, because only USD stages and glTF files are"],
            };
            return Err(FileError::new(path, message, "convert the file to USD").into());
        }
        let (stage, first, world_from_mount) =
            AnimatedStage::open(path, &stage_options(path, options)?, mount)?;
        let scene = Self::of_stage(path, first).with_surfaces(options)?;
        let animated = AnimatedScene {
            path: path.to_owned(),
            options: options.clone(),
            source: Animated::Stage(stage),
            world_from_mount,
        };
        Ok((animated, scene))
    }

    /// Takes the scene out, and leaves an empty one with the same unit, in which the cameras keep their meaning.
    #[must_use]
    pub fn take_scene(&mut self) -> Scene {
        let empty = Scene {
            meters_per_unit: self.scene.meters_per_unit,
            ..Scene::default()
        };
        std::mem::replace(&mut self.scene, empty)
    }

    /// Gives surfaces what the options say of them and the file does not.
    fn with_surfaces(mut self, options: &OpenOptions) -> Result<Self, SceneFileError> {
        self.scene.micro_texture = options.micro_texture.then(|| MicroTexture::ordinary(0));
        let set = self.scene.set_infrared(&options.infrared);
        set.map_err(|error| SceneFileError::Infrared {
            file: self.path.clone(),
            error,
        })?;
        Ok(self)
    }

    /// Returns whether a file is a USD stage, by its extension: only stages can be animated.
    #[must_use]
    pub fn is_stage(path: &Path) -> bool {
        USD.contains(&extension(path).as_str())
    }

    /// Returns whether a file states the length of its unit, by its extension.
    #[must_use]
    pub fn states_unit(path: &Path) -> bool {
        Self::is_stage(path) || import::states_unit(path)
    }

    /// Returns whether [`SceneFile::open_animated`] takes a file, by its extension.
    #[must_use]
    pub fn may_move(path: &Path) -> bool {
        Self::is_stage(path) || is_gltf(path)
    }

    fn of_stage(path: &Path, stage: StageScene) -> Self {
        Self {
            path: path.to_owned(),
            scene: stage.scene,
            cameras: stage.cameras,
            products: stage.products,
            findings: stage.findings,
        }
    }

    fn import(path: &Path, options: &OpenOptions) -> Result<Self, SceneFileError> {
        Ok(Self::imported(path, options)?.0)
    }

    /// Imports a mesh file, with the first and the last keyframe of its animations, s.
    fn imported(path: &Path, options: &OpenOptions) -> Result<(Self, Option<(f64, f64)>), SceneFileError> {
        let can_move = is_gltf(path);
        for (given, name) in [
            (options.time.is_some() && !can_move, "time"),
            (options.subdivide > 0, "subdivide"),
        ] {
            if given {
                let message = message![opt(name), " requires a USD stage"];
                return Err(FileError::new(path, message, message!["remove ", opt(name)]).into());
            }
        }
        let imported = import::open(path, &import_options(options))?;
        let meters_per_unit = imported.scene.meters_per_unit.0;
        let cameras = imported.cameras.iter();
        let file = Self {
            path: path.to_owned(),
            cameras: cameras.map(|camera| as_prim(camera, meters_per_unit)).collect(),
            scene: imported.scene,
            products: Vec::new(),
            findings: imported.findings,
        };
        Ok((file, imported.animated_s))
    }
}

/// Whether a scene is another one with other poses of its instances.
fn is_moved(scene: &Scene, first: &Scene) -> bool {
    let other = |(own, first): (&Instance, &Instance)| {
        let moved = Instance {
            world_from_mesh: first.world_from_mesh,
            ..own.clone()
        };
        moved != *first
    };
    scene.instances.len() == first.instances.len()
        && !scene.instances.iter().zip(&first.instances).any(other)
        && scene.meshes == first.meshes
        && scene.materials == first.materials
        && scene.textures == first.textures
        && scene.lights == first.lights
}

/// A USD stage that stays open, or a glTF file.
#[derive(Debug)]
pub struct AnimatedScene {
    path: PathBuf,
    options: OpenOptions,
    source: Animated,
    world_from_mount: Option<RigidTransform>,
}

/// What is animated.
#[derive(Debug)]
enum Animated {
    Stage(AnimatedStage),
    Gltf(Box<Nodes>),
}

/// A glTF file, which is read again for each time: its time codes are seconds.
#[derive(Debug)]
struct Nodes {
    /// The scene of the first time.
    first: Scene,
    /// Whether only nodes have moved so far. A scene that was built for another time stays one of its own.
    is_rigid: bool,
    timing: StageTiming,
}

impl Nodes {
    /// Reads the file at another time. Of a scene in which only nodes have moved, the meshes of the first time stay.
    fn at(
        &mut self,
        path: &Path,
        options: &OpenOptions,
        time_s: Option<f64>,
    ) -> Result<SceneChange, SceneFileError> {
        let options = OpenOptions {
            time: time_s,
            ..options.clone()
        };
        let file = SceneFile::open(path, &options)?;
        self.is_rigid = self.is_rigid && is_moved(&file.scene, &self.first);
        if !self.is_rigid {
            return Ok(SceneChange::Rebuilt(Box::new(file)));
        }
        let instances = file.scene.instances.iter().map(|one| one.world_from_mesh);
        let cameras = file.cameras.iter().map(|one| one.world_from_camera);
        Ok(SceneChange::Moved(
            instances.enumerate().collect(),
            cameras.enumerate().collect(),
        ))
    }
}

/// The contents of an animated scene at another time.
#[derive(Clone, Debug, PartialEq)]
pub enum SceneChange {
    /// The first scene with other transforms: of instances (`world_from_mesh`) and of cameras (`world_from_camera`), by their indices.
    Moved(Vec<(usize, DAffine3)>, Vec<(usize, RigidTransform)>),
    /// Another scene.
    Rebuilt(Box<SceneFile>),
}

impl AnimatedScene {
    /// Returns the times of the stage.
    #[must_use]
    pub fn timing(&self) -> &StageTiming {
        match &self.source {
            Animated::Stage(stage) => stage.timing(),
            Animated::Gltf(nodes) => &nodes.timing,
        }
    }

    /// Returns the pose of the prim that carries a device, in metres, at the time that was read last.
    #[must_use]
    pub fn world_from_mount(&self) -> Option<&RigidTransform> {
        self.world_from_mount.as_ref()
    }

    /// Reads the stage at a time code, or at its default values. The findings are about this time.
    ///
    /// # Errors
    /// Returns an error if the stage cannot be read at this time.
    pub fn at(&mut self, time: Option<f64>) -> Result<(SceneChange, Vec<Finding>), SceneFileError> {
        let stage = match &mut self.source {
            Animated::Stage(stage) => stage,
            Animated::Gltf(nodes) => {
                let mut change = nodes.at(&self.path, &self.options, time)?;
                let findings = match &mut change {
                    SceneChange::Rebuilt(file) => std::mem::take(&mut file.findings),
                    SceneChange::Moved(..) => Vec::new(),
                };
                return Ok((change, findings));
            }
        };
        let change = stage.at(time)?;
        // A prim whose transform is singular stays where it was.
        self.world_from_mount = change.world_from_mount.or(self.world_from_mount);
        let mut findings = Vec::from_iter(change.mount_finding);
        let contents = match change.contents {
            StageContents::Moved { instances, cameras } => SceneChange::Moved(instances, cameras),
            StageContents::Rebuilt(scene) => {
                let mut file = SceneFile::of_stage(&self.path, *scene).with_surfaces(&self.options)?;
                findings.append(&mut file.findings);
                SceneChange::Rebuilt(Box::new(file))
            }
        };
        Ok((contents, findings))
    }
}

fn import_options(options: &OpenOptions) -> ImportOptions {
    ImportOptions {
        up: options.up,
        scale: options.scale.unwrap_or(1.0),
        allow_outside: options.allow_outside,
        time_s: options.time,
    }
}

/// Whether a file is glTF, by its extension.
fn is_gltf(path: &Path) -> bool {
    ["gltf", "glb"].contains(&extension(path).as_str())
}

fn extension(path: &Path) -> String {
    path.extension()
        .map(|extension| extension.to_string_lossy().to_lowercase())
        .unwrap_or_default()
}

fn stage_options(path: &Path, options: &OpenOptions) -> Result<SceneOptions, FileError> {
    for (given, name) in [(options.up.is_some(), "up"), (options.scale.is_some(), "scale")] {
        if given {
            let message = message![opt(name), " does not apply to a USD stage, which has its own"];
            return Err(FileError::new(path, message, message!["remove ", opt(name)]));
        }
    }
    Ok(SceneOptions {
        time: options.time,
        subdivide: options.subdivide,
        limit: options.limit,
        texture_coordinates: options.texture_coordinates,
    })
}

/// A mesh file's camera as the attributes of a prim: the vertical field of view as a focal length for an aperture 10 high.
fn as_prim(camera: &ImportedCamera, meters_per_unit: f64) -> SceneCamera {
    const HEIGHT: f64 = 10.0;
    // Without an aspect ratio in the file, use an OAK's stereo cameras'.
    let aspect = camera.aspect.unwrap_or(1.6);
    let clip = Clip::default();
    let attributes = [
        (
            "focalLength",
            AttributeValue::Float(HEIGHT / (2.0 * (camera.vfov / 2.0).tan())),
        ),
        ("horizontalAperture", AttributeValue::Float(HEIGHT * aspect)),
        ("verticalAperture", AttributeValue::Float(HEIGHT)),
        (
            "clippingRange",
            AttributeValue::Floats(vec![clip.near_m / meters_per_unit, clip.far_m / meters_per_unit]),
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
        "has no extension".to_owned()
    } else {
        format!("unknown scene format .{extension}")
    };
    FileError::new(
        path,
        message,
        "give a usd, usda, usdc, usdz, gltf, glb, dae, obj, stl or ply file",
    )
}
