//! The colours of pixels, eight at a time.

use glam::Vec3;
use oaktwin_base::interrupt;
use oaktwin_image::Image;
use oaktwin_simd::run_lanes_at;
use rayon::prelude::*;

use super::ShadingContext;
use super::film::Film;
use super::mirrored::Followed;
use super::occlusion::ShadingPoint;
use super::paint::{Paint, finishes};
use super::path::Arrival;
use super::reflect::Radiance;
use super::strength::Strengths;
use super::surfaces::{Packet, lane_of};
use super::tiles::TILE;
use super::visible_pixels::{VisiblePixel, each_visible_pixel};
use crate::ray::Stack;
use crate::rays::Rays;
use crate::{Hit, Visibility};

/// The reused memory of a thread.
pub(super) struct Workspace<'a> {
    rays: &'a Rays<'a>,
    packet: Packet<'a>,
    strengths: Strengths,
    pub(super) stack: Stack,
    arrivals: Vec<Arrival<'a>>,
    /// The light of each arrival.
    lights: Vec<Vec3>,
}

/// What a pixel sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ExposedPixel {
    /// The colour, on film.
    pub(super) color: Vec3,
    /// The distance at which the pixel's brightest surface appears to be, divided by the distance of the first surface. It differs from 1
    /// in mirrors and behind glass.
    pub(super) stretch: f32,
}

/// The images of what the centres of pixels see.
pub(super) struct Centres {
    /// The colours, on film; black where the lens has no ray.
    pub(super) colors: Image<[f32; 3]>,
    /// [`ExposedPixel::stretch`]; `None` if no material of the scene reflects rays or lets them pass.
    pub(super) stretch: Option<Image<f32>>,
}

