//! Superpixels by simple linear iterative clustering (Achanta et al. 2012) with one channel: each pixel belongs to the
//! nearest of the nine surrounding centres, by position and grey level, and centres are the means of their pixels.

use oaktwin_simd::{self as simd, Kernel, Level};
use rayon::prelude::*;

use super::super::census::Census;

/// The initial distance between neighbouring centres, px.
pub(super) const SIDE: usize = 8;

/// The number of iterations.
const ROUNDS: usize = 2;

/// The number of candidate centres of a pixel: 3×3 cells, with the pixel's own cell in the middle.
const NEAR: usize = 9;
const OWN: u8 = 4;

/// A position in px and an 8-bit grey level.
#[derive(Clone, Copy, Debug, Default)]
struct Centre {
    x: i32,
    y: i32,
    level: i32,
}

#[derive(Clone, Copy, Debug, Default)]
struct Sums {
    count: u32,
    x: u32,
    y: u32,
    level: u32,
}

/// The assignment of pixels to superpixels.
#[derive(Clone, Debug, Default)]
pub(super) struct Superpixels {
    columns: usize,
    /// The index, from 0 to 8, of each pixel's centre around its cell.
    labels: Vec<u8>,
    /// The centre of each cell; `None` if it has no pixels.
    centres: Vec<Option<Centre>>,
    sums: Vec<Sums>,
}

/// A sum over the pixels of a superpixel.
pub(super) trait Total: Clone + Copy + Default + Send + Sync {
    fn add(&mut self, other: &Self);
}

impl Total for Sums {
    #[inline(always)]
    fn add(&mut self, other: &Self) {
        self.count += other.count;
        self.x += other.x;
        self.y += other.y;
        self.level += other.level;
    }
}

impl Superpixels {
    /// Computes the superpixels of the left image's first `height` rows.
    pub(super) fn find(&mut self, level: Level, left: &Census, height: usize) {
        let width = left.width();
        self.columns = width.div_ceil(SIDE);
        self.labels.clear();
        self.labels.resize(width * height, OWN);
        for _ in 0..ROUNDS {
            let mut sums = std::mem::take(&mut self.sums);
            self.total(width, &mut sums, |y, x, sums| {
                sums.count += 1;
                sums.x += small(x);
                sums.y += small(y);
                sums.level += left.levels(y).get(x).copied().map_or(0, u32::from);
            });
            self.centres.clear();
            self.centres.extend(sums.iter().map(|sums| {
                let mean = |sum: u32| (sum + sums.count / 2).checked_div(sums.count);
                Some(Centre {
                    x: mean(sums.x)?.cast_signed(),
                    y: mean(sums.y)?.cast_signed(),
                    level: mean(sums.level)?.cast_signed(),
                })
            }));
            self.sums = sums;
            self.choose(level, left, width);
        }
    }

    fn choose(&mut self, level: Level, left: &Census, width: usize) {
        let Self {
            columns,
            labels,
            centres,
            ..
        } = self;
        let (columns, centres) = (*columns, centres.as_slice());
        let bands = labels.par_chunks_mut(SIDE * width).enumerate();
        bands.for_each(|(band, labels)| {
            // The candidate centres of each cell in the band.
            let around: Vec<[Option<Centre>; NEAR]> = (0..columns)
                .map(|column| {
                    std::array::from_fn(|near| {
                        let cell = cell(columns, band, column, near)?;
                        *centres.get(cell)?
                    })
                })
                .collect();
            for (y, labels) in (band * SIDE..).zip(labels.chunks_exact_mut(width)) {
                simd::run_at(
                    level,
                    Choose {
                        y: small(y).cast_signed(),
                        around: &around,
                        levels: left.levels(y),
                        labels,
                    },
                );
            }
        });
    }

