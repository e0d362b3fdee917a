//! A robot in a scene.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use oaktwin_base::diagnostic::{Finding, add_new, message, nearest, opt, suggestion};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_image::srgb;
use oaktwin_scene::import::{self, ImportOptions};
use oaktwin_scene::shape::{self, Axis};
use oaktwin_scene::{Instance, Material, MaterialSpan, Mesh, Scene, Texture, Up};

use super::RobotFileError;
use super::robot::{LinkVisual, Robot, Shape};

/// A robot whose shapes are instances of a scene.
#[derive(Clone, Debug)]
pub struct PlacedRobot {
    robot: Robot,
    world_from_base: RigidTransform,
    parts: Vec<Part>,
    /// The index of the first instance in the scene.
    first: usize,
    path: String,
}

/// An instance of the robot; they follow each other in the scene.
#[derive(Clone, Debug)]
struct Part {
    link: usize,
    link_from_mesh: DAffine3,
}

/// The meshes of a shape or a file in the scene, with their transforms in the file's frame.
type Meshes = Vec<(u32, DAffine3)>;

impl PlacedRobot {
    /// Adds a robot to a scene, at its [rest](Robot::rest), with its base at a pose; by default at the origin, upright. Its instances are at
    /// `/ROBOT/LINK/SHAPE`. The findings are about its meshes.
    ///
    /// # Errors
    /// Returns an error if a mesh cannot be read.
    pub fn new(
        robot: Robot,
        scene: &mut Scene,
        world_from_base: Option<RigidTransform>,
    ) -> Result<(Self, Vec<Finding>), RobotFileError> {
        let mut placed = Self {
            world_from_base: world_from_base.unwrap_or_else(|| upright(scene.up)),
            parts: Vec::new(),
            first: scene.instances.len(),
            path: free_path(scene, &robot.name),
            robot,
        };
        let mut builder = Builder {
            scene,
            files: HashMap::new(),
            stages: Vec::new(),
            colors: HashMap::new(),
            findings: Vec::new(),
        };
        for (link, own) in placed.robot.links.iter().enumerate() {
            for visual in &own.visuals {
                let name = format!("{}/{}", placed.link_path(link), visual.name);
                for link_from_mesh in builder.add(&name, visual)? {
                    placed.parts.push(Part { link, link_from_mesh });
                }
            }
        }
        let findings = builder.findings;
        let links = placed.world_from_links(&placed.robot.rest());
        for (instance, world_from_mesh) in placed.poses(&links) {
            scene.instances[instance].world_from_mesh = world_from_mesh;
        }
        Ok((placed, findings))
    }

    /// The robot.
    #[must_use]
    pub fn robot(&self) -> &Robot {
        &self.robot
    }

    /// The path of its instances in the scene.
    #[must_use]
    pub fn path(&self) -> &str {
        &self.path
    }

    /// Returns the path of a link in the scene, below which are its instances.
    #[must_use]
    pub fn link_path(&self, link: usize) -> String {
        format!("{}/{}", self.path, step(&self.robot.links[link].name))
    }

    /// Returns the pose of each link in the world, for a position of each joint.
    #[must_use]
    pub fn world_from_links(&self, positions: &[f64]) -> Vec<RigidTransform> {
        let mut links = self.robot.base_from_links(positions);
        for link in &mut links {
            *link = self.world_from_base * *link;
        }
        links
    }

