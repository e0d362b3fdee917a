use oaktwin_image::Image;
use rayon::prelude::*;

use super::Pixel;

/// `DecimationFilter`: makes the image smaller by a whole number; the values stay as they are.
///
/// Columns and rows that fill no whole block are left out, but one pixel is always left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decimation {
    /// `decimationFactor`, 1 to 4: the side of a block, px.
    pub factor: u32,
    /// `decimationMode`
    pub mode: DecimationMode,
}

impl Default for Decimation {
    fn default() -> Self {
        Self {
            factor: 1,
            mode: DecimationMode::default(),
        }
    }
}

/// `DecimationMode`: what stands for a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DecimationMode {
    /// `PIXEL_SKIPPING`: its first pixel.
    #[default]
    PixelSkipping,
    /// `NON_ZERO_MEDIAN`: the median of its values; of an even number the lower one.
    NonZeroMedian,
    /// `NON_ZERO_MEAN`: the mean of its values, cut off.
    NonZeroMean,
}

impl DecimationMode {
    /// All, by their numbers.
    pub const ALL: [Self; 3] = [Self::PixelSkipping, Self::NonZeroMedian, Self::NonZeroMean];

    /// `DepthAI`'s name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::PixelSkipping => "PIXEL_SKIPPING",
            Self::NonZeroMedian => "NON_ZERO_MEDIAN",
            Self::NonZeroMean => "NON_ZERO_MEAN",
        }
    }
}

impl Decimation {
    /// The size of what an image of this size becomes.
    #[must_use]
    pub fn size(&self, width: u32, height: u32) -> (u32, u32) {
        let shorter = |length: u32| (length / self.factor.max(1)).max(length.min(1));
        (shorter(width), shorter(height))
    }

    pub(super) fn run<P: Pixel>(&self, image: &Image<P>) -> Image<P> {
        let (width, height) = self.size(image.width(), image.height());
        let factor = self.factor.clamp(1, 4) as usize;
        let mut out = Image::filled(width, height, P::default());
        let rows: Vec<&[P]> = image.rows().collect();
        let width = (width as usize).max(1);
        let rows = rows.par_chunks(factor);
        out.pixels_mut()
            .par_chunks_exact_mut(width)
            .zip(rows)
            .for_each(|(out, rows)| {
                if self.mode == DecimationMode::PixelSkipping {
                    let kept = rows
                        .first()
                        .into_iter()
                        .flat_map(|row| row.iter().step_by(factor));
                    out.iter_mut().zip(kept).for_each(|(pixel, &kept)| *pixel = kept);
                    return;
                }
                for (x, pixel) in out.iter_mut().enumerate() {
                    // A block has up to 4×4 pixels; those without a value are written over.
                    let (mut values, mut count) = ([P::default(); 17], 0);
                    for row in rows {
                        let end = row.len().min((x + 1) * factor);
                        for &value in &row[x * factor..end] {
                            values[count] = value;
                            count += usize::from(value != P::default());
                        }
                    }
                    *pixel = self.mode.of(&mut values[..count]);
                }
            });
        out
    }
}

impl DecimationMode {
    /// What stands for some values, none of them 0.
    fn of<P: Pixel>(self, values: &mut [P]) -> P {
        if values.is_empty() {
            return P::default();
        }
        if self == Self::NonZeroMedian {
            values.sort_unstable();
            return values[(values.len() - 1) / 2];
        }
        let sum: u32 = values
            .iter()
            .map(|&value| u32::from(Into::<u16>::into(value)))
            .sum();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_possible_wrap,
            reason = "up to 16 values"
        )]
        let mean = (sum / values.len() as u32) as i32;
        P::cut(mean)
    }
}
