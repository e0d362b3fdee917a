use std::collections::HashMap;
use std::rc::Rc;

use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_diagnostic::{Finding, Level};
use oaktwin_scene::polygon::{PolygonMesh, Scheme};
use oaktwin_scene::{Attribute, Instance, Label, MaterialSpan, Mesh, Scene};
use openusd::sdf::Path;

use super::super::reader::{Outcome, Record};
use super::super::walk::{Visitor, Walk, Which, is_in_prototype};
use super::context::Context;
use super::findings::Findings;
use super::instancer::PointInstancer;
use super::material::{Materials, Surface};
use super::own::Own;
use super::shape::{self, Shape};
use super::{SceneOptions, light, mesh};

/// More than this many things in a scene come from point instancers inside point instancers, not from people.
const MOST_INSTANCES: usize = 20_000_000;
/// Triangles of squashed instances that get a mesh of their own.
const MOST_BAKED_TRIANGLES: usize = 10_000_000;

/// Starts the name of a prim inside a point instancer's original until it is known at which point it stands. No path
/// starts like this.
const INSIDE: &str = "[]";

/// What is known of a kind of prim that is not drawn.
const UNSUPPORTED: [(&str, &str); 13] = [
    ("BasisCurves", "curves are not drawn"),
    ("NurbsCurves", "curves are not drawn"),
    ("HermiteCurves", "curves are not drawn"),
    ("NurbsPatch", "a NURBS patch is not drawn"),
    ("Points", "points are not drawn"),
    ("TetMesh", "a tetrahedral mesh is not drawn"),
    ("Volume", "a volume is not drawn"),
    ("ParticleField", "a particle field is not drawn"),
    ("ParticleField3DGaussianSplat", "a particle field is not drawn"),
    (
        "SkelRoot",
        "its meshes are drawn as they were modelled, not as the skeleton poses them",
    ),
    ("GeometryLight", "a light made of geometry does not shine"),
    ("PortalLight", "a portal does not guide light"),
    ("PluginLight", "a plug-in's light does not shine"),
];

/// Makes a scene of prims.
pub(in crate::stage) struct Builder {
    pub(super) scene: Scene,
    pub(super) findings: Findings,
    options: SceneOptions,
    meters_per_unit: f64,
    materials: Materials,
    /// Meshes that instances share.
    meshes: HashMap<MeshKey, Option<u32>>,
    /// The point instancers whose originals are being read, outermost first.
    instancers: Vec<Path>,
    too_many: bool,
}

/// What makes two prims the same mesh.
#[derive(Clone, PartialEq, Eq, Hash)]
struct MeshKey {
    /// The prim, or the kind and the measures of a shape.
    what: String,
    material: Option<u32>,
    /// From which ancestors it has surface values.
    inherited: Vec<String>,
}

impl Builder {
    pub(in crate::stage) fn new(options: SceneOptions, meters_per_unit: f64, up: oaktwin_scene::Up) -> Self {
        Self {
            scene: Scene {
                up,
                meters_per_unit: oaktwin_scene::MetersPerUnit(meters_per_unit),
                ..Scene::default()
            },
            findings: Findings::default(),
            options,
            meters_per_unit,
            materials: Materials::new(),
            meshes: HashMap::new(),
            instancers: Vec::new(),
            too_many: false,
        }
    }

    /// An instance whose prototype was not seen before: its materials are named after it.
    pub(in crate::stage) fn enter_prototype(&mut self, prototype: &Path, path: &str) {
        self.materials.name_prototype(prototype, path);
    }

    /// Adds what a prim is, at the place that `context` says; whether its children are to be visited for more.
    pub(in crate::stage) fn add(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        own: &Own,
        context: &Context,
    ) -> Outcome<Children> {
        if !context.is_drawn() {
            return Ok(Children::Visit);
        }
        let kind = prim.type_name.as_str();
        match kind {
            "" | "Xform" | "Scope" => {}
            "Mesh" => self.add_mesh(walk, prim, path, context)?,
            "Cube" | "Sphere" | "Cylinder" | "Cylinder_1" | "Cone" | "Capsule" | "Capsule_1" | "Plane" => {
                self.add_shape(walk, prim, path, context);
            }
            "PointInstancer" => {
                self.add_points(walk, prim, path, own, context)?;
                return Ok(Children::VisitWithoutDrawing);
            }
            _ if kind.contains("Light") && self.instancers.is_empty() => {
                if let Some(light) = light::read(
                    walk.reader,
                    prim,
                    path,
                    self.world(context.stage_from_prim),
                    self.scene.up,
                    &mut self.materials,
                    &mut self.scene.textures,
                    &mut self.findings,
                ) {
                    self.scene.lights.push(light);
                }
            }
            _ => {}
        }
        if let Some((_, what)) = UNSUPPORTED.iter().find(|(unsupported, _)| *unsupported == kind) {
            self.findings
                .warn("unsupported-prim", path, format!("{kind}: {what}"), "");
        }
        Ok(Children::Visit)
    }

