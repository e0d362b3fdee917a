//! Shading: colour images for stereo matching and for people. It is not a path tracer.
//!
//! Mirrors reflect the scene, and glass shows what lies behind it, up to a number of surfaces (`path`). Textures are filtered over the footprint of a pixel, lamps cast soft shadows, nearby surfaces occlude ambient light, and
//! indirect light is a constant. Sampling is deterministic: every point samples the same spots of
//! lamps and the same directions, and the image decides only which points are sampled and between which ones light is interpolated.

mod arrived;
mod beam;
mod closed;
mod coarse;
mod curvature;
mod dome;
mod edges;
mod expose;
mod film;
mod filter;
mod grain;
mod harmonics;
mod lamp;
mod lobe;
mod mirrored;
mod occlusion;
mod optic;
mod outlines;
mod paint;
mod path;
mod pattern;
mod pyramid;
mod reflect;
mod returns;
mod rig;
mod strength;
mod surfaces;
#[cfg(test)]
mod tests;
mod textures;
mod tiles;
mod tone;
mod visible_pixels;

use std::sync::Arc;

use glam::Vec3;
use oaktwin_base::diagnostic::Finding;
use oaktwin_image::Image;
use oaktwin_image::annotation::Returns;
use oaktwin_image::srgb::srgb_from_linear;
use oaktwin_scene::{Instance, Material, Mesh, Scene};
use oaktwin_simd::Level;
use rayon::prelude::*;

pub use self::beam::{Beam, BeamPattern};
use self::closed::Closed;
use self::coarse::{Coarse, SpareCoarse};
pub(crate) use self::edges::{Corners, corners_of};
use self::expose::Centres;
use self::film::Film;
pub(crate) use self::film::print;
use self::lamp::Emitter;
use self::occlusion::Occlusion;
use self::optic::Optic;
pub(crate) use self::paint::Band;
use self::paint::{Paint, paints};
use self::pattern::Pattern;
pub use self::rig::WHITE;
use self::rig::{LightRig, luminance};
use self::textures::Textures;
use self::tone::Encoder;
use crate::ray::RayCaster;
use crate::rays::Rays;
use crate::spare::Spare;
use crate::{Hit, View, Visibility};

/// Whether a material decides what a time-of-flight camera receives.
pub(crate) fn decides_returns(material: &Material) -> bool {
    material.infrared.is_some() || Optic::new(material).is_some()
}

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
    closed: Arc<Closed>,
    spare: Arc<SpareImages>,
}

/// The memory of earlier images.
#[derive(Debug, Default)]
struct SpareImages {
    colors: Spare<[f32; 3]>,
    bytes: Spare<[u8; 4]>,
    coarse: SpareCoarse,
}

impl ShaderAssets {
    pub(crate) fn new(scene: &Scene) -> Self {
        Self {
            textures: Arc::new(Textures::new(scene)),
            pattern: Arc::new(Pattern::new()),
            closed: Arc::new(Closed::new(scene)),
            spare: Arc::default(),
        }
    }

