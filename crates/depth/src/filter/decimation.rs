use super::Pixel;
use oaktwin_image::Image;

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
        let factor = self.factor.max(1) as usize;
        let mut out = Image::filled(width, height, P::default());
        let mut block: Vec<P> = Vec::with_capacity(factor * factor);
        let rows: Vec<&[P]> = image.rows().collect();
        for (row, rows) in out
            .pixels_mut()
            .chunks_exact_mut((width as usize).max(1))
            .zip(rows.chunks(factor))
        {
            for (x, pixel) in row.iter_mut().enumerate() {
                let columns = |row: &&[P]| {
                    row.iter()
                        .skip(x * factor)
                        .take(factor)
                        .copied()
                        .collect::<Vec<P>>()
                };
                block.clear();
                block.extend(rows.iter().flat_map(columns));
                *pixel = self.mode.of(&mut block);
            }
        }
        out
    }
}

impl DecimationMode {
    fn of<P: Pixel>(self, block: &mut Vec<P>) -> P {
        let first = block.first().copied().unwrap_or_default();
        if self == Self::PixelSkipping {
            return first;
        }
        block.retain(|&value| value != P::default());
        match (self, block.len()) {
            (_, 0) => P::default(),
            (Self::NonZeroMedian, count) => {
                block.sort_unstable();
                block[(count - 1) / 2]
            }
            (_, count) => {
                let sum: i32 = block.iter().map(|&value| Into::<i32>::into(value)).sum();
                P::cut(sum / i32::try_from(count).unwrap_or(i32::MAX))
            }
        }
    }
}