    /// From a frame in the stage's unit into the world.
    fn world(&self, stage_from_prim: DAffine3) -> DAffine3 {
        DAffine3::from_scale(DVec3::splat(self.meters_per_unit)) * stage_from_prim
    }

    fn add_mesh(&mut self, walk: &Walk<'_>, prim: &Record, path: &str, context: &Context) -> Outcome<()> {
        let shared = is_in_prototype(&prim.path) || !self.instancers.is_empty();
        let surface = self.surface(walk, prim, context, path);
        let key =
            shared.then(|| self.mesh_key(prim, prim.path.as_str().to_owned(), surface.as_ref(), context));
        if let Some(known) = key.as_ref().and_then(|key| self.meshes.get(key)) {
            if let Some(mesh) = *known {
                self.place(mesh, path, context);
            }
            return Ok(());
        }
        let subsets = self.subsets(walk, prim, path, context)?;
        // A mesh with one set of texture coordinates: those that the first material wants.
        let mut surfaces = surface.iter().chain(subsets.iter().map(|(_, surface)| surface));
        let uv = surfaces.clone().find_map(|surface| surface.uv.clone());
        let bare = surface.is_none() || surfaces.any(|surface| surface.shows_mesh_colors);
        let wanted = mesh::Wanted {
            uv: uv.as_deref(),
            colors: bare,
            refined: self.options.subdivide > 0,
        };
        let mut polygons = mesh::read(walk.reader, prim, context, &wanted);
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
            self.place(mesh, path, context);
        }
        Ok(())
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
        let (mesh, findings) = polygons.into_mesh(path);
        self.take(findings);
        if mesh.triangles.is_empty() {
            return None;
        }
        self.push_mesh(mesh)
    }

    fn take(&mut self, findings: Vec<Finding>) {
        for finding in findings {
            self.findings.push(finding);
        }
    }

    fn push_mesh(&mut self, mesh: Mesh) -> Option<u32> {
        let index = u32::try_from(self.scene.meshes.len()).ok()?;
        self.scene.meshes.push(mesh);
        Some(index)
    }

    fn add_shape(&mut self, walk: &Walk<'_>, prim: &Record, path: &str, context: &Context) {
        let Some((shape, odd)) = Shape::read(walk.reader, prim) else {
            return;
        };
        if let Some(odd) = odd {
            self.findings.warn("unsupported-prim", path, odd, "");
        }
        if !shape.is_finite() {
            let message = "its measures are not finite; it is left out";
            self.findings
                .warn("shape-measures", path, message, "correct them");
            return;
        }
        let surface = self.surface(walk, prim, context, path);
        let shows_color = surface.as_ref().is_none_or(|surface| surface.shows_mesh_colors);
        let color = shows_color
            .then(|| shape::color(walk.reader, prim, context))
            .flatten();
        // Shapes of one size and colour are one mesh.
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
            self.place(mesh, path, context);
        }
    }

    /// The surface of the material that a prim is bound to.
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

    /// Faces with materials of their own.
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
            let own = subset.own(walk.reader);
            let path = format!("{path}/{name}");
            if let Some(surface) = self.surface(walk, &subset, &context.with(own, &path), &path) {
                found.push((faces, surface));
            }
        }
        Ok(found)
    }

    /// Places a mesh.
    fn place(&mut self, mesh: u32, path: &str, context: &Context) {
        let world_from_mesh = if self.instancers.is_empty() {
            self.world(context.stage_from_prim)
        } else {
            context.stage_from_prim
        };
        self.push_instance(Instance {
            mesh,
            path: path.to_owned(),
            world_from_mesh,
            labels: context.labels.to_vec(),
        });
    }

    fn push_instance(&mut self, instance: Instance) {
        if self.scene.instances.len() < MOST_INSTANCES {
            self.scene.instances.push(instance);
        } else if !self.too_many {
            self.too_many = true;
            self.findings.push(Finding::new(
                "too-many-instances",
                Level::Error,
                &instance.path,
                format!("the scene has more than {MOST_INSTANCES} things; this and the rest are left out"),
                "look for point instancers inside point instancers",
            ));
        }
    }

    fn add_points(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        own: &Own,
        context: &Context,
    ) -> Outcome<()> {
        if self.instancers.contains(&prim.path) {
            let message = "is, by way of its prototypes, a part of itself";
            self.findings
                .warn("point-instancer", path, message, "remove it from its prototypes");
            return Ok(());
        }
        let instancer = PointInstancer::read(walk.reader, prim, path, &mut self.findings);
        let fragments = self.fragments(walk, prim, path, own, context, &instancer)?;
        let outer = if self.instancers.is_empty() {
            self.world(context.stage_from_prim)
        } else {
            context.stage_from_prim
        };
        for point in &instancer.points {
            let world_from_prototype = outer * point.instancer_from_prototype;
            for part in &fragments[point.prototype] {
                if self.too_many {
                    return Ok(());
                }
                let point_path = format!("{path}[{}]", point.index);
                let labels = part.labels.iter().map(|label| Label {
                    prim: match label.prim.strip_prefix(INSIDE) {
                        Some(inside) => format!("{point_path}{inside}"),
                        None => label.prim.clone(),
                    },
                    ..label.clone()
                });
                self.push_instance(Instance {
                    mesh: part.mesh,
                    labels: labels.collect(),
                    path: point_path + &part.path,
                    world_from_mesh: world_from_prototype * part.world_from_mesh,
                });
            }
        }
        Ok(())
    }

    /// What each prototype of a point instancer consists of, in the frame of its parent.
    fn fragments(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        own: &Own,
        context: &Context,
        instancer: &PointInstancer,
    ) -> Outcome<Vec<Vec<Instance>>> {
        self.instancers.push(prim.path.clone());
        let before = std::mem::take(&mut self.scene.instances);
        let mut fragments = Vec::with_capacity(instancer.prototypes.len());
        let mut result = Ok(());
        for prototype in &instancer.prototypes {
            let inner = prototype_context(walk, prim, own, context, prototype, |path| {
                self.materials.scene_path(path)
            });
            let path_of_prototype = self.materials.scene_path(prototype);
            result = inner.and_then(|inner| {
                let mut drawing = Drawing { builder: self };
                walk.from(&mut drawing, prototype, &path_of_prototype, &inner, Which::Active)
            });
            if result.is_err() {
                break;
            }
            let mut parts = std::mem::take(&mut self.scene.instances);
            let above = path_of_prototype.rfind('/').unwrap_or_default();
            let below = format!("{path_of_prototype}/");
            for part in &mut parts {
                part.path.drain(..above);
                for label in &mut part.labels {
                    // Its own labels are told from those that it inherits by where their names start.
                    if label.prim == path_of_prototype || label.prim.starts_with(&below) {
                        label.prim.replace_range(..above, INSIDE);
                    }
                }
            }
            if parts.is_empty()
                && instancer
                    .points
                    .iter()
                    .any(|point| point.prototype == fragments.len())
            {
                let message = format!("its prototype <{prototype}> has nothing that can be drawn");
                self.findings.warn("point-instancer", path, message, "");
            }
            fragments.push(parts);
        }
        self.scene.instances = before;
        self.instancers.pop();
        result.map(|()| fragments)
    }

    /// The scene, after all prims were added.
    pub(in crate::stage) fn finish(mut self) -> (Scene, Findings) {
        self.drop_or_bake();
        (self.scene, self.findings)
    }

    /// Sees to it that every instance's transform can be inverted.
    fn drop_or_bake(&mut self) {
        let singular = |instance: &Instance| !is_invertible(&instance.world_from_mesh);
        if !self.scene.instances.iter().any(singular) {
            return;
        }
        let mut budget = MOST_BAKED_TRIANGLES;
        for mut instance in std::mem::take(&mut self.scene.instances) {
            if !singular(&instance) {
                self.scene.instances.push(instance);
                continue;
            }
            let place = instance.path.clone();
            if !instance.world_from_mesh.is_finite() {
                let message = "its transform is not finite; it is left out";
                self.findings
                    .warn("singular-transform", &place, message, "correct its transform");
                continue;
            }
            // Without an area there is nothing to see.
            let baked = (!is_thin(&instance.world_from_mesh.matrix3))
                .then(|| self.scene.meshes.get(instance.mesh as usize))
                .flatten()
                .filter(|mesh| mesh.triangles.len() <= budget)
                .map(|mesh| baked(mesh, &instance.world_from_mesh));
            let Some(mesh) = baked else {
                let message = "its transform squashes it to nothing; it is left out";
                self.findings.warn("singular-transform", &place, message, "");
                continue;
            };
            budget -= mesh.triangles.len();
            let Some(index) = self.push_mesh(mesh) else {
                continue;
            };
            instance.mesh = index;
            instance.world_from_mesh = DAffine3::IDENTITY;
            self.scene.instances.push(instance);
            let message = "its transform squashes it flat";
            self.findings.warn("singular-transform", &place, message, "");
        }
    }
}

