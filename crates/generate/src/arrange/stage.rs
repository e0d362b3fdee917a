//! The renderer of a base scene, in which arrangements are shown one after the other.

use std::collections::HashMap;
use std::path::PathBuf;

use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_render::Renderer;
use oaktwin_scene::{
    ColorSpace, Instance, Label, Light, LightKind, Material, MicroTexture, Scene, Texture, TextureSource,
};

use super::{Arrangement, DrawnLight, DrawnLook, Placed};
use crate::context::Context;

/// The triangles of objects above which a stage forgets them.
const MAX_TRIANGLES: usize = 20_000_000;

/// A renderer whose scene is a base scene with the objects, looks and lights of an arrangement. The geometry of objects that were
/// shown before is kept.
#[derive(Debug)]
pub(crate) struct Stage {
    base: usize,
    renderer: Renderer,
    /// The contents of the base scene.
    contents: BaseContents,
    /// The first mesh and the first texture of each object that was added, by the entry of its file.
    added: HashMap<usize, [u32; 2]>,
    images: HashMap<PathBuf, u32>,
    triangles: usize,
    /// The instances of each object of the arrangement.
    pub(crate) objects: Vec<std::ops::Range<usize>>,
}

#[derive(Debug)]
struct BaseContents {
    instances: Vec<Instance>,
    materials: Vec<Material>,
    lights: Vec<Light>,
}

