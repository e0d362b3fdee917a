//! Interpolation of the light between samples.

use oaktwin_simd::{I32Lanes, LaneKernel, Lanes};

use super::samples::{Rows, Surfaces, row};
use crate::ray::Vector;
use crate::shade::occlusion::{LightRows, Shares};
use crate::shade::surfaces::PacketSurfaces;

/// The minimum total similarity for interpolation.
pub(super) const MIN_SIMILARITY: f32 = 0.02;

/// The difference between the shares of lamp light around a pixel that marks the edge of a shadow.
const EDGE: f32 = 0.06;

/// Returns the columns, or the rows, of the samples around a pixel: pixels in even columns coincide with a sample and the others lie
/// between two.
pub(super) const fn around(x: u32) -> [u32; 2] {
    [x / 2, x.div_ceil(2)]
}

/// Interpolates between the samples around the pixels of a packet. Returns the lanes that have samples of the same surface, the others
/// are arbitrary, and those at the edge of a shadow.
pub(super) struct Between<'a> {
    pub(super) samples: &'a [Rows],
    /// The light that arrives and that without shadows of lamps, the light of the surroundings; the light of the sky, the share of lamp
    /// light.
    pub(super) light: &'a [LightRows],
    pub(super) size: [u32; 2],
    pub(super) found: &'a PacketSurfaces<'a, 'a>,
    pub(super) shares: &'a mut Shares,
}

impl LaneKernel for Between<'_> {
    type Output = [u32; 2];

    #[inline(always)]
    fn run<L: Lanes>(self) -> [u32; 2] {
        let zero = L::splat(0.0);
        let surfaces = self.found.surfaces;
        let at = Surfaces::<L>::new(
            Vector::load(&surfaces.point),
            Vector::load(&surfaces.normal),
            L::load(&surfaces.range),
        );
        let (columns, rows) = self.places();
        let mut sum = Vector::<L>::splat([0.0; 3]);
        let (mut sky, mut weights) = (zero, zero);
        let (mut lowest, mut highest) = (L::splat(1.0), zero);
        for (row_of, is_row) in &rows {
            for (column_of, is_column) in &columns {
                let mask = L::I32::load(is_row) & L::I32::load(is_column);
                if mask.signs() == 0 {
                    continue;
                }
                let mut samples = [0; 8];
                for lane in 0..8 {
                    samples[lane] = row_of[lane] * self.size[0] + column_of[lane];
                }
                let weight = L::select(mask, at.similarity(self.samples, samples), zero);
                sum = sum + row(self.light, samples, 0) * weight;
                let more = row::<L, 2>(self.light, samples, 1);
                sky = sky + more.x * weight;
                let is_same = L::splat(MIN_SIMILARITY).lt(weight);
                lowest = L::select(is_same, lowest.min(more.y), lowest);
                highest = L::select(is_same, highest.max(more.y), highest);
                weights = weights + weight;
            }
        }
        let direct = L::select(zero.lt(sum.y), sum.x / sum.y, L::splat(1.0));
        direct.store(&mut self.shares.direct);
        (sum.z / weights).store(&mut self.shares.ambient);
        (sky / weights).store(&mut self.shares.sky);
        let known = L::splat(MIN_SIMILARITY).lt(weights).signs();
        [known, (lowest + L::splat(EDGE)).lt(highest).signs()]
    }
}

/// The first or the second column, or row, of the samples around eight pixels, and the mask of the pixels that have it.
type SampleLine = ([u32; 8], [i32; 8]);

impl Between<'_> {
    /// Returns the columns and the rows of the samples around the pixels.
    #[inline(always)]
    fn places(&self) -> ([SampleLine; 2], [SampleLine; 2]) {
        let mut lines = [[([0; 8], [-1; 8]); 2]; 2];
        for lane in 0..8 {
            let place = self.found.place(lane);
            for axis in 0..2 {
                let [first, second] = around(place[axis]);
                let last = self.size[axis] - 1;
                lines[axis][0].0[lane] = if first < last { first } else { last };
                lines[axis][1].0[lane] = if second < last { second } else { last };
                lines[axis][1].1[lane] = -i32::from(first != second);
            }
        }
        let [columns, rows] = lines;
        (columns, rows)
    }
}
