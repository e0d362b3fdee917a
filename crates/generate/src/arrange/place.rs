//! The search for the place of one object, without interpenetration.

use std::fmt;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_scene::Bounds;
use parry3d_f64::query;

use super::placed::{Placed, bounds_at};
use crate::GenerateError;
use crate::context::Context;
use crate::random::{Numbers, rotation_around, rotation_between};
use crate::recipe::{ObjectRule, Pose};
use crate::world::{Asset, Base, Hull, fall, pose_to_parry};

/// The cosine of the maximum slope of surfaces on which objects stand: 5 degrees.
const LEVEL: f64 = 0.9962;
/// The maximum distance between a corner at the bottom of an object and the surface below it, metres.
const SUPPORT_M: f64 = 0.003;
/// The maximum number of surfaces above each other.
const MAX_LEVELS: usize = 32;

/// The reasons why attempts failed.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Rejected {
    without_surface: u32,
    unsupported: u32,
    colliding: u32,
    outside: u32,
}

impl fmt::Display for Rejected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.without_surface, "found no horizontal surface"),
            (self.unsupported, "extended beyond the edge of a surface"),
            (self.colliding, "collided"),
            (self.outside, "left the region"),
        ];
        let texts = counts.iter().filter(|(count, _)| *count > 0);
        let texts: Vec<String> = texts.map(|(count, text)| format!("{count} {text}")).collect();
        f.write_str(&texts.join(", "))
    }
}

/// Returns the region of the objects' centres.
pub(super) fn region_of(context: &Context, base: usize, rule: usize) -> Result<Bounds, GenerateError> {
    let objects = &context.file.recipe.objects[rule];
    if let Some(region) = objects.region {
        return Ok(Bounds {
            min: region.min.into(),
            max: region.max.into(),
        });
    }
    let base = &context.bases[base];
    base.bounds_of(&objects.on.0).ok_or_else(|| GenerateError::Unfit {
        recipe: context.file.path.clone(),
        place: format!("objects.{rule}.on"),
        problem: format!(
            "there is no prim {} with triangles in {}",
            objects.on.0.join(" or "),
            base.name
        )
        .into(),
        remedy: "name prims of the base scene, from the root: /World/Table".into(),
    })
}

/// The search for the place of one object.
pub(super) struct PlacementSearch<'a> {
    base: &'a Base,
    rule: &'a ObjectRule,
    region: Bounds,
    hull: &'a Hull,
    /// From the file's axes to the world's, upright.
    upright: DMat3,
    others: &'a [Placed],
}

impl<'a> PlacementSearch<'a> {
    pub(super) fn new(
        context: &'a Context,
        base: usize,
        rule: usize,
        asset: &Asset,
        hull: &'a Hull,
        others: &'a [Placed],
    ) -> Result<Self, GenerateError> {
        let region = region_of(context, base, rule)?;
        let base = &context.bases[base];
        Ok(Self {
            base,
            rule: &context.file.recipe.objects[rule],
            region,
            hull,
            upright: rotation_between(asset.scene.up.direction(), base.up()),
            others,
        })
    }

    pub(super) fn find(&self, numbers: &mut Numbers) -> Result<RigidTransform, Rejected> {
        let mut rejected = Rejected::default();
        for _ in 0..self.rule.attempts {
            let rotation = self.rotation(numbers);
            let at = [numbers.uniform(), numbers.uniform(), numbers.uniform()];
            let at = self.region.min + self.region.size() * DVec3::from(at);
            let found = match self.rule.pose {
                Pose::Upright | Pose::Resting => self.stand(rotation, at, numbers, &mut rejected),
                Pose::Piled => self.drop(rotation, at, &mut rejected),
                Pose::Floating => Some(self.centered(rotation, at)),
            };
            let Some(pose) = found else { continue };
            if self.collides(&pose) {
                rejected.colliding += 1;
                continue;
            }
            return Ok(pose);
        }
        Err(rejected)
    }

    fn rotation(&self, numbers: &mut Numbers) -> DMat3 {
        let up = self.base.up();
        let turn = rotation_around(up, std::f64::consts::TAU * numbers.uniform());
        match self.rule.pose {
            Pose::Upright => turn * self.upright,
            Pose::Resting => {
                // A larger face is more likely to be the lower one.
                let total: f64 = self.hull.rests.iter().map(|(_, area)| area).sum();
                let mut left = total * numbers.uniform();
                let face = self.hull.rests.iter().find(|(_, area)| {
                    left -= area;
                    left <= 0.0
                });
                match face.or(self.hull.rests.last()) {
                    Some((normal, _)) => turn * rotation_between(*normal, -up),
                    None => turn * self.upright,
                }
            }
            Pose::Piled | Pose::Floating => numbers.rotation(),
        }
    }

