//! Shading: colour images for stereo matching and for people. It is not a path tracer.
//!
//! Textures are filtered over the footprint of a pixel, lamps cast soft shadows, nearby surfaces occlude ambient light, and
//! indirect light is a constant. Sampling is deterministic: the position in the image selects the samples of lamps and
//! surroundings from a periodic pattern, and a filter over the pattern's period removes the pattern.

mod beam;
mod coarse;
mod dome;
mod edges;
mod film;
mod harmonics;
mod lamp;
mod occlusion;
mod paint;
mod pattern;
mod pyramid;
mod reflect;
mod rig;
#[cfg(test)]
mod tests;
mod textures;
mod tone;

use std::sync::Arc;

use glam::Vec3;
use oaktwin_camera::math::DVec3;
use oaktwin_diagnostic::Finding;
use oaktwin_image::Image;
use oaktwin_image::srgb::srgb_from_linear;
use oaktwin_scene::{Mesh, Scene};
use oaktwin_simd::{Level, run_lanes_at};
use rayon::prelude::*;

pub use self::beam::{Beam, BeamPattern};
use self::coarse::{Coarse, place};
pub(crate) use self::edges::{Corners, corners_of};
use self::film::Film;
use self::lamp::Emitter;
use self::occlusion::Occlusion;
use self::paint::{Layer, Paint, paints};
use self::pattern::Pattern;
use self::reflect::{Facet, Facets, Radiance};
use self::rig::{LightRig, WHITE, luminance};
use self::textures::Textures;
use crate::annotate::{Surface, SurfaceFinder};
use crate::ray::{RayCaster, Stack};
use crate::rays::Rays;
use crate::{Hit, View, Visibility};

/// The data that shading needs of a scene beside its triangles.
#[derive(Debug)]
pub(crate) struct Shader {
    assets: ShaderAssets,
    rig: LightRig,
}

/// The part of that data that does not depend on poses.
#[derive(Clone, Debug)]
pub(crate) struct ShaderAssets {
    textures: Arc<Textures>,
    pattern: Arc<Pattern>,
}

impl ShaderAssets {
    pub(crate) fn new(scene: &Scene) -> Self {
        Self {
            textures: Arc::new(Textures::new(scene)),
            pattern: Arc::new(Pattern::new()),
        }
    }

    /// Returns the mean sRGB colour of each triangle of a mesh, without light.
    pub(crate) fn flat_colors(&self, scene: &Scene, mesh: &Mesh) -> Vec<[u8; 3]> {
        let spans = mesh.materials.iter().filter_map(|span| span.material);
        let used = spans.filter_map(|material| scene.materials.get(material as usize));
        for texture in used.filter_map(|material| material.base_color_texture) {
            // A surface whose texture cannot be decoded is grey; rendering reports the texture.
            let _ = self.textures.get(scene, texture.texture);
        }
        let paints = paints(scene, &self.textures);
        let color = |triangle: u32| {
            let material = mesh
                .material(triangle)
                .and_then(|index| paints.get(index as usize));
            let linear = material.unwrap_or(&Paint::BARE).flat(mesh, triangle as usize);
            linear.to_array().map(srgb_from_linear)
        };
        (0..).take(mesh.triangles.len()).map(color).collect()
    }
}

/// The data that all pixels of an image are shaded with.
struct ShadingContext<'a> {
    scene: &'a Scene,
    view: &'a View,
    rig: &'a LightRig,
    level: Level,
    paints: Vec<Paint<'a>>,
    occlusion: Occlusion<'a>,
    coarse: Coarse,
    film: Film,
}

/// The input of shading: a scene, its ray caster, a view and the visible surfaces.
#[derive(Clone, Copy)]
pub(crate) struct ShadingInput<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) caster: &'a RayCaster,
    pub(crate) view: &'a View,
    pub(crate) rays: &'a Rays<'a>,
    pub(crate) seen: &'a Visibility,
}

/// The luminance from the scene's lights and from a beam.
pub(crate) struct LuminanceParts {
    pub(crate) scene: Image<f32>,
    pub(crate) beam: Option<Image<f32>>,
}

impl Shader {
    pub(crate) fn new(scene: &Scene, caster: &RayCaster, assets: ShaderAssets) -> Self {
        Self {
            rig: LightRig::new(scene, caster, &assets.pattern),
            assets,
        }
    }

    /// Returns sRGB and coverage: 255, or 0 for a miss, which has the colour of the sky. Outlines are antialiased if the
    /// corners of pixels are given. The findings name the textures that cannot be shown, in the order of the scene.
    pub(crate) fn shade(
        &self,
        input: ShadingInput<'_>,
        corners: Option<&Corners<'_>>,
    ) -> (Image<[u8; 4]>, Vec<Finding>) {
        self.with_context(input, Film::Tones, |context| {
            let colors = context.centres(input.rays, input.seen);
            let mut rgb = film::developed(context.film, &colors, input.seen);
            if let Some(corners) = corners {
                let outlines = edges::outlines_of(context.film, input.seen, &colors);
                edges::smooth(
                    context,
                    corners,
                    input.seen,
                    &colors,
                    &outlines,
                    &mut rgb,
                    |pixel, color| {
                        let [r, g, b] = Film::Tones.srgb(color);
                        *pixel = [r, g, b, pixel[3]];
                    },
                );
            }
            rgb
        })
    }

