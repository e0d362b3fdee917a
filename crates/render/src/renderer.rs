use std::sync::OnceLock;

use oaktwin_image::ZDepth;
use oaktwin_scene::Scene;

use crate::annotate::Semantics;
use crate::raster::Rasterizer;
use crate::ray::RayCaster;
use crate::shade::Shader;
use crate::{Backend, Hit, Ray, View, Visibility};

/// A scene made ready to be rendered any number of times, from any number of threads.
///
/// What a backend needs of its own is made when it is first used.
#[derive(Debug)]
pub struct Renderer {
    scene: Scene,
    rasterizer: OnceLock<Rasterizer>,
    ray_caster: OnceLock<RayCaster>,
    semantics: OnceLock<Semantics>,
    shader: OnceLock<Shader>,
}

impl Renderer {
    /// For this scene.
    #[must_use]
    pub fn new(scene: Scene) -> Self {
        Self {
            scene,
            rasterizer: OnceLock::new(),
            ray_caster: OnceLock::new(),
            semantics: OnceLock::new(),
            shader: OnceLock::new(),
        }
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The distance of what each pixel sees, along the optical axis, metres; `+inf` for a miss.
    #[must_use]
    pub fn depth(&self, view: &View, backend: Backend) -> ZDepth {
        match backend.for_view(view) {
            Backend::Ray => self.ray_caster().depth(&self.scene, view),
            Backend::Auto | Backend::Raster => self.rasterizer().depth(&self.scene, view),
        }
    }

    /// What each pixel sees.
    #[must_use]
    pub fn visibility(&self, view: &View, backend: Backend) -> Visibility {
        match backend.for_view(view) {
            Backend::Ray => self.ray_caster().visibility(&self.scene, view),
            Backend::Auto | Backend::Raster => self.rasterizer().visibility(&self.scene, view),
        }
    }

    /// The nearest triangle on each ray, both its ends included, and how far that is, in lengths of the ray's
    /// direction; of equally near ones the first. `None` for a miss.
    #[must_use]
    pub fn cast_rays(&self, rays: &[Ray]) -> Vec<Option<(f64, Hit)>> {
        self.ray_caster().cast_all(&self.scene, rays)
    }

    /// Whether anything lies on each ray between its ends, which do not count.
    #[must_use]
    pub fn occluded(&self, rays: &[Ray]) -> Vec<bool> {
        self.ray_caster().are_occluded(&self.scene, rays)
    }

    pub(crate) fn rasterizer(&self) -> &Rasterizer {
        self.rasterizer.get_or_init(|| Rasterizer::new(&self.scene))
    }

    pub(crate) fn ray_caster(&self) -> &RayCaster {
        self.ray_caster.get_or_init(|| RayCaster::new(&self.scene))
    }

    pub(crate) fn shader(&self) -> &Shader {
        (self.shader).get_or_init(|| Shader::new(&self.scene, self.ray_caster()))
    }

    pub(crate) fn semantics(&self) -> &Semantics {
        self.semantics.get_or_init(|| Semantics::new(&self.scene))
    }
}
