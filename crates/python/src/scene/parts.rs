//! The parts of a scene: their names, poses and pickles.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, RwLock, RwLockReadGuard, TryLockError};

use oaktwin::camera::RigidTransform;
use oaktwin::camera::math::DAffine3;
use oaktwin::diagnostic::suggest;
use oaktwin::render::Renderer;
use oaktwin::scene::{self, Instance, Label, MaterialSpan, Up};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use super::cameras::Cameras;
use super::lit::Lit;
use super::{Origin, Scene};
use crate::choice::named;
use crate::error::wrong;
use crate::mesh::Mesh;
use crate::pose::{one_pose, rows};
use crate::settings::mistyped;

/// A callable, its arguments, and the state that is set afterwards.
pub(super) type Reduced<'py> = (Bound<'py, PyAny>, Bound<'py, PyTuple>, SceneState<'py>);

/// The poses that are set, and the frame number of the next pair.
type SceneState<'py> = (Bound<'py, PyDict>, u64);

/// What a scene shows at present: a renderer with the poses of its instances, which are the parts of the scene, and the cameras.
pub(crate) struct Stage {
    pub(crate) renderer: Renderer,
    pub(super) cameras: Cameras,
    /// The time code, if there is one.
    pub(super) time: Option<f64>,
    /// The pose and the rest of the transform of each instance with a given pose, by its index; see
    /// [`Instance::pose_and_rest`], which returns the others'.
    placed: BTreeMap<usize, (RigidTransform, DAffine3)>,
    pub(super) lit: Lit,
    /// A number that no other state of a scene has.
    pub(super) version: u64,
}

/// The number of the next state of a scene.
fn next_version() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

impl Stage {
    pub(super) fn new(scene: scene::Scene, cameras: Cameras, time: Option<f64>) -> Self {
        Self {
            renderer: Renderer::new(scene),
            cameras,
            time,
            placed: BTreeMap::new(),
            lit: Lit::default(),
            version: next_version(),
        }
    }

    /// Moves instances.
    fn move_all(&mut self, transforms: impl IntoIterator<Item = (usize, DAffine3)>) {
        self.renderer.set_poses(transforms);
        self.lit.clear();
        self.version = next_version();
    }

    pub(super) fn poses(&self) -> impl Iterator<Item = (&str, RigidTransform)> {
        let instances = self.renderer.scene().instances.iter().enumerate();
        instances.map(|(index, instance)| (instance.path.as_str(), self.pose_and_rest(index, instance).0))
    }

    /// The paths of all parts, with what a pose leaves of their transforms.
    pub(crate) fn parts(&self) -> impl Iterator<Item = (&str, DAffine3)> {
        let instances = self.renderer.scene().instances.iter().enumerate();
        instances.map(|(index, instance)| (instance.path.as_str(), self.pose_and_rest(index, instance).1))
    }

    fn pose_and_rest(&self, index: usize, instance: &Instance) -> (RigidTransform, DAffine3) {
        let placed = self.placed.get(&index).copied();
        placed.unwrap_or_else(|| instance.pose_and_rest())
    }

    /// Moves parts: all, or none if a name is unknown.
    pub(super) fn place(&mut self, poses: &[(String, RigidTransform)]) -> PyResult<()> {
        let found = poses.iter().map(|(name, pose)| {
            let (index, instance) = self.find(name)?;
            Ok((index, (*pose, self.pose_and_rest(index, instance).1)))
        });
        let found: Vec<_> = found.collect::<PyResult<_>>()?;
        let transforms = found
            .iter()
            .map(|(index, (pose, rest))| (*index, Instance::placed(pose, *rest)));
        self.move_all(transforms);
        self.placed.extend(found);
        Ok(())
    }

    /// Moves animated parts, whose given poses are lost.
    pub(super) fn animate(&mut self, instances: Vec<(usize, DAffine3)>) {
        for (index, _) in &instances {
            self.placed.remove(index);
        }
        self.move_all(instances);
    }

    fn find(&self, name: &str) -> PyResult<(usize, &Instance)> {
        let path = path(name);
        let instances = &self.renderer.scene().instances;
        let found = instances
            .iter()
            .enumerate()
            .find(|(_, instance)| instance.path == path);
        found.ok_or_else(|| unknown_part(name, instances.iter().map(|instance| instance.path.as_str())))
    }
}

/// The error of a name that none of the paths has.
pub(crate) fn unknown_part<'a>(name: &str, paths: impl Iterator<Item = &'a str>) -> PyErr {
    let names = paths.map(|path| path.strip_prefix("/World/").unwrap_or(path));
    wrong(name, "the scene has no such part", suggest(name, names))
}

