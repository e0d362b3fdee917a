//! Incident light at half resolution, filtered over the sampling pattern and interpolated for all pixels.
//!
//! Shadow rays are cast at a quarter of the samples, and elsewhere only where these disagree.

mod between;
mod samples;
mod smooth;

use oaktwin_image::Image;
use oaktwin_simd::{Level, run_lanes_at};
use rayon::prelude::*;

use self::between::{Between, MIN_SIMILARITY};
use self::samples::{Rows, Sample, Samples};
use self::smooth::What;
use super::lamp::Lamp;
use super::occlusion::{LampSamples, Light, LightRows, Occlusion, Place, Shares};
use super::pattern::{PERIOD, Pattern};
use super::strength::Strengths;
use super::surfaces::{Found, Packet};
use super::targets::{Target, each_target};
use super::tiles::{TILE, in_tiles};
use crate::ray::Stack;
use crate::rays::Rays;
use crate::spare::Spare;
use crate::{View, Visibility};

/// Samples at a quarter of a view's pixels.
#[derive(Debug)]
pub(super) struct Coarse {
    samples: Samples,
    /// The light of each sample, as [`Between`] interpolates it.
    light: Image<LightRows>,
    has_sky: bool,
}

/// The memory of earlier samples.
#[derive(Debug, Default)]
pub(super) struct SpareCoarse {
    samples: Spare<Rows>,
    light: Spare<LightRows>,
    lamps: Spare<LampSamples>,
}

/// Samples the light of a view.
#[derive(Clone, Copy)]
struct Sampler<'a> {
    view: &'a View,
    rays: &'a Rays<'a>,
    seen: &'a Visibility,
    occlusion: &'a Occlusion<'a>,
    spare: &'a SpareCoarse,
    level: Level,
}

impl<'a> Sampler<'a> {
    /// Finds the surfaces of every other pixel of every other row.
    fn surfaces(&self, width: u32, height: u32) -> Samples {
        let mut samples = Samples::misses(width, height, &self.spare.samples);
        let scene = self.occlusion.scene;
        let row_length = (width as usize).max(1);
        let strips = samples.pixels_mut().par_chunks_mut(TILE as usize * row_length);
        strips.zip(0..height.div_ceil(TILE)).for_each_init(
            || {
                let packet = Packet::new(scene, self.view, self.rays, self.level);
                (Vec::new(), packet)
            },
            |(targets, packet), (strip, row)| {
                let first = TILE * row;
                targets.clear();
                for [x, y] in in_tiles(width, (first..height).take(TILE as usize)) {
                    let [column, line] = [2 * x, 2 * y];
                    let seen = self
                        .seen
                        .hits
                        .get(column, line)
                        .zip(self.seen.z.0.get(column, line));
                    let Some((hit, z)) = seen.filter(|(hit, _)| !hit.is_miss()) else {
                        continue;
                    };
                    targets.push(Target {
                        tag: (y - first) as usize * row_length + x as usize,
                        place: [column, line],
                        hit: *hit,
                        z: *z,
                    });
                }
                for tile in targets.chunks_mut((TILE * TILE) as usize) {
                    each_target(tile, scene, self.level, |Target { tag, place, hit, z }| {
                        let Some(ray) = packet.ray(place) else { return };
                        if !packet.has_room_for(hit.instance) {
                            put(packet, strip);
                        }
                        packet.push(tag, place, ray, hit, z);
                    });
                }
                put(packet, strip);
            },
        );
        samples
    }

