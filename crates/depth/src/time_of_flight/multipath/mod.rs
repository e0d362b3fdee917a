//! Light that comes by another surface: lamp, surface, this surface, camera.
//!
//! It has come a longer way than the light that came straight, and adds to its phasor: concave corners are reported too far,
//! and rounded.
//!
//! # Steps
//! 1. **Patches.** The image in square cells, 40 × 30 at most. What a cell shows is one patch, with the mean point and normal
//!    of its pixels, each weighted by what it reflects: albedo·Ω of the light of the lamp, Ω the pixel's solid angle. The sum
//!    of these is the patch's flux Φ, and that of the pixels' surfaces its area a.
//! 2. **Receivers.** Twice as many as cells in each row and column: points and normals as single pixels see them. At each, the
//!    sum over all patches of Φ·cos α·cos β/(π d² + a), Lambert's law twice, α and β the angles of the line between them, d
//!    long, to both normals; near a patch it is as of a disc of its area, no more. Of each frequency the phase is of half the
//!    way from the lamp to the patch and on to the receiver.
//! 3. **Pixels.** Of the four receivers around, those count whose normal is like the pixel's, and near whose plane it lies: no
//!    light leaks over edges. Where none is like it, as on what is thinner than a cell, there is less light than there
//!    would be. By signal·albedo it becomes electrons, whose phase the pixel's own half of the way completes.
//!
//! The reverse way, lamp, this surface, another, camera, ends in the pixel that sees the other surface: what each pixel gets
//! is one of the two.
//!
//! # What is known, and what is an estimate
//! All of it is an estimate, from what the image shows. Left out: more than one bounce (a white corner has much of it), what
//! shines, whether something stands between two surfaces, and what lies outside the image, behind something, or turned away
//! from the camera. All moves as the pixel does. A patch is one even disc, which is coarse near by: half a cell from an edge
//! of 90° it makes 7 % less of the error than every pixel would.

mod gather;
mod patches;
mod spread;

use oaktwin_simd::{self as simd, Level};
use rayon::prelude::*;

use self::gather::{Gather, LANES, Lit};
use self::patches::{Found, Patch, Surveyor};
pub(super) use self::spread::{Add, Normals, Surfaces};
use self::spread::{Receiver, Spread};
use super::light::Lamp;
use super::optics::Optics;
use oaktwin_image::ImageView;

/// Cells in a row and in a column, at most.
const CELLS: [u32; 2] = [40, 30];

/// Receivers that one thread works on: a multiple of [`LANES`].
const TASK: usize = 8 * LANES;

/// What an image is made of.
pub(super) struct View<'a> {
    pub(super) depth: ImageView<'a, f32>,
    pub(super) picture: Option<ImageView<'a, [u8; 4]>>,
    /// Where there is no picture.
    pub(super) albedo: f32,
    pub(super) optics: &'a Optics,
    pub(super) lamp: &'a Lamp,
    pub(super) level: Level,
}

/// Receivers' light of one image.
#[derive(Clone, Debug)]
pub(super) struct Multipath {
    /// Electrons of a white surface per unit of the receivers' light.
    signal: f32,
    columns: Vec<usize>,
    rows: Vec<usize>,
    /// Row by row.
    receivers: Vec<Receiver>,
}

/// How an image is divided.
#[derive(Clone, Copy, Debug)]
struct Grid {
    size: [usize; 2],
    cell: usize,
    /// Pixels from one receiver to the next.
    step: usize,
}

impl Grid {
    fn new(width: u32, height: u32) -> Self {
        let cell = width.div_ceil(CELLS[0]).max(height.div_ceil(CELLS[1])).max(1) as usize;
        Self {
            size: [width as usize, height as usize],
            cell,
            step: cell.div_ceil(2),
        }
    }

    /// The receivers' columns, or rows.
    fn receivers(&self, axis: usize) -> Vec<usize> {
        let size = self.size[axis];
        let starts = (0..size).step_by(self.step);
        // The last lies in the image, and after the one before.
        starts
            .map(|start| (start + self.step / 2).min(size - 1))
            .collect()
    }
}

impl Multipath {
    /// `strength`: 1 as it would be.
    pub(super) fn new(view: &View<'_>, strength: f32) -> Self {
        let grid = Grid::new(view.depth.width(), view.depth.height());
        let [columns, rows] = [0, 1].map(|axis| grid.receivers(axis));
        let bands: Vec<(Vec<Patch>, Vec<Found>)> = (0..grid.size[1].div_ceil(grid.cell))
            .into_par_iter()
            .map(|band| Surveyor::new(view, grid, &columns, &rows).band(band))
            .collect();
        let patches: Vec<Patch> = bands.iter().flat_map(|(patches, _)| patches).copied().collect();
        let found: Vec<Found> = bands.into_iter().flat_map(|(_, found)| found).collect();
        let mut receivers = vec![Receiver::default(); found.len()];
        receivers
            .par_chunks_mut(TASK)
            .zip(found.par_chunks(TASK))
            .for_each(|(receivers, found)| {
                for (receivers, found) in receivers.chunks_mut(LANES).zip(found.chunks(LANES)) {
                    let lit = simd::run_at(
                        view.level,
                        Gather {
                            patches: &patches,
                            found: &Lit::new(found),
                            turns_per_m: view.lamp.turns_per_m,
                        },
                    );
                    for (lane, (receiver, found)) in receivers.iter_mut().zip(found).enumerate() {
                        *receiver = Receiver::new(found, lit.map(|channel| channel[lane]));
                    }
                }
            });
        Self {
            signal: strength * view.lamp.signal,
            columns,
            rows,
            receivers,
        }
    }

    /// Electrons of a white surface per unit of the receivers' light.
    pub(super) fn signal(&self) -> f32 {
        self.signal
    }

    /// The receivers' light at the pixels of row `y`, whose surfaces these are.
    pub(super) fn spread(&self, level: Level, y: usize, surfaces: &mut Surfaces) {
        let below = self.rows.partition_point(|&row| row <= y);
        let pair = [below.saturating_sub(1), below.min(self.rows.len() - 1)];
        let at = pair.map(|row| self.rows[row]);
        let count = self.columns.len();
        let rows = pair.map(|row| &self.receivers[row * count..(row + 1) * count]);
        simd::run_at(
            level,
            Spread {
                columns: &self.columns,
                rows,
                lower: between(at, y),
                surfaces,
            },
        );
    }
}

/// How far `at` is from the first to the second.
#[inline(always)]
fn between([first, second]: [usize; 2], at: usize) -> f32 {
    if second > first {
        at.saturating_sub(first) as f32 / (second - first) as f32
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests;
