use oaktwin_camera::math::DAffine3;
use oaktwin_scene::{Instance, Label};
use openusd::sdf::Path;

use super::super::context::Context;
use super::super::instancer::PointInstancer;
use super::{Builder, Children};
use crate::stage::prim_opinions::PrimOpinions;
use crate::stage::reader::{Outcome, Record};
use crate::stage::walk::{VisitedPrim, Visitor, Walk, Which};

/// Marks the name of a prim inside a point instancer's prototype until its point is known. No path starts with it.
const PROTOTYPE_PREFIX: &str = "[]";

impl Builder {
    pub(super) fn add_points(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        opinions: &PrimOpinions,
        context: &Context,
    ) -> Outcome<()> {
        if self.instancers.contains(&prim.path) {
            let message = "contains itself through its prototypes";
            self.findings
                .warn("point-instancer", path, message, "remove it from its prototypes");
            return Ok(());
        }
        let instancer = PointInstancer::read(walk.reader, prim, path, &mut self.findings);
        let prototypes = self.parts_of_prototypes(walk, prim, path, opinions, context, &instancer)?;
        let outer = if self.instancers.is_empty() {
            self.world(context.stage_from_prim)
        } else {
            context.stage_from_prim
        };
        for point in &instancer.points {
            let world_from_prototype = outer * point.instancer_from_prototype;
            for part in &prototypes[point.prototype] {
                let point_path = format!("{path}[{}]", point.index);
                let labels = part.labels.iter().map(|label| Label {
                    prim: match label.prim.strip_prefix(PROTOTYPE_PREFIX) {
                        Some(inside) => format!("{point_path}{inside}"),
                        None => label.prim.clone(),
                    },
                    ..label.clone()
                });
                self.push_instance(
                    walk,
                    Instance {
                        mesh: part.mesh,
                        labels: labels.collect(),
                        path: point_path + &part.path,
                        world_from_mesh: world_from_prototype * part.world_from_mesh,
                        material_offset: 0,
                    },
                );
            }
        }
        Ok(())
    }

    /// Returns the instances that make up each prototype of a point instancer, in the frame of the prototype's parent.
    fn parts_of_prototypes(
        &mut self,
        walk: &Walk<'_>,
        prim: &Record,
        path: &str,
        opinions: &PrimOpinions,
        context: &Context,
        instancer: &PointInstancer,
    ) -> Outcome<Vec<Vec<Instance>>> {
        self.instancers.push(prim.path.clone());
        let before = std::mem::take(&mut self.scene.instances);
        let mut prototypes = Vec::with_capacity(instancer.prototypes.len());
        let mut result = Ok(());
        for prototype in &instancer.prototypes {
            let inner = prototype_context(walk, prim, opinions, context, prototype, |path| {
                self.materials.scene_path(path)
            });
            let path_of_prototype = self.materials.scene_path(prototype);
            result = inner.and_then(|inner| {
                let mut drawing = PrototypeVisitor { builder: self };
                walk.from(
                    &mut drawing,
                    prototype,
                    &path_of_prototype,
                    &inner,
                    Which::Prototype,
                )
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
                    // Labels on prims inside the prototype are renamed for each point; inherited ones are kept.
                    if label.prim == path_of_prototype || label.prim.starts_with(&below) {
                        label.prim.replace_range(..above, PROTOTYPE_PREFIX);
                    }
                }
            }
            if parts.is_empty()
                && instancer
                    .points
                    .iter()
                    .any(|point| point.prototype == prototypes.len())
            {
                let message = format!("its prototype <{prototype}> has no geometry that can be drawn");
                self.findings.warn("point-instancer", path, message, "");
            }
            prototypes.push(parts);
        }
        self.scene.instances = before;
        self.instancers.pop();
        result.map(|()| prototypes)
    }
}

/// Draws the prototypes of a point instancer.
struct PrototypeVisitor<'b> {
    builder: &'b mut Builder,
}

impl Visitor for PrototypeVisitor<'_> {
    type Context = Context;

    fn prim(
        &mut self,
        walk: &Walk<'_>,
        prim: &VisitedPrim,
        path: &str,
        context: &Context,
    ) -> Outcome<Option<Context>> {
        let opinions = prim.opinions(walk.reader);
        let inner = context.with(opinions, path);
        match self.builder.add(walk, prim, path, opinions, &inner)? {
            Children::Visit => Ok(Some(inner.hand_down(prim, opinions))),
            Children::VisitWithoutDrawing => Ok(None),
        }
    }
}

/// Returns what a point instancer's prototype inherits: from the instancer and the prims between them or, if the
/// prototype lies elsewhere, from its own ancestors.
fn prototype_context(
    walk: &Walk<'_>,
    instancer: &Record,
    opinions: &PrimOpinions,
    context: &Context,
    prototype: &Path,
    names: impl Fn(&Path) -> String,
) -> Outcome<Context> {
    let below = prototype.has_prefix(&instancer.path);
    let mut inner = if below {
        context.clone().hand_down(instancer, opinions)
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
        let opinions = ancestor.opinions(walk.reader);
        inner = inner.with(opinions, &names(&path)).hand_down(&ancestor, opinions);
    }
    inner.stage_from_prim = DAffine3::IDENTITY;
    // Prototypes are often kept below invisible prims.
    inner.drawn = true;
    Ok(inner)
}