    /// Samples the lamps at even samples, and the surroundings at every other sample; the others get NaN.
    fn sample(&self, samples: &Samples) -> (Image<LightRows>, Image<LampSamples>) {
        let (width, height) = (samples.width(), samples.height());
        let row_length = (width as usize).max(1);
        let mut light = self.spare.light.image(width, height, Light::FULL.rows());
        let [columns, rows] = [width.div_ceil(2), height.div_ceil(2)];
        let mut lamp_samples = self.spare.lamps.image(columns, rows, LampSamples::default());
        let strip = TILE as usize * row_length;
        let rows = (light.pixels_mut().par_chunks_mut(strip)).zip(samples.pixels().par_chunks(strip));
        let lamp_rows = TILE as usize / 2 * row_length.div_ceil(2);
        rows.zip(lamp_samples.pixels_mut().par_chunks_mut(lamp_rows))
            .for_each_init(
                Workspace::default,
                |workspace, ((light, samples), lamp_samples)| {
                    let Workspace { strengths, stack } = workspace;
                    let rows = (0..TILE).take(samples.len() / row_length);
                    for [x, y] in in_tiles(width, rows) {
                        let index = y as usize * row_length + x as usize;
                        // The even samples in a row of a tile.
                        if x % TILE == 0 && y % 2 == 0 {
                            self.measure(samples.iter().skip(index).step_by(2), strengths);
                        }
                        let (Some(sample), Some(out)) = (samples.get(index), light.get_mut(index)) else {
                            continue;
                        };
                        if Sample(sample).is_miss() {
                            continue;
                        }
                        let place = Sample(sample).place();
                        let mut light = Light::FULL;
                        let cell = Pattern::cell(x, y);
                        let half = y as usize / 2 * row_length.div_ceil(2) + x as usize / 2;
                        if x % 2 == 0
                            && y % 2 == 0
                            && let Some(lamp_samples) = lamp_samples.get_mut(half)
                        {
                            let strongest = strengths.strongest((x % TILE / 2) as usize);
                            (light, *lamp_samples) =
                                self.occlusion.sample_lamps(&place, strongest, cell, stack);
                        }
                        (light.ambient, light.sky) = if (x + y) % 2 == 0 {
                            self.occlusion.sample_surroundings(&place, cell, stack)
                        } else {
                            (f32::NAN, f32::NAN)
                        };
                        *out = light.rows();
                    }
                },
            );
        (light, lamp_samples)
    }

    /// Measures the lamps at the first eight samples.
    fn measure<'s>(&self, samples: impl Iterator<Item = &'s Rows>, strengths: &mut Strengths) {
        for (lane, [point, normal, ..]) in samples.take(8).enumerate() {
            strengths.set(lane, (*point).into(), (*normal).into());
        }
        strengths.measure(self.occlusion.emitters, self.level);
    }

    /// Computes the light that [`sample`](Self::sample) left out.
    fn complete(
        &self,
        samples: &Samples,
        first: &Image<LightRows>,
        lamp_samples: &Image<LampSamples>,
    ) -> Image<LightRows> {
        let mut complete = (self.spare.light).image(first.width(), first.height(), LightRows::default());
        let (row_length, height) = ((samples.width() as usize).max(1), samples.height());
        let rows =
            (complete.pixels_mut().par_chunks_mut(row_length)).zip(samples.pixels().par_chunks(row_length));
        rows.zip(first.pixels().par_chunks(row_length))
            .zip(0..height)
            .for_each_init(
                Workspace::default,
                |workspace, (((row, samples_of_row), first_of_row), y)| {
                    row.copy_from_slice(first_of_row);
                    let Workspace { strengths, stack } = workspace;
                    for ((out, sample), x) in row.iter_mut().zip(samples_of_row).zip(0..) {
                        if x % 8 == 0 {
                            self.measure(samples_of_row.iter().skip(x as usize), strengths);
                        }
                        let sample = Sample(sample);
                        if sample.is_miss() {
                            continue;
                        }
                        let cell = Pattern::cell(x, y);
                        let place = &sample.place();
                        let mut light = Light::of_rows(*out);
                        let (ambient, sky) = (light.ambient, light.sky);
                        // There is no shadow edge where all even neighbours see a lamp or none does.
                        if x % 2 != 0 || y % 2 != 0 {
                            let around = Neighbours::new(samples, lamp_samples, sample, x, y);
                            let sees = |index: u32, lamp: &Lamp, spot: [f64; 2]| {
                                around
                                    .all_see(index)
                                    .unwrap_or_else(|| self.occlusion.sees(place, lamp, spot, stack))
                            };
                            let strongest = strengths.strongest((x % 8) as usize);
                            (light, _) = self.occlusion.lamplight(place.from_eye, strongest, cell, sees);
                        }
                        (light.ambient, light.sky) = (ambient, sky);
                        // Every other sample takes the mean of its four neighbours.
                        if ambient.is_nan() {
                            (light.ambient, light.sky) = mean_around(samples, first, sample, x, y)
                                .unwrap_or_else(|| self.occlusion.sample_surroundings(place, cell, stack));
                        }
                        *out = light.rows();
                    }
                },
            );
        complete
    }
}

/// The reused memory of a thread.
#[derive(Default)]
struct Workspace {
    strengths: Strengths,
    stack: Stack,
}

