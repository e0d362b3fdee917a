//! The light that reaches each second pixel of each second row, freed of the pattern, for all pixels.

use glam::Vec3;
use oaktwin_image::Image;
use oaktwin_scene::Scene;
use rayon::prelude::*;

use super::occlusion::{Light, Occlusion, Place};
use super::pattern::{PERIOD, Pattern};
use crate::annotate::{Surface, SurfaceFinder};
use crate::ray::Stack;
use crate::rays::Rays;
use crate::{View, Visibility};

/// A pixel's place and light.
#[derive(Clone, Copy, Debug)]
struct Sample {
    /// From the eye, metres.
    point: Vec3,
    /// Zero where nothing is seen.
    normal: Vec3,
    /// Of the plane distance within which another sample belongs to the same surface.
    per_tolerance: f32,
    light: Light,
}

const NOTHING: Sample = Sample {
    point: Vec3::ZERO,
    normal: Vec3::ZERO,
    per_tolerance: 0.0,
    light: Light::FULL,
};

/// A quarter of a view's pixels.
#[derive(Debug)]
pub(super) struct Coarse {
    samples: Image<Sample>,
}

pub(super) fn place(surface: &Surface<'_>, view: &View) -> Place {
    Place {
        point: surface.point,
        from_eye: (surface.point - view.world_from_camera.translation).as_vec3(),
        normal: surface.normal,
        flat_normal: surface.flat_normal,
        range: surface.range,
    }
}

impl Sample {
    #[expect(clippy::cast_possible_truncation, reason = "shading is float32")]
    fn new(place: &Place) -> Self {
        Self {
            point: place.from_eye,
            normal: place.normal.as_vec3(),
            per_tolerance: 1.0 / (place.range as f32 * 0.01).max(f32::MIN_POSITIVE),
            light: Light::FULL,
        }
    }

    /// How much another one says about this: 0 to 1, by how parallel they are and how far the other is off this one's
    /// plane.
    #[inline]
    fn kinship(&self, other: &Self) -> f32 {
        let parallel = (self.normal.dot(other.normal) - 0.75) * 4.0;
        let off = self.normal.dot(other.point - self.point).abs() * self.per_tolerance;
        parallel.max(0.0) * (1.0 - off).max(0.0)
    }
}

impl Coarse {
    pub(super) fn new(
        scene: &Scene,
        view: &View,
        rays: &Rays<'_>,
        seen: &Visibility,
        occlusion: &Occlusion<'_>,
    ) -> Self {
        let (width, height) = (seen.hits.width().div_ceil(2), seen.hits.height().div_ceil(2));
        let mut samples = Image::filled(width, height, NOTHING);
        let row_length = (width as usize).max(1);
        let rows = samples.pixels_mut().par_chunks_mut(row_length);
        rows.zip(0..height).for_each_init(Stack::new, |stack, (row, y)| {
            let mut finder = SurfaceFinder::new(scene, view);
            for (sample, x) in row.iter_mut().zip(0..) {
                let surface = (seen.hits.get(2 * x, 2 * y).filter(|hit| !hit.is_miss()))
                    .zip(seen.z.0.get(2 * x, 2 * y))
                    .zip(rays.centre(2 * x, 2 * y))
                    .and_then(|((hit, z), ray)| finder.find(*hit, ray, *z));
                if let Some(surface) = surface {
                    let place = place(&surface, view);
                    *sample = Sample::new(&place);
                    sample.light = occlusion.look(&place, Pattern::turn(x, y), stack);
                }
            }
        });
        let samples = smoothed(&samples, |x, y, step| (x.checked_add_signed(step), Some(y)));
        let samples = smoothed(&samples, |x, y, step| (Some(x), y.checked_add_signed(step)));
        Self { samples }
    }

    /// The light at a place that pixel `(x, y)` sees; `None` where none of its neighbours sees the same surface.
    pub(super) fn light(&self, x: u32, y: u32, place: &Place) -> Option<Light> {
        let at = Sample::new(place);
        let mut sum = Light::default();
        let mut weights = 0.0;
        // Smoothing over an even number of samples moved them by half of one, a pixel: of the pixels, those of odd
        // columns have a sample of their own and the others lie between two.
        let within = |at: u32, count: u32| at.min(count.saturating_sub(1));
        for row in y.div_ceil(2)..=y / 2 + 1 {
            for column in x.div_ceil(2)..=x / 2 + 1 {
                let column = within(column, self.samples.width());
                if let Some(sample) = self.samples.get(column, within(row, self.samples.height())) {
                    let weight = at.kinship(sample);
                    sum = sum.plus(sample.light, weight);
                    weights += weight;
                }
            }
        }
        (weights > 0.02).then(|| sum.times(1.0 / weights))
    }
}

/// The mean of a period of samples of the same surface: from two before to one after, which is half a sample before.
fn smoothed(
    samples: &Image<Sample>,
    neighbour: impl Fn(u32, u32, i32) -> (Option<u32>, Option<u32>) + Sync,
) -> Image<Sample> {
    let mut smooth = samples.clone();
    let row_length = (samples.width() as usize).max(1);
    let rows = smooth.pixels_mut().par_chunks_mut(row_length);
    rows.zip(0..samples.height()).for_each(|(row, y)| {
        for (sample, x) in row.iter_mut().zip(0..) {
            if sample.per_tolerance == 0.0 {
                continue;
            }
            let mut sum = Light::default();
            let mut weights = 0.0;
            let before = PERIOD.cast_signed() / 2;
            for step in -before..PERIOD.cast_signed() - before {
                let other = match neighbour(x, y, step) {
                    (Some(x), Some(y)) => samples.get(x, y),
                    _ => None,
                };
                if let Some(other) = other {
                    let weight = if step == 0 { 1.0 } else { sample.kinship(other) };
                    sum = sum.plus(other.light, weight);
                    weights += weight;
                }
            }
            let small = sample.light.small;
            sample.light = Light {
                small,
                ..sum.times(1.0 / weights)
            };
        }
    });
    smooth
}
