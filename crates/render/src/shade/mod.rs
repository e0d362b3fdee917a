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
mod filter;
mod grain;
mod harmonics;
mod lamp;
mod occlusion;
mod outlines;
mod paint;
mod pattern;
mod pyramid;
mod reflect;
mod rig;
mod strength;
mod surfaces;
mod targets;
#[cfg(test)]
mod tests;
mod textures;
mod tiles;
mod tone;

use std::sync::Arc;

use glam::Vec3;
use oaktwin_base::diagnostic::Finding;
use oaktwin_image::Image;
use oaktwin_image::srgb::srgb_from_linear;
use oaktwin_scene::{Mesh, Scene};
use oaktwin_simd::{Level, run_lanes_at};
use rayon::prelude::*;

pub use self::beam::{Beam, BeamPattern};
use self::coarse::{Coarse, SpareCoarse};
pub(crate) use self::edges::{Corners, corners_of};
use self::film::Film;
use self::lamp::Emitter;
use self::occlusion::Occlusion;
use self::occlusion::Place;
use self::paint::{Paint, finishes, paints};
use self::pattern::Pattern;
use self::reflect::Radiance;
use self::rig::{LightRig, WHITE, luminance};
use self::strength::Strengths;
use self::surfaces::{Packet, lane_of};
use self::targets::{Target, each_target};
use self::textures::Textures;
use self::tiles::TILE;
use self::tone::Encoder;
use crate::ray::{RayCaster, Stack};
use crate::rays::Rays;
use crate::spare::Spare;
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
            spare: Arc::default(),
        }
    }

    /// Makes room for textures that were added to the scene.
    pub(crate) fn add_textures(&mut self, scene: &Scene) {
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
            let (width, height) = (colors.width(), colors.height());
            let mut rgb = Image::filled(width, height, [0; 4]);
            film::develop(context.film, &colors, input.seen, &mut rgb);
            if let Some(corners) = corners {
                let outlines = outlines::outlines_of(input.seen, &rgb, context.level);
                let encoder = Encoder::new();
                edges::smooth(
                    context,
                    corners,
                    input.seen,
                    &colors,
                    &outlines,
                    &mut rgb,
                    |pixel, color| {
                        let [r, g, b] = Film::Tones.srgb(color, encoder);
                        *pixel = [r, g, b, pixel[3]];
                    },
                );
            }
            context.spare.colors.keep(colors);
            rgb
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
        self.with_context(input, Film::Linear, |context| {
            let colors = context.centres(input.rays, input.seen);
            let value = |color: Vec3| luminance(color) * (1.0 / WHITE);
            let mut grey = colors.map(|color| value(Vec3::from(*color)));
            if let Some(corners) = corners {
                let mut rgb = context.spare.bytes.image(colors.width(), colors.height(), [0; 4]);
                film::develop(context.film, &colors, input.seen, &mut rgb);
                let outlines = outlines::outlines_of(input.seen, &rgb, context.level);
                context.spare.bytes.keep(rgb);
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
            context.spare.colors.keep(colors);
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
            paints: paints(scene, &self.assets.textures),
            occlusion,
            coarse,
            film,
            spare,
        };
        let made = work(&context);
        context.coarse.keep(&spare.coarse);
        (made, findings)
    }

    /// Decodes the textures of the visible surfaces; the findings name those that cannot be decoded.
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
        let seen = (scene.instances.iter().zip(instances))
            .filter_map(|(instance, is_seen)| is_seen.then_some(instance));
        let used = seen.flat_map(|instance| {
            let mesh = scene.meshes.get(instance.mesh as usize);
            let spans = mesh.map_or(&[][..], |mesh| &mesh.materials[..]);
            spans.iter().filter_map(|span| instance.material(span.material))
        });
        let mut wanted: Vec<u32> = used
            .filter_map(|material| scene.materials.get(material as usize)?.base_color_texture)
            .map(|texture| texture.texture)
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
    packet: Packet<'a>,
    strengths: Strengths,
    stack: Stack,
}

impl ShadingContext<'_> {
    fn workspace<'a>(&'a self, rays: &'a Rays<'a>) -> Workspace<'a> {
        Workspace {
            packet: Packet::new(self.scene, self.view, rays, self.level),
            strengths: Strengths::default(),
            stack: Stack::new(),
        }
    }

    /// Returns the colour, on film, at the centre of each pixel; black where the lens has no ray.
    fn centres(&self, rays: &Rays<'_>, seen: &Visibility) -> Image<[f32; 3]> {
        let (width, height) = (seen.hits.width(), seen.hits.height());
        let mut colors = self.spare.colors.image(width, height, [0.0; 3]);
        let row_length = (width as usize).max(1);
        let strip = TILE as usize * row_length;
        let strips = colors.pixels_mut().par_chunks_mut(strip);
        let seen_strips = (seen.z.0.pixels().par_chunks(strip)).zip(seen.hits.pixels().par_chunks(strip));
        strips
            .zip(seen_strips)
            .zip(0..height.div_ceil(TILE))
            .for_each_init(
                || (self.workspace(rays), Vec::new()),
                |(workspace, targets), ((colors, (depths, hits)), strip)| {
                    for left in (0..width).step_by(TILE as usize) {
                        targets.clear();
                        let columns = left as usize..row_length.min((left + TILE) as usize);
                        let rows = hits.chunks(row_length).zip(depths.chunks(row_length));
                        for (y, (hits, depths)) in (TILE * strip..).zip(rows) {
                            let seen = hits[columns.clone()].iter().zip(&depths[columns.clone()]);
                            let first = (y - TILE * strip) as usize * row_length;
                            for ((hit, z), x) in seen.zip(left..) {
                                targets.push(Target {
                                    tag: first + x as usize,
                                    place: [x, y],
                                    hit: *hit,
                                    z: *z,
                                });
                            }
                        }
                        self.colors(targets, workspace, |tag, color| {
                            if let Some(pixel) = colors.get_mut(tag) {
                                *pixel = color.to_array();
                            }
                        });
                    }
                },
            );
        colors
    }

    /// Computes the colours, on film, of the workspace's rays through pixels, each with its own tag. `put` receives the tags and
    /// the colours. Rays that the lens does not have are left out.
    fn colors(
        &self,
        targets: &mut [Target],
        workspace: &mut Workspace<'_>,
        mut put: impl FnMut(usize, Vec3),
    ) {
        each_target(targets, self.scene, self.level, |target| {
            let Target { tag, place, hit, z } = target;
            let Some(ray) = workspace.packet.ray(place) else {
                return;
            };
            if hit.is_miss() {
                let direction = (self.view.world_from_camera.rotation * ray).normalize_or_zero();
                put(tag, self.film.exposed(self.rig.background(direction)));
                return;
            }
            if !workspace.packet.has_room_for(hit.instance) {
                self.expose(workspace, &mut put);
            }
            workspace.packet.push(tag, place, ray, hit, z);
        });
        self.expose(workspace, &mut put);
    }

    /// Computes the colours of a packet and clears it.
    fn expose(&self, workspace: &mut Workspace<'_>, put: &mut impl FnMut(usize, Vec3)) {
        let Workspace {
            packet,
            strengths,
            stack,
            ..
        } = workspace;
        if let Some(found) = packet.find() {
            let grain = self.scene.micro_texture.as_ref();
            let finishes = finishes(&self.paints, &found, grain, self.level);
            let (mut shares, known) = self.coarse.light(&found, self.level);
            for lane in 0..found.count() {
                if (known >> lane) & 1 == 0 {
                    let place = Place::new(&found, lane);
                    shares.set(
                        lane,
                        self.occlusion.sample_alone(&place, strengths, stack).shares(),
                    );
                }
            }
            let kernel = Radiance {
                surfaces: found.surfaces,
                finishes: &finishes,
                shares: &shares,
                emitters: self.occlusion.emitters,
                rig: self.rig,
                film: self.film,
            };
            let colors = run_lanes_at(self.level, kernel);
            for lane in 0..found.count() {
                put(found.tag(lane), lane_of(&colors, lane));
            }
        }
        packet.clear();
    }

    #[inline]
    fn paint(&self, hit: Hit) -> &Paint<'_> {
        let found = self.scene.instances.get(hit.instance as usize);
        let material = found.and_then(|instance| {
            let mesh = self.scene.meshes.get(instance.mesh as usize)?;
            instance.material(mesh.material(hit.triangle))
        });
        let paint = material.and_then(|index| self.paints.get(index as usize));
        paint.unwrap_or(&Paint::BARE)
    }
}
