//! Reads materials: base colour, roughness, metalness and emission of a shading network.

mod network;
mod opacity;
mod optics;
mod surface;
mod texture;
mod uv;

use std::collections::HashMap;
use std::rc::Rc;

use oaktwin_scene::{Material, Opacity, Scene};
use openusd::sdf::Path;

use super::super::reader::Reader;
use super::super::walk::is_in_prototype;
use super::findings::Findings;
use network::{Node, surface_shader};

pub(super) use texture::Textures;

/// The materials read so far.
pub(super) struct Materials {
    known: HashMap<Path, Option<Rc<Surface>>>,
    /// Materials of prims without one, by the bits of their opacity.
    display: HashMap<u32, Option<Rc<Surface>>>,
    pub(super) textures: Textures,
    /// The first instance of each prototype, which provides scene paths for the prototype's prims.
    prototypes: HashMap<String, String>,
}

/// A material of the scene, with the properties that meshes depend on.
pub(super) struct Surface {
    /// The index of the material in the scene.
    pub(super) index: u32,
    /// The primvar with its texture coordinates.
    pub(super) uv: Option<String>,
    /// Whether the mesh's own colours are visible.
    pub(super) shows_mesh_colors: bool,
    /// Whether its shading network is supported.
    pub(super) understood: bool,
}

impl Materials {
    pub(super) fn new() -> Self {
        Self {
            known: HashMap::new(),
            display: HashMap::new(),
            textures: Textures::default(),
            prototypes: HashMap::new(),
        }
    }

    pub(super) fn name_prototype(&mut self, prototype: &Path, path: &str) {
        self.prototypes
            .entry(prototype.as_str().to_owned())
            .or_insert_with(|| path.to_owned());
    }

    /// Returns the scene path of a path inside a prototype.
    pub(in crate::stage::scene) fn scene_path(&self, path: &Path) -> String {
        let text = path.as_str();
        if is_in_prototype(path) {
            let end = text[1..].find('/').map_or(text.len(), |at| at + 1);
            if let Some(instance) = self.prototypes.get(&text[..end]) {
                return format!("{instance}{}", &text[end..]);
            }
        }
        text.to_owned()
    }

    /// Returns the surface of the material at `path`, or `None` if there is no material.
    pub(super) fn surface(
        &mut self,
        reader: &Reader,
        path: &Path,
        user: &str,
        scene: &mut Scene,
        findings: &mut Findings,
    ) -> Option<Rc<Surface>> {
        if let Some(known) = self.known.get(path) {
            return known.clone();
        }
        // A material inside an instance is its prototype's.
        let canonical = if is_in_prototype(path) || self.prototypes.is_empty() {
            None
        } else {
            reader.stage.prim(path.clone()).prim_in_prototype().ok().flatten()
        };
        let surface = match canonical {
            Some(prim) if prim.path() != path => self.surface(reader, prim.path(), user, scene, findings),
            _ => self.read(reader, path, user, scene, findings),
        };
        self.known.insert(path.clone(), surface.clone());
        surface
    }

    /// Returns the surface of a prim that has an opacity and no material; `None` if it is solid.
    pub(super) fn of_opacity(
        &mut self,
        value: f32,
        user: &str,
        scene: &mut Scene,
        findings: &mut Findings,
    ) -> Option<Rc<Surface>> {
        if let Some(what) = Material::not_a_share("displayOpacity", value) {
            findings.warn("material-value", user, what, "correct the number");
        }
        if let Some(known) = self.display.get(&value.to_bits()) {
            return known.clone();
        }
        let surface = Opacity::new(value, None, 0.0).and_then(|opacity| {
            let index = u32::try_from(scene.materials.len()).ok()?;
            scene.materials.push(Material {
                name: format!("displayOpacity {value}"),
                opacity: Some(opacity),
                ..Material::default()
            });
            Some(Rc::new(Surface {
                index,
                uv: None,
                shows_mesh_colors: true,
                understood: true,
            }))
        });
        self.display.insert(value.to_bits(), surface.clone());
        surface
    }

    fn read(
        &mut self,
        reader: &Reader,
        path: &Path,
        user: &str,
        scene: &mut Scene,
        findings: &mut Findings,
    ) -> Option<Rc<Surface>> {
        let name = self.scene_path(path);
        let prim = reader.stage.prim(path.clone());
        if prim
            .type_name()
            .ok()
            .flatten()
            .is_none_or(|kind| kind.as_str() != "Material")
        {
            let message = format!("is bound to the material <{name}>, which does not exist");
            findings.warn(
                "missing-material",
                user,
                message,
                "correct the binding, or add the file that defines it",
            );
            return None;
        }
        let mut material = Material {
            name: name.clone(),
            ..Material::default()
        };
        let mut read = surface::SurfaceReading {
            reader,
            place: &name,
            textures: &mut self.textures,
            scene_textures: &mut scene.textures,
            findings,
            uv: None,
        };
        let understood = match surface_shader(reader, path) {
            Some(shader) => read.shader(&shader, &mut material),
            None => {
                read.findings.warn(
                    "unsupported-material",
                    &name,
                    "has no surface shader; using grey",
                    "",
                );
                false
            }
        };
        let uv = read.uv.take();
        if !understood {
            material.base_color.get_or_insert(surface::GREY);
        }
        let surface = Rc::new(Surface {
            index: u32::try_from(scene.materials.len()).ok()?,
            uv: (material.base_color_texture.is_some() || material.masks().next().is_some())
                .then(|| uv.unwrap_or_else(|| "st".to_owned())),
            shows_mesh_colors: material.base_color.is_none() && material.base_color_texture.is_none(),
            understood,
        });
        scene.materials.push(material);
        Some(surface)
    }
}

/// Returns the identifier of a node of a shading network.
fn identifier(reader: &Reader, node: &Node) -> String {
    use super::super::value::text;
    let token = |name| reader.attribute_value(&node.shader, name).and_then(text);
    token("info:id").unwrap_or_default()
}
