//! Filtering of the light over the sampling pattern.

use oaktwin_image::Image;
use oaktwin_simd::{I32Lanes, LaneKernel, Lanes, Level, run_lanes_at};
use rayon::prelude::*;

use super::samples::{Rows, Samples, Surfaces, row};
use crate::ray::Vector;
use crate::shade::occlusion::LightRows;
use crate::shade::pattern::PERIOD;

/// What a filter changes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum What {
    /// All light except the light of small lamps, which cast sharp shadows.
    Smooth,
    /// The light of the surroundings and the sky.
    Surroundings,
}

/// Filters over four samples of the same surface, `step` apart, from two before to one after, into another image.
pub(super) fn smooth(
    samples: &Samples,
    (from, to): (&Image<LightRows>, &mut Image<LightRows>),
    step: [i32; 2],
    what: What,
    level: Level,
) {
    let size = [samples.width(), samples.height()];
    let rows = to.pixels_mut().par_chunks_mut((size[0] as usize).max(1));
    rows.zip(0..size[1]).for_each(|(out, y)| {
        let kernel = Smooth {
            samples: samples.pixels(),
            light: from.pixels(),
            size,
            y,
            step,
            what,
            out,
        };
        run_lanes_at(level, kernel);
    });
}

/// Filters a row.
struct Smooth<'a> {
    samples: &'a [Rows],
    light: &'a [LightRows],
    size: [u32; 2],
    y: u32,
    step: [i32; 2],
    what: What,
    out: &'a mut [LightRows],
}

impl LaneKernel for Smooth<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(mut self) {
        let zero = L::splat(0.0);
        let nothing = Vector::<L>::splat([0.0; 3]);
        for x in (0..self.size[0]).step_by(8) {
            let (own, _) = self.samples_at(x, [0, 0]);
            let surfaces = Surfaces::<L>::load(self.samples, own);
            let (mut first, mut second) = (nothing, nothing);
            let mut weights = zero;
            for i in 0..PERIOD.cast_signed() {
                let steps = i - PERIOD.cast_signed() / 2;
                let (at, is_inside) = self.samples_at(x, [self.step[0] * steps, self.step[1] * steps]);
                let weight = if steps == 0 {
                    L::splat(1.0)
                } else {
                    let weight = surfaces.similarity(self.samples, at);
                    L::select(L::I32::load(&is_inside), weight, zero)
                };
                first = first + row(self.light, at, 0) * weight;
                second = second + row(self.light, at, 1) * weight;
                weights = weights + weight;
            }
            let scale = L::splat(1.0) / weights;
            let mut smooth = [[[0.0; 8]; 3]; 2];
            (first * scale).store(&mut smooth[0]);
            (second * scale).store(&mut smooth[1]);
            self.put(x as usize, surfaces.per_tolerance.to_array(), &smooth);
        }
    }
}

impl Smooth<'_> {
    /// Returns the indices of eight consecutive samples from column `x` on, moved by an offset, and the mask of those that are
    /// inside the image; the others are samples at its border.
    #[inline(always)]
    fn samples_at(&self, x: u32, by: [i32; 2]) -> ([u32; 8], [i32; 8]) {
        let [width, height] = self.size.map(u32::cast_signed);
        let y = self.y.cast_signed() + by[1];
        let is_row_inside = y >= 0 && y < height;
        let first = y.clamp(0, height - 1) * width;
        let (mut at, mut is_inside) = ([0; 8], [0; 8]);
        for ((at, is_inside), lane) in at.iter_mut().zip(&mut is_inside).zip(0..) {
            let x = x.cast_signed() + lane + by[0];
            *at = (first + x.clamp(0, width - 1)).cast_unsigned();
            *is_inside = -i32::from(is_row_inside && x >= 0 && x < width);
        }
        (at, is_inside)
    }

    /// Writes the light of eight samples, except for misses.
    #[inline(always)]
    fn put(&mut self, x: usize, per_tolerance: [f32; 8], smooth: &[[[f32; 8]; 3]; 2]) {
        let first = self.y as usize * self.size[0] as usize + x;
        for lane in 0..8.min(self.out.len() - x) {
            let mut light = self.light[first + lane];
            if per_tolerance[lane] != 0.0 {
                if self.what == What::Smooth {
                    light[0][2] = smooth[0][2][lane];
                    light[1][0] = smooth[1][0][lane];
                }
                light[1][1] = smooth[1][1][lane];
                light[1][2] = smooth[1][2][lane];
            }
            self.out[x + lane] = light;
        }
    }
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation, reason = "small numbers")]
mod tests {
    use super::super::samples::Sample;
    use super::*;
    use crate::spare::Spare;

