//! The reflected light: converts a row of depth to a row of phasors.

use oaktwin_image::{Image, ImageView, annotation};
use oaktwin_simd::Kernel;

use crate::turns::{fraction, sin_of_turns};

/// The maximum distance of a surface: 10 km.
const LEAST_INVERSE: f32 = 1e-4;

/// The distance at which brightness saturates: 0.1 mm.
const MOST_INVERSE: f32 = 1e4;

/// The tangent of 89°; pixels that are steeper on both sides are edges.
const STEEPEST: f32 = 57.289_96;

/// The minimum albedo.
const LEAST_ALBEDO: f32 = 0.02;

/// Computes inverse depth, 1/m; 0 without a surface and beside the row.
pub(super) struct InverseDepth<'a> {
    pub(super) depth: &'a [f32],
    /// One pixel longer at both ends.
    pub(super) out: &'a mut [f32],
}

impl Kernel for InverseDepth<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let inside = self.out.get_mut(1..).unwrap_or_default();
        for (out, &z) in inside.iter_mut().zip(self.depth) {
            let inverse = 1.0 / z;
            let bounded = if inverse < MOST_INVERSE {
                inverse
            } else {
                MOST_INVERSE
            };
            // False for NaN.
            let surface = (z > 0.0) & (inverse >= LEAST_INVERSE);
            *out = if surface { bounded } else { 0.0 };
        }
    }
}

/// Computes the albedos of a row of the colour image, at least 0.02: an estimate, since the image shows visible light. It
/// is the luma and not its linear value: dyes and paints that look dark reflect much more at 940 nm, and images have shadows.
pub(super) struct Albedos<'a> {
    pub(super) picture: &'a [[u8; 4]],
    pub(super) out: &'a mut [f32],
}

impl Kernel for Albedos<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        for (out, [r, g, b, _]) in self.out.iter_mut().zip(self.picture) {
            let luma = (77 * u16::from(*r) + 150 * u16::from(*g) + 29 * u16::from(*b)) >> 8;
            let albedo = f32::from(luma) * (1.0 / 255.0);
            *out = if albedo > LEAST_ALBEDO {
                albedo
            } else {
                LEAST_ALBEDO
            };
        }
    }
}

/// The light of one row of pixels, with the border pixels repeated at both ends: real and imaginary part of each
/// frequency's phasor, then all light; electrons per sample.
#[derive(Clone, Debug, Default)]
pub(super) struct LightRow {
    pub(super) channels: [Vec<f32>; CHANNELS],
}

/// The channels of a [`LightRow`].
pub(super) const CHANNELS: usize = 5;

impl LightRow {
    pub(super) fn reset(&mut self, width: usize) {
        for channel in &mut self.channels {
            channel.clear();
            channel.resize(width + 2, 0.0);
        }
    }

    /// Repeats the pixels at both ends.
    pub(super) fn close(&mut self) {
        for channel in &mut self.channels {
            match &mut channel[..] {
                [left, first, .., last, right] => (*left, *right) = (*first, *last),
                [left, only, right] => (*left, *right) = (*only, *only),
                _ => {}
            }
        }
    }
}

/// The constants of all rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Lamp {
    pub(super) signal: f32,
    pub(super) contrast: f32,
    pub(super) ambient: f32,
    /// Turns of the phase per metre.
    pub(super) turns_per_m: [f32; 2],
    /// The age of each frequency's measurement, s.
    pub(super) age_s: [f32; 2],
}

/// Computes the phasors of a row.
pub(super) struct Returns<'a> {
    pub(super) lamp: &'a Lamp,
    /// The inverse depth of the row above, this row and the row below, one pixel longer at both ends.
    pub(super) inverse: [&'a [f32]; 3],
    pub(super) depth: &'a [f32],
    pub(super) albedo: &'a [f32],
    /// The error of the distance, m.
    pub(super) shift: &'a [f32],
    /// The radial velocity since each frequency's measurement, m/s.
    pub(super) velocity: [&'a [f32]; 2],
    pub(super) focal_length_px: f32,
    pub(super) u: &'a [f32],
    pub(super) v: f32,
    pub(super) out: &'a mut LightRow,
}

impl<'a> Kernel for Returns<'a> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Lamp {
            signal,
            contrast,
            ambient,
            turns_per_m,
            age_s,
        } = *self.lamp;
        let n = self.depth.len();
        let padded = |row: &'a [f32]| row.get(..n + 2);
        let [Some(above), Some(here), Some(below)] = self.inverse.map(padded) else {
            return;
        };
        let inside = |row: &'a [f32]| row.get(..n);
        let [slow, fast] = self.velocity;
        let rows = [self.albedo, self.shift, slow, fast, self.u].map(inside);
        let [Some(albedo), Some(shift), Some(slow), Some(fast), Some(u)] = rows else {
            return;
        };
        let depth = self.depth;
        let outs = self.out.channels.each_mut().map(|row| row.get_mut(1..=n));
        let [Some(re0), Some(im0), Some(re1), Some(im1), Some(total)] = outs else {
            return;
        };
        let (v, f) = (self.v, self.focal_length_px);
        for x in 0..n {
            let w = here[x + 1];
            let beside = [here[x], here[x + 2], above[x + 1], below[x + 1]];
            let [gx, gy, gz] = plane(w, beside, [u[x], v], f);
            let normal2 = gx * gx + gy * gy + gz * gz;
            let ray2 = 1.0 + u[x] * u[x] + v * v;
            let cosine = w / (normal2 * ray2).sqrt();
            let surface = w > 0.0;
            let reflected = signal * albedo[x] * cosine * (w * w / ray2);
            let reflected = if surface { reflected } else { 0.0 };
            let range = depth[x] * ray2.sqrt() + shift[x];
            let range = if surface { range } else { 0.0 };
            let amplitude = contrast * reflected;
            let seen = [range - slow[x] * age_s[0], range - fast[x] * age_s[1]];
            (re0[x], im0[x]) = phasor(amplitude, seen[0] * turns_per_m[0]);
            (re1[x], im1[x]) = phasor(amplitude, seen[1] * turns_per_m[1]);
            let ambient = if surface { ambient * albedo[x] } else { 0.0 };
            total[x] = reflected + ambient;
        }
    }
}