    /// Makes room for meshes and textures that were added to the scene.
    pub(crate) fn add(&mut self, scene: &Scene) {
        self.closed = Arc::new(Closed::new(scene));
        // Shaders, which share the textures, are dropped whenever the scene changes.
        match Arc::get_mut(&mut self.textures) {
            Some(textures) => textures.add(scene),
            None => self.textures = Arc::new(Textures::new(scene)),
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
        let paints = paints(scene, &self.textures, Band::Visible);
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
    closed: &'a Closed,
    occlusion: Occlusion<'a>,
    coarse: Coarse,
    film: Film,
    spare: &'a SpareImages,
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

/// A colour image.
pub(crate) struct Shaded {
    /// sRGB and coverage: 255, or 0 for a miss, which has the colour of the sky.
    pub(crate) rgb: Image<[u8; 4]>,
    /// The distance at which the brightest surface in each pixel appears to be, in mirrors and behind glass, divided by the distance of
    /// the first surface; `None` if it is 1 everywhere.
    pub(crate) stretch: Option<Image<f32>>,
    /// The light of the colours, if it is kept: linear, in the exposure of the scene, and coverage.
    pub(crate) light: Option<Image<[f32; 4]>>,
}

/// The luminance from the scene's lights and from a beam.
pub(crate) struct LuminanceParts {
    pub(crate) scene: Image<f32>,
    pub(crate) beam: Option<Image<f32>>,
}

impl ShadingContext<'_> {
    /// Antialiases the outlines of an image that was made from the linear colours of pixel centres, by `value`.
    fn smooth<T: Send>(
        &self,
        corners: &Corners<'_>,
        seen: &Visibility,
        colors: &Image<[f32; 3]>,
        image: &mut Image<T>,
        value: impl Fn(Vec3) -> T + Sync,
    ) {
        let mut rgb = self.spare.bytes.image(colors.width(), colors.height(), [0; 4]);
        film::develop(self.film, colors, seen, &mut rgb);
        let outlines = outlines::outlines_of(seen, &rgb, self.level);
        self.spare.bytes.keep(rgb);
        edges::smooth(self, corners, seen, colors, &outlines, image, |pixel, color| {
            *pixel = value(color);
        });
    }
}

impl Shader {
    pub(crate) fn new(scene: &Scene, caster: &RayCaster, assets: ShaderAssets) -> Self {
        Self {
            rig: LightRig::new(scene, caster, &assets.pattern),
            assets,
        }
    }

    /// Returns colours, with antialiased outlines if the corners of pixels are given, and their light if it is kept. The findings name the textures that cannot be
    /// shown, in the order of the scene.
    pub(crate) fn shade(
        &self,
        input: ShadingInput<'_>,
        corners: Option<&Corners<'_>>,
        keeps_light: bool,
        band: Band,
    ) -> (Shaded, Vec<Finding>) {
        self.with_context(input, Film::Tones, band, |context| {
            let Centres { colors, stretch } = context.centres(input.rays, input.seen);
            let (width, height) = (colors.width(), colors.height());
            let mut rgb = Image::filled(width, height, [0; 4]);
            film::develop(context.film, &colors, input.seen, &mut rgb);
            let mut kept = keeps_light.then(|| colors.clone());
            if let Some(corners) = corners {
                let outlines = outlines::outlines_of(input.seen, &rgb, context.level);
                let (seen, encoder) = (input.seen, Encoder::new());
                match &mut kept {
                    None => edges::smooth(
                        context,
                        corners,
                        seen,
                        &colors,
                        &outlines,
                        &mut rgb,
                        |pixel, color| {
                            let [r, g, b] = Film::Tones.srgb(color, encoder);
                            *pixel = [r, g, b, pixel[3]];
                        },
                    ),
                    Some(kept) => {
                        edges::smooth(
                            context,
                            corners,
                            seen,
                            &colors,
                            &outlines,
                            kept,
                            |pixel, color| {
                                *pixel = color.to_array();
                            },
                        );
                        film::develop(context.film, kept, seen, &mut rgb);
                    }
                }
            }
            context.spare.colors.keep(colors);
            Shaded {
                rgb,
                stretch,
                light: kept.map(|kept| film::light(&kept, input.seen)),
            }
        })
    }

    /// Returns linear colours in the exposure of the scene, with antialiased outlines. The findings are as in [`Shader::shade`].
    pub(crate) fn radiance(
        &self,
        input: ShadingInput<'_>,
        corners: &Corners<'_>,
    ) -> (Image<[f32; 3]>, Vec<Finding>) {
        self.with_context(input, Film::Linear, Band::Visible, |context| {
            let colors = context.centres(input.rays, input.seen).colors;
            let mut smooth = colors.clone();
            context.smooth(corners, input.seen, &colors, &mut smooth, |color| {
                color.to_array()
            });
            context.spare.colors.keep(colors);
            smooth
        })
    }

    /// Returns linear luminance, with antialiased outlines, and the luminance that a beam adds; 1 is a white diffuse surface in
    /// typical light. The findings are as in [`Shader::shade`].
    pub(crate) fn luminance(
        &self,
        input: ShadingInput<'_>,
        corners: Option<&Corners<'_>>,
        beam: Option<&Beam<'_>>,
    ) -> (LuminanceParts, Vec<Finding>) {
        self.with_context(input, Film::Linear, Band::Infrared, |context| {
            let colors = context.centres(input.rays, input.seen).colors;
            let value = |color: Vec3| luminance(color) * (1.0 / WHITE);
            let mut grey = colors.map(|color| value(Vec3::from(*color)));
            if let Some(corners) = corners {
                context.smooth(corners, input.seen, &colors, &mut grey, value);
            }
            context.spare.colors.keep(colors);
            LuminanceParts {
                scene: grey,
                beam: beam.map(|beam| context.beam(&input, beam)),
            }
        })
    }

    /// Returns the light that a time-of-flight camera receives where mirrors, transparent surfaces or given reflectances decide about it.
    pub(crate) fn returns(&self, input: ShadingInput<'_>) -> Returns {
        let (found, _) = self.with_context(input, Film::Linear, Band::Visible, |context| {
            context.returns(&input)
        });
        found
    }

    fn with_context<T>(
        &self,
        input: ShadingInput<'_>,
        film: Film,
        band: Band,
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
        let level = Level::detect();
        let occlusion = Occlusion {
            scene,
            caster,
            rig: &self.rig,
            emitters: &emitters,
            pattern: &self.assets.pattern,
            level,
            eye: view.world_from_camera.translation,
        };
        let spare = &*self.assets.spare;
        let coarse = Coarse::new(view, rays, seen, &occlusion, &spare.coarse);
        let context = ShadingContext {
            scene,
            view,
            rig: &self.rig,
            level,
            paints: paints(scene, &self.assets.textures, band),
            closed: &self.assets.closed,
            occlusion,
            coarse,
            film,
            spare,
        };
        let made = work(&context);
        context.coarse.keep(&spare.coarse);
        (made, findings)
    }

    /// Decodes the textures of the visible surfaces, and of all surfaces if some of the visible ones reflect rays or let them pass; the
    /// findings name those that cannot be decoded.
    fn decode(&self, scene: &Scene, hits: &Image<Hit>) -> Vec<Finding> {
        let mut instances = vec![false; scene.instances.len()];
        let mut last = u32::MAX;
        for hit in hits.pixels() {
            if hit.instance != last {
                last = hit.instance;
                if let Some(is_seen) = instances.get_mut(last as usize) {
                    *is_seen = true;
                }
            }
        }
        let materials_of = |instance: &Instance| -> Vec<&Material> {
            let mesh = scene.meshes.get(instance.mesh as usize);
            let spans = mesh.map_or(&[][..], |mesh| &mesh.materials[..]);
            let used = spans.iter().filter_map(|span| instance.material(span.material));
            used.filter_map(|material| scene.materials.get(material as usize))
                .collect()
        };
        let seen = scene.instances.iter().zip(&instances);
        let mut used: Vec<&Material> = (seen.filter(|(_, is_seen)| **is_seen))
            .flat_map(|(instance, _)| materials_of(instance))
            .collect();
        if used.iter().any(|material| Optic::new(material).is_some()) {
            used = scene.instances.iter().flat_map(materials_of).collect();
        }
        let mut wanted: Vec<u32> = (used.into_iter())
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