    /// The pose with the centre of the object at a point.
    fn centered(&self, rotation: DMat3, at: DVec3) -> RigidTransform {
        RigidTransform::new(rotation, at - rotation * self.hull.center)
    }

    /// Puts the object on a horizontal surface above or below a point.
    fn stand(
        &self,
        rotation: DMat3,
        at: DVec3,
        numbers: &mut Numbers,
        rejected: &mut Rejected,
    ) -> Option<RigidTransform> {
        let up = self.base.up();
        let heights = self.surfaces(at);
        let Some(&height) = numbers.pick(&heights) else {
            rejected.without_surface += 1;
            return None;
        };
        let level = self.centered(rotation, at - up * at.dot(up));
        let lowest = self.hull.corners().map(|corner| level.apply(corner).dot(up));
        let lowest = lowest.fold(f64::INFINITY, f64::min);
        let raise = height + self.rule.gap_m - lowest;
        let pose = RigidTransform::new(rotation, level.translation + up * raise);
        if self.is_supported(&pose, height) {
            return Some(pose);
        }
        rejected.unsupported += 1;
        None
    }

    /// Returns the heights of the horizontal surfaces above and below a point within the region.
    fn surfaces(&self, at: DVec3) -> Vec<f64> {
        let up = self.base.up();
        let (top, bottom) = (self.region.max.dot(up), self.region.min.dot(up));
        let margin = 1e-3 * (1.0 + top - bottom);
        let mut origin = at + up * (top + margin - at.dot(up));
        let mut heights = Vec::new();
        for level in 0..MAX_LEVELS {
            let reach = origin.dot(up) - bottom + margin;
            let Some(hit) = self.base.cast(origin, -up, reach) else {
                break;
            };
            let is_surface = hit.normal.dot(up) > LEVEL && (hit.is_front || level == 0);
            if is_surface && self.base.is_below(hit.instance, &self.rule.on.0) {
                heights.push(hit.point.dot(up));
            }
            origin = hit.point - up * 1e-6 * (1.0 + reach);
        }
        heights
    }

    /// Whether there is a surface below all of the object's lowest corners.
    fn is_supported(&self, pose: &RigidTransform, height: f64) -> bool {
        let up = self.base.up();
        let bottom = height + self.rule.gap_m + 1e-3;
        let mut corners = self.hull.corners().map(|corner| pose.apply(corner));
        corners.all(|corner| {
            corner.dot(up) > bottom
                || self
                    .base
                    .cast(corner + up * 1e-4, -up, self.rule.gap_m + SUPPORT_M)
                    .is_some()
        })
    }

    /// Lowers the object from the top of the region until it touches something.
    fn drop(&self, rotation: DMat3, at: DVec3, rejected: &mut Rejected) -> Option<RigidTransform> {
        let up = self.base.up();
        let top = self.region.max.dot(up);
        let raised = self.centered(rotation, at + up * (top - at.dot(up)));
        let (reach, gap) = (
            self.region.size().dot(up) + self.base.bounds.size().length(),
            self.rule.gap_m,
        );
        let others = self.others.iter().filter_map(|other| {
            let shape = (&pose_to_parry(&other.world_from_object), &other.hull.shape as _);
            fall(shape, self.hull, &raised, -up, reach, gap)
        });
        let fallen = self.base.fall(self.hull, &raised, -up, reach, gap);
        let Some(fallen) = fallen.into_iter().chain(others).reduce(f64::min) else {
            rejected.without_surface += 1;
            return None;
        };
        let pose = RigidTransform::new(rotation, raised.translation - up * fallen);
        let center = pose.apply(self.hull.center).dot(up);
        if fallen <= 0.0 || center < self.region.min.dot(up) {
            rejected.outside += 1;
            return None;
        }
        Some(pose)
    }

    fn collides(&self, pose: &RigidTransform) -> bool {
        let bounds = bounds_at(self.hull, pose);
        let own = pose_to_parry(pose);
        let hits = |other: &Placed| {
            let is_near =
                bounds.min.cmple(other.bounds.max).all() && other.bounds.min.cmple(bounds.max).all();
            is_near
                && query::intersection_test(
                    &own,
                    &self.hull.shape,
                    &pose_to_parry(&other.world_from_object),
                    &other.hull.shape,
                )
                .is_ok_and(|found| found.intersecting)
        };
        self.others.iter().any(hits)
            || self.base.intersects(self.hull, pose)
            || (self.rule.pose == Pose::Floating && self.base.contains(pose.apply(self.hull.center)))
    }
}
