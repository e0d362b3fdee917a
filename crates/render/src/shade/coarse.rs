//! Incident light at half resolution, filtered over the sampling pattern and interpolated for all pixels.
//!
//! Shadow rays are cast at a quarter of the samples, and elsewhere only where these disagree.

use glam::{Vec3, Vec4};
use oaktwin_image::Image;
use oaktwin_simd::Level;
use rayon::prelude::*;

use super::lamp::Lamp;
use super::occlusion::{LampSamples, Light, Occlusion, Place, Shares};
use super::pattern::{PERIOD, Pattern};
use super::surfaces::Packet;
use super::tiles::{TILE, in_tiles};
use crate::ray::Stack;
use crate::rays::Rays;
use crate::{View, Visibility};

/// The surface that a pixel sees.
#[derive(Clone, Copy, Debug)]
struct Sample {
    place: Place,
    /// Zero for a miss; the inverse of the distance from the plane within which another sample belongs to the same surface.
    per_tolerance: f32,
}

const NOTHING: Sample = Sample {
    place: Place {
        from_eye: Vec3::ZERO,
        range: 0.0,
        normal: Vec3::ZERO,
        flat_normal: Vec3::ZERO,
    },
    per_tolerance: 0.0,
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

impl Sample {
    fn new(place: &Place) -> Self {
        Self {
            place: *place,
            per_tolerance: 100.0 / place.range.max(f32::MIN_POSITIVE),
        }
    }

    /// Returns the weight of another sample, 0 to 1: from the angle between the normals and its distance from this sample's
    /// plane.
    #[inline]
    fn similarity(&self, other: &Self) -> f32 {
        let (a, b) = (&self.place, &other.place);
        let parallel = (a.normal.dot(b.normal) - 0.75) * 4.0;
        let off = a.normal.dot(b.from_eye - a.from_eye).abs() * self.per_tolerance;
        parallel.max(0.0) * (1.0 - off).max(0.0)
    }
}

/// Samples the light of a view.
#[derive(Clone, Copy)]
struct Sampler<'a> {
    view: &'a View,
    rays: &'a Rays<'a>,
    seen: &'a Visibility,
    occlusion: &'a Occlusion<'a>,
    level: Level,
}

impl<'a> Sampler<'a> {
    /// Finds the surfaces of every other pixel of every other row.
    fn surfaces(&self, width: u32, height: u32) -> Image<Sample> {
        let mut samples = Image::filled(width, height, NOTHING);
        let rows = samples.pixels_mut().par_chunks_mut((width as usize).max(1));
        rows.zip(0..height).for_each_init(
            || Packet::new(self.occlusion.scene, self.view, self.rays, self.level),
            |packet, (row, y)| {
                for x in 0..width {
                    let place = [2 * x, 2 * y];
                    let (Some(hit), Some(z), Some(ray)) = (
                        self.seen.hits.get(place[0], place[1]),
                        self.seen.z.0.get(place[0], place[1]),
                        packet.ray(place),
                    ) else {
                        continue;
                    };
                    if hit.is_miss() {
                        continue;
                    }
                    if !packet.has_room_for(hit.instance) {
                        put(packet, row);
                    }
                    packet.push(x as usize, place, ray, *hit, *z);
                }
                put(packet, row);
            },
        );
        samples
    }

