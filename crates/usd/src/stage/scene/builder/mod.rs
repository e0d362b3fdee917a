//! Builds a scene from composed prims.

mod instancing;
mod prims;
mod singular;
mod triangulation;

use std::collections::{BTreeMap, HashMap};

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::math::{DAffine3, DVec3};
use oaktwin_scene::{Instance, Mesh, Scene};
use openusd::sdf::Path;

use super::context::Context;
use super::findings::Findings;
use super::material::Materials;
use super::{SceneOptions, light};
use crate::stage::prim_opinions::PrimOpinions;
use crate::stage::reader::{Outcome, Record};
use crate::stage::walk::Walk;
use prims::MeshKey;
pub(in crate::stage) use singular::is_invertible;
use triangulation::Triangulation;

/// The types of prim that are skipped, and the reason.
const UNSUPPORTED: [(&str, &str); 12] = [
    ("BasisCurves", "curves are not supported; skipped"),
    ("NurbsCurves", "curves are not supported; skipped"),
    ("HermiteCurves", "curves are not supported; skipped"),
    ("NurbsPatch", "NURBS patches are not supported; skipped"),
    ("Points", "points are not supported; skipped"),
    ("TetMesh", "tetrahedral meshes are not supported; skipped"),
    ("Volume", "volumes are not supported; skipped"),
    ("ParticleField", "particle fields are not supported; skipped"),
    (
        "ParticleField3DGaussianSplat",
        "particle fields are not supported; skipped",
    ),
    ("GeometryLight", "geometry lights are not supported; skipped"),
    ("PortalLight", "portal lights are not supported; skipped"),
    ("PluginLight", "plug-in lights are not supported; skipped"),
];

/// Accumulates a scene prim by prim.
pub(in crate::stage) struct Builder {
    pub(super) scene: Scene,
    pub(super) findings: Findings,
    options: SceneOptions,
    meters_per_unit: f64,
    materials: Materials,
    /// The meshes that instances may share; `None` for a mesh without triangles.
    meshes: HashMap<MeshKey, Option<u32>>,
    /// The meshes that are empty in the scene until it is finished.
    triangulation: Triangulation,
    /// The point instancers whose prototypes are being read, outermost first.
    instancers: Vec<Path>,
}

/// How a prim's children are visited.
pub(in crate::stage) enum Children {
    Visit,
    /// Children are visited for cameras and sensors, but not drawn at their own transform.
    VisitWithoutDrawing,
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
            triangulation: Triangulation::default(),
            instancers: Vec::new(),
        }
    }

    /// Records the first instance of a prototype, after which the prototype's materials are named.
    pub(in crate::stage) fn enter_prototype(&mut self, prototype: &Path, path: &str) {
        self.materials.name_prototype(prototype, path);
    }

    /// Adds a prim with the inherited state `context`. Returns how its children are to be visited.
    pub(in crate::stage) fn add(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        opinions: &PrimOpinions,
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
                self.add_points(walk, prim, path, opinions, context)?;
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

    /// Converts a transform in stage units to one into the world, in metres.
    fn world(&self, stage_from_prim: DAffine3) -> DAffine3 {
        DAffine3::from_scale(DVec3::splat(self.meters_per_unit)) * stage_from_prim
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

    /// Adds an instance of a mesh.
    fn place(&mut self, walk: &Walk<'_>, mesh: u32, path: &str, context: &Context) {
        let world_from_mesh = if self.instancers.is_empty() {
            self.world(context.stage_from_prim)
        } else {
            context.stage_from_prim
        };
        self.push_instance(
            walk,
            Instance {
                mesh,
                path: path.to_owned(),
                world_from_mesh,
                labels: context.labels.to_vec(),
                material_offset: 0,
            },
        );
    }

    fn push_instance(&mut self, walk: &Walk<'_>, instance: Instance) {
        walk.reader.budget().instance(&instance.path);
        self.scene.instances.push(instance);
    }

    /// Returns the finished scene.
    pub(in crate::stage) fn finish(mut self) -> (Scene, Findings) {
        let mut of_meshes = BTreeMap::new();
        for done in std::mem::take(&mut self.triangulation).finish() {
            if let Some(mesh) = self.scene.meshes.get_mut(done.index as usize) {
                *mesh = done.mesh;
            }
            of_meshes.insert(done.index, done.findings);
        }
        self.findings.fill(of_meshes);
        self.drop_or_bake();
        (self.scene, self.findings)
    }
}
