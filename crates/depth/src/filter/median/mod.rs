mod network;

use oaktwin_base::parameter::{FieldText, Kind, choice, parameters};
use oaktwin_image::Image;
use oaktwin_simd::Level;
use rayon::prelude::*;

pub(crate) use network::{Network, Networks};

use super::Pixel;
use super::kernels::kernels;

choice! {
    /// `MedianFilter`: the median of a square around each pixel. The image's border is repeated outside; 0 is a value.
    Median {
        /// 3 × 3 pixels.
        Kernel3x3 = "KERNEL_3x3",
        /// 5 × 5 pixels.
        Kernel5x5 = "KERNEL_5x5",
        /// 7 × 7 pixels.
        Kernel7x7 = "KERNEL_7x7",
    }
}

parameters! {
    /// The settings of the median filter.
    pub struct MedianSettings("median filter", platform) {
        /// The side of the square.
        kernel: Median = Median::Kernel5x5 => ("size" as Side.alias("kernel")),
    }
}

/// The side of a square, or `DepthAI`'s name.
struct Side;

impl FieldText<Median> for Side {
    const KIND: Kind = Kind::Text("3, 5 or 7");

    fn set(field: &mut Median, text: &str) -> Option<()> {
        let sized = |median: &&Median| median.size().to_string() == text || median.name()[7..] == *text;
        *field = Median::from_name(text).or_else(|| Median::ALL.iter().find(sized).copied())?;
        Some(())
    }

    fn get(field: &Median) -> String {
        field.size().to_string()
    }
}

/// The number of rows in a unit of work.
const BAND: usize = 32;

/// The number of pixels in a vector.
const LANES: usize = 32;

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

    /// Replaces the pixels by their medians.
    pub(super) fn run<P: Pixel>(self, level: Level, image: &mut Image<P>) {
        match self {
            Self::Kernel3x3 => bands(image, |rows, sorted, out| {
                median3(level, rows, sorted, out);
            }),
            Self::Kernel5x5 => bands(image, |rows, sorted, out| {
                median5(level, rows, sorted, out);
            }),
            Self::Kernel7x7 => bands(image, |rows, sorted, out| {
                median7(level, rows, sorted, out);
            }),
        }
    }
}

fn bands<P: Pixel, const K: usize>(
    image: &mut Image<P>,
    row: impl Fn([&[P]; K], &mut [Vec<P>], &mut [P]) + Sync,
) {
    let (width, height) = (image.width() as usize, image.height() as usize);
    if width == 0 {
        return;
    }
    // The rows around each band, before they change.
    let pixels = image.pixels();
    let above = |start: usize| pixels[start.saturating_sub(K / 2) * width..start * width].to_vec();
    let below = |end: usize| pixels[end * width..(end + K / 2).min(height) * width].to_vec();
    let starts = (0..height).step_by(BAND);
    let around: Vec<[Vec<P>; 2]> = starts
        .map(|start| [above(start), below((start + BAND).min(height))])
        .collect();
    let padded = width.next_multiple_of(LANES) + K - 1;
    let buffers = || (Vec::new(), vec![vec![P::default(); padded]; K]);
    let bands = image.pixels_mut().par_chunks_mut(BAND * width).zip(&around);
    bands.for_each_init(buffers, |(seen, sorted), (band, [above, below])| {
        seen.clear();
        seen.extend_from_slice(above);
        seen.extend_from_slice(band);
        seen.extend_from_slice(below);
        let rows: Vec<&[P]> = seen.chunks_exact(width).collect();
        for (y, out) in (above.len() / width..).zip(band.chunks_exact_mut(width)) {
            let near = |i: usize| rows[(y + i).saturating_sub(K / 2).min(rows.len() - 1)];
            row(std::array::from_fn(near), sorted, out);
        }
    });
}

/// The medians of a row of 3×3 squares.
#[inline(always)]
pub(super) fn row3<P: Pixel>(rows: [&[P]; 3], sorted: &mut [Vec<P>], out: &mut [P]) {
    row(rows, sorted, out);
}

/// The medians of a row of 5×5 squares.
#[inline(always)]
pub(super) fn row5<P: Pixel>(rows: [&[P]; 5], sorted: &mut [Vec<P>], out: &mut [P]) {
    row(rows, sorted, out);
}

/// The medians of a row of 7×7 squares.
#[inline(always)]
pub(super) fn row7<P: Pixel>(rows: [&[P]; 7], sorted: &mut [Vec<P>], out: &mut [P]) {
    row(rows, sorted, out);
}

/// Sorts the columns of K rows, then takes the median of each K sorted columns. `sorted` holds K rows of a whole number of
/// lanes and K − 1 pixels.
#[inline(always)]
fn row<P: Pixel, const K: usize>(rows: [&[P]; K], sorted: &mut [Vec<P>], out: &mut [P])
where
    Networks: Network<K>,
{
    let radius = K / 2;
    for x in (0..out.len()).step_by(LANES) {
        let mut columns = [[P::default(); LANES]; K];
        for (lanes, row) in columns.iter_mut().zip(rows) {
            *lanes = load(row, x);
        }
        Networks::sort(&mut columns);
        for (sorted, lanes) in sorted.iter_mut().zip(&columns) {
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
        let mut near = [[[P::default(); LANES]; K]; K];
        for (near, sorted) in near.iter_mut().zip(&*sorted) {
            for (c, lanes) in near.iter_mut().enumerate() {
                lanes.copy_from_slice(&sorted[x + c..][..LANES]);
            }
        }
        let medians = Networks::median(near);
        out.copy_from_slice(&medians[..out.len()]);
    }
}

/// Returns the pixels of a row from a column on, padded with 0.
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

kernels! {
    /// [`row3`]
    fn median3<'a> = row3 => (rows: [&'a [P]; 3], sorted: &'a mut [Vec<P>], out: &'a mut [P]);
    /// [`row5`]
    fn median5<'a> = row5 => (rows: [&'a [P]; 5], sorted: &'a mut [Vec<P>], out: &'a mut [P]);
    /// [`row7`]
    fn median7<'a> = row7 => (rows: [&'a [P]; 7], sorted: &'a mut [Vec<P>], out: &'a mut [P]);
}