    /// Samples the lamps at even samples, and the surroundings at every other sample; the others get NaN.
    fn sample(&self, samples: &Image<Sample>) -> (Image<Light>, Image<LampSamples>) {
        let (width, height) = (samples.width(), samples.height());
        let row_length = (width as usize).max(1);
        let mut light = Image::filled(width, height, Light::FULL);
        let mut lamp_samples = Image::filled(width.div_ceil(2), height.div_ceil(2), LampSamples::default());
        let strip = TILE as usize * row_length;
        let rows = (light.pixels_mut().par_chunks_mut(strip)).zip(samples.pixels().par_chunks(strip));
        let lamp_rows = TILE as usize / 2 * row_length.div_ceil(2);
        rows.zip(lamp_samples.pixels_mut().par_chunks_mut(lamp_rows))
            .for_each_init(Stack::new, |stack, ((light, samples), lamp_samples)| {
                let rows = (0..TILE).take(samples.len() / row_length);
                for [x, y] in in_tiles(width, rows) {
                    let index = y as usize * row_length + x as usize;
                    let (Some(sample), Some(light)) = (samples.get(index), light.get_mut(index)) else {
                        continue;
                    };
                    if sample.per_tolerance == 0.0 {
                        continue;
                    }
                    let cell = Pattern::cell(x, y);
                    let half = y as usize / 2 * row_length.div_ceil(2) + x as usize / 2;
                    if x % 2 == 0
                        && y % 2 == 0
                        && let Some(lamp_samples) = lamp_samples.get_mut(half)
                    {
                        (*light, *lamp_samples) = self.occlusion.sample_lamps(&sample.place, cell, stack);
                    }
                    (light.ambient, light.sky) = if (x + y) % 2 == 0 {
                        self.occlusion.sample_surroundings(&sample.place, cell, stack)
                    } else {
                        (f32::NAN, f32::NAN)
                    };
                }
            });
        (light, lamp_samples)
    }

    /// Computes the light that [`sample`](Self::sample) left out.
    fn complete(
        &self,
        samples: &Image<Sample>,
        first: &Image<Light>,
        lamp_samples: &Image<LampSamples>,
    ) -> Image<Light> {
        let mut complete = first.clone();
        let (row_length, height) = ((samples.width() as usize).max(1), samples.height());
        let rows =
            (complete.pixels_mut().par_chunks_mut(row_length)).zip(samples.pixels().par_chunks(row_length));
        rows.zip(0..height)
            .for_each_init(Stack::new, |stack, ((row, samples_of_row), y)| {
                for ((light, sample), x) in row.iter_mut().zip(samples_of_row).zip(0..) {
                    if sample.per_tolerance == 0.0 {
                        continue;
                    }
                    let cell = Pattern::cell(x, y);
                    let place = &sample.place;
                    let (ambient, sky) = (light.ambient, light.sky);
                    // There is no shadow edge where all even neighbours see a lamp or none does.
                    if x % 2 != 0 || y % 2 != 0 {
                        let around = Neighbours::new(samples, lamp_samples, sample, x, y);
                        let sees = |index: u32, lamp: &Lamp, spot: [f64; 2]| {
                            around
                                .all_see(index)
                                .unwrap_or_else(|| self.occlusion.sees(place, lamp, spot, stack))
                        };
                        (*light, _) = self.occlusion.lamplight(place.from_eye, place.normal, cell, sees);
                    }
                    (light.ambient, light.sky) = (ambient, sky);
                    // Every other sample takes the mean of its four neighbours.
                    if ambient.is_nan() {
                        (light.ambient, light.sky) = mean_around(samples, first, sample, x, y)
                            .unwrap_or_else(|| self.occlusion.sample_surroundings(place, cell, stack));
                    }
                }
            });
        complete
    }
}

impl Coarse {
    pub(super) fn new(
        view: &View,
        rays: &Rays<'_>,
        seen: &Visibility,
        occlusion: &Occlusion<'_>,
        level: Level,
    ) -> Self {
        let sampler = Sampler {
            view,
            rays,
            seen,
            occlusion,
            level,
        };
        let (width, height) = (seen.hits.width().div_ceil(2), seen.hits.height().div_ceil(2));
        let samples = sampler.surfaces(width, height);
        let (first, lamp_samples) = sampler.sample(&samples);
        let mut light = sampler.complete(&samples, &first, &lamp_samples);
        for step in [[1, 0], [0, 1]] {
            light = smoothed(&samples, &light, step, Light::with_smooth);
        }
        if occlusion.rig.has_sky {
            let tile = PERIOD.cast_signed();
            for step in [[tile, 0], [0, tile]] {
                light = smoothed(&samples, &light, step, Light::with_smooth_surroundings);
            }
        }
        let light = light.map(|light| {
            let (some, all) = (
                light.small.some + light.large.some,
                light.small.all + light.large.all,
            );
            Vec4::new(some, all, light.ambient, light.sky)
        });
        Self { samples, light }
    }

