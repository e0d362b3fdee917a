//! From triangles to pixels, for ideal pinholes.

use oaktwin_image::ZDepth;
use oaktwin_scene::Scene;

use crate::{View, Visibility};

/// What the rasterizer prepares of a scene.
#[derive(Debug)]
pub(crate) struct Rasterizer;

impl Rasterizer {
    pub(crate) fn new(_scene: &Scene) -> Self {
        Self
    }

    pub(crate) fn depth(&self, scene: &Scene, view: &View) -> ZDepth {
        self.visibility(scene, view).z
    }

    pub(crate) fn visibility(&self, scene: &Scene, view: &View) -> Visibility {
        crate::ray::brute::visibility(scene, view)
    }
}
