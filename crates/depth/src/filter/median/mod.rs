mod network;

use oaktwin_image::Image;
use rayon::prelude::*;

use super::Pixel;
use super::simd::{self, Level};

/// `MedianFilter`: the median of a square around each pixel; outside the image its edge goes on. 0 counts as a value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Median {
    /// `KERNEL_3x3`
    Kernel3x3,
    /// `KERNEL_5x5`
    #[default]
    Kernel5x5,
    /// `KERNEL_7x7`
    Kernel7x7,
}

/// Rows that a thread takes at a time.
const BAND: usize = 32;

/// Pixels that are worked on together.
const LANES: usize = 64;

impl Median {
    /// The side of the square, px.
    #[must_use]
    pub const fn size(self) -> u32 {
        match self {
            Self::Kernel3x3 => 3,
            Self::Kernel5x5 => 5,
            Self::Kernel7x7 => 7,
        }
    }

    /// Writes the medians of an image to another of its size.
    pub(super) fn run<P: Pixel>(self, level: Level, image: &Image<P>, out: &mut Image<P>) {
        match self {
            Self::Kernel3x3 => bands(image, out, |rows, sorted, out| {
                simd::median3(level, rows, sorted, out);
            }),
            Self::Kernel5x5 => bands(image, out, |rows, sorted, out| {
                simd::median5(level, rows, sorted, out);
            }),
            Self::Kernel7x7 => bands(image, out, |rows, sorted, out| {
                simd::median7(level, rows, sorted, out);
            }),
        }
    }
}

fn bands<P: Pixel, const K: usize>(
    image: &Image<P>,
    out: &mut Image<P>,
    row: impl Fn([&[P]; K], &mut [Vec<P>], &mut [P]) + Sync,
) {
    let width = image.width() as usize;
    if width == 0 {
        return;
    }
    let rows: Vec<&[P]> = image.rows().collect();
    let bands = out.pixels_mut().par_chunks_mut(BAND * width).enumerate();
    bands.for_each(|(band, out)| {
        let padded = width.next_multiple_of(LANES) + K - 1;
        let mut sorted = vec![vec![P::default(); padded]; K];
        for (y, out) in (band * BAND..).zip(out.chunks_exact_mut(width)) {
            let near = |i: usize| rows[(y + i).saturating_sub(K / 2).min(rows.len() - 1)];
            row(std::array::from_fn(near), &mut sorted, out);
        }
    });
}

/// The medians of a row of 3×3 squares.
#[inline(always)]
pub(super) fn row3<P: Pixel>(rows: [&[P]; 3], sorted: &mut [Vec<P>], out: &mut [P]) {
    row(rows, sorted, out, network::sort3, network::median3);
}

/// The medians of a row of 5×5 squares.
#[inline(always)]
pub(super) fn row5<P: Pixel>(rows: [&[P]; 5], sorted: &mut [Vec<P>], out: &mut [P]) {
    row(rows, sorted, out, network::sort5, network::median5);
}

/// The medians of a row of 7×7 squares.
#[inline(always)]
pub(super) fn row7<P: Pixel>(rows: [&[P]; 7], sorted: &mut [Vec<P>], out: &mut [P]) {
    row(rows, sorted, out, network::sort7, network::median7);
}

/// Sorts the columns of K rows, then takes the median of each K sorted columns. `sorted` holds K rows of a whole number of
/// lanes and K − 1 pixels.
#[inline(always)]
fn row<P: Pixel, const K: usize>(
    rows: [&[P]; K],
    sorted: &mut [Vec<P>],
    out: &mut [P],
    sort: impl Fn(&mut [P; K]),
    median: impl Fn([[P; K]; K]) -> P,
) {
    let radius = K / 2;
    for x in (0..out.len()).step_by(LANES) {
        let loaded = rows.map(|row| load(row, x));
        let mut lanes = [[P::default(); LANES]; K];
        for l in 0..LANES {
            let mut column = std::array::from_fn(|i| loaded[i][l]);
            sort(&mut column);
            for i in 0..K {
                lanes[i][l] = column[i];
            }
        }
        for (sorted, lanes) in sorted.iter_mut().zip(&lanes) {
            sorted[x + radius..][..LANES].copy_from_slice(lanes);
        }
    }
    for sorted in &mut *sorted {
        let first = sorted[radius];
        sorted[..radius].fill(first);
        let last = sorted[radius + out.len() - 1];
        sorted[radius + out.len()..][..radius].fill(last);
    }
    for (x, out) in (0..).step_by(LANES).zip(out.chunks_mut(LANES)) {
        let mut medians = [P::default(); LANES];
        let near: [[[P; LANES]; K]; K] =
            std::array::from_fn(|i| std::array::from_fn(|c| load(&sorted[i], x + c)));
        for l in 0..LANES {
            medians[l] = median(std::array::from_fn(|i| std::array::from_fn(|c| near[i][c][l])));
        }
        out.copy_from_slice(&medians[..out.len()]);
    }
}

/// Pixels of a row from a column on; behind its end any.
#[inline(always)]
fn load<P: Pixel>(row: &[P], x: usize) -> [P; LANES] {
    let rest = &row[x..];
    if let Some(lanes) = rest.first_chunk() {
        return *lanes;
    }
    let mut lanes = [P::default(); LANES];
    lanes[..rest.len()].copy_from_slice(rest);
    lanes
}