    /// Returns a number from 0 to 1.
    fn number(seed: u32) -> f32 {
        let mixed = seed.wrapping_mul(0x9e37_79b1) ^ seed.rotate_left(13).wrapping_mul(0x85eb_ca6b);
        f32::from((mixed >> 16) as u16) / 65_535.0
    }

    /// Samples on two walls, with some misses, and their light.
    fn scene() -> (Samples, Image<LightRows>) {
        let (width, height) = (21, 13);
        let mut samples = Samples::misses(width, height, &Spare::default());
        let mut light = Image::filled(width, height, LightRows::default());
        let pixels = samples.pixels_mut().iter_mut().zip(light.pixels_mut());
        for (at, (sample, light)) in (0u32..).zip(pixels) {
            *light = std::array::from_fn(|row| {
                std::array::from_fn(|column| number(at * 6 + 3 * row as u32 + column as u32))
            });
            if number(at + 999) < 0.2 {
                continue;
            }
            let is_left = at % width < 9;
            let normal = if is_left {
                [0.0, 0.6, -0.8]
            } else {
                [-1.0, 0.0, 0.0]
            };
            let point = [number(at + 5) * 0.01, 0.1, 2.0 + 0.001 * number(at + 7)];
            *sample = [point, normal, normal, [2.0, 50.0, 0.0]];
        }
        (samples, light)
    }

    fn expected(samples: &Samples, light: &Image<LightRows>, step: [i32; 2], what: What) -> Vec<LightRows> {
        let places = (0..samples.height()).flat_map(|y| (0..samples.width()).map(move |x| (x, y)));
        let smooth = |(x, y)| {
            let own = *light.get(x, y).unwrap();
            let sample = samples.get(x, y).unwrap();
            if sample.is_miss() {
                return own;
            }
            let (mut sum, mut weights) = (LightRows::default(), 0.0);
            for i in -2..2 {
                let (x, y) = (
                    x.wrapping_add_signed(step[0] * i),
                    y.wrapping_add_signed(step[1] * i),
                );
                let Some(other): Option<Sample<'_>> = samples.get(x, y) else {
                    continue;
                };
                let weight = if i == 0 { 1.0 } else { sample.similarity(other) };
                let others = light.get(x, y).unwrap().as_flattened();
                for (sum, value) in sum.as_flattened_mut().iter_mut().zip(others) {
                    *sum += value * weight;
                }
                weights += weight;
            }
            sum.as_flattened_mut()
                .iter_mut()
                .for_each(|value| *value /= weights);
            if what == What::Smooth {
                [[own[0][0], own[0][1], sum[0][2]], sum[1]]
            } else {
                [own[0], [own[1][0], sum[1][1], sum[1][2]]]
            }
        };
        places.map(smooth).collect()
    }

    #[test]
    fn matches_the_formula_at_every_level() {
        let (samples, light) = scene();
        for (step, what) in [
            ([1, 0], What::Smooth),
            ([0, 1], What::Smooth),
            ([4, 0], What::Surroundings),
            ([0, 4], What::Surroundings),
        ] {
            let expected = expected(&samples, &light, step, what);
            assert_ne!(expected, light.pixels());
            let made = Level::available().into_iter().map(|level| {
                let mut out = light.clone();
                smooth(&samples, (&light, &mut out), step, what, level);
                out
            });
            let made: Vec<_> = made.collect();
            for out in &made {
                assert_eq!(*out, made[0]);
                let pairs = out.pixels().as_flattened().iter().flatten();
                for (value, expected) in pairs.zip(expected.as_flattened().iter().flatten()) {
                    assert!((value - expected).abs() < 1e-6, "{value} {expected}");
                }
            }
        }
    }
}
