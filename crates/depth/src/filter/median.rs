use super::Pixel;
use oaktwin_image::Image;

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

    pub(super) fn run<P: Pixel>(self, image: &Image<P>) -> Image<P> {
        let (width, height) = (image.width() as usize, image.height() as usize);
        let radius = self.size() as usize / 2;
        let mut square = Vec::new();
        let mut out = Vec::with_capacity(image.pixels().len());
        for y in 0..height {
            for x in 0..width {
                square.clear();
                for dy in 0..=2 * radius {
                    for dx in 0..=2 * radius {
                        let row = (y + dy).saturating_sub(radius).min(height - 1);
                        let column = (x + dx).saturating_sub(radius).min(width - 1);
                        square.push(image.pixels()[row * width + column]);
                    }
                }
                square.sort_unstable();
                out.push(square[square.len() / 2]);
            }
        }
        let mut result = image.clone();
        result.pixels_mut().copy_from_slice(&out);
        result
    }
}
