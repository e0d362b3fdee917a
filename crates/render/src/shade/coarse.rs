//! Incident light at half resolution, filtered over the sampling pattern and interpolated for all pixels.
//!
//! Shadow rays are cast at a quarter of the samples, and elsewhere only where these disagree.

use glam::{Vec3, Vec4};
use oaktwin_image::Image;
use oaktwin_scene::Scene;
use rayon::prelude::*;

use super::lamp::Lamp;
use super::occlusion::{LampSamples, Light, Occlusion, Place, Shares};
use super::pattern::{PERIOD, Pattern};
use crate::annotate::{Surface, SurfaceFinder};
use crate::ray::Stack;
use crate::rays::Rays;
use crate::{View, Visibility};

/// The surface and the light of a pixel.
#[derive(Clone, Copy, Debug)]
struct Sample {
    /// The point relative to the eye, metres.
    point: Vec3,
    /// Zero for a miss.
    normal: Vec3,
    /// The inverse of the distance from the plane within which another sample belongs to the same surface.
    per_tolerance: f32,
    light: Light,
}

const NOTHING: Sample = Sample {
    point: Vec3::ZERO,
    normal: Vec3::ZERO,
    per_tolerance: 0.0,
    light: Light::FULL,
};

/// The minimum total similarity for interpolation.
const MIN_SIMILARITY: f32 = 0.02;

/// Samples at a quarter of a view's pixels.
#[derive(Debug)]
pub(super) struct Coarse {
    samples: Image<Sample>,
    /// The light of each sample: the lamp light that arrives, the lamp light without shadows, and the visible shares of the
    /// surroundings and the sky.
    light: Image<Vec4>,
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

    /// Returns the weight of another sample, 0 to 1: from the angle between the normals and its distance from this sample's
    /// plane.
    #[inline]
    fn similarity(&self, other: &Self) -> f32 {
        let parallel = (self.normal.dot(other.normal) - 0.75) * 4.0;
        let off = self.normal.dot(other.point - self.point).abs() * self.per_tolerance;
        parallel.max(0.0) * (1.0 - off).max(0.0)
    }
}

/// Finds the surfaces of a view's samples.
#[derive(Clone, Copy)]
struct Sampler<'a> {
    scene: &'a Scene,
    view: &'a View,
    rays: &'a Rays<'a>,
    seen: &'a Visibility,
    occlusion: &'a Occlusion<'a>,
}

impl<'a> Sampler<'a> {
    fn workspace(&self) -> (SurfaceFinder<'a>, Stack) {
        (SurfaceFinder::new(self.scene, self.view), Stack::new())
    }

    fn place(&self, finder: &mut SurfaceFinder<'_>, x: u32, y: u32) -> Option<Place> {
        let hit = self.seen.hits.get(2 * x, 2 * y).filter(|hit| !hit.is_miss())?;
        let (z, ray) = (self.seen.z.0.get(2 * x, 2 * y)?, self.rays.centre(2 * x, 2 * y)?);
        finder
            .find(*hit, ray, *z)
            .map(|surface| place(&surface, self.view))
    }

    /// Samples the lamps at even samples, and the surroundings at every other sample; the others get NaN.
    fn sample(&self, width: u32, height: u32) -> (Image<Sample>, Image<LampSamples>) {
        let mut samples = Image::filled(width, height, NOTHING);
        let row_length = (width as usize).max(1);
        let mut lamp_samples = Image::filled(width.div_ceil(2), height.div_ceil(2), LampSamples::default());
        // One row of lamp samples for two rows of samples.
        let lamp_sample_rows = lamp_samples.pixels_mut().par_chunks_mut(row_length.div_ceil(2));
        let rows = samples.pixels_mut().par_chunks_mut(2 * row_length);
        rows.zip(lamp_sample_rows)
            .zip(0..height.div_ceil(2))
            .for_each_init(
                || self.workspace(),
                |(finder, stack), ((samples, lamp_samples), half_y)| {
                    for (row, y) in samples.chunks_mut(row_length).zip(2 * half_y..) {
                        for (sample, x) in row.iter_mut().zip(0..) {
                            let Some(place) = self.place(finder, x, y) else {
                                continue;
                            };
                            *sample = Sample::new(&place);
                            let cell = Pattern::cell(x, y);
                            if x % 2 == 0
                                && y % 2 == 0
                                && let Some(lamp_samples) = lamp_samples.get_mut(x as usize / 2)
                            {
                                (sample.light, *lamp_samples) =
                                    self.occlusion.sample_lamps(&place, cell, stack);
                            }
                            (sample.light.ambient, sample.light.sky) = if (x + y) % 2 == 0 {
                                self.occlusion.sample_surroundings(&place, cell, stack)
                            } else {
                                (f32::NAN, f32::NAN)
                            };
                        }
                    }
                },
            );
        (samples, lamp_samples)
    }

