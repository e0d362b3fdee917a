//! The scenes that the page can show.

use std::collections::{BTreeMap, VecDeque};
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};

use axum::body::Bytes;
use oaktwin::camera::RigidTransform;
use oaktwin::diagnostic::Finding;
use oaktwin::render::{OpenOptions, Renderer, SceneFile, look_at, overview};
use oaktwin::scene::{Bounds, Scene, Up};

use crate::mesh;
use crate::pose::pose_of;
use crate::protocol::{Failure, Pose, SceneInfo, SceneObject};
use crate::robot::{self, RobotFile, SceneRobot};
use crate::task::Job;

/// The number of dropped scenes that are kept, besides the command line's, and of their triangles.
const KEPT: usize = 24;
const KEPT_TRIANGLES: usize = 2 * MAX_TRIANGLES;
/// The number of objects that the page can name, and of bytes of their paths; others are part of the scene only.
const MAX_OBJECTS: usize = 20_000;
const MAX_PATH_BYTES: usize = 4 << 20;
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
    /// The up axis and the metres per unit with which it was read, where they were given.
    pub(crate) given: (Option<Up>, Option<f64>),
    pub(crate) robot: Option<SceneRobot>,
    meshes: Mutex<BTreeMap<usize, Bytes>>,
}

impl LoadedScene {
    /// Reads a file, with its id, its name on the page and its name on a command line.
    pub(crate) fn open(
        path: &Path,
        options: &OpenOptions,
        (id, name, argument): (&str, &str, &str),
    ) -> Result<Self, Failure> {
        let file = SceneFile::open(path, options).map_err(|error| {
            // The page knows the file by the name that it was dropped with.
            Failure::from(local(&error.to_string(), path, name))
        })?;
        let scene = file.scene;
        let Some(bounds) = scene.bounds() else {
            return Err(Failure {
                error: format!("{name}: has no triangles; give a scene with meshes"),
                findings: file.findings,
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
            scale: (!SceneFile::is_stage(path)).then(|| options.scale.unwrap_or(1.0)),
            triangles: mesh::triangles(&scene),
            bounds: corners(bounds),
            objects: objects(&scene),
            findings: (file.findings.into_iter().take(MAX_FINDINGS))
                .map(|finding| Finding {
                    place: local(&finding.place, path, name),
                    ..finding
                })
                .collect(),
            pose: initial_pose(&scene),
            robot: None,
        };
        Ok(Self {
            info,
            renderer: Renderer::new(scene),
            argument: argument.to_owned(),
            made_by: None,
            given: (options.up, options.scale),
            robot: None,
            meshes: Mutex::default(),
        })
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
        Self {
            info: self.info.clone(),
            renderer: Renderer::new(self.renderer.scene().clone()),
            argument: self.argument.clone(),
            made_by: self.made_by.clone(),
            given: self.given,
            robot: self.robot.clone(),
            meshes: Mutex::default(),
        }
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
            ..self.info.clone()
        };
        info.findings.extend(findings.into_iter().take(MAX_FINDINGS));
        if let Some(bounds) = scene.bounds() {
            info.bounds = corners(bounds);
        }
        Ok(Self {
            info,
            renderer: Renderer::new(scene),
            robot: Some(robot),
            argument: self.argument.clone(),
            made_by: self.made_by.clone(),
            given: self.given,
            meshes: Mutex::default(),
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

/// Names a file, and others in its folder, as the page knows them.
fn local(text: &str, path: &Path, name: &str) -> String {
    let text = text.replace(&path.display().to_string(), name);
    match path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        Some(folder) => text.replace(&format!("{}/", folder.display()), ""),
        None => text,
    }
}

/// An overview of the whole scene, or the origin.
fn initial_pose(scene: &Scene) -> Pose {
    let seen = overview(scene).and_then(|[eye, target]| look_at(eye, target, scene.up.direction()).ok());
    pose_of(&seen.unwrap_or(RigidTransform::IDENTITY))
}

fn corners(bounds: Bounds) -> [[f64; 3]; 2] {
    [bounds.min.to_array(), bounds.max.to_array()]
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

/// Scenes in postures of their robots. The one that was used last is the last.
#[derive(Debug, Default)]
struct Postures(Vec<Arc<LoadedScene>>);

impl Postures {
    /// The number of copies of scenes that are kept.
    const KEPT: usize = 6;

    /// Returns a scene in a posture: a copy that nobody uses any more is moved, which is faster than another copy.
    fn get(&mut self, id: &str, scene: &LoadedScene, posture: &str) -> Result<Arc<LoadedScene>, Failure> {
        if let Some(place) = self.0.iter().position(|one| one.info.id == id) {
            let found = self.0.remove(place);
            self.0.push(Arc::clone(&found));
            return Ok(found);
        }
        let Some(robot) = &scene.robot else {
            let error = format!(
                "the scene {} has no robot; open the page without its link",
                scene.info.name
            );
            return Err(Failure::of("scene", &error));
        };
        let positions = robot.parse(posture)?;
        let is_free = |one: &Arc<LoadedScene>| {
            robot::split(&one.info.id).is_some_and(|(own, _)| own == scene.info.id)
                && Arc::strong_count(one) == 1
        };
        let spare = self.0.iter().position(is_free).map(|place| self.0.remove(place));
        let mut moved = match spare.map(Arc::try_unwrap) {
            Some(Ok(spare)) => spare,
            Some(Err(_)) | None => scene.copied(),
        };
        moved.pose(id, positions);
        let moved = Arc::new(moved);
        self.0.push(Arc::clone(&moved));
        if self.0.len() > Self::KEPT {
            self.0.remove(0);
        }
        Ok(moved)
    }
}

/// The scenes by id.
#[derive(Debug)]
pub(crate) struct Scenes {
    first: Arc<LoadedScene>,
    /// The one that was used last is the last.
    dropped: Mutex<VecDeque<Arc<LoadedScene>>>,
    postures: Mutex<Postures>,
}

impl Scenes {
    pub(crate) fn new(first: LoadedScene) -> Self {
        Self {
            first: Arc::new(first),
            dropped: Mutex::default(),
            postures: Mutex::default(),
        }
    }

    /// The scene that is shown first.
    pub(crate) fn first(&self) -> &LoadedScene {
        &self.first
    }

    /// Returns a scene, in the posture of its robot that the id may name.
    pub(crate) fn get(&self, id: &str) -> Result<Arc<LoadedScene>, Failure> {
        let Some((own, posture)) = robot::split(id) else {
            return self.unposed(id);
        };
        let scene = self.unposed(own)?;
        let mut postures = self.postures.lock().unwrap_or_else(PoisonError::into_inner);
        postures.get(id, &scene, posture)
    }

    fn unposed(&self, id: &str) -> Result<Arc<LoadedScene>, Failure> {
        if self.first.info.id == id {
            return Ok(Arc::clone(&self.first));
        }
        self.dropped(id).ok_or_else(|| {
            Failure::of(
                "scene",
                &format!("no scene '{id}'; drop the file onto the page again"),
            )
        })
    }

    /// Returns a dropped scene that is kept.
    pub(crate) fn dropped(&self, id: &str) -> Option<Arc<LoadedScene>> {
        let mut dropped = self.dropped.lock().unwrap_or_else(PoisonError::into_inner);
        let place = dropped.iter().position(|scene| scene.info.id == id)?;
        let scene = dropped.remove(place)?;
        dropped.push_back(Arc::clone(&scene));
        Some(scene)
    }

    /// Keeps a dropped scene and forgets those that nobody has used for longest.
    pub(crate) fn add(&self, scene: LoadedScene) -> Arc<LoadedScene> {
        let scene = Arc::new(scene);
        let mut dropped = self.dropped.lock().unwrap_or_else(PoisonError::into_inner);
        dropped.retain(|known| known.info.id != scene.info.id);
        dropped.push_back(Arc::clone(&scene));
        let triangles = |kept: &VecDeque<Arc<LoadedScene>>| -> usize {
            kept.iter().map(|scene| scene.info.triangles).sum()
        };
        while dropped.len() > 1 && (dropped.len() > KEPT || triangles(&dropped) > KEPT_TRIANGLES) {
            dropped.pop_front();
        }
        scene
    }
}
