//! The light of each lamp at eight points, without shadows.

use glam::Vec3;
use oaktwin_simd::{LaneKernel, Lanes, Level, run_lanes_at};

use super::lamp::{Emitter, Receiver};
use super::rig::luminance;
use super::surfaces::{Columns, set_lane};
use crate::ray::Vector;

/// The number of lamps for which shadow rays are cast, beginning with the strongest; the others get the same shadow.
pub(super) const MAX_SHADOWS: usize = 4;

/// The lamps that contribute most to a point, with their luminance.
pub(super) type Strongest = [Option<(u32, f32)>; MAX_SHADOWS];

/// The reused memory for the strengths of lamps at eight points.
#[derive(Debug, Default)]
pub(super) struct Strengths {
    points: Columns,
    normals: Columns,
    /// The luminance of each lamp.
    of_lamps: Vec<[f32; 8]>,
}

impl Strengths {
    /// Sets the point, relative to the eye, and the normal of one of eight lanes.
    #[inline]
    pub(super) fn set(&mut self, lane: usize, point: Vec3, normal: Vec3) {
        set_lane(&mut self.points, lane, point);
        set_lane(&mut self.normals, lane, normal);
    }

    /// Measures the lamps in all lanes.
    pub(super) fn measure(&mut self, emitters: &[Emitter], level: Level) {
        let kernel = Measure {
            emitters,
            strengths: self,
        };
        run_lanes_at(level, kernel);
    }

    /// Returns the lamps that contribute most in a lane.
    #[inline]
    pub(super) fn strongest(&self, lane: usize) -> Strongest {
        let mut strongest = [None; MAX_SHADOWS];
        for (index, strengths) in (0u32..).zip(&self.of_lamps) {
            let strength = strengths[lane & 7];
            let mut entry = (strength > 0.0).then_some((index, strength));
            for slot in &mut strongest {
                if entry.is_some()
                    && slot.is_none_or(|(_, other): (u32, f32)| other < entry.map_or(0.0, |(_, mine)| mine))
                {
                    std::mem::swap(slot, &mut entry);
                }
            }
        }
        strongest
    }
}

struct Measure<'a> {
    emitters: &'a [Emitter],
    strengths: &'a mut Strengths,
}

impl LaneKernel for Measure<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Strengths {
            points,
            normals,
            of_lamps,
        } = self.strengths;
        let (point, normal) = (Vector::<L>::load(points), Vector::load(normals));
        of_lamps.resize(self.emitters.len(), [0.0; 8]);
        for (strength, emitter) in of_lamps.iter_mut().zip(self.emitters) {
            let mut sum = Sum {
                normal,
                strength: L::splat(0.0),
            };
            emitter.shine(point, &mut sum);
            sum.strength.store(strength);
        }
    }
}

/// The luminance that a diffuse surface receives.
struct Sum<L: Lanes> {
    normal: Vector<L>,
    strength: L,
}

impl<L: Lanes> Receiver<L> for Sum<L> {
    #[inline(always)]
    fn receive(&mut self, towards: Vector<L>, share: L, radiance: Vec3, _: L) {
        let cosine = self.normal.dot(towards).max(L::splat(0.0));
        self.strength = self.strength + L::splat(luminance(radiance)) * share * cosine;
    }
}
