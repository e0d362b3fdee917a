//! The scenes that the page can show.

pub(crate) mod infrared;
mod moving;
mod recent;
mod scenes;

use std::collections::BTreeMap;
use std::path::{MAIN_SEPARATOR, Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use axum::body::Bytes;
use oaktwin::camera::RigidTransform;
use oaktwin::diagnostic::{Finding, Level};
use oaktwin::render::{OpenOptions, Renderer, SceneFile, look_at, overview};
use oaktwin::scene::{Bounds, Scene, Up};
use tempfile::TempDir;

use crate::mesh;
use crate::pose::pose_of;
use crate::protocol::{Failure, Pose, SceneInfo, SceneObject};
use crate::robot::{RobotFile, SceneRobot};
use crate::task::Job;
use moving::Moving;

pub(crate) use scenes::{Scenes, at_any_time, in_any_state};

/// The number of objects that the page can name, and of bytes of their paths; others are part of the scene only.
const MAX_OBJECTS: usize = 20_000;
const MAX_PATH_BYTES: usize = 4 << 20;
/// The number of materials and labels that the page offers.
const MAX_NAMES: usize = 1000;
/// The number of triangles of a dropped scene, counting instances: frames of more take too long.
const MAX_TRIANGLES: usize = 100_000_000;
/// The number of findings about a scene that the page lists.
const MAX_FINDINGS: usize = 1000;

/// A scene that was read.
#[derive(Debug)]
pub(crate) struct LoadedScene {
    pub(crate) info: SceneInfo,
    pub(crate) renderer: Renderer,
    /// The name on a command line.
    pub(crate) argument: String,
    /// The command that writes the file of this name.
    pub(crate) made_by: Option<String>,
    /// The options with which it was read.
    pub(crate) options: OpenOptions,
    /// The time code, if it is not the scene as it was opened.
    pub(crate) time: Option<f64>,
    /// Whether only instances have moved since the scene was opened.
    pub(crate) is_moved: bool,
    /// The file, if it was dropped.
    pub(crate) kept: Option<Arc<Kept>>,
    /// The path on this machine, which the page does not know.
    path: PathBuf,
    moving: Option<Moving>,
    pub(crate) robot: Option<SceneRobot>,
    meshes: Mutex<BTreeMap<usize, Bytes>>,
    textures: Mutex<Option<Bytes>>,
}

/// A dropped file on the disk, which is removed with its scene.
#[derive(Debug)]
pub(crate) struct Kept {
    /// Keeps the folder of the file.
    _folder: TempDir,
    pub(crate) bytes: u64,
}

impl LoadedScene {
    /// Reads a file, with its id, its name on the page and its name on a command line.
    pub(crate) fn open(
        path: &Path,
        options: &OpenOptions,
        (id, name, argument): (&str, &str, &str),
    ) -> Result<Self, Failure> {
        let opened = match SceneFile::may_move(path) {
            true => SceneFile::open_animated(path, options, None)
                .map(|(moving, file)| (Moving::new(moving), file)),
            false => SceneFile::open(path, options).map(|file| (None, file)),
        };
        // The page knows the file by the name that it was dropped with.
        let (moving, file) = opened.map_err(|error| Failure::from(local(&error.to_string(), path, name)))?;
        let (moving, animation) = moving.unzip();
        let scene = file.scene;
        let Some(bounds) = scene.bounds() else {
            return Err(Failure {
                error: format!("{name}: has no triangles; give a scene with meshes"),
                findings: local_findings(file.findings, path, name),
                ..Failure::default()
            });
        };
        let info = SceneInfo {
            id: id.to_owned(),
            name: name.to_owned(),
            up: match scene.up {
                Up::Y => "y",
                Up::Z => "z",
            },
            scale: (!SceneFile::states_unit(path)).then(|| options.scale.unwrap_or(1.0)),
            triangles: mesh::triangles(&scene),
            bounds: corners(bounds),
            objects: objects(&scene),
            findings: local_findings(file.findings, path, name),
            pose: initial_pose(&scene),
            animation,
            robot: None,
            infrared: names(&scene),
        };
        Ok(Self {
            info,
            renderer: Renderer::new(scene),
            argument: argument.to_owned(),
            made_by: None,
            options: options.clone(),
            time: None,
            is_moved: false,
            kept: None,
            path: path.to_owned(),
            moving,
            robot: None,
            meshes: Mutex::default(),
            textures: Mutex::default(),
        })
    }

    /// Keeps the folder of a dropped file with its scene.
    pub(crate) fn keeping(mut self, folder: TempDir) -> Result<Self, Failure> {
        let bytes = std::fs::metadata(&self.path).map(|metadata| metadata.len());
        let bytes = bytes.map_err(|error| unreadable(&self.info.name, &error))?;
        self.kept = Some(Arc::new(Kept {
            _folder: folder,
            bytes,
        }));
        Ok(self)
    }

    /// Reads the file that was dropped.
    pub(crate) fn file(&self) -> Result<Vec<u8>, Failure> {
        std::fs::read(&self.path).map_err(|error| unreadable(&self.info.name, &error))
    }

    /// Returns the scene at a time code.
    fn at(&self, time: f64) -> Result<Arc<Self>, Failure> {
        match &self.moving {
            Some(moving) => moving.at(self, time),
            None => {
                let error = format!("{}: nothing moves in it; load the page again", self.info.name);
                Err(Failure::of("time", &error))
            }
        }
    }

    /// Returns this scene with what it contains at a time code.
    pub(crate) fn at_time(
        &self,
        renderer: Renderer,
        is_moved: bool,
        time: f64,
        findings: Vec<Finding>,
    ) -> Self {
        let info = SceneInfo {
            id: format!("{}@{time:?}", self.info.id),
            triangles: mesh::triangles(renderer.scene()),
            findings: self.local_findings(findings),
            ..self.info.clone()
        };
        Self {
            time: Some(time),
            is_moved,
            ..self.with(info, renderer)
        }
    }

    /// Returns another scene of the same file, which stays open for this one only.
    fn with(&self, info: SceneInfo, renderer: Renderer) -> Self {
        Self {
            info,
            renderer,
            argument: self.argument.clone(),
            made_by: self.made_by.clone(),
            options: self.options.clone(),
            time: self.time,
            is_moved: false,
            kept: self.kept.clone(),
            path: self.path.clone(),
            moving: None,
            robot: self.robot.clone(),
            meshes: Mutex::default(),
            textures: Mutex::default(),
        }
    }

    /// Names the file, and others in its folder, as the page knows them.
    pub(crate) fn local(&self, text: &str) -> String {
        local(text, &self.path, &self.info.name)
    }

    /// The same for findings.
    pub(crate) fn local_findings(&self, findings: Vec<Finding>) -> Vec<Finding> {
        local_findings(findings, &self.path, &self.info.name)
    }

    /// Rejects a scene whose frames would take too long for the page.
    pub(crate) fn check_triangles(&self) -> Result<(), Failure> {
        let SceneInfo { name, triangles, .. } = &self.info;
        match *triangles <= MAX_TRIANGLES {
            true => Ok(()),
            false => Err(Failure::from(format!(
                "{name}: has {triangles} triangles with all instances, more than {MAX_TRIANGLES}; drop a smaller scene, or use the command line"
            ))),
        }
    }

    /// Returns a copy of the scene, with an empty cache.
    pub(crate) fn copied(&self) -> Self {
        let renderer = Renderer::new(self.renderer.scene().clone());
        self.with(self.info.clone(), renderer)
    }

    /// Returns the scene with a robot in it, under another id.
    pub(crate) fn with_robot(&self, file: &RobotFile, id: &str, name: &str) -> Result<Self, Failure> {
        if let Some(robot) = &self.robot {
            let error = format!(
                "the scene has a robot already, {}; open a scene without one first",
                robot.placed.robot().name
            );
            return Err(Failure::of("robot", &error));
        }
        let mut scene = self.renderer.scene().clone();
        let opened = SceneRobot::open(file, &mut scene);
        let (robot, findings) = opened.map_err(|failure| Failure {
            error: local(&failure.error, &file.path, name),
            ..failure
        })?;
        let mut info = SceneInfo {
            id: id.to_owned(),
            triangles: mesh::triangles(&scene),
            objects: objects(&scene),
            robot: Some(robot.info()),
            animation: None,
            ..self.info.clone()
        };
        info.findings.extend(findings.into_iter().take(MAX_FINDINGS));
        if self.info.animation.is_some() {
            let what = "the page does not play its animation beside a robot";
            info.findings.push(Finding::new(
                "animation-stopped",
                Level::Note,
                &info.name,
                what,
                "",
            ));
        }
        if let Some(bounds) = scene.bounds() {
            info.bounds = corners(bounds);
        }
        Ok(Self {
            robot: Some(robot),
            ..self.with(info, Renderer::new(scene))
        })
    }

    /// Moves the robot to a posture, under another id.
    pub(crate) fn pose(&mut self, id: &str, positions: Vec<f64>) {
        let Some(robot) = &mut self.robot else { return };
        robot.positions = positions;
        let links = robot.placed.world_from_links(&robot.positions);
        self.renderer.set_poses(robot.placed.poses(&links));
        let scene = self.renderer.scene();
        for (instance, world_from_mesh) in robot.placed.poses(&links) {
            let instance = &scene.instances[instance];
            let bounds = scene
                .meshes
                .get(instance.mesh as usize)
                .and_then(oaktwin::scene::Mesh::bounds);
            let place = self
                .info
                .objects
                .binary_search_by(|object| object.path.cmp(&instance.path));
            if let (Some(bounds), Ok(place)) = (bounds, place) {
                self.info.objects[place].bounds = corners(bounds.transformed(world_from_mesh));
            }
        }
        self.info.robot = Some(robot.info());
        id.clone_into(&mut self.info.id);
        self.meshes
            .get_mut()
            .unwrap_or_else(PoisonError::into_inner)
            .clear();
        self.textures = Mutex::default();
    }

    /// Returns the surfaces with their textures, which are made once.
    pub(crate) fn textures(&self, job: &Job) -> Result<Bytes, Failure> {
        let mut textures = self.textures.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = &*textures {
            return Ok(known.clone());
        }
        let made = Bytes::from(mesh::of_textures(self, job)?);
        Ok(textures.insert(made).clone())
    }

    /// Sets the pose from which the page first shows the scene.
    pub(crate) fn shown_from(mut self, pose: Pose) -> Self {
        self.info.pose = pose;
        self
    }

    /// Sets the command that writes the file.
    pub(crate) fn made_by(self, command: Option<String>) -> Self {
        Self {
            made_by: command,
            ..self
        }
    }

    /// Returns the binary mesh with about this many triangles, which is made once.
    pub(crate) fn mesh(&self, triangles: usize, job: &Job) -> Result<Bytes, Failure> {
        let mut meshes = self.meshes.lock().unwrap_or_else(PoisonError::into_inner);
        if meshes.len() > 1 {
            // A page asks for one size, and for the full detail.
            meshes.retain(|size, _| *size == triangles);
        }
        if let Some(known) = meshes.get(&triangles) {
            return Ok(known.clone());
        }
        let sizes = (triangles, mesh::MAX_WELDED);
        let made = mesh::of_scene(&self.renderer, &self.info.objects, sizes, job)?;
        let made = Bytes::from(made);
        meshes.insert(triangles, made.clone());
        Ok(made)
    }
}

/// Names a file as the page knows it, and others without the folders of this machine.
fn local(text: &str, path: &Path, name: &str) -> String {
    let text = text.replace(&path.display().to_string(), name);
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let whole = folder.canonicalize().unwrap_or_default();
    // Other files may be in folders above it. A folder below the root could be a prim.
    let above = whole.ancestors().filter(|folder| folder.components().count() > 2);
    std::iter::once(folder).chain(above).fold(text, |text, folder| {
        let folder = format!("{}{MAIN_SEPARATOR}", folder.display());
        match folder.starts_with('.') {
            true => text,
            false => text.replace(&folder, ""),
        }
    })
}

fn local_findings(findings: Vec<Finding>, path: &Path, name: &str) -> Vec<Finding> {
    let findings = findings.into_iter().take(MAX_FINDINGS);
    findings
        .map(|finding| finding.map_texts(|text| local(text, path, name)))
        .collect()
}

fn unreadable(name: &str, error: &std::io::Error) -> Failure {
    Failure::from(format!(
        "{name}: the dropped file cannot be read: {error}; drop it again"
    ))
}

/// An overview of the whole scene, or the origin.
fn initial_pose(scene: &Scene) -> Pose {
    let seen = overview(scene).and_then(|[eye, target]| look_at(eye, target, scene.up.direction()).ok());
    pose_of(&seen.unwrap_or(RigidTransform::IDENTITY))
}

fn corners(bounds: Bounds) -> [[f64; 3]; 2] {
    [bounds.min.to_array(), bounds.max.to_array()]
}

/// The materials and labels whose reflectance in the infrared can be set.
fn names(scene: &Scene) -> Vec<String> {
    let names = scene.infrared_names().into_iter().take(MAX_NAMES);
    names.map(str::to_owned).collect()
}

/// The prims with triangles by path. Instances of one path are one object.
fn objects(scene: &Scene) -> Vec<SceneObject> {
    let meshes: Vec<Option<Bounds>> = scene.meshes.iter().map(oaktwin::scene::Mesh::bounds).collect();
    let mut found: BTreeMap<&str, Bounds> = BTreeMap::new();
    for instance in &scene.instances {
        let Some(bounds) = meshes.get(instance.mesh as usize).copied().flatten() else {
            continue;
        };
        let bounds = bounds.transformed(instance.world_from_mesh);
        found
            .entry(&instance.path)
            .and_modify(|known| *known = known.union(bounds))
            .or_insert(bounds);
    }
    let object = |(path, bounds): (&str, Bounds)| SceneObject {
        path: path.to_owned(),
        bounds: corners(bounds),
    };
    let mut bytes = 0;
    let shown = found.into_iter().take(MAX_OBJECTS).take_while(|(path, _)| {
        bytes += path.len();
        bytes <= MAX_PATH_BYTES
    });
    shown.map(object).collect()
}
