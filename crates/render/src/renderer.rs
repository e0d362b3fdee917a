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
mod tests {
    use rayon::prelude::*;

    use super::*;
    use crate::{AnnotateOptions, fixture};

    #[test]
    fn moved_instances_look_as_if_they_had_always_been_there() {
        use oaktwin_camera::math::{DQuat, DVec3};
        use oaktwin_image::annotation::Annotator;

        let mut scene = Scene::default();
        for z in [2.0, 3.0, 4.0] {
            fixture::placed(
                &mut scene,
                "/Part",
                fixture::rectangle([-0.3 * z, 0.1], [-0.5, 0.5], z),
            );
        }
        let view = fixture::view();
        let all = [
            Annotator::DistanceToImagePlane,
            Annotator::Rgb,
            Annotator::Normals,
            Annotator::InstanceIdSegmentation,
        ];
        let render = |renderer: &Renderer, backend| {
            format!(
                "{:?}",
                renderer.annotate(&view, &all, backend, &AnnotateOptions::default())
            )
        };
        let mut moving = Renderer::new(scene.clone());
        let before = render(&moving, Backend::Ray);
        for step in 1..4_u32 {
            let turn = DQuat::from_rotation_z(0.3 * f64::from(step));
            let pose =
                DAffine3::from_rotation_translation(turn, DVec3::new(0.2, 0.1, -0.4 * f64::from(step)));
            moving.set_poses([(1, pose), (7, pose)]);
            scene.instances[1].world_from_mesh = pose;
            for backend in [Backend::Ray, Backend::Raster] {
                let after = render(&moving, backend);
                assert!(
                    after == render(&Renderer::new(scene.clone()), backend),
                    "{backend:?}"
                );
                assert_ne!(after, before);
            }
        }
    }

    #[test]
    fn replaced_instances_look_as_if_they_had_always_been_there() {
        use oaktwin_image::annotation::Annotator;
        use oaktwin_scene::MaterialSpan;

        let red = |value: f32| Material {
            base_color: Some([value, 0.1, 0.1]),
            ..Material::default()
        };
        let mut scene = Scene::default();
        for z in [2.0, 3.0, 4.0] {
            let mut mesh = fixture::rectangle([-0.3 * z, 0.1], [-0.5, 0.5], z);
            mesh.materials = vec![MaterialSpan {
                end: 2,
                material: Some(0),
            }];
            fixture::placed(&mut scene, "/Part", mesh);
        }
        scene.materials = vec![red(0.9)];
        let view = fixture::view();
        let all = [
            Annotator::Rgb,
            Annotator::DistanceToImagePlane,
            Annotator::InstanceIdSegmentation,
        ];
        let render = |renderer: &Renderer, backend| {
            format!(
                "{:?}",
                renderer.annotate(&view, &all, backend, &AnnotateOptions::default())
            )
        };
        let mut first = scene.clone();
        first.meshes.truncate(2);
        first.instances.truncate(2);
        let mut moving = Renderer::new(first);
        for backend in [Backend::Ray, Backend::Raster] {
            let _ = render(&moving, backend);
        }
        moving.add(scene.meshes.split_off(2), []);
        let mut other = scene.instances[2].clone();
        other.material_offset = 1;
        let placed = vec![
            scene.instances[1].clone(),
            other.clone(),
            Instance {
                world_from_mesh: DAffine3::from_translation([0.3, 0.1, 0.0].into()),
                ..other
            },
        ];
        let materials = vec![red(0.5), red(0.2)];
        scene.meshes = moving.scene().meshes.clone();
        scene.instances.clone_from(&placed);
        scene.materials.clone_from(&materials);
        moving.place(placed, materials, Vec::new());
        let mut plain = scene.clone();
        plain
            .instances
            .iter_mut()
            .for_each(|instance| instance.material_offset = 0);
        for backend in [Backend::Ray, Backend::Raster] {
            let after = render(&moving, backend);
            assert!(
                after == render(&Renderer::new(scene.clone()), backend),
                "{backend:?}"
            );
            assert_ne!(after, render(&Renderer::new(plain.clone()), backend));
        }
    }

    #[test]
    fn some_blocks_are_rendered_like_the_whole_image() {
        let mut scene = Scene::default();
        for step in 0..300u16 {
            let z = 3.0 - 0.005 * f64::from(step);
            let side = 0.01 * f64::from(step % 17) - 0.1;
            fixture::placed(
                &mut scene,
                "/Rectangle",
                fixture::rectangle([side * z, (side + 0.02) * z], [-1.0, 1.0], z),
            );
        }
        let view = fixture::view();
        let renderer = Renderer::new(scene);
        for backend in [Backend::Ray, Backend::Raster] {
            let whole = renderer.visibility(&view, backend);
            let (width, height) = (whole.hits.width(), whole.hits.height());
            for (across, down) in [(1, 0), (3, 2), (20, 7)] {
                let mut blocks = Blocks::none(width, height);
                for (x, y) in [(0, 0), (width - 1, height - 1), (8 * across, 8 * down + 7)] {
                    blocks.add(x, y);
                }
                let part = renderer.visibility_in(&blocks, &view, backend);
                let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
                let mut compared = 0;
                for (x, y) in places.filter(|(x, y)| blocks.contains(x / 8, y / 8)) {
                    compared += 1;
                    assert_eq!(part.z.0.get(x, y), whole.z.0.get(x, y));
                    assert_eq!(part.hits.get(x, y), whole.hits.get(x, y));
                }
                assert_eq!(compared, 3 * 64);
                assert_ne!(part.hits, whole.hits);
            }
        }
    }

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
