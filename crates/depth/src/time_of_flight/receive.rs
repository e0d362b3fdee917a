//! The sensor's processing of light: samples, phases and distances.

use oaktwin_simd::Kernel;

use super::unwrap::Unwrapping;
use crate::Reason;
use crate::random::box_muller;
use crate::turns::angle_in_turns;

/// 2²³: from here to 2²⁴, `float32` represents exactly the integers, in its lowest bits. Adding it rounds, halves to even.
const ONE_A_STEP: f32 = 8_388_608.0;

/// A number far below every amplitude.
const TINY: f32 = 1e-30;

/// Mixes the light of three rows into the middle one.
pub(super) struct Mix<'a> {
    pub(super) weight: f32,
    pub(super) rows: [&'a [f32]; 3],
    pub(super) out: &'a mut [f32],
}

impl Kernel for Mix<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let (side, middle) = (self.weight, 1.0 - 2.0 * self.weight);
        let [above, here, below] = self.rows;
        for (((out, &a), &h), &b) in self.out.iter_mut().zip(above).zip(here).zip(below) {
            *out = middle * h + side * (a + b);
        }
    }
}

/// The constants of all rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Receiver {
    /// The weight of each neighbour.
    pub(super) mixing: f32,
    /// The wiggling of the amplitude, and of the phase.
    pub(super) wiggling: [f32; 2],
    /// Electrons² per sample.
    pub(super) read_variance: f32,
    /// The standard deviation of the mean of one or two random numbers.
    pub(super) noise: f32,
}

/// Computes the noisy phase and amplitude of one frequency.
///
/// A pixel takes four samples, a quarter of a period apart: total + amplitude·cos(φ − kπ/2), with shot noise and read
/// noise. Half the differences of opposite samples are the parts of the phasor, each with the variance
/// (total + read noise²)/2 at every phase, so that the phasor is drawn directly. Its length has Rice's distribution.
pub(super) struct Sample<'a> {
    pub(super) receiver: &'a Receiver,
    /// One pixel longer at both ends.
    pub(super) phasor: [&'a [f32]; 2],
    pub(super) total: &'a [f32],
    /// One word per pixel and measurement: the upper half is the radius, the lower the angle.
    pub(super) words: [&'a [u32]; 2],
    pub(super) turns: &'a mut [f32],
    pub(super) amplitude: &'a mut [f32],
    /// The electrons in the fullest sample.
    pub(super) fullest: &'a mut [f32],
}

impl<'a> Kernel for Sample<'a> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let n = self.turns.len();
        let padded = |row: &'a [f32]| row.get(..n + 2);
        let [Some(re), Some(im)] = self.phasor.map(padded) else {
            return;
        };
        let (Some(total), Some(first)) = (padded(self.total), self.words[0].get(..n)) else {
            return;
        };
        let second = self.words[1].get(..n);
        let (Some(amplitude), Some(fullest)) = (self.amplitude.get_mut(..n), self.fullest.get_mut(..n))
        else {
            return;
        };
        let turns = self.turns;
        let receiver = *self.receiver;
        let (side, middle) = (receiver.mixing, 1.0 - 2.0 * receiver.mixing);
        for x in 0..n {
            let mut noise = normal(first[x]);
            if let Some(second) = second {
                let other = normal(second[x]);
                noise = [noise[0] + other[0], noise[1] + other[1]];
            }
            let re = middle * re[x + 1] + side * (re[x] + re[x + 2]);
            let im = middle * im[x + 1] + side * (im[x] + im[x + 2]);
            let total = middle * total[x + 1] + side * (total[x] + total[x + 2]);
            let length = (re * re + im * im).sqrt();
            let per = 1.0 / (length + TINY);
            let (c, s) = (re * per, im * per);
            let (c2, s2) = (c * c - s * s, 2.0 * c * s);
            let (c4, s4) = (c2 * c2 - s2 * s2, 2.0 * c2 * s2);
            let shape = 1.0 + receiver.wiggling[0] * c4;
            let turn = -receiver.wiggling[1] * s4;
            let sigma = receiver.noise * ((total + receiver.read_variance) * 0.5).sqrt();
            let noisy_re = shape * (re - turn * im) + sigma * noise[0];
            let noisy_im = shape * (im + turn * re) + sigma * noise[1];
            turns[x] = angle_in_turns(noisy_re, noisy_im);
            amplitude[x] = (noisy_re * noisy_re + noisy_im * noisy_im).sqrt();
            fullest[x] = total + length * shape;
        }
    }
}

/// Returns two independent standard normal numbers for the halves of a word, up to 4.9 standard deviations.
#[inline(always)]
fn normal(word: u32) -> [f32; 2] {
    // The centre of the interval of the 16 bits.
    box_muller(word & 0xFFFF_0000 | 0x8000, word << 16)
}

/// The pixels that are unwrapped together.
const LANES: usize = 16;

/// The phases and amplitudes of a row at both frequencies and the resulting distances, padded to [`LANES`].
#[derive(Clone, Debug, Default)]
pub(super) struct Sampled {
    pub(super) turns: [Vec<f32>; 2],
    pub(super) amplitudes: [Vec<f32>; 2],
    pub(super) fullest: [Vec<f32>; 2],
    /// The distance along the ray, m.
    range: Vec<f32>,
    /// The difference between the two frequencies' distances, m.
    apart: Vec<f32>,
}

impl Sampled {
    pub(super) fn reset(&mut self, width: usize) {
        let pairs = [&mut self.turns, &mut self.amplitudes, &mut self.fullest];
        let rows = pairs.into_iter().flatten();
        for row in rows.chain([&mut self.range, &mut self.apart]) {
            row.clear();
            row.resize(width.next_multiple_of(LANES), 0.0);
        }
    }
}