impl<'a> ShadingContext<'a> {
    pub(super) fn workspace<'w>(&'w self, rays: &'w Rays<'w>) -> Workspace<'w> {
        Workspace {
            rays,
            packet: Packet::new(self.scene, self.view, rays, self.level),
            strengths: Strengths::default(),
            stack: Stack::default(),
            arrivals: Vec::new(),
            lights: Vec::new(),
        }
    }

    /// Returns what the centre of each pixel sees.
    pub(super) fn centres(&self, rays: &Rays<'_>, seen: &Visibility) -> Centres {
        let (width, height) = (seen.hits.width(), seen.hits.height());
        let mut colors = self.spare.colors.image(width, height, [0.0; 3]);
        let has_optics = self.paints.iter().any(|paint| paint.optic().is_some());
        let mut stretch = has_optics.then(|| Image::filled(width, height, 1.0));
        let row_length = (width as usize).max(1);
        let strip = TILE as usize * row_length;
        let strips = colors.pixels_mut().par_chunks_mut(strip);
        let seen_strips = (seen.z.0.pixels().par_chunks(strip)).zip(seen.hits.pixels().par_chunks(strip));
        let mut no_strips = Vec::new();
        let stretch_strips: Vec<&mut [f32]> = match &mut stretch {
            Some(stretch) => stretch.pixels_mut().chunks_mut(strip).collect(),
            None => {
                no_strips.resize_with(height.div_ceil(TILE) as usize, || [0.0; 0]);
                no_strips.iter_mut().map(|none| &mut none[..]).collect()
            }
        };
        strips
            .zip(seen_strips)
            .zip(stretch_strips)
            .zip(0..height.div_ceil(TILE))
            .for_each_init(
                || (self.workspace(rays), Vec::new()),
                |(workspace, targets), (((colors, (depths, hits)), stretch), strip)| {
                    workspace.stack.forget();
                    for left in (0..width).step_by(TILE as usize) {
                        if interrupt::is_unwanted() {
                            return;
                        }
                        targets.clear();
                        let columns = left as usize..row_length.min((left + TILE) as usize);
                        let rows = hits.chunks(row_length).zip(depths.chunks(row_length));
                        for (y, (hits, depths)) in (TILE * strip..).zip(rows) {
                            let seen = hits[columns.clone()].iter().zip(&depths[columns.clone()]);
                            let first = (y - TILE * strip) as usize * row_length;
                            for ((hit, z), x) in seen.zip(left..) {
                                targets.push(VisiblePixel {
                                    tag: first + x as usize,
                                    place: [x, y],
                                    hit: *hit,
                                    z: *z,
                                });
                            }
                        }
                        self.colors(targets, workspace, |tag, seen| {
                            if let Some(pixel) = colors.get_mut(tag) {
                                *pixel = seen.color.to_array();
                            }
                            if let Some(pixel) = stretch.get_mut(tag) {
                                *pixel = seen.stretch;
                            }
                        });
                    }
                },
            );
        Centres { colors, stretch }
    }

    /// Computes what the workspace's rays through pixels see, each with its own tag. `put` receives the tags and
    /// what was seen. Rays that the lens does not have are left out.
    pub(super) fn colors<'w>(
        &'w self,
        targets: &mut [VisiblePixel],
        workspace: &mut Workspace<'w>,
        mut put: impl FnMut(usize, ExposedPixel),
    ) {
        each_visible_pixel(targets, self.scene, self.level, |target| {
            let VisiblePixel { tag, place, hit, z } = target;
            let Some(ray) = workspace.packet.ray(place) else {
                return;
            };
            if hit.is_miss() {
                let direction = (self.view.world_from_camera.rotation * ray).normalize_or_zero();
                let seen = ExposedPixel {
                    color: self.film.exposed(self.rig.background(direction)),
                    stretch: 1.0,
                };
                put(tag, seen);
                return;
            }
            if !workspace.packet.has_room_for(hit.instance) {
                self.expose(workspace, &mut put);
            }
            workspace.packet.push(tag, place, ray, hit, z);
        });
        self.expose(workspace, &mut put);
    }

    /// Computes what a packet sees and clears it.
    fn expose<'w>(&'w self, workspace: &mut Workspace<'w>, put: &mut impl FnMut(usize, ExposedPixel)) {
        let Workspace {
            rays,
            packet,
            strengths,
            stack,
            arrivals,
            lights,
        } = workspace;
        if let Some(found) = packet.find() {
            let grain = self.scene.micro_texture.as_ref();
            let finishes = finishes(&self.paints, &found, grain, self.level);
            let (mut shares, known) = self.coarse.light(&found, &self.occlusion, strengths, stack);
            for lane in 0..found.count() {
                if (known >> lane) & 1 == 0 {
                    let place = ShadingPoint::new(&found, lane);
                    shares.set(
                        lane,
                        self.occlusion.sample_alone(&place, strengths, stack).shares(),
                    );
                }
            }
            let followed = Followed::new(self, rays, &found, &finishes, stack, arrivals);
            let radiance = |own, film| {
                let kernel = Radiance {
                    surfaces: found.surfaces,
                    finishes: &finishes,
                    shares: &shares,
                    emitters: self.occlusion.emitters,
                    rig: self.rig,
                    viewer: None,
                    own,
                    film,
                };
                run_lanes_at(self.level, kernel)
            };
            if followed.is_some() {
                self.lights(arrivals, lights, strengths, stack);
            }
            let (colors, matt) = match &followed {
                None => (radiance(None, self.film), None),
                Some(followed) => (
                    radiance(Some(&followed.own), Film::Linear),
                    Some(radiance(Some(&followed.own.matt()), Film::Linear)),
                ),
            };
            for lane in 0..found.count() {
                let own = lane_of(&colors, lane);
                let seen = match followed.as_ref().zip(matt.as_ref()) {
                    None => ExposedPixel {
                        color: own,
                        stretch: 1.0,
                    },
                    Some((followed, matt)) => {
                        let own = [own, lane_of(matt, lane)];
                        let range = f64::from(found.surfaces.range[lane & 7]);
                        let (light, distance) = followed.gathered(lane, own, range, arrivals, lights);
                        #[expect(clippy::cast_possible_truncation, reason = "a ratio near 1")]
                        ExposedPixel {
                            color: self.film.exposed(light),
                            stretch: (distance / range) as f32,
                        }
                    }
                };
                put(found.tag(lane), seen);
            }
        }
        packet.clear();
    }

    #[inline]
    pub(super) fn paint(&self, hit: Hit) -> &Paint<'a> {
        let found = self.scene.instances.get(hit.instance as usize);
        let material = found.and_then(|instance| {
            let mesh = self.scene.meshes.get(instance.mesh as usize)?;
            instance.material(mesh.material(hit.triangle))
        });
        let paint = material.and_then(|index| self.paints.get(index as usize));
        paint.unwrap_or(&Paint::BARE)
    }
}
