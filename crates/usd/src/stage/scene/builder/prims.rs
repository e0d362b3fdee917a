use std::rc::Rc;

use oaktwin_scene::polygon::{PolygonMesh, Scheme};
use oaktwin_scene::{MaterialSpan, Mesh};

use super::super::blend;
use super::super::context::Context;
use super::super::material::Surface;
use super::super::mesh;
use super::super::primvar::primvar;
use super::super::shape::{self, PrimitiveShape};
use super::super::skin::{self, Skin};
use super::Builder;
use crate::stage::reader::{Outcome, Record};
use crate::stage::value::{floats, text};
use crate::stage::walk::{Walk, is_in_prototype};

/// Identifies prims that share one mesh.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) struct MeshKey {
    /// The prim, or the type and dimensions of a shape.
    what: String,
    material: Option<u32>,
    /// The ancestors from which it inherits primvars.
    inherited: Vec<String>,
}

impl Builder {
    pub(super) fn add_mesh(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        context: &Context,
    ) -> Outcome<()> {
        let skin = self.skin(walk, prim, path, context)?;
        let placed = skin.as_ref().map(|skin| Context {
            stage_from_prim: skin.stage_from_skeleton,
            ..context.clone()
        });
        let placed = placed.as_ref().unwrap_or(context);
        let shared = is_in_prototype(&prim.path) || !self.instancers.is_empty();
        let surface = self.surface_or_opacity(walk, prim, context, path);
        let key =
            shared.then(|| self.mesh_key(prim, prim.path.as_str().to_owned(), surface.as_ref(), context));
        if let Some(known) = key.as_ref().and_then(|key| self.meshes.get(key)) {
            if let Some(mesh) = *known {
                self.place(walk, mesh, path, placed);
            }
            return Ok(());
        }
        let subsets = self.subsets(walk, prim, path, context)?;
        // A mesh has one set of texture coordinates, the set that the first textured material uses.
        let mut surfaces = surface.iter().chain(subsets.iter().map(|(_, surface)| surface));
        let uv = surfaces.clone().find_map(|surface| surface.uv.clone());
        let uv = uv.or_else(|| self.options.texture_coordinates.then(|| "st".to_owned()));
        let bare = surface.is_none() || surfaces.any(|surface| surface.shows_mesh_colors);
        let request = mesh::MeshRequest {
            uv: uv.as_deref(),
            colors: bare,
            refined: self.options.subdivide > 0,
        };
        let mut polygons = mesh::read(walk.reader, prim, context, &request);
        let blended = match blend::read(walk, prim, context)? {
            Ok(Some(blend)) => blend.apply(&mut polygons),
            Ok(None) => Ok(()),
            Err(what) => Err(what),
        };
        if let Err(what) = blended {
            let what = format!("{what}; its blend shapes are not applied");
            self.findings
                .warn("skin", path, what, "bind it to its skeleton again");
        }
        if let Some(Err(what)) = skin.map(|skin| skin.apply(&mut polygons)) {
            self.not_skinned(path, &what);
        }
        polygons.material = surface.as_ref().map(|surface| surface.index);
        polygons.face_materials = subsets
            .into_iter()
            .map(|(faces, surface)| mesh::face_material(faces, surface.index))
            .collect();
        let mesh = self.add_polygons(polygons, path);
        if let Some(key) = key {
            self.meshes.insert(key, mesh);
        }
        if let Some(mesh) = mesh {
            self.place(walk, mesh, path, placed);
        }
        Ok(())
    }

    /// Returns the skin of a mesh, and reports what of it is not applied.
    fn skin(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        context: &Context,
    ) -> Outcome<Option<Skin>> {
        let method = walk
            .reader
            .value(prim, "primvars:skel:skinningMethod")
            .and_then(text);
        if method.is_some_and(|method| method == "dualQuaternion") {
            let what = "its points are moved by linear blending instead of dual quaternions";
            self.findings.warn("unsupported-prim", path, what, "");
        }
        let skin = skin::read(walk, prim, context)?;
        Ok(skin.unwrap_or_else(|what| {
            self.not_skinned(path, &what);
            None
        }))
    }

    fn not_skinned(&mut self, path: &str, what: &str) {
        let what = format!("{what}; its points are not moved");
        self.findings
            .warn("skin", path, what, "bind it to its skeleton again");
    }

    fn mesh_key(
        &self,
        prim: &Record,
        what: String,
        surface: Option<&Rc<Surface>>,
        context: &Context,
    ) -> MeshKey {
        let inherits = |name: &str| (!prim.has(name)).then(|| context.ancestor_with(name)).flatten();
        let uv = surface.and_then(|surface| surface.uv.as_deref()).unwrap_or("st");
        let uv = format!("primvars:{uv}");
        MeshKey {
            what,
            material: surface.map(|surface| surface.index),
            inherited: ["primvars:displayColor", "primvars:normals", uv.as_str()]
                .into_iter()
                .map(|name| inherits(name).map_or_else(String::new, |path| path.as_str().to_owned()))
                .collect(),
        }
    }