    /// Returns linear luminance, with antialiased outlines, and the luminance that a beam adds; 1 is a white diffuse surface in
    /// typical light. The findings are those of [`Shader::shade`].
    pub(crate) fn luminance(
        &self,
        input: ShadingInput<'_>,
        corners: Option<&Corners<'_>>,
        beam: Option<&Beam<'_>>,
    ) -> (LuminanceParts, Vec<Finding>) {
        self.with_context(input, Film::Linear, |context| {
            let colors = context.centres(input.rays, input.seen);
            let value = |color: Vec3| luminance(color) * (1.0 / WHITE);
            let mut grey = colors.map(|color| value(Vec3::from(*color)));
            if let Some(corners) = corners {
                let outlines = edges::outlines_of(context.film, input.seen, &colors);
                edges::smooth(
                    context,
                    corners,
                    input.seen,
                    &colors,
                    &outlines,
                    &mut grey,
                    |pixel, color| {
                        *pixel = value(color);
                    },
                );
            }
            LuminanceParts {
                scene: grey,
                beam: beam.map(|beam| context.beam(&input, beam)),
            }
        })
    }

    fn with_context<T>(
        &self,
        input: ShadingInput<'_>,
        film: Film,
        work: impl FnOnce(&ShadingContext<'_>) -> T,
    ) -> (T, Vec<Finding>) {
        let ShadingInput {
            scene,
            caster,
            view,
            rays,
            seen,
        } = input;
        let findings = self.decode(scene, &seen.hits);
        let emitters: Vec<Emitter> = (self.rig.lamps.iter())
            .map(|lamp| lamp.seen_from(view.world_from_camera.translation))
            .collect();
        let occlusion = Occlusion {
            scene,
            caster,
            rig: &self.rig,
            emitters: &emitters,
            pattern: &self.assets.pattern,
            eye: view.world_from_camera.translation,
        };
        let coarse = Coarse::new(scene, view, rays, seen, &occlusion);
        let context = ShadingContext {
            scene,
            view,
            rig: &self.rig,
            level: Level::detect(),
            paints: paints(scene, &self.assets.textures),
            occlusion,
            coarse,
            film,
        };
        (work(&context), findings)
    }

    /// Decodes the textures of the visible surfaces; the findings name those that cannot be decoded, or are reduced.
    fn decode(&self, scene: &Scene, hits: &Image<Hit>) -> Vec<Finding> {
        let mut meshes = vec![false; scene.meshes.len()];
        let mut last = u32::MAX;
        for hit in hits.pixels() {
            if hit.instance != last {
                last = hit.instance;
                let mesh =
                    (scene.instances.get(last as usize)).map_or(usize::MAX, |found| found.mesh as usize);
                if let Some(mesh) = meshes.get_mut(mesh) {
                    *mesh = true;
                }
            }
        }
        let seen = (scene.meshes.iter().zip(meshes)).filter_map(|(mesh, is_seen)| is_seen.then_some(mesh));
        let mut wanted: Vec<u32> = seen
            .flat_map(|mesh| &mesh.materials)
            .filter_map(|span| scene.materials.get(span.material? as usize))
            .filter_map(|material| Some(material.base_color_texture?.texture))
            .collect();
        wanted.sort_unstable();
        wanted.dedup();
        let findings: Vec<Option<Finding>> = wanted
            .into_par_iter()
            .map(|texture| {
                let loaded = self.assets.textures.get(scene, texture)?;
                loaded.finding.clone()
            })
            .collect();
        self.rig
            .findings
            .iter()
            .cloned()
            .chain(findings.into_iter().flatten())
            .collect()
    }
}

/// The reused memory of a thread.
struct Workspace<'a> {
    finder: SurfaceFinder<'a>,
    stack: Stack,
    /// The layer of the last triangle.
    layer: Option<(Hit, Layer<'a>)>,
}

/// The target of a ray.
enum Visible {
    /// The exposed colour of the sky.
    Sky(Vec3),
    Facet(Facet),
}

impl ShadingContext<'_> {
    fn workspace(&self) -> Workspace<'_> {
        Workspace {
            finder: SurfaceFinder::new(self.scene, self.view),
            stack: Stack::new(),
            layer: None,
        }
    }

    /// Returns the colour, on film, at the centre of each pixel; black where the lens has no ray.
    fn centres(&self, rays: &Rays<'_>, seen: &Visibility) -> Image<[f32; 3]> {
        let (width, height) = (seen.hits.width(), seen.hits.height());
        let mut colors = Image::filled(width, height, [0.0; 3]);
        let row_length = (width as usize).max(1);
        let rows = colors.pixels_mut().par_chunks_mut(row_length);
        let seen_rows =
            (seen.z.0.pixels().par_chunks(row_length)).zip(seen.hits.pixels().par_chunks(row_length));
        rows.zip(seen_rows).zip(0..height).for_each_init(
            || (self.workspace(), Facets::default()),
            |(workspace, facets), ((row, (depths, hits)), y)| {
                let (mut places, mut count) = ([0; 8], 0);
                for ((z, hit), x) in depths.iter().zip(hits).zip(0..) {
                    let Some(ray) = rays.centre(x, y) else {
                        continue;
                    };
                    let next = || rays.next(x, y, ray);
                    match self.seen([x, y], *hit, ray, next, *z, workspace) {
                        Visible::Sky(color) => {
                            if let Some(pixel) = row.get_mut(x as usize) {
                                *pixel = self.film.exposed(color).to_array();
                            }
                        }
                        Visible::Facet(facet) => {
                            facets.set(count, &facet);
                            places[count] = x as usize;
                            count += 1;
                        }
                    }
                    if count == places.len() {
                        self.expose(facets, &places, row);
                        count = 0;
                    }
                }
                self.expose(facets, &places[..count], row);
            },
        );
        colors
    }

    /// Writes the colours of the first facets into their pixels of a row.
    fn expose(&self, facets: &Facets, places: &[usize], row: &mut [[f32; 3]]) {
        if places.is_empty() {
            return;
        }
        let radiance = self.radiance(facets);
        for (lane, place) in places.iter().enumerate() {
            if let Some(pixel) = row.get_mut(*place) {
                let color = Vec3::from(radiance.map(|channel| channel[lane & 7]));
                *pixel = self.film.exposed(color).to_array();
            }
        }
    }

    fn radiance(&self, facets: &Facets) -> [[f32; 8]; 3] {
        let kernel = Radiance {
            facets,
            emitters: self.occlusion.emitters,
            rig: self.rig,
        };
        run_lanes_at(self.level, kernel)
    }

    /// Returns the colour, on film, along one ray; see [`seen`](Self::seen).
    fn color<'a>(
        &'a self,
        at: [u32; 2],
        hit: Hit,
        ray: DVec3,
        next: impl Fn() -> [Option<DVec3>; 2],
        z: f32,
        workspace: &mut Workspace<'a>,
    ) -> Vec3 {
        let color = match self.seen(at, hit, ray, next, z, workspace) {
            Visible::Sky(color) => color,
            Visible::Facet(facet) => {
                let mut facets = Facets::default();
                facets.set(0, &facet);
                Vec3::from(self.radiance(&facets).map(|channel| channel[0]))
            }
        };
        self.film.exposed(color)
    }

    /// Returns the target of a ray through pixel `(x, y)`; `next` returns the rays of the pixels to the right and below.
    #[inline]
    fn seen<'a>(
        &'a self,
        [x, y]: [u32; 2],
        hit: Hit,
        ray: DVec3,
        next: impl Fn() -> [Option<DVec3>; 2],
        z: f32,
        workspace: &mut Workspace<'a>,
    ) -> Visible {
        let surface = if hit.is_miss() {
            None
        } else {
            workspace.finder.find(hit, ray, z)
        };
        let Some(surface) = surface else {
            let direction = (self.view.world_from_camera.rotation * ray).normalize_or_zero();
            return Visible::Sky(self.rig.background(direction));
        };
        let place = place(&surface, self.view);
        let light = self
            .coarse
            .light(x, y, &place)
            .unwrap_or_else(|| self.occlusion.sample_alone(&place, &mut workspace.stack).shares());
        Visible::Facet(Facet {
            point: place.from_eye,
            normal: surface.normal.as_vec3(),
            finish: self.layer(&surface, hit, workspace).at(&surface, next),
            direct: light.direct,
            ambient: light.ambient,
            sky: light.sky,
        })
    }

    /// Returns the layer of a triangle.
    #[inline]
    fn layer<'a, 'd>(
        &'a self,
        surface: &Surface<'_>,
        hit: Hit,
        workspace: &'d mut Workspace<'a>,
    ) -> &'d Layer<'a> {
        if workspace.layer.as_ref().is_some_and(|(last, _)| *last != hit) {
            workspace.layer = None;
        }
        let (_, layer) = workspace.layer.get_or_insert_with(|| {
            let material = surface.mesh.material(hit.triangle);
            let paint = material.and_then(|index| self.paints.get(index as usize));
            (hit, paint.unwrap_or(&Paint::BARE).layer(surface, hit.triangle))
        });
        layer
    }
}