impl Stage {
    pub(crate) fn new(context: &Context, base: usize) -> Self {
        let mut scene = context.bases[base].scene.clone();
        let recipe = &context.file.recipe;
        #[expect(
            clippy::cast_possible_truncation,
            reason = "32 bits of the seed are enough for noise"
        )]
        let seed = recipe.seed as u32;
        scene.micro_texture = recipe
            .scene_options
            .micro_texture
            .then(|| MicroTexture::ordinary(seed));
        scene.possible_labels = possible_labels(context);
        let contents = BaseContents {
            instances: scene.instances.clone(),
            materials: scene.materials.clone(),
            lights: scene.lights.clone(),
        };
        Self {
            contents,
            renderer: Renderer::new(scene),
            base,
            added: HashMap::new(),
            images: HashMap::new(),
            triangles: 0,
            objects: Vec::new(),
        }
    }

    /// Whether the stage shows this base scene, and has room for more objects.
    pub(crate) fn suits(&self, arrangement: &Arrangement) -> bool {
        self.base == arrangement.base && self.triangles < MAX_TRIANGLES
    }

    pub(crate) fn renderer(&self) -> &Renderer {
        &self.renderer
    }

    /// Shows an arrangement.
    pub(crate) fn show(&mut self, context: &Context, arrangement: &Arrangement) {
        let mut instances = self.contents.instances.clone();
        let mut materials = self.contents.materials.clone();
        for (rule, look) in context.file.recipe.looks.iter().zip(&arrangement.looks) {
            self.change_look(&mut instances, &mut materials, &rule.prims.0, look, context);
        }
        self.objects.clear();
        for object in &arrangement.objects {
            let first = instances.len();
            self.put(object, &mut instances, &mut materials);
            self.objects.push(first..instances.len());
        }
        let mut lights = match context.file.recipe.light.keep {
            true => self.contents.lights.clone(),
            false => Vec::new(),
        };
        let up = context.bases[self.base].up();
        for (index, light) in arrangement.lights.iter().enumerate() {
            let light = self.light(light, index, up);
            if matches!(light.kind, LightKind::Dome { .. }) {
                lights.retain(|other| !matches!(other.kind, LightKind::Dome { .. }));
            }
            lights.push(light);
        }
        self.renderer.place(instances, materials, lights);
    }

    fn light(&mut self, light: &DrawnLight, index: usize, up: DVec3) -> Light {
        let texture = light.image.clone().map(|image| self.image(image));
        light.light(index, up, texture)
    }

    /// Gives a drawn material to instances of the base scene.
    fn change_look(
        &mut self,
        instances: &mut [Instance],
        materials: &mut Vec<Material>,
        prims: &[String],
        look: &DrawnLook,
        context: &Context,
    ) {
        let Some(look) = look else { return };
        let texture = look.texture.clone().map(|image| self.image(image));
        let material = look.material(texture);
        let base = &context.bases[self.base];
        let count = self.contents.materials.len();
        // A copy for each material of the base scene, so that the offset is the same for all of its meshes.
        let offset = index(materials.len());
        // What is invisible stays so.
        materials.extend((0..count.max(1)).map(|index| {
            Material {
                opacity: self
                    .contents
                    .materials
                    .get(index)
                    .and_then(|material| material.opacity),
                ..material.clone()
            }
        }));
        for (at, instance) in (0..).zip(instances) {
            if base.is_below(at, prims) {
                instance.material_offset = offset;
            }
        }
    }

    /// Adds the instances and materials of an object.
    fn put(&mut self, object: &Placed, instances: &mut Vec<Instance>, materials: &mut Vec<Material>) {
        let [mesh, texture] = self.geometry(object);
        let own = &object.asset.scene;
        let offset = index(materials.len());
        let moved = own
            .materials
            .iter()
            .map(|material| material.clone().after_textures(texture));
        match &object.look {
            Some(look) => {
                let image = look.texture.clone().map(|image| self.image(image));
                let drawn = look.material(image);
                // What is invisible stays so.
                materials.extend(moved.map(|material| Material {
                    opacity: material.opacity,
                    ..drawn.clone()
                }));
            }
            None => materials.extend(moved),
        }
        let pose = &object.world_from_object;
        let world_from_object = DAffine3::from_mat3_translation(pose.rotation, pose.translation)
            * DAffine3::from_scale(DVec3::splat(object.scale));
        for (at, instance) in own.instances.iter().enumerate() {
            instances.push(Instance {
                mesh: instance.mesh + mesh,
                path: match own.instances.len() {
                    1 => object.path.clone(),
                    _ => format!("{}/part_{at}", object.path),
                },
                world_from_mesh: world_from_object * instance.world_from_mesh,
                labels: vec![Label {
                    prim: object.path.clone(),
                    taxonomy: "class".to_owned(),
                    name: object.label.clone(),
                }],
                material_offset: offset,
            });
        }
    }

    /// Returns the first mesh and the first texture of an object, which are added on first use.
    fn geometry(&mut self, object: &Placed) -> [u32; 2] {
        if let Some(first) = self.added.get(&object.entry) {
            return *first;
        }
        let Scene { meshes, textures, .. } = self.renderer.scene();
        let first = [index(meshes.len()), index(textures.len())];
        let own = &object.asset.scene;
        self.triangles += own.meshes.iter().map(|mesh| mesh.triangles.len()).sum::<usize>();
        self.renderer.add(own.meshes.clone(), own.textures.clone());
        self.added.insert(object.entry, first);
        first
    }

    /// Returns the texture of an image file, which is added on first use.
    fn image(&mut self, path: PathBuf) -> u32 {
        if let Some(known) = self.images.get(&path) {
            return *known;
        }
        let texture = index(self.renderer.scene().textures.len());
        let source = TextureSource::File(path.clone());
        self.renderer.add(
            [],
            [Texture {
                source,
                color_space: ColorSpace::Auto,
            }],
        );
        self.images.insert(path, texture);
        texture
    }
}

#[expect(clippy::cast_possible_truncation, reason = "a scene's indices are u32")]
const fn index(length: usize) -> u32 {
    length as u32
}

/// Returns the labels of all objects and of all base scenes.
fn possible_labels(context: &Context) -> Vec<Vec<Label>> {
    let objects = context.object_files.labels().into_iter().map(|name| {
        vec![Label {
            prim: String::new(),
            taxonomy: "class".to_owned(),
            name,
        }]
    });
    let bases = context.bases.iter();
    let bases = bases.flat_map(|base| {
        base.scene
            .instances
            .iter()
            .map(|instance| instance.labels.clone())
    });
    let mut all: Vec<Vec<Label>> = objects.chain(bases).collect();
    all.sort_by(|a, b| names(a).cmp(names(b)));
    all.dedup_by(|a, b| names(a).eq(names(b)));
    all
}

fn names(labels: &[Label]) -> impl Iterator<Item = (&str, &str, &str)> {
    labels
        .iter()
        .map(|label| (label.prim.as_str(), label.taxonomy.as_str(), label.name.as_str()))
}
