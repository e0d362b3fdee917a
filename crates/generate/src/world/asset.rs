use std::path::Path;
use std::sync::OnceLock;

use oaktwin_camera::math::DVec3;
use oaktwin_files::memory;
use oaktwin_pipeline::render::{OpenOptions, SceneFile};
use oaktwin_scene::{Material, MaterialSpan, Scene, Up};

use super::hull::Hull;
use super::parts::Parts;
use super::triangles::Triangles;
use crate::GenerateError;

/// An object that can be placed.
#[derive(Debug)]
pub(crate) struct Asset {
    /// The geometry in metres with the file's axes, and its materials, of which every triangle has one.
    pub(crate) scene: Scene,
    pub(crate) hull: Hull,
    /// Its convex parts, which are found when they are first used.
    parts: OnceLock<Parts>,
}

impl Asset {
    pub(crate) fn open(path: &Path, up: Option<Up>) -> Result<Self, GenerateError> {
        let file = SceneFile::open(
            path,
            &OpenOptions {
                up: up.filter(|_| !is_stage(path)),
                texture_coordinates: true,
                ..OpenOptions::default()
            },
        )?;
        let mut scene = file.scene;
        scene.lights.clear();
        give_materials(&mut scene);
        let empty = || GenerateError::Empty {
            file: path.to_owned(),
        };
        let triangles: usize = scene.meshes.iter().map(|mesh| mesh.triangles.len()).sum();
        if triangles == 0 {
            return Err(empty());
        }
        let points = world_points(&scene);
        memory::check(24 * points.len() as u64).map_err(|shortage| GenerateError::Memory {
            file: path.to_owned(),
            shortage,
        })?;
        let hull = Hull::new(&points).ok_or_else(empty)?;
        Ok(Self {
            scene,
            hull,
            parts: OnceLock::new(),
        })
    }

    /// Returns its convex parts.
    pub(crate) fn parts(&self) -> &Parts {
        self.parts
            .get_or_init(|| Parts::new(&Triangles::of(&self.scene), &self.hull))
    }
}

fn is_stage(path: &Path) -> bool {
    let extension = path
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase();
    extension.starts_with("usd")
}

/// Gives a material to the triangles that have none, so that they can get another one.
#[expect(clippy::cast_possible_truncation, reason = "a scene's indices are u32")]
pub(super) fn give_materials(scene: &mut Scene) {
    let bare = scene.materials.len() as u32;
    scene.materials.push(Material {
        roughness: 0.6,
        ..Material::default()
    });
    for mesh in &mut scene.meshes {
        let end = mesh.triangles.len() as u32;
        if mesh.materials.is_empty() {
            mesh.materials.push(MaterialSpan { end, material: None });
        }
        for span in &mut mesh.materials {
            span.material = Some(span.material.unwrap_or(bare));
        }
    }
}

fn world_points(scene: &Scene) -> Vec<DVec3> {
    let mut points = Vec::new();
    for instance in &scene.instances {
        let Some(mesh) = scene.meshes.get(instance.mesh as usize) else {
            continue;
        };
        let mut is_used = vec![false; mesh.positions.len()];
        for vertex in mesh.triangles.iter().flatten() {
            is_used[*vertex as usize] = true;
        }
        let used = mesh.positions.iter().zip(is_used).filter(|(_, is_used)| *is_used);
        points.extend(used.map(|(p, _)| {
            instance
                .world_from_mesh
                .transform_point3(DVec3::from(p.map(f64::from)))
        }));
    }
    points
}
