//! The light of a projector: a point source with a pattern finer than a pixel.

use glam::{Vec2, Vec3};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_image::Image;
use rayon::prelude::*;

use super::optic::Optic;
use super::path::{Arrival, Origin, Tracer, Vertex};
use super::rig::luminance;
use super::surfaces::Spot;
use super::{ShadingContext, ShadingInput};
use crate::Hit;
use crate::annotate::{Surface, SurfaceFinder};
use crate::ray::{Ray, RayCaster, Stack};

/// The samples of a pixel in a row and in a column.
const SAMPLES: u8 = 4;

/// Surfaces this close to the projector, such as its own window, do not block it, metres.
const NEAR_M: f64 = 0.01;

/// A projector in a scene.
#[derive(Clone, Copy)]
pub struct Beam<'a> {
    /// The pose in metres; the axes are `OpenCV`'s, and the beam points along z.
    pub world_from_beam: RigidTransform,
    /// The projected pattern.
    pub pattern: &'a dyn BeamPattern,
}

impl std::fmt::Debug for Beam<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Beam")
            .field("world_from_beam", &self.world_from_beam)
            .finish_non_exhaustive()
    }
}

/// The pattern of a projector as a function of direction, given as (x/z, y/z).
pub trait BeamPattern: Sync {
    /// Returns the luminance of a white diffuse surface at 1 m that faces the projector; 1 is the same surface in the scene's
    /// typical light.
    fn luminance(&self, at: [f32; 2]) -> f32;

    /// Whether the pattern is dark everywhere within a radius. May return false where it is dark.
    fn is_dark_around(&self, at: [f32; 2], radius: f32) -> bool;
}

/// The light of a beam on a surface, relative to a surface at 1 m that faces it, and the pixel's footprint in the pattern.
struct Lit {
    strength: f32,
    footprint: Footprint,
}

/// The footprint of a pixel in the pattern: homogeneous and linear across the pixel, since its surface is flat.
#[derive(Clone, Copy)]
struct Footprint {
    middle: Vec3,
    across: Vec3,
    down: Vec3,
}

impl Footprint {
    /// Returns the direction at a point of the pixel, −½ to ½ from its centre.
    #[inline]
    fn at(&self, x: f32, y: f32) -> Vec2 {
        let p = self.middle + self.across * x + self.down * y;
        Vec2::new(p.x, p.y) / p.z
    }

    /// Returns a bound of the distance of the pixel's points from its centre: to first order, plus a fifth.
    fn radius(&self, middle: Vec2) -> f32 {
        let step = |by: Vec3| (Vec2::new(by.x, by.y) - middle * by.z).length();
        0.6 * (step(self.across) + step(self.down)) / self.middle.z.abs()
    }
}

/// How an eye, perhaps a virtual one behind a mirror, sees a surface.
#[derive(Clone, Copy)]
struct Sight<'s, 'a> {
    surface: &'s Surface<'a>,
    hit: Hit,
    eye: DVec3,
    /// From the frame of the rays.
    world_from_rays: DMat3,
    ray: DVec3,
    /// The rays of the pixels to the right and below.
    next: [Option<DVec3>; 2],
}

impl<'a> ShadingContext<'a> {
    /// Returns the luminance that a beam adds to each pixel by diffuse reflection: the surface at the pixel's centre with the
    /// mean of the pattern over the pixel. Mirrors and glass show lit surfaces, but the beam itself is neither reflected nor weakened.
    pub(super) fn beam(&self, input: &ShadingInput<'_>, beam: &Beam<'_>) -> Image<f32> {
        let hits = &input.seen.hits;
        let (width, height) = (hits.width(), hits.height());
        let mut out = Image::filled(width, height, 0.0);
        let row_length = (width as usize).max(1);
        let seen_rows =
            (input.seen.z.0.pixels().par_chunks(row_length)).zip(hits.pixels().par_chunks(row_length));
        let rows = out.pixels_mut().par_chunks_mut(row_length);
        let pose = &self.view.world_from_camera;
        rows.zip(seen_rows).zip(0..height).for_each_init(
            || {
                (
                    SurfaceFinder::new(self.scene, self.view),
                    Stack::default(),
                    Vec::new(),
                )
            },
            |(finder, stack, arrivals), ((row, (depths, hits)), y)| {
                stack.forget();
                for (((pixel, z), hit), x) in row.iter_mut().zip(depths).zip(hits).zip(0..) {
                    let Some(ray) = input.rays.centre(x, y).filter(|_| !hit.is_miss()) else {
                        continue;
                    };
                    let Some(surface) = finder.find(*hit, ray, *z) else {
                        continue;
                    };
                    let sight = Sight {
                        surface: &surface,
                        hit: *hit,
                        eye: pose.translation,
                        world_from_rays: pose.rotation,
                        ray,
                        next: input.rays.next(x, y, ray),
                    };
                    *pixel = match self.paint(*hit).optic() {
                        None => self.beamed(&sight, Vec3::ONE, input, beam, stack),
                        Some(optic) => self.beamed_beyond(&sight, optic, input, beam, stack, arrivals),
                    };
                }
            },
        );
        out
    }

