//! All steps for an image, row by row and in memory that fits the processor's caches.

use oaktwin_image::{ImageView, annotation};
use oaktwin_simd::{self as simd, Level};
use rayon::prelude::*;

use super::light::{Albedos, CHANNELS, Echoes, InverseDepth, Lamp, LightRow, Returns};
use super::multipath::{Add, Multipath, MultipathInput, Normals, Surfaces};
use super::optics::Optics;
use super::receive::{Decode, Decoded, Limits, Mix, Receiver, Sample, Sampled, Unwrap};
use super::{TimeOfFlight, TimeOfFlightOutput};
use crate::filter::DepthConfidence;
use crate::random::{NoiseStage, RandomPlane, Stream};
use crate::{DepthShot, Reason};

/// The rows that one thread processes. The first and the last also require the rows beyond.
const BAND: usize = 48;

/// The measurement of one image.
pub(super) struct Job<'a> {
    sensor: &'a TimeOfFlight,
    optics: Optics,
    depth: ImageView<'a, f32>,
    picture: Option<ImageView<'a, [u8; 4]>>,
    velocities: Option<[ImageView<'a, f32>; 2]>,
    returns: Option<&'a annotation::Returns>,
    /// The random numbers of this frame's measurements, and of the previous frame's if they are shared.
    measurements: [Option<RandomPlane>; 2],
    fixed_pattern: Option<RandomPlane>,
    multipath: Option<Multipath>,
    level: Level,
}

/// The constants of all rows of all images.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Constants {
    pub(super) lamp: Lamp,
    pub(super) receiver: Receiver,
    pub(super) limits: Limits,
    pub(super) albedo: f32,
    pub(super) multipath: f32,
    pub(super) bias_m: f32,
    pub(super) fixed_pattern_m: f32,
    pub(super) velocity_m_s: f32,
    pub(super) confidence: DepthConfidence,
}

/// The memory of one thread.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    /// The rows y − 1, y and y + 1, at their numbers modulo 3.
    inverse: [Vec<f32>; 3],
    light: [LightRow; 3],
    mixed: LightRow,
    albedo: Vec<f32>,
    shift: Vec<f32>,
    velocity: Vec<f32>,
    surfaces: Surfaces,
    words: [Vec<u32>; 2],
    sampled: Sampled,
    depth: Vec<u16>,
    amplitude: Vec<u16>,
    confidence: Vec<u16>,
}

/// A finished row.
pub(super) struct SensedRow<'a> {
    /// Millimetres.
    pub(super) depth: &'a [u16],
    pub(super) amplitude: &'a [u16],
    pub(super) confidence: &'a [u16],
    /// What determined the depth.
    decoded: Decoded<'a>,
}

impl SensedRow<'_> {
    /// Writes the depth in metres.
    pub(super) fn metres(&self, out: &mut [f32]) {
        for (out, &millimetres) in out.iter_mut().zip(self.depth) {
            *out = f32::from(millimetres) / 1000.0;
        }
    }

    /// Writes why pixels have no depth.
    pub(super) fn reasons(&self, out: &mut [u8]) {
        for (x, (code, depth)) in out.iter_mut().zip(self.depth).enumerate() {
            let reason = if *depth > 0 {
                Reason::Measured
            } else {
                self.decoded.reason(x)
            };
            *code = reason.code();
        }
    }
}

impl<'a> Job<'a> {
    pub(super) fn new(sensor: &'a TimeOfFlight, shot: &DepthShot<'a>, random: &Stream) -> Self {
        let p = sensor.parameters();
        let depth = shot.depth();
        let plane = |frame| random.plane(NoiseStage::Correlation, frame, shot.item);
        let shares = p.enable_phase_shuffle_temporal_filter && !p.enable_burst_mode;
        let has_pattern = !p.enable_fppn_correction && p.fixed_pattern_m > 0.0;
        let job = Self {
            sensor,
            optics: Optics::new(p, depth.width(), depth.height()),
            depth,
            picture: shot.rgb(),
            velocities: shot.radial_velocities(),
            returns: shot.returns(),
            measurements: [
                Some(plane(shot.frame)),
                shares.then(|| plane(shot.frame.wrapping_sub(1))),
            ],
            // The same for every frame of the device.
            fixed_pattern: has_pattern.then(|| random.plane(NoiseStage::FixedPattern, 0, 0)),
            multipath: None,
            level: Level::detect(),
        };
        job.with_multipath()
    }

    fn with_multipath(mut self) -> Self {
        let c = self.sensor.constants();
        let is_asked = c.multipath > 0.0 && !self.depth.pixels().is_empty();
        self.multipath = is_asked.then(|| {
            let view = MultipathInput {
                depth: self.depth,
                picture: self.picture,
                albedo: c.albedo,
                optics: &self.optics,
                lamp: &c.lamp,
                level: self.level,
            };
            Multipath::new(&view, c.multipath)
        });
        self
    }

    #[cfg(test)]
    pub(super) fn at(mut self, level: Level) -> Self {
        self.level = level;
        self.with_multipath()
    }

