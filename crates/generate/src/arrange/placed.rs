use std::sync::Arc;

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::DVec3;
use oaktwin_scene::Bounds;
use serde::Serialize;

use super::look::DrawnLook;
use super::pose::serialize_pose;
use crate::world::{Asset, Hull};

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
    /// The index of its rule.
    #[serde(skip)]
    pub(super) rule: usize,
    /// Its number among the objects of its rule.
    #[serde(skip)]
    pub(super) index: u64,
    /// Its number among all objects.
    #[serde(skip)]
    pub(super) serial: usize,
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
    pub(super) bounds: Bounds,
}

impl Placed {
    pub(super) fn move_to(&mut self, pose: RigidTransform) {
        self.center = pose.apply(self.hull.center);
        self.bounds = bounds_at(&self.hull, &pose);
        self.world_from_object = pose;
    }

    /// Whether a point is inside the object's hull, or nearer to it than a distance in metres.
    pub(crate) fn is_within(&self, point: DVec3, distance: f64) -> bool {
        let nearest = point.clamp(self.bounds.min, self.bounds.max);
        (nearest - point).length() <= distance
            && self.hull.distance(self.world_from_object.inverse().apply(point)) <= distance
    }
}

pub(super) fn bounds_at(hull: &Hull, pose: &RigidTransform) -> Bounds {
    let corners = hull.corners().map(|corner| Bounds::of(pose.apply(corner)));
    corners
        .reduce(Bounds::union)
        .unwrap_or(Bounds::of(pose.translation))
}