    /// Returns the transforms of the robot's instances, by their indices in the scene, for poses of the links.
    pub fn poses<'a>(
        &'a self,
        world_from_links: &'a [RigidTransform],
    ) -> impl Iterator<Item = (usize, DAffine3)> + 'a {
        self.parts.iter().enumerate().map(|(index, part)| {
            let link = &world_from_links[part.link];
            let world_from_link = DAffine3::from_mat3_translation(link.rotation, link.translation);
            (self.first + index, world_from_link * part.link_from_mesh)
        })
    }

    /// Returns the index of the link that an instance of the scene belongs to; `None` if it is not a part of the robot.
    #[must_use]
    pub fn link_of(&self, instance: usize) -> Option<usize> {
        let part = self.parts.get(instance.checked_sub(self.first)?)?;
        (!self.robot.links[part.link].is_world).then_some(part.link)
    }

    /// Returns whether an instance of the scene came with the robot, as a part or as its surroundings.
    #[must_use]
    pub fn has(&self, instance: usize) -> bool {
        (self.first..self.first + self.parts.len()).contains(&instance)
    }

    /// Finds the link that carries an OAK.
    ///
    /// # Errors
    /// Returns an error that suggests the nearest names.
    pub fn mount(&self, link: &str) -> Result<usize, RobotFileError> {
        self.robot.link(link).ok_or_else(|| {
            let known: Vec<&str> = self.robot.links.iter().map(|link| link.name.as_str()).collect();
            let near = nearest(link, known.iter().copied());
            RobotFileError::Option(message![
                opt("mount"),
                format!(": the robot has no link '{link}'; {}", suggestion(&near, &known))
            ])
        })
    }
}

/// The pose of a base at the origin whose z axis is the scene's up axis.
fn upright(up: Up) -> RigidTransform {
    let rotation = match up {
        Up::Z => DMat3::IDENTITY,
        // x stays, z becomes y.
        Up::Y => DMat3::from_cols(DVec3::X, DVec3::NEG_Z, DVec3::Y),
    };
    RigidTransform::new(rotation, DVec3::ZERO)
}

/// A name as one component of a path.
fn step(name: &str) -> String {
    let name = name.trim().chars();
    name.map(|c| if c == '/' || c.is_control() { '_' } else { c })
        .collect()
}

fn free_path(scene: &Scene, name: &str) -> String {
    let own = format!("/{}", step(name));
    let is_taken = |path: &str| scene.instances.iter().any(|instance| instance.is_below(path));
    (1..)
        .map(|number| {
            if number == 1 {
                own.clone()
            } else {
                format!("{own}_{number}")
            }
        })
        .find(|path| !is_taken(path))
        .unwrap_or_default()
}

struct Builder<'a> {
    scene: &'a mut Scene,
    /// What was read of each file, for each colour that its surfaces get.
    files: HashMap<(PathBuf, u32), Meshes>,
    /// The addresses of stages, with the index of their first mesh.
    stages: Vec<(usize, u32)>,
    colors: HashMap<[u32; 3], u32>,
    findings: Vec<Finding>,
}