    fn width(&self) -> usize {
        self.depth.width() as usize
    }

    /// Computes the distance of all rows on all threads.
    pub(super) fn distance(&self, out: &mut [f32]) {
        let (band, width) = ((BAND * self.width()).max(1), self.width().max(1));
        out.par_chunks_mut(band)
            .enumerate()
            .for_each_init(Scratch::default, |scratch, (index, out)| {
                let mut rows = out.chunks_exact_mut(width);
                let count = rows.len();
                self.rows(scratch, index * BAND, count, |row| {
                    row.metres(rows.next().unwrap_or_default());
                });
            });
    }

    /// Computes why pixels have no depth.
    pub(super) fn reasons(&self, out: &mut [u8]) {
        let (band, width) = ((BAND * self.width()).max(1), self.width().max(1));
        out.par_chunks_mut(band)
            .enumerate()
            .for_each_init(Scratch::default, |scratch, (index, out)| {
                let mut rows = out.chunks_exact_mut(width);
                let count = rows.len();
                self.rows(scratch, index * BAND, count, |row| {
                    row.reasons(rows.next().unwrap_or_default());
                });
            });
    }

    /// Computes all outputs.
    pub(super) fn output(&self, out: &mut TimeOfFlightOutput) {
        let (band, width) = ((BAND * self.width()).max(1), self.width().max(1));
        let distance = out.distance.0.pixels_mut().par_chunks_mut(band);
        let amplitude = out.amplitude.pixels_mut().par_chunks_mut(band);
        let confidence = out.confidence.pixels_mut().par_chunks_mut(band);
        let bands = distance.zip(amplitude).zip(confidence).enumerate();
        bands.for_each_init(
            Scratch::default,
            |scratch, (index, ((distance, amplitude), confidence))| {
                let count = distance.len() / width;
                let mut rows = distance
                    .chunks_exact_mut(width)
                    .zip(amplitude.chunks_exact_mut(width))
                    .zip(confidence.chunks_exact_mut(width));
                self.rows(scratch, index * BAND, count, |row| {
                    if let Some(((distance, amplitude), confidence)) = rows.next() {
                        row.metres(distance);
                        amplitude.copy_from_slice(row.amplitude);
                        confidence.copy_from_slice(row.confidence);
                    }
                });
            },
        );
    }

    /// Computes `count` rows from `first` and passes each to `finish`.
    pub(super) fn rows(
        &self,
        s: &mut Scratch,
        first: usize,
        count: usize,
        mut finish: impl FnMut(SensedRow<'_>),
    ) {
        if count == 0 || self.width() == 0 {
            return;
        }
        s.begin(self);
        let (first, last) = (first.cast_signed(), (first + count).cast_signed());
        // The light of a row requires the depth of the adjacent rows, the measurement the light of the adjacent rows.
        for y in first - 2..last + 2 {
            s.inverse(self, y);
            if y >= first {
                s.light(self, y - 1);
            }
            if y >= first + 2 {
                s.measure(self, y - 2);
                finish(SensedRow {
                    depth: &s.depth,
                    amplitude: &s.amplitude,
                    confidence: &s.confidence,
                    decoded: Decoded {
                        threshold_m: self.sensor.unwrapping().threshold_m,
                        limits: &self.sensor.constants().limits,
                        sampled: &s.sampled,
                        inverse: &s.inverse[slot(y - 2)],
                    },
                });
            }
        }
    }
}

/// Returns the index of a row's buffer.
fn slot(y: isize) -> usize {
    y.rem_euclid(3) as usize
}

/// Returns a row of an image, or `None` outside it.
fn row<T>(image: ImageView<'_, T>, y: isize) -> Option<&[T]> {
    let width = image.width() as usize;
    let start = usize::try_from(y).ok()?.checked_mul(width)?;
    image.pixels().get(start..start + width)
}

impl Scratch {
    fn begin(&mut self, job: &Job<'_>) {
        let (width, c) = (job.width(), job.sensor.constants());
        for row in &mut self.inverse {
            row.clear();
            row.resize(width + 2, 0.0);
        }
        for row in self.light.iter_mut().chain([&mut self.mixed]) {
            row.reset(width);
        }
        let fill = |row: &mut Vec<f32>, value| {
            row.clear();
            row.resize(width, value);
        };
        fill(&mut self.albedo, c.albedo);
        fill(&mut self.shift, c.bias_m);
        fill(&mut self.velocity, c.velocity_m_s);
        self.sampled.reset(width);
        if job.multipath.is_some() {
            self.surfaces.reset(width);
        }
        for row in [&mut self.depth, &mut self.amplitude, &mut self.confidence] {
            row.clear();
            row.resize(width, 0);
        }
    }

    /// There is no surface beyond the border.
    fn inverse(&mut self, job: &Job<'_>, y: isize) {
        let out = &mut self.inverse[slot(y)];
        match row(job.depth, y) {
            None => out.fill(0.0),
            Some(depth) => simd::run_at(job.level, InverseDepth { depth, out }),
        }
    }