impl Coarse {
    pub(super) fn new(
        view: &View,
        rays: &Rays<'_>,
        seen: &Visibility,
        occlusion: &Occlusion<'_>,
        memory: &SpareCoarse,
    ) -> Self {
        let level = occlusion.level;
        let sampler = Sampler {
            view,
            rays,
            seen,
            occlusion,
            spare: memory,
            level,
        };
        let (width, height) = (seen.hits.width().div_ceil(2), seen.hits.height().div_ceil(2));
        let samples = sampler.surfaces(width, height);
        let (mut spare, lamp_samples) = sampler.sample(&samples);
        let mut light = sampler.complete(&samples, &spare, &lamp_samples);
        let mut filter = |steps: [[i32; 2]; 2], what| {
            for step in steps {
                smooth::smooth(&samples, (&light, &mut spare), step, what, level);
                std::mem::swap(&mut light, &mut spare);
            }
        };
        filter([[1, 0], [0, 1]], What::Smooth);
        let has_sky = occlusion.rig.has_sky;
        if has_sky {
            let tile = PERIOD.cast_signed();
            filter([[tile, 0], [0, tile]], What::Surroundings);
        }
        light
            .pixels_mut()
            .par_iter_mut()
            .with_min_len(4096)
            .for_each(|rows| {
                let light = Light::of_rows(*rows);
                let arrived = light.arrived();
                *rows = [[arrived.some, arrived.all, light.ambient], [light.sky, 0.0, 0.0]];
            });
        memory.light.keep(spare);
        memory.lamps.keep(lamp_samples);
        Self {
            samples,
            light,
            has_sky,
        }
    }

    /// Keeps the memory.
    pub(super) fn keep(self, memory: &SpareCoarse) {
        self.samples.keep(&memory.samples);
        memory.light.keep(self.light);
    }

    /// Returns the light at the points that a packet's pixels see, and the lanes that have it; the others see a surface that no sample
    /// lies on.
    pub(super) fn light(&self, found: &Found<'_, '_>, level: Level) -> (Shares, u32) {
        let mut shares = Shares::default();
        let size = [self.samples.width(), self.samples.height()];
        let kernel = Between {
            samples: self.samples.pixels(),
            light: self.light.pixels(),
            size,
            has_sky: self.has_sky,
            found,
            shares: &mut shares,
        };
        let mut known = run_lanes_at(level, kernel);
        for lane in 0..found.count() {
            if (known >> lane) & 1 == 0
                && let Some(light) = self.farther(found.place(lane), &Place::new(found, lane))
            {
                shares.set(lane, light);
                known |= 1 << lane;
            }
        }
        (shares, known)
    }

    /// Returns the weighted mean of the samples of the same surface, also of those one sample farther away than the nearest.
    #[cold]
    fn farther(&self, place: [u32; 2], at: &Place) -> Option<[f32; 3]> {
        let rows = samples::rows(at);
        let [columns, rows_around] = place.map(|x| {
            let [first, last] = between::around(x);
            first.saturating_sub(1)..=last + 1
        });
        let within = |at: u32, count: u32| at.min(count.saturating_sub(1));
        let mut sum = [[0.0; 3]; 2];
        let mut weights = 0.0;
        for row in rows_around {
            let row = within(row, self.samples.height());
            for column in columns.clone() {
                let column = within(column, self.samples.width());
                if let (Some(sample), Some(light)) =
                    (self.samples.get(column, row), self.light.get(column, row))
                {
                    let weight = Sample(&rows).similarity(sample);
                    for (sum, light) in sum.as_flattened_mut().iter_mut().zip(light.as_flattened()) {
                        *sum += light * weight;
                    }
                    weights += weight;
                }
            }
        }
        let [[some, all, ambient], [sky, ..]] = sum;
        let direct = if all > 0.0 { some / all } else { 1.0 };
        (weights > MIN_SIMILARITY).then(|| [direct, ambient / weights, sky / weights])
    }
}

/// Stores the surfaces of a packet in a strip of samples, and clears the packet.
fn put(packet: &mut Packet<'_>, strip: &mut [Rows]) {
    if let Some(found) = packet.find() {
        for lane in 0..found.count() {
            if let Some(sample) = strip.get_mut(found.tag(lane)) {
                *sample = samples::rows(&Place::new(&found, lane));
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
    fn new(samples: &Samples, lamp_samples: &'a Image<LampSamples>, at: Sample<'_>, x: u32, y: u32) -> Self {
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
    samples: &Samples,
    light: &Image<LightRows>,
    at: Sample<'_>,
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
            let light = Light::of_rows(*light);
            ambient += light.ambient * weight;
            sky += light.sky * weight;
            weights += weight;
        }
    }
    (weights > 0.5).then(|| (ambient / weights, sky / weights))
}