impl Builder<'_> {
    /// Adds the instances of a shape. Returns their transforms in the frame of the link.
    fn add(&mut self, path: &str, visual: &LinkVisual) -> Result<Vec<DAffine3>, RobotFileError> {
        let pose = &visual.link_from_shape;
        let link_from_shape = DAffine3::from_mat3_translation(pose.rotation, pose.translation);
        let color = self.color(visual.color.unwrap_or([0.5; 3]));
        let mut labels = Vec::new();
        let (meshes, shape_from_file) = match &visual.shape {
            Shape::Mesh {
                file,
                shape_from_file,
            } => (self.file(file, color)?, *shape_from_file),
            Shape::Instance {
                scene,
                instance,
                link_from_mesh,
            } => {
                let instance = &scene.instances[*instance];
                let first = self.stage(scene, color);
                labels.clone_from(&instance.labels);
                (vec![(first + instance.mesh, *link_from_mesh)], DAffine3::IDENTITY)
            }
            shape => self.solid(shape, color),
        };
        let mut transforms = Vec::new();
        for (number, (mesh, file_from_mesh)) in meshes.into_iter().enumerate() {
            self.scene.instances.push(Instance {
                mesh,
                path: if number == 0 {
                    path.to_owned()
                } else {
                    format!("{path}_part_{number}")
                },
                world_from_mesh: DAffine3::IDENTITY,
                labels: labels.clone(),
                material_offset: 0,
            });
            transforms.push(link_from_shape * shape_from_file * file_from_mesh);
        }
        Ok(transforms)
    }

    /// Returns the mesh of a shape of a unit size, where one does for all sizes, and its size.
    fn solid(&mut self, shape: &Shape, color: u32) -> (Meshes, DAffine3) {
        let (mesh, size) = match *shape {
            Shape::Box(size) => (shape::cube(1.0), size),
            Shape::Ellipsoid(radii) => (shape::sphere(1.0), radii),
            Shape::Cylinder { radius, length } => (shape::cylinder(radius, length, Axis::Z), DVec3::ONE),
            Shape::Capsule { radius, length } => (shape::capsule(radius, length, Axis::Z), DVec3::ONE),
            Shape::Rectangle { width, length } => (shape::plane(width, length, Axis::Z), DVec3::ONE),
            Shape::Mesh { .. } | Shape::Instance { .. } => (Mesh::default(), DVec3::ONE),
        };
        self.scene.meshes.push(painted(mesh, color));
        let mesh = count(self.scene.meshes.len() - 1);
        (vec![(mesh, DAffine3::IDENTITY)], DAffine3::from_scale(size))
    }

    /// Returns what a mesh file adds to the scene, which is added when it is first used. Surfaces without a material get the colour.
    fn file(&mut self, file: &Path, color: u32) -> Result<Meshes, RobotFileError> {
        let key = (file.to_owned(), color);
        if let Some(known) = self.files.get(&key) {
            return Ok(known.clone());
        }
        let imported = import::open(file, &ImportOptions::default())
            .map_err(|error| RobotFileError::Option(error.to_string().into()))?;
        add_new(&mut self.findings, imported.findings);
        let first = self.merge(
            imported.scene.meshes,
            imported.scene.materials,
            imported.scene.textures,
            color,
        );
        let instances = imported.scene.instances.iter();
        let meshes: Meshes = instances
            .map(|one| (first + one.mesh, one.world_from_mesh))
            .collect();
        self.files.insert(key, meshes.clone());
        Ok(meshes)
    }

    /// Returns the index of the first mesh of a stage, which is added when it is first used.
    fn stage(&mut self, scene: &Arc<Scene>, color: u32) -> u32 {
        let key = Arc::as_ptr(scene).addr();
        if let Some((_, first)) = self.stages.iter().find(|(known, _)| *known == key) {
            return *first;
        }
        let (meshes, materials) = (scene.meshes.clone(), scene.materials.clone());
        let first = self.merge(meshes, materials, scene.textures.clone(), color);
        self.stages.push((key, first));
        first
    }

    /// Adds meshes with their materials and textures, and returns the index of the first one. Surfaces without a material get the colour.
    fn merge(
        &mut self,
        meshes: Vec<Mesh>,
        own_materials: Vec<Material>,
        own_textures: Vec<Texture>,
        color: u32,
    ) -> u32 {
        let materials = count(self.scene.materials.len());
        let textures = count(self.scene.textures.len());
        let first = count(self.scene.meshes.len());
        self.scene.textures.extend(own_textures);
        let moved = own_materials.into_iter();
        self.scene
            .materials
            .extend(moved.map(|material| material.after_textures(textures)));
        for mut mesh in meshes {
            for span in &mut mesh.materials {
                span.material = Some(span.material.map_or(color, |material| materials + material));
            }
            self.scene.meshes.push(match mesh.materials.is_empty() {
                true => painted(mesh, color),
                false => mesh,
            });
        }
        first
    }

    /// Returns the material of a colour, sRGB.
    fn color(&mut self, color: [f32; 3]) -> u32 {
        let scene = &mut *self.scene;
        let added = self.colors.entry(color.map(f32::to_bits)).or_insert_with(|| {
            scene.materials.push(Material {
                name: format!("robot_{}", scene.materials.len()),
                base_color: Some(color.map(srgb::linear)),
                ..Material::default()
            });
            count(scene.materials.len() - 1)
        });
        *added
    }
}

/// A mesh whose triangles have a material, unless they have colours of their own.
fn painted(mut mesh: Mesh, material: u32) -> Mesh {
    if mesh.colors.is_none() {
        mesh.materials = vec![MaterialSpan {
            end: count(mesh.triangles.len()),
            material: Some(material),
        }];
    }
    mesh
}

fn count(number: usize) -> u32 {
    u32::try_from(number).unwrap_or(u32::MAX)
}