/// The prim path of a name.
pub(crate) fn path(name: &str) -> String {
    if name.starts_with('/') {
        name.to_owned()
    } else {
        format!("/World/{name}")
    }
}

/// The items of an optional mapping from names.
fn items<'py>(
    argument: &str,
    mapping: Option<&Bound<'py, PyAny>>,
) -> PyResult<Vec<(String, Bound<'py, PyAny>)>> {
    let Some(mapping) = mapping else {
        return Ok(Vec::new());
    };
    let items = mapping
        .call_method0("items")
        .map_err(|_| wrong(argument, "is not a mapping", "pass a dictionary from names"))?;
    let item = |item: PyResult<Bound<'py, PyAny>>| {
        let (name, value): (Bound<'py, PyAny>, Bound<'py, PyAny>) = item?.extract()?;
        let name = name
            .extract::<String>()
            .map_err(|_| wrong(argument, format_args!("has the key {name}"), "pass names as keys"))?;
        Ok((name, value))
    };
    items.try_iter()?.map(item).collect()
}

/// Reads a mapping from names to poses.
pub(super) fn poses(mapping: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<(String, RigidTransform)>> {
    let pose = |(name, pose): (String, Bound<'_, PyAny>)| {
        let pose = one_pose(&format!("poses: {name}"), &pose)?;
        Ok((name, pose))
    };
    items("poses", mapping)?.into_iter().map(pose).collect()
}

/// The arguments of a scene of meshes.
pub(super) struct Parts {
    pub(super) meshes: Vec<(String, Py<Mesh>)>,
    pub(super) poses: BTreeMap<String, RigidTransform>,
    pub(super) labels: BTreeMap<String, String>,
}

impl Parts {
    /// Reads mappings from names.
    pub(super) fn read(
        meshes: &Bound<'_, PyAny>,
        poses: Option<&Bound<'_, PyAny>>,
        labels: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let mesh = |(name, mesh): (String, Bound<'_, PyAny>)| {
            let mesh = mesh.cast_into::<Mesh>().map_err(|_| {
                let is = format_args!("the value of {name} is not a mesh");
                wrong("meshes", is, "pass oaktwin.Mesh(vertices, faces)")
            })?;
            Ok((name, mesh.unbind()))
        };
        let label = |(name, label): (String, Bound<'_, PyAny>)| {
            let text = label.extract();
            let text = text.map_err(|_| mistyped("labels", &label, "a text for each name"))?;
            Ok((name, text))
        };
        let meshes = items("meshes", Some(meshes))?.into_iter().map(mesh);
        let labels = items("labels", labels)?.into_iter().map(label);
        Ok(Self {
            meshes: meshes.collect::<PyResult<_>>()?,
            poses: self::poses(poses)?.into_iter().collect(),
            labels: labels.collect::<PyResult<_>>()?,
        })
    }

    /// Returns the scene, and the pose of each part.
    fn scene(&self, up: &str) -> PyResult<(scene::Scene, Vec<RigidTransform>)> {
        let mut scene = scene::Scene {
            up: named("up", up)?,
            ..scene::Scene::default()
        };
        let mut paths = BTreeMap::new();
        let mut numbers = BTreeMap::new();
        for (name, mesh) in &self.meshes {
            let path = path(name);
            let is_valid = |element: &str| !element.is_empty() && !element.contains(char::is_control);
            if !path.split('/').skip(1).all(is_valid) {
                return Err(wrong(
                    name,
                    "is not a valid name",
                    "pass names such as \"arm/link_1\"",
                ));
            }
            let number = *numbers
                .entry(mesh.as_ptr())
                .or_insert_with(|| add(&mut scene, mesh.get()));
            scene.instances.push(Instance {
                mesh: number,
                labels: Vec::new(),
                world_from_mesh: DAffine3::IDENTITY,
                path: path.clone(),
                material_offset: 0,
            });
            if paths.insert(path, scene.instances.len() - 1).is_some() {
                return Err(wrong(name, "appears twice", "pass each name once"));
            }
        }
        let find = |name: &str| {
            let names = self.meshes.iter().map(|(name, _)| name.as_str());
            paths
                .get(&path(name))
                .copied()
                .ok_or_else(|| wrong(name, "there is no mesh of this name", suggest(name, names)))
        };
        let mut poses = vec![RigidTransform::IDENTITY; scene.instances.len()];
        for (name, pose) in &self.poses {
            let index = find(name)?;
            poses[index] = *pose;
            scene.instances[index].world_from_mesh = Instance::placed(pose, DAffine3::IDENTITY);
        }
        for (name, label) in &self.labels {
            scene.instances[find(name)?].labels = vec![Label {
                prim: path(name),
                taxonomy: "class".to_owned(),
                name: label.clone(),
            }];
        }
        Ok((scene, poses))
    }
}

/// Adds a mesh with its material and texture, and returns its number.
fn add(scene: &mut scene::Scene, mesh: &Mesh) -> u32 {
    let number = |count: usize| u32::try_from(count).unwrap_or(u32::MAX);
    let mut own = mesh.mesh.clone();
    if let Some(mut material) = mesh.material.clone() {
        if let (Some(used), Some(texture)) = (&mut material.base_color_texture, &mesh.texture) {
            used.texture = number(scene.textures.len());
            scene.textures.push(texture.clone());
        }
        material.name = format!("material_{}", scene.materials.len());
        own.materials = vec![MaterialSpan {
            end: number(own.triangles.len()),
            material: Some(number(scene.materials.len())),
        }];
        scene.materials.push(material);
    }
    scene.meshes.push(own);
    number(scene.meshes.len() - 1)
}

impl Scene {
    pub(super) fn of_parts(parts: Parts, up: &str) -> PyResult<Self> {
        let (scene, poses) = parts.scene(up)?;
        let mut stage = Stage::new(scene, Ok(Vec::new()), None);
        let poses = poses.into_iter().map(|pose| (pose, DAffine3::IDENTITY));
        stage.placed.extend(poses.enumerate());
        Ok(Self {
            stage: RwLock::new(stage),
            next_frame: AtomicU64::new(0),
            origin: Origin::Meshes(parts.meshes),
            animation: Mutex::default(),
            findings: Vec::new(),
        })
    }

    /// The stage for reading. The interpreter is released while another thread moves parts.
    pub(crate) fn read(&self, py: Python<'_>) -> RwLockReadGuard<'_, Stage> {
        loop {
            match self.stage.try_read() {
                Ok(stage) => return stage,
                Err(TryLockError::Poisoned(error)) => return error.into_inner(),
                Err(TryLockError::WouldBlock) => py.detach(|| drop(self.stage.read())),
            }
        }
    }

    /// Changes the stage. The interpreter is released while other threads render.
    pub(super) fn write<T>(&self, py: Python<'_>, change: impl FnOnce(&mut Stage) -> T) -> T {
        loop {
            match self.stage.try_write() {
                Ok(mut stage) => return change(&mut stage),
                Err(TryLockError::Poisoned(error)) => return change(&mut error.into_inner()),
                Err(TryLockError::WouldBlock) => py.detach(|| drop(self.stage.write())),
            }
        }
    }
}

pub(super) fn reduce<'py>(scene: &Scene, py: Python<'py>) -> PyResult<Reduced<'py>> {
    let partial = py.import("functools")?.getattr("partial")?;
    let own = py.get_type::<Scene>();
    let (options, poses) = (PyDict::new(py), PyDict::new(py));
    let stage = scene.read(py);
    let next_frame = scene.next_frame.load(Ordering::Relaxed);
    let call = |make: &str, options| partial.call((own.getattr(make)?,), Some(options));
    match &scene.origin {
        Origin::File {
            path,
            options: opened,
            mount,
        } => {
            options.set_item("time", stage.time)?;
            options.set_item("subdivide", opened.subdivide)?;
            options.set_item("up", opened.up.map(Up::name))?;
            options.set_item("scale", opened.scale)?;
            options.set_item("scene_limit", opened.limit.factor())?;
            options.set_item("allow_outside", opened.allow_outside)?;
            options.set_item("micro_texture", opened.micro_texture)?;
            options.set_item("infrared", &opened.infrared)?;
            options.set_item("mount", mount)?;
            let instances = &stage.renderer.scene().instances;
            for (index, (pose, _)) in &stage.placed {
                poses.set_item(&instances[*index].path, rows(py, pose)?)?;
            }
            Ok((
                call("open", &options)?,
                PyTuple::new(py, [path])?,
                (poses, next_frame),
            ))
        }
        Origin::Meshes(meshes) => {
            let (labels, all) = (PyDict::new(py), PyDict::new(py));
            let instances = &stage.renderer.scene().instances;
            for (((name, mesh), (_, pose)), instance) in meshes.iter().zip(stage.poses()).zip(instances) {
                all.set_item(name, mesh)?;
                poses.set_item(name, rows(py, &pose)?)?;
                if let Some(label) = instance.labels.first() {
                    labels.set_item(name, &label.name)?;
                }
            }
            options.set_item("poses", poses)?;
            options.set_item("labels", labels)?;
            options.set_item("up", stage.renderer.scene().up.name())?;
            let state = (PyDict::new(py), next_frame);
            Ok((call("from_meshes", &options)?, PyTuple::new(py, [all])?, state))
        }
    }
}
