use std::sync::OnceLock;

use oaktwin_image::ZDepth;
use oaktwin_scene::Scene;

use crate::annotate::Semantics;
use crate::raster::Rasterizer;
use crate::ray::RayCaster;
use crate::shade::Shader;
use crate::{Backend, Hit, Ray, View, Visibility};

/// A scene that can be rendered any number of times, from any number of threads.
///
/// The data structures of a backend are built when it is first used.
#[derive(Debug)]
pub struct Renderer {
    scene: Scene,
    rasterizer: OnceLock<Rasterizer>,
    ray_caster: OnceLock<RayCaster>,
    semantics: OnceLock<Semantics>,
    shader: OnceLock<Shader>,
}

impl Renderer {
    /// Creates a renderer of a scene.
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

    /// Returns the scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Renders the z-depth of each pixel in metres; `+inf` for a miss.
    #[must_use]
    pub fn depth(&self, view: &View, backend: Backend) -> ZDepth {
        match backend.for_view(view) {
            Backend::Ray => self.ray_caster().depth(&self.scene, view),
            Backend::Auto | Backend::Raster => self.rasterizer().depth(&self.scene, view),
        }
    }

    /// Renders the visible triangle and the z-depth of each pixel.
    #[must_use]
    pub fn visibility(&self, view: &View, backend: Backend) -> Visibility {
        match backend.for_view(view) {
            Backend::Ray => self.ray_caster().visibility(&self.scene, view),
            Backend::Auto | Backend::Raster => self.rasterizer().visibility(&self.scene, view),
        }
    }

    /// Finds the nearest triangle on each ray, both ends included, and its distance in lengths of the ray's direction; of
    /// equally near triangles the first in the scene. `None` for a miss.
    #[must_use]
    pub fn cast_rays(&self, rays: &[Ray]) -> Vec<Option<(f64, Hit)>> {
        self.ray_caster().cast_all(&self.scene, rays)
    }

    /// Tests whether anything lies on each ray between its ends, both excluded.
    #[must_use]
    pub fn occluded(&self, rays: &[Ray]) -> Vec<bool> {
        self.ray_caster().are_occluded(&self.scene, rays)
    }

    pub(crate) fn rasterizer(&self) -> &Rasterizer {
        self.rasterizer
            .get_or_init(|| in_own_pool(|| Rasterizer::new(&self.scene)))
    }

    pub(crate) fn ray_caster(&self) -> &RayCaster {
        self.ray_caster
            .get_or_init(|| in_own_pool(|| RayCaster::new(&self.scene)))
    }

    pub(crate) fn shader(&self) -> &Shader {
        self.shader
            .get_or_init(|| in_own_pool(|| Shader::new(&self.scene, self.ray_caster())))
    }

    pub(crate) fn semantics(&self) -> &Semantics {
        self.semantics.get_or_init(|| Semantics::new(&self.scene))
    }
}

/// Runs a constructor in a new thread pool of the current size. A caller that waits in its own pool would steal other tasks
/// meanwhile, and one of them may need the result: a deadlock.
fn in_own_pool<T: Send>(make: impl FnOnce() -> T + Send) -> T {
    let threads = rayon::current_num_threads();
    let made = std::thread::scope(|scope| {
        let maker = scope.spawn(
            || match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
                Ok(pool) => pool.install(make),
                Err(_) => make(),
            },
        );
        maker.join()
    });
    made.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

#[cfg(test)]
mod tests {
    use rayon::prelude::*;

    use super::*;
    use crate::fixture;

    #[test]
    fn many_views_at_once_wait_for_one_preparation() {
        let mut scene = Scene::default();
        for step in 0..300u16 {
            let z = 3.0 + 0.01 * f64::from(step);
            fixture::placed(
                &mut scene,
                "/Rectangle",
                fixture::rectangle([-z, 0.01 * z], [-1.0, 1.0], z),
            );
        }
        let view = fixture::view();
        let renderer = Renderer::new(scene);
        let alone = Renderer::new(renderer.scene().clone()).depth(&view, Backend::Ray);
        let backends = [Backend::Raster, Backend::Ray, Backend::Ray, Backend::Raster];
        let all: Vec<_> = backends
            .repeat(8)
            .into_par_iter()
            .map(|backend| renderer.depth(&view, backend))
            .collect();
        assert_eq!(all[1], alone);
        assert!(all.chunks(4).all(|chunk| *chunk == all[..4]));
    }
}
