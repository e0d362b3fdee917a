//! The light of a projector: a point source with a pattern finer than a pixel.

use glam::{Vec2, Vec3};
use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_image::Image;
use rayon::prelude::*;

use super::rig::luminance;
use super::surfaces::Spot;
use super::{ShadingContext, ShadingInput};
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

impl ShadingContext<'_> {
    /// Returns the luminance that a beam adds to each pixel by diffuse reflection: the surface at the pixel's centre with the
    /// mean of the pattern over the pixel.
    pub(super) fn beam(&self, input: &ShadingInput<'_>, beam: &Beam<'_>) -> Image<f32> {
        let hits = &input.seen.hits;
        let (width, height) = (hits.width(), hits.height());
        let mut out = Image::filled(width, height, 0.0);
        let row_length = (width as usize).max(1);
        let seen_rows =
            (input.seen.z.0.pixels().par_chunks(row_length)).zip(hits.pixels().par_chunks(row_length));
        let rows = out.pixels_mut().par_chunks_mut(row_length);
        rows.zip(seen_rows).zip(0..height).for_each_init(
            || (SurfaceFinder::new(self.scene, self.view), Stack::new()),
            |(finder, stack), ((row, (depths, hits)), y)| {
                for (((pixel, z), hit), x) in row.iter_mut().zip(depths).zip(hits).zip(0..) {
                    let Some(ray) = input.rays.centre(x, y).filter(|_| !hit.is_miss()) else {
                        continue;
                    };
                    let next = input.rays.next(x, y, ray);
                    let found = finder.find(*hit, ray, *z);
                    let lit = found
                        .as_ref()
                        .and_then(|surface| Some((surface, self.lit(surface, ray, next, beam)?)));
                    let Some((surface, lit)) = lit else {
                        continue;
                    };
                    let middle = lit.footprint.at(0.0, 0.0);
                    if beam
                        .pattern
                        .is_dark_around(middle.to_array(), lit.footprint.radius(middle))
                        || is_shadowed(input, surface, beam.world_from_beam.translation, stack)
                    {
                        continue;
                    }
                    let paint = self.paint(*hit);
                    let color = paint.color(surface.mesh, hit.triangle, &spot(surface, next), self.level);
                    let albedo = luminance(color) * (1.0 - paint.metallic());
                    *pixel = mean(&lit.footprint, beam.pattern) * lit.strength * albedo;
                }
            },
        );
        out
    }

    /// Returns `None` where the beam does not reach the visible side.
    #[expect(clippy::cast_possible_truncation, reason = "light is float32")]
    fn lit(
        &self,
        surface: &Surface<'_>,
        ray: DVec3,
        next: [Option<DVec3>; 2],
        beam: &Beam<'_>,
    ) -> Option<Lit> {
        let eye = self.view.world_from_camera.translation;
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
            let ray = self.view.world_from_camera.rotation * ray;
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
}

/// Returns the place on the triangle that a pixel sees; `next` are the rays of the pixels to the right and below.
#[expect(clippy::cast_possible_truncation, reason = "shading is float32")]
fn spot(surface: &Surface<'_>, next: [Option<DVec3>; 2]) -> Spot {
    let [_, b, c] = surface.weights;
    let [across, down] = next.map(|next| {
        let [_, next_b, next_c] = next.map_or(surface.weights, |next| surface.weights_of(next));
        let step = [next_b - b, next_c - c];
        if step.iter().all(|step| step.is_finite()) {
            step.map(|step| step as f32)
        } else {
            [0.0; 2]
        }
    });
    Spot {
        at: [b as f32, c as f32],
        across,
        down,
    }
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
    caster.is_occluded(input.scene, ray, stack)
}
