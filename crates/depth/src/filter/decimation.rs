use oaktwin_base::parameter::{Numbered, choice, parameters};
use oaktwin_camera::{ImageSize, Intrinsics, OpenCv, PixelPoint};
use oaktwin_image::Image;
use oaktwin_simd::{Level, saturating_trunc};
use rayon::prelude::*;

use super::Pixel;
use super::kernels::kernels;

parameters! {
    /// `DecimationFilter`: reduces the size of the image by a whole factor without changing the values.
    ///
    /// Columns and rows that do not fill a block are dropped, but at least one pixel remains.
    pub struct Decimation("decimation filter", platform) {
        /// The side of a block.
        factor: u32 = 1 => ("factor".alias("decimationFactor").unit("px").range(1.0..=4.0).step(1.0)),
        /// The value of a block.
        mode: DecimationMode = DecimationMode::default() => ("mode" as Numbered.alias("decimationMode")),
    }
}

choice! {
    /// `DecimationMode`: the value of a block.
    DecimationMode {
        /// Its first pixel.
        PixelSkipping = "PIXEL_SKIPPING",
        /// The median of its valid pixels; of an even number the lower one.
        NonZeroMedian = "NON_ZERO_MEDIAN",
        /// The mean of its valid pixels, rounded down.
        NonZeroMean = "NON_ZERO_MEAN",
    }
}

impl Decimation {
    /// The size of the decimated image.
    #[must_use]
    pub fn size(&self, width: u32, height: u32) -> (u32, u32) {
        let shorter = |length: u32| (length / self.factor.max(1)).max(length.min(1));
        (shorter(width), shorter(height))
    }

    /// The intrinsics of the decimated image, for a camera that sees the first pixel of each block, or
    /// for medians and means the centre of the block.
    #[must_use]
    pub fn intrinsics(&self, intrinsics: &Intrinsics) -> Intrinsics {
        let factor = f64::from(self.factor.max(1));
        let first = match self.mode {
            DecimationMode::PixelSkipping => 0.0,
            DecimationMode::NonZeroMedian | DecimationMode::NonZeroMean => (factor - 1.0) / 2.0,
        };
        let (width, height) = self.size(intrinsics.size.width, intrinsics.size.height);
        let c = intrinsics.principal_point::<OpenCv>();
        let centre = PixelPoint::<OpenCv>::new((c.x - first) / factor, (c.y - first) / factor);
        let size = ImageSize::new(width, height);
        Intrinsics::new(size, intrinsics.fx / factor, intrinsics.fy / factor, centre)
    }

    /// Decimates an image of other values at the same pixels, such as its colours: the first pixel of each block, or for
    /// medians and means the mean of the block.
    #[must_use]
    pub fn companion<T: Sample>(&self, image: &Image<T>) -> Image<T> {
        let (width, height) = self.size(image.width(), image.height());
        let factor = self.factor.max(1) as usize;
        let is_mean = self.mode != DecimationMode::PixelSkipping;
        let rows: Vec<&[T]> = image.rows().collect();
        let mut pixels = Vec::with_capacity(width as usize * height as usize);
        for rows in rows.chunks(factor).take(height as usize) {
            for x in (0..).step_by(factor).take(width as usize) {
                let block = rows
                    .iter()
                    .flat_map(|row| row.iter().skip(x).take(factor))
                    .copied();
                let side = if is_mean { usize::MAX } else { 1 };
                pixels.push(T::mean(block.take(side)));
            }
        }
        Image::new(width, height, pixels).unwrap_or_else(|| image.clone())
    }

    pub(super) fn run<P: Pixel>(&self, level: Level, image: &Image<P>) -> Image<P> {
        let (width, height) = self.size(image.width(), image.height());
        let factor = self.factor.clamp(1, 4) as usize;
        let mut out = Image::filled(width, height, P::default());
        let rows: Vec<&[P]> = image.rows().collect();
        let width = (width as usize).max(1);
        let rows = rows.par_chunks(factor);
        let rows = out.pixels_mut().par_chunks_exact_mut(width).zip(rows);
        rows.for_each(|(out, rows)| decimate(level, factor, self.mode, rows, out));
        out
    }
}

/// A pixel value that has a mean.
pub trait Sample: Copy {
    /// Returns the mean of values, of which there is at least one.
    fn mean(values: impl Iterator<Item = Self>) -> Self;
}

impl Sample for f32 {
    fn mean(values: impl Iterator<Item = Self>) -> Self {
        let (sum, count) = values.fold((0.0, 0u16), |(sum, count), value| (sum + value, count + 1));
        sum / Self::from(count.max(1))
    }
}

