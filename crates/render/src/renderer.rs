use std::sync::OnceLock;

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::math::DAffine3;
use oaktwin_image::ZDepth;
use oaktwin_scene::{Instance, Light, Material, Mesh, Scene, Texture};

use crate::annotate::Semantics;
use crate::blocks::Blocks;
use crate::cutout::{Cutouts, Transparent};
use crate::raster::Rasterizer;
use crate::ray::RayCaster;
use crate::rays::Rays;
use crate::shade::{Corners, Shader, ShaderAssets, ShadingInput, corners_of};
use crate::through::look_through;
use crate::visibility::SpareVisibility;
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
    shader_assets: OnceLock<ShaderAssets>,
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
            shader_assets: OnceLock::new(),
            shader: OnceLock::new(),
        }
    }

    /// Returns the scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Moves instances: sets `world_from_mesh` of those with the given indices. Indices out of range are ignored.
    ///
    /// Only the hierarchy over the instances is built again. The lighting, whose exposure depends on what the lamps illuminate, is
    /// computed again when colour is next rendered.
    pub fn set_poses(&mut self, poses: impl IntoIterator<Item = (usize, DAffine3)>) {
        for (index, world_from_mesh) in poses {
            if let Some(instance) = self.scene.instances.get_mut(index) {
                instance.world_from_mesh = world_from_mesh;
            }
        }
        if let Some(caster) = self.ray_caster.get_mut() {
            caster.place(&self.scene);
        }
        self.shader.take();
    }

    /// Adds meshes and textures, after those that exist.
    pub fn add(
        &mut self,
        meshes: impl IntoIterator<Item = Mesh>,
        textures: impl IntoIterator<Item = Texture>,
    ) {
        self.scene.meshes.extend(meshes);
        self.scene.textures.extend(textures);
        self.shader.take();
        if let Some(rasterizer) = self.rasterizer.get_mut() {
            rasterizer.add_meshes(&self.scene);
        }
        if let Some(caster) = self.ray_caster.get_mut() {
            caster.add_meshes(&self.scene);
        }
        if let Some(assets) = self.shader_assets.get_mut() {
            assets.add(&self.scene);
        }
    }

    /// Replaces all instances, materials and lights. Meshes and textures remain, and so do the data structures built for them.
    pub fn place(&mut self, instances: Vec<Instance>, materials: Vec<Material>, lights: Vec<Light>) {
        self.scene.instances = instances;
        self.scene.materials = materials;
        self.scene.lights = lights;
        if let Some(rasterizer) = self.rasterizer.get_mut() {
            rasterizer.place(&self.scene);
        }
        if let Some(caster) = self.ray_caster.get_mut() {
            caster.place(&self.scene);
        }
        self.semantics.take();
        self.shader.take();
    }

    /// Renders the z-depth of each pixel in metres; `+inf` for a miss.
    #[must_use]
    pub fn depth(&self, view: &View, backend: Backend) -> ZDepth {
        if Cutouts::are_in(&self.scene) {
            let Visibility { z, hits } = self.visibility(view, backend);
            self.spare_visibility(view, backend).keep(None, hits);
            return z;
        }
        match backend.for_view(view) {
            Backend::Ray => self.ray_caster().depth(&self.scene, view),
            Backend::Auto | Backend::Raster => self.rasterizer().depth(&self.scene, view),
        }
    }

    /// Renders the visible triangle and the z-depth of each pixel.
    #[must_use]
    pub fn visibility(&self, view: &View, backend: Backend) -> Visibility {
        let seen = match backend.for_view(view) {
            Backend::Ray => self.ray_caster().visibility(&self.scene, view),
            Backend::Auto | Backend::Raster => self.rasterizer().visibility(&self.scene, view),
        };
        self.cut(view, None, Transparent::Surface, seen)
    }

    /// Renders [`visibility`](Self::visibility) in some blocks; pixels elsewhere are arbitrary.
    pub(crate) fn visibility_in(&self, blocks: &Blocks, view: &View, backend: Backend) -> Visibility {
        let seen = match backend.for_view(view) {
            Backend::Ray => self.ray_caster().visibility_in(blocks, &self.scene, view),
            Backend::Auto | Backend::Raster => self.rasterizer().visibility_in(blocks, &self.scene, view),
        };
        self.cut(view, Some(blocks), Transparent::Surface, seen)
    }

    /// Makes of what a view sees what it sees through clear surfaces: the first surface on each ray that is not clear.
    pub(crate) fn past_clear(&self, view: &View, seen: Visibility) -> Visibility {
        self.cut(view, None, Transparent::Through, seen)
    }

    /// Finds what is seen through the invisible, or clear, parts of surfaces.
    fn cut(
        &self,
        view: &View,
        blocks: Option<&Blocks>,
        transparent: Transparent,
        mut seen: Visibility,
    ) -> Visibility {
        if let Some(cutouts) = self.cutouts() {
            let caster = self.ray_caster();
            look_through(cutouts, caster, &self.scene, view, blocks, transparent, &mut seen);
        }
        seen
    }

    /// Returns the masks of the surfaces that are not solid everywhere, if there are any.
    pub(crate) fn cutouts(&self) -> Option<&Cutouts> {
        Cutouts::are_in(&self.scene)
            .then(|| self.ray_caster().cutouts())
            .flatten()
    }

    /// Returns the masks that cannot be read.
    pub(crate) fn unread_masks(&self) -> Vec<Finding> {
        self.cutouts()
            .map_or_else(Vec::new, |cutouts| cutouts.findings().cloned().collect())
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

    /// Returns the mean sRGB colour of each triangle of a mesh, without light: for overviews. Empty if the scene has no such mesh.
    #[must_use]
    pub fn flat_colors(&self, mesh: usize) -> Vec<[u8; 3]> {
        let mesh = self.scene.meshes.get(mesh);
        mesh.map_or_else(Vec::new, |mesh| {
            self.shader_assets().flat_colors(&self.scene, mesh)
        })
    }

    /// Returns the memory that [`visibility`](Self::visibility) uses.
    pub(crate) fn spare_visibility(&self, view: &View, backend: Backend) -> &SpareVisibility {
        match backend.for_view(view) {
            Backend::Ray => &self.ray_caster().spare,
            Backend::Auto | Backend::Raster => &self.rasterizer().spare,
        }
    }

    pub(crate) fn rasterizer(&self) -> &Rasterizer {
        self.rasterizer
            .get_or_init(|| in_own_pool(|| Rasterizer::new(&self.scene)))
    }

    pub(crate) fn ray_caster(&self) -> &RayCaster {
        self.ray_caster
            .get_or_init(|| in_own_pool(|| RayCaster::new(&self.scene)))
    }

    /// Returns the rays of a view.
    pub(crate) fn rays<'a>(&self, view: &'a View) -> Rays<'a> {
        Rays::with_table(view, || self.ray_caster().table(view))
    }

    /// Returns the input of the shader for a view.
    pub(crate) fn shading<'a>(
        &'a self,
        view: &'a View,
        rays: &'a Rays<'a>,
        seen: &'a Visibility,
    ) -> ShadingInput<'a> {
        ShadingInput {
            scene: self.scene(),
            caster: self.ray_caster(),
            view,
            rays,
            seen,
        }
    }

    /// Returns the corners of a view's pixels.
    pub(crate) fn corners(&self, view: &View, backend: Backend) -> Corners<'_> {
        let view = corners_of(view);
        Corners {
            view,
            render: Box::new(move |blocks| self.visibility_in(blocks, &view, backend)),
            spare: self.spare_visibility(&view, backend),
        }
    }

    fn shader_assets(&self) -> &ShaderAssets {
        self.shader_assets.get_or_init(|| ShaderAssets::new(&self.scene))
    }

    pub(crate) fn shader(&self) -> &Shader {
        let assets = self.shader_assets();
        self.shader
            .get_or_init(|| in_own_pool(|| Shader::new(&self.scene, self.ray_caster(), assets.clone())))
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
mod tests;
