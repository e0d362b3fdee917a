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
        self.rasterizer
            .get_or_init(|| apart(|| Rasterizer::new(&self.scene)))
    }

    pub(crate) fn ray_caster(&self) -> &RayCaster {
        self.ray_caster
            .get_or_init(|| apart(|| RayCaster::new(&self.scene)))
    }

    pub(crate) fn shader(&self) -> &Shader {
        self.shader
            .get_or_init(|| apart(|| Shader::new(&self.scene, self.ray_caster())))
    }

    pub(crate) fn semantics(&self) -> &Semantics {
        self.semantics.get_or_init(|| Semantics::new(&self.scene))
    }
}

/// Makes something with threads of its own, as many as the caller's. A caller that waited in its own pool would take up
/// other work meanwhile, which may need what is being made: it would wait for itself.
fn apart<T: Send>(make: impl FnOnce() -> T + Send) -> T {
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