    fn light(&mut self, job: &Job<'_>, y: isize) {
        let Some(depth) = row(job.depth, y) else { return };
        let c = job.sensor.constants();
        if let Some(picture) = job.picture.and_then(|picture| row(picture, y)) {
            simd::run_at(
                job.level,
                Albedos {
                    picture,
                    out: &mut self.albedo,
                },
            );
        }
        if let Some(pattern) = &job.fixed_pattern {
            pattern.normals(counter(y), &mut self.shift);
            for shift in &mut self.shift {
                *shift = c.bias_m + c.fixed_pattern_m * *shift;
            }
        }
        let of_row = |velocity| row(velocity, y).unwrap_or(&self.velocity);
        let velocity = (job.velocities).map_or([&self.velocity[..]; 2], |both| both.map(of_row));
        let rows @ [_, here, _] = [y - 1, y, y + 1].map(slot);
        let inverse = rows.map(|slot| self.inverse[slot].as_slice());
        let out = &mut self.light[here];
        simd::run_at(
            job.level,
            Returns {
                lamp: &c.lamp,
                inverse,
                depth,
                albedo: &self.albedo,
                shift: &self.shift,
                velocity,
                focal_length_px: job.optics.focal_length_px,
                u: &job.optics.columns,
                v: job.optics.row(y),
                out,
            },
        );
        if let Some(returns) = job.returns {
            simd::run_at(
                job.level,
                Echoes {
                    lamp: &c.lamp,
                    returns,
                    y: y.unsigned_abs(),
                    shift: &self.shift,
                    velocity,
                    u: &job.optics.columns,
                    v: job.optics.row(y),
                    out,
                },
            );
        }
        if let Some(multipath) = &job.multipath {
            simd::run_at(
                job.level,
                Normals {
                    inverse,
                    depth,
                    focal_length_px: job.optics.focal_length_px,
                    u: &job.optics.columns,
                    v: job.optics.row(y),
                    out: &mut self.surfaces,
                },
            );
            multipath.spread(job.level, y.unsigned_abs(), &mut self.surfaces);
            simd::run_at(
                job.level,
                Add {
                    lamp: &c.lamp,
                    signal: multipath.signal(),
                    surfaces: &self.surfaces,
                    albedo: &self.albedo,
                    shift: &self.shift,
                    velocity,
                    out,
                },
            );
        }
        out.close();
    }

    fn measure(&mut self, job: &Job<'_>, y: isize) {
        let (c, width) = (job.sensor.constants(), job.width());
        // Beyond the border, the border is repeated.
        let last = (job.depth.height() as usize).cast_signed() - 1;
        let slots = [y - 1, y, y + 1].map(|y| slot(y.clamp(0, last)));
        let is_mixed = c.receiver.mixing > 0.0;
        if is_mixed {
            for channel in 0..CHANNELS {
                simd::run_at(
                    job.level,
                    Mix {
                        weight: c.receiver.mixing,
                        rows: slots.map(|slot| self.light[slot].channels[channel].as_slice()),
                        out: &mut self.mixed.channels[channel],
                    },
                );
            }
        }
        let seen = if is_mixed {
            &self.mixed
        } else {
            &self.light[slots[1]]
        };
        let stride = width.next_multiple_of(64);
        for (words, plane) in self.words.iter_mut().zip(&job.measurements) {
            words.resize(plane.map_or(0, |_| 2 * stride), 0);
            if let Some(plane) = plane {
                plane.row_words(counter(y), words);
            }
        }
        let [re0, im0, re1, im1, total] = &seen.channels;
        for (frequency, phasor) in [[re0, im0], [re1, im1]].into_iter().enumerate() {
            let words = self.words.each_ref();
            simd::run_at(
                job.level,
                Sample {
                    receiver: &c.receiver,
                    phasor: phasor.map(Vec::as_slice),
                    total,
                    words: words.map(|words| words.get(frequency * stride..).unwrap_or_default()),
                    turns: &mut self.sampled.turns[frequency][..width],
                    amplitude: &mut self.sampled.amplitudes[frequency],
                    fullest: &mut self.sampled.fullest[frequency],
                },
            );
        }
        simd::run_at(
            job.level,
            Unwrap {
                unwrapping: job.sensor.unwrapping(),
                sampled: &mut self.sampled,
            },
        );
        simd::run_at(
            job.level,
            Decode {
                threshold_m: job.sensor.unwrapping().threshold_m,
                limits: &c.limits,
                sampled: &self.sampled,
                inverse: &self.inverse[slots[1]],
                u: &job.optics.columns,
                v: job.optics.row(y),
                depth: &mut self.depth,
                amplitude: &mut self.amplitude,
            },
        );
        c.confidence
            .run_rows(job.level, &self.amplitude, &mut self.depth, &mut self.confidence);
    }
}

/// Converts a row number for the generator.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "images have less than 2³² rows, none below 0"
)]
fn counter(y: isize) -> u32 {
    y as u32
}