    /// Computes the light that [`sample`](Self::sample) left out.
    fn complete(&self, samples: &mut Image<Sample>, lamp_samples: &Image<LampSamples>) {
        let first = samples.clone();
        let (row_length, height) = ((samples.width() as usize).max(1), samples.height());
        let rows = samples.pixels_mut().par_chunks_mut(row_length);
        rows.zip(0..height).for_each_init(
            || self.workspace(),
            |(finder, stack), (row, y)| {
                for (sample, x) in row.iter_mut().zip(0..) {
                    if sample.per_tolerance == 0.0 {
                        continue;
                    }
                    let cell = Pattern::cell(x, y);
                    let (ambient, sky) = (sample.light.ambient, sample.light.sky);
                    // There is no shadow edge where all even neighbours see a lamp or none does.
                    if x % 2 != 0 || y % 2 != 0 {
                        let around = Neighbours::new(&first, lamp_samples, sample, x, y);
                        let sees = |index: u32, lamp: &Lamp, spot: [f64; 2]| {
                            around.all_see(index).unwrap_or_else(|| {
                                self.place(finder, x, y)
                                    .is_some_and(|place| self.occlusion.sees(&place, lamp, spot, stack))
                            })
                        };
                        (sample.light, _) = self.occlusion.lamplight(sample.point, sample.normal, cell, sees);
                    }
                    (sample.light.ambient, sample.light.sky) = (ambient, sky);
                    // Every other sample takes the mean of its four neighbours.
                    if ambient.is_nan() {
                        let found = mean_around(&first, sample, x, y).or_else(|| {
                            let place = self.place(finder, x, y)?;
                            Some(self.occlusion.sample_surroundings(&place, cell, stack))
                        });
                        (sample.light.ambient, sample.light.sky) = found.unwrap_or((1.0, 1.0));
                    }
                }
            },
        );
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
        let sampler = Sampler {
            scene,
            view,
            rays,
            seen,
            occlusion,
        };
        let (width, height) = (seen.hits.width().div_ceil(2), seen.hits.height().div_ceil(2));
        let (mut samples, lamp_samples) = sampler.sample(width, height);
        sampler.complete(&mut samples, &lamp_samples);
        samples = smoothed(&samples, [1, 0], Light::with_smooth);
        samples = smoothed(&samples, [0, 1], Light::with_smooth);
        if occlusion.rig.has_sky {
            let tile = PERIOD.cast_signed();
            samples = smoothed(&samples, [tile, 0], Light::with_smooth_surroundings);
            samples = smoothed(&samples, [0, tile], Light::with_smooth_surroundings);
        }
        let light = samples.map(|Sample { light, .. }| {
            let (some, all) = (
                light.small.some + light.large.some,
                light.small.all + light.large.all,
            );
            Vec4::new(some, all, light.ambient, light.sky)
        });
        Self { samples, light }
    }

    /// Returns the light at the point that pixel `(x, y)` sees; `None` where no neighbour sees the same surface.
    pub(super) fn light(&self, x: u32, y: u32, place: &Place) -> Option<Shares> {
        let at = Sample::new(place);
        // Filtering over an even number of samples shifts them by half a sample, which is one pixel: pixels in odd columns
        // coincide with a sample and the others lie between two.
        let columns = [x.div_ceil(2), x / 2 + 1];
        let rows = [y.div_ceil(2), y / 2 + 1];
        self.mean(&at, columns, rows).or_else(|| {
            let wider = |[first, last]: [u32; 2]| [first.saturating_sub(1), last + 1];
            self.mean(&at, wider(columns), wider(rows))
        })
    }

    /// Returns the weighted mean of the samples of the same surface.
    #[inline]
    fn mean(&self, at: &Sample, columns: [u32; 2], rows: [u32; 2]) -> Option<Shares> {
        let within = |at: u32, count: u32| at.min(count.saturating_sub(1));
        let mut sum = Vec4::ZERO;
        let mut weights = 0.0;
        for row in rows[0]..=rows[1] {
            let row = within(row, self.samples.height());
            for column in columns[0]..=columns[1] {
                let column = within(column, self.samples.width());
                if let (Some(sample), Some(light)) =
                    (self.samples.get(column, row), self.light.get(column, row))
                {
                    let weight = at.similarity(sample);
                    sum += *light * weight;
                    weights += weight;
                }
            }
        }
        let [some, all, ambient, sky] = sum.to_array();
        (weights > MIN_SIMILARITY).then(|| Shares {
            direct: if all > 0.0 { some / all } else { 1.0 },
            ambient: ambient / weights,
            sky: sky / weights,
        })
    }
}

/// The lamp samples of the even neighbours; `None` for a neighbour that may belong to another surface.
struct Neighbours([Option<LampSamples>; 4]);

impl Neighbours {
    fn new(samples: &Image<Sample>, lamp_samples: &Image<LampSamples>, at: &Sample, x: u32, y: u32) -> Self {
        let (columns, rows) = ([x / 2, x.div_ceil(2)], [y / 2, y.div_ceil(2)]);
        Self([0, 1, 2, 3].map(|i| {
            let (column, row) = (columns[i % 2], rows[i / 2]);
            let other = samples.get(2 * column, 2 * row)?;
            let is_similar = at.similarity(other) >= 0.25;
            lamp_samples.get(column, row).copied().filter(|_| is_similar)
        }))
    }

    /// Whether all of them see a lamp or none does; `None` where they disagree.
    fn all_see(&self, lamp: u32) -> Option<bool> {
        let mut all = None;
        for lamp_samples in &self.0 {
            let found = lamp_samples
                .as_ref()?
                .iter()
                .flatten()
                .find(|lamp_sample| lamp_sample.lamp == lamp)?;
            if all.is_some_and(|all| all != found.is_seen) {
                return None;
            }
            all = Some(found.is_seen);
        }
        all
    }
}

/// The mean of the four neighbours' ambient light; `None` where too few belong to the same surface.
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
            let weight = at.similarity(other);
            ambient += other.light.ambient * weight;
            sky += other.light.sky * weight;
            weights += weight;
        }
    }
    (weights > 0.5).then(|| (ambient / weights, sky / weights))
}

/// Filters over four samples of the same surface, `step` apart, from two before to one after. `take` combines the unfiltered and
/// the filtered light.
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
                    let weight = if i == 0 { 1.0 } else { sample.similarity(other) };
                    sum = sum.plus(other.light, weight);
                    weights += weight;
                }
            }
            sample.light = take(sample.light, sum.times(1.0 / weights));
        }
    });
    smooth
}