/// Adds the phasors of both returns, in place of one surface's, in the pixels for which returns are given.
pub(super) struct Echoes<'a> {
    pub(super) lamp: &'a Lamp,
    /// The strength of the first is NaN where the phasors stay.
    pub(super) returns: &'a annotation::Returns,
    /// The row.
    pub(super) y: usize,
    pub(super) shift: &'a [f32],
    pub(super) velocity: [&'a [f32]; 2],
    pub(super) u: &'a [f32],
    pub(super) v: f32,
    pub(super) out: &'a mut LightRow,
}

impl<'a> Kernel for Echoes<'a> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Lamp {
            signal,
            contrast,
            ambient,
            turns_per_m,
            age_s,
        } = *self.lamp;
        let n = self.u.len();
        let inside = |row: &'a [f32]| row.get(..n);
        let of = |image: &'a Image<f32>| ImageView::from(image).row(self.y).unwrap_or_default();
        let [near, far] = self.returns.depths.each_ref().map(of);
        let [strong, weak] = self.returns.strengths.each_ref().map(of);
        let [slow, fast] = self.velocity;
        let rows = [near, far, strong, weak, self.shift, slow, fast].map(inside);
        let [
            Some(near),
            Some(far),
            Some(strong),
            Some(weak),
            Some(shift),
            Some(slow),
            Some(fast),
        ] = rows
        else {
            return;
        };
        let outs = self.out.channels.each_mut().map(|row| row.get_mut(1..=n));
        let [Some(re0), Some(im0), Some(re1), Some(im1), Some(total)] = outs else {
            return;
        };
        for x in 0..n {
            if strong[x].is_nan() {
                continue;
            }
            let u = self.u[x];
            let ray = (1.0 + u * u + self.v * self.v).sqrt();
            let mut sums = [0.0; CHANNELS];
            for (depth, strength) in [(near[x], strong[x]), (far[x], weak[x])] {
                let range = depth * ray;
                let is_surface = (range > 0.0) & (range * LEAST_INVERSE <= 1.0) & (strength > 0.0);
                if !is_surface {
                    continue;
                }
                let inverse = if 1.0 / range < MOST_INVERSE {
                    1.0 / range
                } else {
                    MOST_INVERSE
                };
                let reflected = signal * strength * (inverse * inverse);
                let amplitude = contrast * reflected;
                let seen = range + shift[x];
                let (re, im) = phasor(amplitude, (seen - slow[x] * age_s[0]) * turns_per_m[0]);
                (sums[0], sums[1]) = (sums[0] + re, sums[1] + im);
                let (re, im) = phasor(amplitude, (seen - fast[x] * age_s[1]) * turns_per_m[1]);
                (sums[2], sums[3]) = (sums[2] + re, sums[3] + im);
                sums[4] += reflected + ambient * strength;
            }
            [re0[x], im0[x], re1[x], im1[x], total[x]] = sums;
        }
    }
}

/// Returns the normal g away from the camera, where g·p = 1 for points p of the plane. The inverse depth of a plane is
/// linear in u and v, so this is exact. `beside`: left, right, above, below.
#[inline(always)]
pub(super) fn plane(middle: f32, beside: [f32; 4], [u, v]: [f32; 2], focal_length_px: f32) -> [f32; 3] {
    let [left, right, above, below] = beside;
    let gx = gradient(left, middle, right, focal_length_px);
    let gy = gradient(above, middle, below, focal_length_px);
    [gx, gy, middle - gx * u - gy * v]
}

/// Returns the derivative by u or v at the middle, from the flatter side; 0 across an edge.
#[inline(always)]
fn gradient(before: f32, middle: f32, after: f32, focal_length_px: f32) -> f32 {
    let (a, b) = (middle - before, after - middle);
    let flatter = if a.abs() < b.abs() { a } else { b } * focal_length_px;
    if flatter.abs() > STEEPEST * middle {
        0.0
    } else {
        flatter
    }
}

#[inline(always)]
pub(super) fn phasor(amplitude: f32, turns: f32) -> (f32, f32) {
    let turns = fraction(turns);
    (
        amplitude * sin_of_turns(turns + 0.25),
        amplitude * sin_of_turns(turns),
    )
}
