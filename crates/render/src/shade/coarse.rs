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
        let place_of = |finder: &mut SurfaceFinder<'_>, x: u32, y: u32| {
            let hit = seen.hits.get(2 * x, 2 * y).filter(|hit| !hit.is_miss())?;
            let (z, ray) = (seen.z.0.get(2 * x, 2 * y)?, rays.centre(2 * x, 2 * y)?);
            finder.find(*hit, ray, *z).map(|surface| place(&surface, view))
        };
        let state = || (SurfaceFinder::new(scene, view), Stack::new());
        let row_length = (width as usize).max(1);
        let rows = samples.pixels_mut().par_chunks_mut(row_length);
        rows.zip(0..height)
            .for_each_init(state, |(finder, stack), (row, y)| {
                for (sample, x) in row.iter_mut().zip(0..) {
                    if let Some(place) = place_of(finder, x, y) {
                        *sample = Sample::new(&place);
                        let now = [x % 2 == 0 && y % 2 == 0, (x + y) % 2 == 0];
                        sample.light = occlusion.look(&place, Pattern::turn(x, y), now, stack);
                    }
                }
            });
        let first = samples.clone();
        let rows = samples.pixels_mut().par_chunks_mut(row_length);
        rows.zip(0..height)
            .for_each_init(state, |(finder, stack), (row, y)| {
                for (sample, x) in row.iter_mut().zip(0..) {
                    // Between places that all see the small lamps, or all do not, no shadow begins.
                    if sample.light.small.some.is_nan() {
                        sample.light.small.some = match share_around(&first, sample, x, y) {
                            Some(share) => sample.light.small.all * share,
                            None => place_of(finder, x, y)
                                .map_or(0.0, |place| occlusion.light_of_small_lamps(&place, stack)),
                        };
                    }
                    // Every other place asks its four neighbours.
                    if sample.light.ambient.is_nan() {
                        let found = mean_around(&first, sample, x, y).or_else(|| {
                            let place = place_of(finder, x, y)?;
                            Some(occlusion.look_around(&place, Pattern::turn(x, y), stack))
                        });
                        (sample.light.ambient, sample.light.sky) = found.unwrap_or((1.0, 1.0));
                    }
                }
            });
        samples = smoothed(&samples, [1, 0], Light::with_smooth);
        samples = smoothed(&samples, [0, 1], Light::with_smooth);
        if occlusion.rig.has_sky {
            let tile = PERIOD.cast_signed();
            samples = smoothed(&samples, [tile, 0], Light::with_smooth_surroundings);
            samples = smoothed(&samples, [0, tile], Light::with_smooth_surroundings);
        }
        Self { samples }
    }

    /// The light at a place that pixel `(x, y)` sees; `None` where none of its neighbours sees the same surface.
    pub(super) fn light(&self, x: u32, y: u32, place: &Place) -> Option<Light> {
        let at = Sample::new(place);
        // Smoothing over an even number of samples moved them by half of one, a pixel: of the pixels, those of odd
        // columns have a sample of their own and the others lie between two.
        let columns = [x.div_ceil(2), x / 2 + 1];
        let rows = [y.div_ceil(2), y / 2 + 1];
        self.mean(&at, columns, rows).or_else(|| {
            let wider = |[first, last]: [u32; 2]| [first.saturating_sub(1), last + 1];
            self.mean(&at, wider(columns), wider(rows))
        })
    }

    /// Of the samples of the same surface.
    fn mean(&self, at: &Sample, columns: [u32; 2], rows: [u32; 2]) -> Option<Light> {
        let within = |at: u32, count: u32| at.min(count.saturating_sub(1));
        let mut sum = Light::default();
        let mut weights = 0.0;
        for row in rows[0]..=rows[1] {
            for column in columns[0]..=columns[1] {
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

/// The share of the small lamps' light that arrives at all of the even places around a place, if it is the same.
fn share_around(samples: &Image<Sample>, at: &Sample, x: u32, y: u32) -> Option<f32> {
    let mut all = None;
    for row in [y / 2 * 2, y.div_ceil(2) * 2] {
        for column in [x / 2 * 2, x.div_ceil(2) * 2] {
            let other = samples.get(column, row)?;
            let arrived = other.light.small;
            let share = if arrived.some == arrived.all { 1.0 } else { 0.0 };
            let is_clear = arrived.all > 0.0 && (arrived.some == 0.0 || share == 1.0);
            if !is_clear || at.kinship(other) < 0.25 || all.is_some_and(|all| all != share) {
                return None;
            }
            all = Some(share);
        }
    }
    all
}

/// The mean of what the four neighbours see around them; `None` where hardly any is of the same surface.
fn mean_around(samples: &Image<Sample>, at: &Sample, x: u32, y: u32) -> Option<(f32, f32)> {
    let neighbours = [
        (x.checked_sub(1), Some(y)),
        (x.checked_add(1), Some(y)),
        (Some(x), y.checked_sub(1)),
        (Some(x), y.checked_add(1)),
    ];
    let (mut ambient, mut sky, mut weights) = (0.0, 0.0, 0.0);
    for (x, y) in neighbours {
        if let Some(other) = x.zip(y).and_then(|(x, y)| samples.get(x, y)) {
            let weight = at.kinship(other);
            ambient += other.light.ambient * weight;
            sky += other.light.sky * weight;
            weights += weight;
        }
    }
    (weights > 0.5).then(|| (ambient / weights, sky / weights))
}

/// The mean of four samples of the same surface, one `step` apart: from two before to one after. `take` puts what is
/// wanted of it into what was there.
fn smoothed(samples: &Image<Sample>, step: [i32; 2], take: fn(Light, Light) -> Light) -> Image<Sample> {
    let mut smooth = samples.clone();
    let row_length = (samples.width() as usize).max(1);
    let rows = smooth.pixels_mut().par_chunks_mut(row_length);
    rows.zip(0..samples.height()).for_each(|(row, y)| {
        for (sample, x) in row.iter_mut().zip(0u32..) {
            if sample.per_tolerance == 0.0 {
                continue;
            }
            let mut sum = Light::default();
            let mut weights = 0.0;
            let before = PERIOD.cast_signed() / 2;
            for i in -before..PERIOD.cast_signed() - before {
                let [dx, dy] = step.map(|step| step * i);
                let other = (x.checked_add_signed(dx).zip(y.checked_add_signed(dy)))
                    .and_then(|(x, y)| samples.get(x, y));
                if let Some(other) = other {
                    let weight = if i == 0 { 1.0 } else { sample.kinship(other) };
                    sum = sum.plus(other.light, weight);
                    weights += weight;
                }
            }
            sample.light = take(sample.light, sum.times(1.0 / weights));
        }
    });
    smooth
}
