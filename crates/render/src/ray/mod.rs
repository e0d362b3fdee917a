//! Rays into the scene, for every lens, for shadows and for whatever else asks.

pub(crate) mod brute;

use oaktwin_camera::math::DVec3;
use oaktwin_image::ZDepth;
use oaktwin_scene::Scene;

use crate::{View, Visibility};

/// What the ray caster prepares of a scene.
#[derive(Debug)]
pub(crate) struct RayCaster;

impl RayCaster {
    pub(crate) fn new(_scene: &Scene) -> Self {
        Self
    }

    pub(crate) fn depth(&self, scene: &Scene, view: &View) -> ZDepth {
        self.visibility(scene, view).z
    }

    pub(crate) fn visibility(&self, scene: &Scene, view: &View) -> Visibility {
        brute::visibility(scene, view)
    }

    /// Whether anything lies on the ray between `near` and `far`, in lengths of `direction`; in the world, metres.
    #[expect(dead_code, reason = "shadows come next")]
    pub(crate) fn is_occluded(
        &self,
        scene: &Scene,
        origin: DVec3,
        direction: DVec3,
        near: f64,
        far: f64,
    ) -> bool {
        brute::is_occluded(scene, origin, direction, near, far)
    }
}