    /// Returns the luminance that a beam adds to a surface, and to all that is seen in it or through it.
    fn beamed_beyond(
        &self,
        sight: &Sight<'_, 'a>,
        optic: &Optic,
        input: &ShadingInput<'_>,
        beam: &Beam<'_>,
        stack: &mut Stack,
        arrivals: &mut Vec<Arrival<'a>>,
    ) -> f32 {
        let length = sight.ray.length();
        let in_world = |ray: DVec3| sight.world_from_rays * ray / length;
        let next = sight.next.map(|next| next.map(in_world));
        let range = sight.surface.range;
        let vertex = Vertex::new(self.scene, sight.eye, in_world(sight.ray), next, sight.hit, range);
        let Some(vertex) = vertex else { return 0.0 };
        arrivals.clear();
        let color = self.color_at(self.paint(sight.hit), &vertex);
        let own = Tracer::new(self, stack, arrivals).follow(&vertex, optic, color);
        let mut sum = self.beamed(sight, Vec3::splat(own.scattered), input, beam, stack);
        for arrival in &*arrivals {
            if let Origin::Surface(vertex, own) = &arrival.from {
                let sight = Sight {
                    surface: &vertex.surface,
                    hit: vertex.hit,
                    eye: vertex.eye,
                    world_from_rays: DMat3::IDENTITY,
                    ray: vertex.ray,
                    next: vertex.next,
                };
                sum += self.beamed(&sight, arrival.factor * own.scattered, input, beam, stack);
            }
        }
        sum
    }

    /// Returns the luminance that a beam adds to a surface, times a factor.
    fn beamed(
        &self,
        sight: &Sight<'_, '_>,
        factor: Vec3,
        input: &ShadingInput<'_>,
        beam: &Beam<'_>,
        stack: &mut Stack,
    ) -> f32 {
        let Some(lit) = lit(sight, beam) else { return 0.0 };
        let middle = lit.footprint.at(0.0, 0.0);
        let is_dark = beam
            .pattern
            .is_dark_around(middle.to_array(), lit.footprint.radius(middle));
        if is_dark || is_shadowed(input, sight.surface, beam.world_from_beam.translation, stack) {
            return 0.0;
        }
        let paint = self.paint(sight.hit);
        let spot = Spot::seen_on(sight.surface, sight.next);
        let color = paint.color(sight.surface.mesh, sight.hit.triangle, &spot, self.level) * factor;
        let albedo = luminance(color) * (1.0 - paint.metallic());
        mean(&lit.footprint, beam.pattern) * lit.strength * albedo
    }
}

/// Returns `None` where the beam does not reach the visible side.
#[expect(clippy::cast_possible_truncation, reason = "light is float32")]
fn lit(sight: &Sight<'_, '_>, beam: &Beam<'_>) -> Option<Lit> {
    let Sight {
        surface,
        eye,
        world_from_rays,
        ray,
        next,
        ..
    } = *sight;
    let from_beam = surface.point - beam.world_from_beam.translation;
    let distance = from_beam.length();
    let cosine = -surface.normal.dot(from_beam) / distance;
    let beam_from_world: DMat3 = beam.world_from_beam.rotation.transpose();
    let is_ahead = (beam_from_world * from_beam).z > 1e-6 * distance;
    if !(is_ahead && cosine > 0.0 && surface.flat_normal.dot(from_beam) < 0.0) {
        return None;
    }
    // A ray r of the eye meets the surface's plane, through p with normal n, at eye + r ((p − eye)·n) / (r·n): relative
    // to the beam a multiple of (eye − beam) (r·n) + r ((p − eye)·n).
    let normal = surface.flat_normal;
    let height = (surface.point - eye).dot(normal);
    let eye_from_beam = eye - beam.world_from_beam.translation;
    let in_beam = |ray: DVec3| {
        let ray = world_from_rays * ray;
        beam_from_world * (eye_from_beam * ray.dot(normal) + ray * height)
    };
    let step = |to: Option<DVec3>| to.map_or(DVec3::ZERO, |to| in_beam(to - ray));
    let middle = in_beam(ray);
    let scale = 1.0 / middle.length();
    let footprint = Footprint {
        middle: (middle * scale).as_vec3(),
        across: (step(next[0]) * scale).as_vec3(),
        down: (step(next[1]) * scale).as_vec3(),
    };
    Some(Lit {
        strength: (cosine / (distance * distance).max(NEAR_M * NEAR_M)) as f32,
        footprint,
    })
}

/// The mean of the pattern over a pixel.
fn mean(footprint: &Footprint, pattern: &dyn BeamPattern) -> f32 {
    let samples = f32::from(SAMPLES);
    let offset = |i: u8| (f32::from(i) + 0.5) / samples - 0.5;
    let mut sum = 0.0;
    for row in 0..SAMPLES {
        for column in 0..SAMPLES {
            sum += pattern.luminance(footprint.at(offset(column), offset(row)).to_array());
        }
    }
    sum / (samples * samples)
}

fn is_shadowed(input: &ShadingInput<'_>, surface: &Surface<'_>, beam: DVec3, stack: &mut Stack) -> bool {
    // The offset is the rounding error of the point.
    let origin = surface.point + surface.flat_normal * (2e-5 + surface.range * 1e-4);
    let direction = beam - origin;
    let ray = Ray {
        origin,
        direction,
        near: 0.0,
        far: (1.0 - NEAR_M / direction.length()).max(0.0),
    };
    let caster: &RayCaster = input.caster;
    caster.is_shadowed(input.scene, ray, 0, stack)
}