    /// Returns the light at the point that pixel `(x, y)` sees; `None` where no neighbour sees the same surface.
    pub(super) fn light(&self, [x, y]: [u32; 2], place: &Place) -> Option<Shares> {
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

/// Stores the surfaces of a packet in a row of samples, and clears the packet.
fn put(packet: &mut Packet<'_>, row: &mut [Sample]) {
    if let Some(found) = packet.find() {
        for lane in 0..found.count() {
            if let Some(sample) = row.get_mut(found.tag(lane)) {
                *sample = Sample::new(&Place::new(&found, lane));
            }
        }
    }
    packet.clear();
}

/// The even neighbours of a sample.
struct Neighbours<'a> {
    lamp_samples: &'a Image<LampSamples>,
    columns: [u32; 2],
    rows: [u32; 2],
    /// Whether all of them belong to the sample's surface.
    are_similar: bool,
}

impl<'a> Neighbours<'a> {
    fn new(
        samples: &Image<Sample>,
        lamp_samples: &'a Image<LampSamples>,
        at: &Sample,
        x: u32,
        y: u32,
    ) -> Self {
        let (columns, rows) = ([x / 2, x.div_ceil(2)], [y / 2, y.div_ceil(2)]);
        let mut are_similar = true;
        for row in rows {
            for column in columns {
                let other = samples.get(2 * column, 2 * row);
                are_similar &= other.is_some_and(|other| at.similarity(other) >= 0.25);
            }
        }
        Self {
            lamp_samples,
            columns,
            rows,
            are_similar,
        }
    }

    /// Whether all of them see a lamp or none does; `None` where they disagree or one belongs to another surface.
    fn all_see(&self, lamp: u32) -> Option<bool> {
        if !self.are_similar {
            return None;
        }
        let mut all = None;
        for row in self.rows {
            for column in self.columns {
                let samples = self.lamp_samples.get(column, row)?;
                let found = samples.iter().flatten().find(|sample| sample.lamp == lamp)?;
                if all.is_some_and(|all| all != found.is_seen) {
                    return None;
                }
                all = Some(found.is_seen);
            }
        }
        all
    }
}

/// The mean of the four neighbours' ambient light; `None` where too few belong to the same surface.
fn mean_around(
    samples: &Image<Sample>,
    light: &Image<Light>,
    at: &Sample,
    x: u32,
    y: u32,
) -> Option<(f32, f32)> {
    let neighbours = [
        (x.wrapping_sub(1), y),
        (x + 1, y),
        (x, y.wrapping_sub(1)),
        (x, y + 1),
    ];
    let (mut ambient, mut sky, mut weights) = (0.0, 0.0, 0.0);
    for (x, y) in neighbours {
        if let (Some(other), Some(light)) = (samples.get(x, y), light.get(x, y)) {
            let weight = at.similarity(other);
            ambient += light.ambient * weight;
            sky += light.sky * weight;
            weights += weight;
        }
    }
    (weights > 0.5).then(|| (ambient / weights, sky / weights))
}

/// Filters over four samples of the same surface, `step` apart, from two before to one after. `take` combines the unfiltered and
/// the filtered light.
fn smoothed(
    samples: &Image<Sample>,
    light: &Image<Light>,
    step: [i32; 2],
    take: fn(Light, Light) -> Light,
) -> Image<Light> {
    let mut smooth = light.clone();
    let row_length = (samples.width() as usize).max(1);
    let rows = (smooth.pixels_mut().par_chunks_mut(row_length)).zip(samples.pixels().par_chunks(row_length));
    rows.zip(0..samples.height())
        .for_each(|((row, samples_of_row), y)| {
            for ((out, sample), x) in row.iter_mut().zip(samples_of_row).zip(0u32..) {
                if sample.per_tolerance == 0.0 {
                    continue;
                }
                let mut sum = Light::default();
                let mut weights = 0.0;
                let before = PERIOD.cast_signed() / 2;
                for i in -before..PERIOD.cast_signed() - before {
                    let x = x.wrapping_add_signed(step[0] * i);
                    let y = y.wrapping_add_signed(step[1] * i);
                    if let (Some(other), Some(light)) = (samples.get(x, y), light.get(x, y)) {
                        let weight = if i == 0 { 1.0 } else { sample.similarity(other) };
                        sum = sum.plus(*light, weight);
                        weights += weight;
                    }
                }
                *out = take(*out, sum.times(1.0 / weights));
            }
        });
    smooth
}
