use super::Pixel;
use oaktwin_image::Image;

/// `ThresholdFilter`: drops what is nearer or farther than a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Threshold {
    /// `minRange`, mm.
    pub min_range: u16,
    /// `maxRange`, mm.
    pub max_range: u16,
}

impl Default for Threshold {
    fn default() -> Self {
        Self {
            min_range: 0,
            max_range: u16::MAX,
        }
    }
}

impl Threshold {
    pub(super) fn run<P: Pixel>(&self, image: &mut Image<P>) {
        for pixel in image.pixels_mut() {
            if !(self.min_range..=self.max_range).contains(&(*pixel).into()) {
                *pixel = P::default();
            }
        }
    }
}
