//! Builds an imported scene step by step.

use std::collections::HashMap;
use std::path::Path;

use oaktwin_base::diagnostic::{Finding, Level, Message};
use oaktwin_camera::math::{DAffine3, DVec3};

use super::error::Fault;
use super::{ImportedCamera, ImportedScene, origin};
use crate::{Instance, Light, Material, Mesh, MetersPerUnit, Scene, Texture, Up};

/// Paths longer than this are shortened at the front, because every instance stores its ancestors' names.
const MAX_PATH_BYTES: usize = 1024;

pub(super) struct Builder {
    scene: Scene,
    cameras: Vec<ImportedCamera>,
    pub(super) findings: Vec<Finding>,
    /// The first and the last keyframe of the file's animations, s.
    pub(super) animated_s: Option<(f64, f64)>,
    /// The paths in use, each with the last number appended to it. Never iterated.
    paths: HashMap<String, u32>,
    scale: f64,
    /// The file's name without extension, used for elements without a name.
    pub(super) stem: String,
}

impl Builder {
    pub(super) fn new(file: &Path, up: Up, scale: f64) -> Self {
        Self {
            scene: Scene {
                up,
                meters_per_unit: MetersPerUnit(scale),
                ..Scene::default()
            },
            cameras: Vec::new(),
            findings: Vec::new(),
            animated_s: None,
            paths: HashMap::new(),
            scale,
            stem: file
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned(),
        }
    }

    pub(super) fn warn(&mut self, code: &'static str, place: impl Into<String>, message: impl Into<Message>) {
        self.findings
            .push(Finding::new(code, Level::Warning, place, message, ""));
    }

    pub(super) fn note(&mut self, code: &'static str, place: impl Into<String>, message: impl Into<Message>) {
        self.findings
            .push(Finding::new(code, Level::Note, place, message, ""));
    }

    /// Sets the unit of a file that states it.
    pub(super) fn set_unit(&mut self, unit: MetersPerUnit) {
        self.scale = unit.0;
        self.scene.meters_per_unit = unit;
    }

    /// Sets the up axis of a file that states it.
    pub(super) fn set_up(&mut self, up: Up) {
        self.scene.up = up;
    }

    /// Converts the file's unit to metres.
    pub(super) fn world_from_file(&self) -> DAffine3 {
        DAffine3::from_scale(DVec3::splat(self.scale))
    }

    /// The origin for meshes with these points, if they are farther than `far_m` metres from that of their frame; see [`origin`].
    pub(super) fn origin(&self, points: impl Iterator<Item = [f64; 3]>, far_m: f64) -> DVec3 {
        origin::origin(points, far_m / self.scale)
    }

    pub(super) fn add_material(&mut self, material: Material) -> u32 {
        self.scene.materials.push(material);
        number(self.scene.materials.len() - 1)
    }

    pub(super) fn add_texture(&mut self, texture: Texture) -> u32 {
        self.scene.textures.push(texture);
        number(self.scene.textures.len() - 1)
    }

    pub(super) fn add_light(&mut self, light: Light) {
        self.scene.lights.push(light);
    }

    pub(super) fn add_camera(&mut self, camera: ImportedCamera) {
        self.cameras.push(camera);
    }

    /// Returns `None` for a mesh without triangles.
    pub(super) fn add_mesh(&mut self, mesh: Mesh) -> Option<u32> {
        if mesh.triangles.is_empty() {
            return None;
        }
        self.scene.meshes.push(mesh);
        Some(number(self.scene.meshes.len() - 1))
    }

    /// Adds an instance of a mesh, with a transform in the file's unit.
    pub(super) fn place(&mut self, mesh: u32, path: &str, file_from_mesh: DAffine3) {
        let world_from_mesh = self.world_from_file() * file_from_mesh;
        let path = self.free_path(path);
        if !world_from_mesh.is_finite() {
            self.warn("node-transform", path, "skipped: its transform is not finite");
            return;
        }
        let (mesh, world_from_mesh) = if is_invertible(world_from_mesh) {
            (mesh, world_from_mesh)
        } else {
            let flat = baked(&self.scene.meshes[mesh as usize], world_from_mesh);
            self.scene.meshes.push(flat);
            (number(self.scene.meshes.len() - 1), DAffine3::IDENTITY)
        };
        self.scene.instances.push(Instance {
            mesh,
            path,
            world_from_mesh,
            labels: Vec::new(),
            material_offset: 0,
        });
    }

    /// Returns the path, with a number appended if it is taken.
    pub(super) fn free_path(&mut self, path: &str) -> String {
        let path = shortened(path);
        let mut free = path.clone();
        while self.paths.contains_key(&free) {
            let times = self.paths.entry(path.clone()).or_insert(0);
            *times += 1;
            free = format!("{path}_{times}");
        }
        self.paths.insert(free.clone(), 1);
        free
    }

    pub(super) fn finish(mut self) -> Result<ImportedScene, Fault> {
        if self.scene.instances.is_empty() {
            let why: String = self
                .findings
                .iter()
                .take(3)
                .map(|finding| format!("; {}: {}", finding.place, finding.message))
                .collect();
            return Err(Fault::new(
                "",
                format!("contains no triangles{why}"),
                "export it with meshes",
            ));
        }
        self.drop_unplaced();
        Ok(ImportedScene {
            scene: self.scene,
            cameras: self.cameras,
            findings: self.findings,
            animated_s: self.animated_s,
        })
    }

    /// Removes meshes without instances.
    fn drop_unplaced(&mut self) {
        let mut used = vec![false; self.scene.meshes.len()];
        for instance in &self.scene.instances {
            used[instance.mesh as usize] = true;
        }
        for (mesh, used) in self.scene.meshes.iter_mut().zip(used) {
            if !used {
                *mesh = Mesh::default();
            }
        }
    }
}

fn shortened(path: &str) -> String {
    if path.len() <= MAX_PATH_BYTES {
        return path.into();
    }
    let mut start = path.len() - MAX_PATH_BYTES;
    while !path.is_char_boundary(start) {
        start += 1;
    }
    format!("/…{}", &path[start..])
}

/// A name as one component of a path.
pub(super) fn step(name: &str) -> String {
    name.trim()
        .chars()
        .take(MAX_PATH_BYTES)
        .map(|c| if c == '/' || c.is_control() { '_' } else { c })
        .collect()
}

/// Whether the mesh keeps its volume, so that the transform can be inverted accurately.
pub(super) fn is_invertible(transform: DAffine3) -> bool {
    let m = transform.matrix3;
    let room = m.x_axis.length() * m.y_axis.length() * m.z_axis.length();
    m.determinant().abs() > 1e-9 * room && transform.inverse().is_finite()
}

/// A copy of the mesh in the world frame.
fn baked(mesh: &Mesh, world_from_mesh: DAffine3) -> Mesh {
    let mut flat = mesh.clone();
    for position in &mut flat.positions {
        let moved = world_from_mesh.transform_point3(DVec3::from(position.map(f64::from)));
        #[allow(clippy::cast_possible_truncation, reason = "meshes store single precision")]
        let moved = moved.to_array().map(|x| (x as f32).clamp(f32::MIN, f32::MAX));
        *position = moved;
    }
    // The transform may be singular, so normals cannot be transformed.
    flat.normals = None;
    flat
}

/// Lists in memory have fewer than 2³² elements.
fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