/// Implements the mean of small whole numbers, halves up.
macro_rules! whole {
    ($($number:ty)+) => {$(
        impl Sample for $number {
            #[expect(clippy::cast_possible_truncation, reason = "a mean is no larger than its values")]
            fn mean(values: impl Iterator<Item = Self>) -> Self {
                let (sum, count) = values.fold((0u32, 0u32), |(sum, count), value| {
                    (sum + u32::from(value), count + 1)
                });
                ((sum + count / 2) / count.max(1)) as Self
            }
        }
    )+};
}

whole!(u8 u16);

impl<T: Sample> Sample for [T; 4] {
    fn mean(values: impl Iterator<Item = Self>) -> Self {
        let values: Vec<Self> = values.collect();
        std::array::from_fn(|channel| T::mean(values.iter().map(|value| value[channel])))
    }
}

/// The number of pixels in a vector.
const LANES: usize = 64;

/// One row of blocks.
#[inline(always)]
pub(super) fn row<P: Pixel>(factor: usize, mode: DecimationMode, rows: &[&[P]], out: &mut [P]) {
    match (mode, factor) {
        (DecimationMode::PixelSkipping, _) => {
            let kept = rows
                .first()
                .into_iter()
                .flat_map(|row| row.iter().step_by(factor));
            out.iter_mut().zip(kept).for_each(|(pixel, &kept)| *pixel = kept);
        }
        (_, 1) => blocks::<P, 1>(mode, rows, out),
        (_, 2) => blocks::<P, 2>(mode, rows, out),
        (_, 3) => blocks::<P, 3>(mode, rows, out),
        _ => blocks::<P, 4>(mode, rows, out),
    }
}

#[inline(always)]
fn blocks<P: Pixel, const F: usize>(mode: DecimationMode, rows: &[&[P]], out: &mut [P]) {
    for (x, out) in (0..).step_by(LANES).zip(out.chunks_mut(LANES)) {
        // Pixels outside the image are invalid.
        let mut values = [[[P::default(); LANES]; F]; F];
        for (values, row) in values.iter_mut().zip(rows) {
            let mut near = [[P::default(); F]; LANES];
            let rest = &row[x * F..];
            let count = rest.len().min(LANES * F);
            near.as_flattened_mut()[..count].copy_from_slice(&rest[..count]);
            for lane in 0..LANES {
                for column in 0..F {
                    values[column][lane] = near[lane][column];
                }
            }
        }
        let values = values.as_flattened_mut();
        let kept = if mode == DecimationMode::NonZeroMedian {
            median(values)
        } else {
            mean(values)
        };
        out.copy_from_slice(&kept[..out.len()]);
    }
}

/// Counts the valid pixels in each lane.
#[inline(always)]
fn counts<P: Pixel>(values: &[[P; LANES]]) -> [u16; LANES] {
    let mut counts = [0; LANES];
    for values in values {
        for (count, &value) in counts.iter_mut().zip(values) {
            *count += u16::from(value != P::default());
        }
    }
    counts
}

#[inline(always)]
fn median<P: Pixel>(values: &mut [[P; LANES]]) -> [P; LANES] {
    let counts = counts(values);
    // Odd-even transposition sort; invalid pixels come first.
    for turn in 0..values.len() {
        for [low, high] in values[turn % 2..].as_chunks_mut().0 {
            for (low, high) in low.iter_mut().zip(high) {
                (*low, *high) = ((*low).min(*high), (*low).max(*high));
            }
        }
    }
    let mut medians = [P::default(); LANES];
    for (from_last, values) in (0..).zip(values.iter().rev()) {
        for lane in 0..LANES {
            let is_median = counts[lane] / 2 == from_last;
            medians[lane] = if is_median { values[lane] } else { medians[lane] };
        }
    }
    medians
}

#[inline(always)]
fn mean<P: Pixel>(values: &[[P; LANES]]) -> [P; LANES] {
    let counts = counts(values);
    let mut means = [P::default(); LANES];
    for lane in 0..LANES {
        let sum: f32 = values.iter().map(|lanes| Into::<f32>::into(lanes[lane])).sum();
        // With up to 16 values the sum is exact, and a quotient that is not whole does not round to a whole number.
        let mean = sum / f32::from(counts[lane].max(1));
        means[lane] = P::cut(saturating_trunc(mean.floor()));
    }
    means
}

kernels! {
    /// [`row`]
    fn decimate<'a> = row => (factor: usize, mode: DecimationMode, rows: &'a [&'a [P]], out: &'a mut [P]);
}
