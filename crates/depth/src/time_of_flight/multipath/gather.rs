//! The light of all patches at some receivers.

use oaktwin_simd::Kernel;

use super::ReceiverPosition;
use super::patches::Patch;
use crate::time_of_flight::light::{CHANNELS, phasor};

/// The receivers that are processed together.
pub(super) const LANES: usize = 16;

/// A number far below every relevant squared distance, m².
const TINY: f32 = 1e-12;

/// Adjacent receivers.
#[derive(Clone, Debug)]
pub(super) struct Lit {
    point: [[f32; LANES]; 3],
    normal: [[f32; LANES]; 3],
}

impl Lit {
    /// Of [`LANES`] or fewer.
    pub(super) fn new(found: &[ReceiverPosition]) -> Self {
        let mut lit = Self {
            point: [[0.0; LANES]; 3],
            normal: [[0.0; LANES]; 3],
        };
        for (lane, found) in found.iter().enumerate().take(LANES) {
            for axis in 0..3 {
                lit.point[axis][lane] = found.point[axis];
                lit.normal[axis][lane] = found.normal[axis];
            }
        }
        lit
    }
}

/// Real and imaginary part of each frequency's phasor, then all light, relative to the lamp's light at 1 m.
pub(super) struct Gather<'a> {
    pub(super) patches: &'a [Patch],
    pub(super) found: &'a Lit,
    pub(super) turns_per_m: [f32; 2],
}

impl Kernel for Gather<'_> {
    type Output = [[f32; LANES]; CHANNELS];

    #[inline(always)]
    fn run(self) -> Self::Output {
        let mut sums = [[0.0f32; LANES]; CHANNELS];
        let [px, py, pz] = self.found.point;
        let [nx, ny, nz] = self.found.normal;
        let [low, high] = self.turns_per_m;
        for patch in self.patches {
            let ([x, y, z], [a, b, c]) = (patch.point, patch.normal);
            let Patch {
                flux, area, range, ..
            } = *patch;
            for i in 0..LANES {
                let (dx, dy, dz) = (x - px[i], y - py[i], z - pz[i]);
                let square = dx * dx + dy * dy + dz * dz;
                // Each is a cosine times the distance.
                let here = nx[i] * dx + ny[i] * dy + nz[i] * dz;
                let there = -(a * dx + b * dy + c * dz);
                let seen = (here > 0.0) & (there > 0.0);
                let light = flux * here * there / ((square + TINY) * (std::f32::consts::PI * square + area));
                let light = if seen { light } else { 0.0 };
                let way = 0.5 * (range + square.sqrt());
                let (re, im) = phasor(light, way * low);
                sums[0][i] += re;
                sums[1][i] += im;
                let (re, im) = phasor(light, way * high);
                sums[2][i] += re;
                sums[3][i] += im;
                sums[4][i] += light;
            }
        }
        sums
    }
}