/// Converts phases to distances.
pub(super) struct Unwrap<'a> {
    pub(super) unwrapping: &'a Unwrapping,
    pub(super) sampled: &'a mut Sampled,
}

impl Kernel for Unwrap<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Unwrapping { turn_m, weights, .. } = *self.unwrapping;
        let [turns0, turns1] = self.sampled.turns.each_ref();
        let (turns0, turns1) = (turns0.as_chunks::<LANES>().0, turns1.as_chunks::<LANES>().0);
        let ranges = self.sampled.range.as_chunks_mut::<LANES>().0;
        let aparts = self.sampled.apart.as_chunks_mut::<LANES>().0;
        let chunks = turns0.iter().zip(turns1).zip(ranges).zip(aparts);
        for (((turns0, turns1), range), apart) in chunks {
            let (mut best, mut least) = ([0.0f32; LANES], [f32::INFINITY; LANES]);
            for periods in &self.unwrapping.candidates {
                for i in 0..LANES {
                    let a = turns0[i] * turn_m[0] + periods[0];
                    let b = turns1[i] * turn_m[1] + periods[1];
                    let apart = (a - b).abs();
                    let fits = apart < least[i];
                    let mean = weights[0] * a + weights[1] * b;
                    best[i] = if fits { mean } else { best[i] };
                    least[i] = if fits { apart } else { least[i] };
                }
            }
            (*range, *apart) = (best, least);
        }
    }
}

/// The conditions for a valid pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Limits {
    pub(super) min_amplitude: f32,
    pub(super) full_well: f32,
    /// Whether distance is converted to depth.
    pub(super) is_depth: bool,
}

/// What determined the depths of a row.
pub(super) struct Decoded<'a> {
    pub(super) threshold_m: f32,
    pub(super) limits: &'a Limits,
    pub(super) sampled: &'a Sampled,
    /// As in [`Decode::inverse`].
    pub(super) inverse: &'a [f32],
}

impl Decoded<'_> {
    /// Returns why a pixel without a depth has none.
    pub(super) fn reason(&self, x: usize) -> Reason {
        let at = |row: &[f32]| row.get(x).copied().unwrap_or_default();
        let [first, second] = self.sampled.fullest.each_ref().map(|row| at(row));
        let [strong, weak] = self.sampled.amplitudes.each_ref().map(|row| at(row));
        let has_surface = self.inverse.get(x + 1).is_some_and(|inverse| *inverse > 0.0);
        if !has_surface {
            Reason::NoSurface
        } else if first.max(second) > self.limits.full_well {
            Reason::Saturated
        } else if 0.5 * (strong + weak) < self.limits.min_amplitude {
            Reason::LowAmplitude
        } else if at(&self.sampled.apart) > self.threshold_m {
            Reason::WrappedPhase
        } else if at(&self.sampled.range) > 1.0 && at(&self.sampled.range) * 1000.0 >= 65535.5 {
            Reason::TooFar
        } else if at(&self.sampled.range) < 5e-4 {
            Reason::TooNear
        } else {
            // Confidence follows from the amplitude.
            Reason::LowAmplitude
        }
    }
}

/// Converts distances to whole millimetres.
pub(super) struct Decode<'a> {
    /// The maximum difference between the two frequencies' distances, m.
    pub(super) threshold_m: f32,
    pub(super) limits: &'a Limits,
    pub(super) sampled: &'a Sampled,
    /// The inverse depth of this row, one pixel longer at both ends; 0 without a surface.
    pub(super) inverse: &'a [f32],
    pub(super) u: &'a [f32],
    pub(super) v: f32,
    /// Millimetres, 0 where nothing was measured.
    pub(super) depth: &'a mut [u16],
    /// Electrons.
    pub(super) amplitude: &'a mut [u16],
}

impl Kernel for Decode<'_> {
    type Output = ();

    #[inline(always)]
    #[expect(
        clippy::cast_possible_truncation,
        reason = "whole numbers are in the low 16 bits"
    )]
    fn run(self) {
        let n = self.depth.len();
        let sampled = self.sampled;
        let pairs = [&sampled.amplitudes, &sampled.fullest];
        let [
            [Some(amplitude0), Some(amplitude1)],
            [Some(fullest0), Some(fullest1)],
        ] = pairs.map(|pair| [pair[0].get(..n), pair[1].get(..n)])
        else {
            return;
        };
        let (Some(range), Some(apart)) = (sampled.range.get(..n), sampled.apart.get(..n)) else {
            return;
        };
        let rows = (
            self.inverse.get(1..=n),
            self.u.get(..n),
            self.amplitude.get_mut(..n),
        );
        let (Some(inverse), Some(u), Some(amplitude_out)) = rows else {
            return;
        };
        let limits = *self.limits;
        for x in 0..n {
            let ray = (1.0 + u[x] * u[x] + self.v * self.v).sqrt();
            let z = if limits.is_depth { range[x] / ray } else { range[x] };
            let millimetres = z * 1000.0;
            let amplitude = 0.5 * (amplitude0[x] + amplitude1[x]);
            let (a, b) = (fullest0[x], fullest1[x]);
            let kept = (inverse[x] > 0.0)
                & (apart[x] <= self.threshold_m)
                & (amplitude >= limits.min_amplitude)
                & (a <= limits.full_well)
                & (b <= limits.full_well)
                & (millimetres < 65535.5);
            let bounded = if kept { millimetres } else { 0.0 };
            self.depth[x] = (bounded + ONE_A_STEP).to_bits() as u16;
            let bounded = if amplitude < 65535.0 { amplitude } else { 65535.0 };
            amplitude_out[x] = (bounded + ONE_A_STEP).to_bits() as u16;
        }
    }
}
