//! Placement of objects without interpenetration.

use std::fmt;
use std::sync::Arc;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_scene::Bounds;
use parry3d_f64::query;
use serde::Serialize;

use super::look::{self, DrawnLook};
use super::serialize_pose;
use crate::GenerateError;
use crate::context::Context;
use crate::random::{Numbers, rotation_around, rotation_between};
use crate::recipe::{ObjectRule, Pose};
use crate::world::{Asset, Base, Hull, fall, pose_to_parry};

/// The maximum number of attempts to place all objects.
const REDRAWS: u32 = 8;
/// The cosine of the maximum slope of surfaces on which objects stand: 5 degrees.
const LEVEL: f64 = 0.9962;
/// The maximum distance between a corner at the bottom of an object and the surface below it, metres.
const SUPPORT_M: f64 = 0.003;
/// The maximum number of surfaces above each other.
const MAX_LEVELS: usize = 32;

/// A placed object.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Placed {
    /// The path of its prim.
    pub(crate) path: String,
    pub(crate) label: String,
    pub(crate) file: String,
    pub(crate) scale: f64,
    /// The pose of the scaled object, metres.
    #[serde(serialize_with = "serialize_pose")]
    pub(crate) world_from_object: RigidTransform,
    pub(crate) look: DrawnLook,
    /// The index of its file.
    #[serde(skip)]
    pub(crate) entry: usize,
    #[serde(skip)]
    pub(crate) asset: Arc<Asset>,
    /// The hull of the scaled object.
    #[serde(skip)]
    pub(crate) hull: Hull,
    /// The centre of its box in the world, metres.
    #[serde(skip)]
    pub(crate) center: DVec3,
    #[serde(skip)]
    bounds: Bounds,
}

impl Placed {
    /// Whether a point is inside the object's hull, or nearer to it than a distance in metres.
    pub(crate) fn is_within(&self, point: DVec3, distance: f64) -> bool {
        let nearest = point.clamp(self.bounds.min, self.bounds.max);
        (nearest - point).length() <= distance
            && self.hull.distance(self.world_from_object.inverse().apply(point)) <= distance
    }
}

/// The reasons why attempts failed.
#[derive(Clone, Copy, Debug, Default)]
struct Rejected {
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

/// An object that found no place.
struct NoPlace {
    rule: usize,
    index: u64,
    count: u64,
    rejected: Rejected,
}

pub(super) fn place_objects(
    context: &Context,
    base: usize,
    number: u64,
) -> Result<Vec<Placed>, GenerateError> {
    let mut failure = None;
    for redraw in 0..REDRAWS {
        match try_place(context, base, number, redraw)? {
            Ok(placed) => return Ok(placed),
            Err(no_place) => failure = Some(no_place),
        }
    }
    let Some(NoPlace {
        rule,
        index,
        count,
        rejected,
    }) = failure
    else {
        return Ok(Vec::new());
    };
    let objects = &context.file.recipe.objects[rule];
    Err(GenerateError::NoPlace {
        recipe: context.file.path.clone(),
        place: format!("objects.{rule}"),
        frame: number * context.file.recipe.frames_per_scene,
        problem: format!(
            "no place for object {} of {count} ({}) in {REDRAWS} times {} attempts: of the last ones, {rejected}",
            index + 1,
            objects.files.0.join(", "),
            objects.attempts,
        ),
        remedy: "lower the count, enlarge the region, name other prims in 'on', or raise attempts".to_owned(),
    })
}

/// Places all objects once. The inner error is an object without a place.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "counts are checked to be small"
)]
fn try_place(
    context: &Context,
    base_index: usize,
    number: u64,
    redraw: u32,
) -> Result<Result<Vec<Placed>, NoPlace>, GenerateError> {
    let base = &context.bases[base_index];
    let mut placed: Vec<Placed> = Vec::new();
    for (rule, objects) in context.file.recipe.objects.iter().enumerate() {
        let count = objects
            .count
            .draw(&mut context.random.numbers(&format!("objects.{rule}.count"), number));
        let count = count.round() as u64;
        let region = region_of(context, base, rule)?;
        for index in 0..count {
            let name = format!("objects.{rule}.{index}");
            let mut numbers = context.random.numbers(&format!("{name}#{redraw}"), number);
            let entries: Vec<usize> = context.object_files.of_rule[rule].clone().collect();
            let entry = numbers.pick(&entries).copied().unwrap_or_default();
            let scale = objects.scale.draw(&mut numbers);
            let asset = context.object_files.asset(&context.file, entry)?;
            let file = &context.object_files.entries[entry];
            let hull = asset.hull.scaled(scale).ok_or_else(|| GenerateError::Empty {
                file: file.path.clone(),
            })?;
            let place = Place {
                base,
                rule: objects,
                region,
                hull: &hull,
                upright: rotation_between(asset.scene.up.direction(), base.up()),
                others: &placed,
            };
            match place.find(&mut numbers) {
                Ok(pose) => {
                    let textures = &context.object_textures[rule];
                    let mut numbers = context.random.numbers(&format!("{name}.look"), number);
                    let look = objects.look.as_ref();
                    placed.push(Placed {
                        path: format!("/Generated/{}_{}", identifier(&file.name), placed.len()),
                        label: file.label.clone(),
                        file: file.path.display().to_string(),
                        scale,
                        look: look.and_then(|look| look::draw(look, textures, &mut numbers)),
                        entry,
                        center: pose.apply(hull.center),
                        bounds: bounds_at(&hull, &pose),
                        world_from_object: pose,
                        asset,
                        hull,
                    });
                }
                Err(rejected) => {
                    return Ok(Err(NoPlace {
                        rule,
                        index,
                        count,
                        rejected,
                    }));
                }
            }
        }
    }
    Ok(Ok(placed))
}

/// Returns the region of the objects' centres.
fn region_of(context: &Context, base: &Base, rule: usize) -> Result<Bounds, GenerateError> {
    let objects = &context.file.recipe.objects[rule];
    if let Some(region) = objects.region {
        return Ok(Bounds {
            min: region.min.into(),
            max: region.max.into(),
        });
    }
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

/// A name as a prim's name.
fn identifier(name: &str) -> String {
    let mut text: String = name
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
        .collect();
    if !text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') {
        text.insert(0, '_');
    }
    text
}

fn bounds_at(hull: &Hull, pose: &RigidTransform) -> Bounds {
    let corners = hull.corners().map(|corner| Bounds::of(pose.apply(corner)));
    corners
        .reduce(Bounds::union)
        .unwrap_or(Bounds::of(pose.translation))
}

/// The search for the place of one object.
struct Place<'a> {
    base: &'a Base,
    rule: &'a ObjectRule,
    region: Bounds,
    hull: &'a Hull,
    /// From the file's axes to the world's, upright.
    upright: DMat3,
    others: &'a [Placed],
}

impl Place<'_> {
    fn find(&self, numbers: &mut Numbers) -> Result<RigidTransform, Rejected> {
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