    /// Sums over each superpixel: `add` adds the pixel at a row and a column.
    pub(super) fn total<T: Total>(
        &self,
        width: usize,
        totals: &mut Vec<T>,
        add: impl Fn(usize, usize, &mut T) + Sync,
    ) {
        let columns = self.columns;
        let rows = (self.labels.len() / width).div_ceil(SIDE);
        // The pixels of a band belong to cells of the same row of cells or of the rows next to it.
        let bands = self.labels.par_chunks(SIDE * width).enumerate();
        let parts: Vec<Vec<T>> = bands
            .map(|(band, labels)| {
                let mut own = vec![T::default(); 3 * columns];
                for (y, labels) in (band * SIDE..).zip(labels.chunks_exact(width)) {
                    for (column, labels) in labels.chunks(SIDE).enumerate() {
                        for (x, &near) in (column * SIDE..).zip(labels) {
                            let near = usize::from(near);
                            // A label always refers to an existing centre, so never to one left of the first column.
                            let at = near / 3 * columns + (column + near % 3).saturating_sub(1);
                            if let Some(total) = own.get_mut(at) {
                                add(y, x, total);
                            }
                        }
                    }
                }
                own
            })
            .collect();
        totals.clear();
        totals.resize(rows * columns, T::default());
        for (band, part) in parts.iter().enumerate() {
            for (i, part) in part.chunks_exact(columns.max(1)).enumerate() {
                let Some(row) = (band + i).checked_sub(1) else {
                    continue;
                };
                let totals = totals.get_mut(row * columns..(row + 1) * columns);
                for (total, part) in totals.unwrap_or_default().iter_mut().zip(part) {
                    total.add(part);
                }
            }
        }
    }

    /// Returns the index of the superpixel for each pixel of row `y`.
    pub(super) fn numbers(&self, width: usize, y: usize) -> impl Iterator<Item = usize> {
        let (columns, band) = (self.columns, y / SIDE);
        let labels = self.labels.get(y * width..(y + 1) * width).unwrap_or_default();
        labels.iter().enumerate().map(move |(x, &near)| {
            let own = cell(columns, band, x / SIDE, near.into());
            own.unwrap_or(usize::MAX)
        })
    }
}

/// Returns the index of one of the nine cells around a cell; `None` if it is outside the image.
#[inline(always)]
fn cell(columns: usize, row: usize, column: usize, near: usize) -> Option<usize> {
    let row = (row + near / 3).checked_sub(1)?;
    let column = (column + near % 3).checked_sub(1).filter(|&own| own < columns)?;
    Some(row * columns + column)
}

/// Assigns a row of pixels to the nearest centres.
struct Choose<'a> {
    y: i32,
    around: &'a [[Option<Centre>; NEAR]],
    levels: &'a [u8],
    labels: &'a mut [u8],
}

impl Kernel for Choose<'_> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let cells = self
            .labels
            .chunks_mut(SIDE)
            .zip(self.levels.chunks(SIDE))
            .zip(self.around);
        let mut first = 0;
        for ((labels, levels), around) in cells {
            let mut own = [0; SIDE];
            for (own, &level) in own.iter_mut().zip(levels) {
                *own = i32::from(level);
            }
            let mut least = [i32::MAX; SIDE];
            let mut best = [i32::from(OWN); SIDE];
            for (near, centre) in (0..).zip(around) {
                let Some(centre) = centre else { continue };
                let rows = (self.y - centre.y) * (self.y - centre.y);
                for i in 0..SIDE {
                    let levels = own[i] - centre.level;
                    let columns = first + lane(i) - centre.x;
                    let apart = levels * levels + columns * columns + rows;
                    let is_nearer = apart < least[i];
                    least[i] = if is_nearer { apart } else { least[i] };
                    best[i] = if is_nearer { near } else { best[i] };
                }
            }
            for (label, &best) in labels.iter_mut().zip(&best) {
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "one of nine"
                )]
                let best = best as u8;
                *label = best;
            }
            first += lane(SIDE);
        }
    }
}

#[inline(always)]
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "up to eight"
)]
fn lane(i: usize) -> i32 {
    i as i32
}

#[expect(clippy::cast_possible_truncation, reason = "a row or a column")]
fn small(value: usize) -> u32 {
    value as u32
}