    fn add_polygons(&mut self, mut polygons: PolygonMesh, path: &str) -> Option<u32> {
        if self.options.subdivide > 0 && polygons.subdivision.scheme != Scheme::None {
            let (refined, findings) = polygons.subdivided(self.options.subdivide, path);
            polygons = refined;
            self.take(findings);
        }
        if !polygons.has_triangles() {
            self.take(polygons.into_mesh(path).1);
            return None;
        }
        let index = self.push_mesh(Mesh::default())?;
        self.findings.reserve(index);
        self.triangulation.begin(index, polygons, path);
        Some(index)
    }

    pub(super) fn add_shape(&mut self, walk: &Walk<'_>, prim: &Record, path: &str, context: &Context) {
        let Some((shape, warning)) = PrimitiveShape::read(walk.reader, prim) else {
            return;
        };
        if let Some(warning) = warning {
            self.findings.warn("unsupported-prim", path, warning, "");
        }
        if !shape.is_finite() {
            let message = "its dimensions are not finite; it is skipped";
            self.findings
                .warn("shape-measures", path, message, "correct them");
            return;
        }
        let surface = self.surface_or_opacity(walk, prim, context, path);
        let shows_color = surface.as_ref().is_none_or(|surface| surface.shows_mesh_colors);
        let color = shows_color
            .then(|| shape::color(walk.reader, prim, context))
            .flatten();
        // Shapes of equal size and colour share one mesh.
        let key = MeshKey {
            what: format!("{shape:?} {color:?}"),
            material: surface.as_ref().map(|surface| surface.index),
            inherited: Vec::new(),
        };
        let mesh = match self.meshes.get(&key) {
            Some(known) => *known,
            None => {
                let mut mesh = shape.mesh();
                mesh.colors = color;
                if let (Some(surface), Ok(end)) = (&surface, u32::try_from(mesh.triangles.len())) {
                    mesh.materials = vec![MaterialSpan {
                        end,
                        material: Some(surface.index),
                    }];
                }
                let mesh = if mesh.triangles.is_empty() {
                    None
                } else {
                    self.push_mesh(mesh)
                };
                self.meshes.insert(key, mesh);
                mesh
            }
        };
        if let Some(mesh) = mesh {
            self.place(walk, mesh, path, context);
        }
    }

    /// Returns the surface of the material bound to a prim: the first that is understood, else the first.
    fn surface(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        context: &Context,
        path: &str,
    ) -> Option<Rc<Surface>> {
        let mut first = None;
        for material in context.bindings.candidates(&prim.path, path) {
            let surface =
                self.materials
                    .surface(walk.reader, material, path, &mut self.scene, &mut self.findings);
            match surface {
                Some(surface) if surface.understood => return Some(surface),
                surface => first = first.or(surface),
            }
        }
        first
    }

    /// Returns the surface of the bound material, or one with the prim's display opacity if no material is bound.
    fn surface_or_opacity(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        context: &Context,
        path: &str,
    ) -> Option<Rc<Surface>> {
        let bound = self.surface(walk, prim, context, path);
        if bound.is_some() {
            return bound;
        }
        let values = primvar(walk.reader, prim, context, "primvars:displayOpacity", floats)?.values;
        let first = *values.first()?;
        #[expect(clippy::cast_precision_loss, reason = "a mean")]
        let mean = values.iter().sum::<f32>() / values.len() as f32;
        let is_constant = values.iter().all(|value| *value == first);
        let opacity = if is_constant { first } else { mean };
        if !is_constant {
            let what = format!("its displayOpacity varies; it is {opacity} everywhere");
            self.findings.warn(
                "unsupported-material",
                path,
                what,
                "bind a material with an opacity texture",
            );
        }
        (self.materials).of_opacity(opacity, path, &mut self.scene, &mut self.findings)
    }

    /// Returns the face subsets that have their own material.
    fn subsets(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        context: &Context,
    ) -> Outcome<Vec<(Vec<i32>, Rc<Surface>)>> {
        let mut found = Vec::new();
        for (name, child) in prim.child_paths() {
            let subset = walk.record(&child, is_in_prototype(&child))?;
            if subset.type_name.as_str() != "GeomSubset" || !subset.active {
                continue;
            }
            let Some(faces) = mesh::subset_faces(walk.reader, &subset) else {
                continue;
            };
            let opinions = subset.opinions(walk.reader);
            let path = format!("{path}/{name}");
            if let Some(surface) = self.surface(walk, &subset, &context.with(opinions, &path), &path) {
                found.push((faces, surface));
            }
        }
        Ok(found)
    }
}