/// What becomes of a prim's children.
pub(in crate::stage) enum Children {
    Visit,
    /// For cameras and the like, but not to be drawn where they stand.
    VisitWithoutDrawing,
}

/// Draws the originals of a point instancer.
struct Drawing<'b> {
    builder: &'b mut Builder,
}

impl Visitor for Drawing<'_> {
    type Context = Context;

    fn prim(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        context: &Context,
    ) -> Outcome<Option<Context>> {
        let own = prim.own(walk.reader);
        let inner = context.with(own, path);
        match self.builder.add(walk, prim, path, own, &inner)? {
            Children::Visit => Ok(Some(inner.hand_down(prim, own))),
            Children::VisitWithoutDrawing => Ok(None),
        }
    }
}

/// What an original of a point instancer inherits: from the instancer, and from what lies between it and the
/// instancer or, where it is somewhere else, from its own ancestors.
fn prototype_context(
    walk: &Walk<'_>,
    instancer: &Record,
    own: &Own,
    context: &Context,
    prototype: &Path,
    names: impl Fn(&Path) -> String,
) -> Outcome<Context> {
    let below = prototype.has_prefix(&instancer.path);
    let mut inner = if below {
        context.clone().hand_down(instancer, own)
    } else {
        Context {
            labels: context.labels.clone(),
            purpose: context.purpose,
            ..Context::default()
        }
    };
    let mut ancestors: Vec<Path> = prototype
        .strict_ancestors()
        .filter(|path| !(path.is_abs_root() || below && instancer.path.has_prefix(path)))
        .collect();
    ancestors.reverse();
    for path in ancestors {
        let ancestor = walk.record(&path, true)?;
        let own = ancestor.own(walk.reader);
        inner = inner.with(own, &names(&path)).hand_down(&ancestor, own);
    }
    inner.stage_from_prim = DAffine3::IDENTITY;
    // Originals are often kept where they are not seen.
    inner.drawn = true;
    Ok(inner)
}

fn is_invertible(transform: &DAffine3) -> bool {
    let inverse = transform.matrix3.inverse();
    transform.is_finite() && transform.matrix3.determinant() != 0.0 && inverse.is_finite()
}

/// Whether a matrix leaves a line or a point of space.
fn is_thin(matrix: &DMat3) -> bool {
    let DMat3 {
        x_axis,
        y_axis,
        z_axis,
    } = *matrix;
    let area = |a: DVec3, b: DVec3| a.cross(b).length_squared();
    area(x_axis, y_axis) == 0.0 && area(y_axis, z_axis) == 0.0 && area(z_axis, x_axis) == 0.0
}

/// A mesh of its own in the world.
fn baked(mesh: &Mesh, world_from_mesh: &DAffine3) -> Mesh {
    let mut baked = mesh.clone();
    for position in &mut baked.positions {
        let [x, y, z] = position.map(f64::from);
        *position = world_from_mesh
            .transform_point3(DVec3::new(x, y, z))
            .as_vec3()
            .to_array();
    }
    // Its normals lie across the plane that it was squashed into: flat ones are right.
    baked.normals = None::<Attribute<[f32; 3]>>;
    baked
}
