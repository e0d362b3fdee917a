use super::Pixel;
use oaktwin_image::{Image, ImageView};

/// `BrightnessFilter`: drops what is too dark or too bright in the picture that the camera took.
///
/// It needs that picture; without one it does nothing. The picture's luma (ITU-R BT.601) stands for what the monochrome
/// imager sees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Brightness {
    /// `minBrightness`, −1 to 255: dropped up to this. `DepthAI`'s default of 0 drops what is black; −1 drops nothing.
    pub min_brightness: i32,
    /// `maxBrightness`, 0 to 256: dropped from this on. 256 drops nothing.
    pub max_brightness: i32,
}

impl Default for Brightness {
    fn default() -> Self {
        Self {
            min_brightness: 0,
            max_brightness: 256,
        }
    }
}

impl Brightness {
    /// `rgb` may be larger than the image, where that has been decimated: the nearest pixel counts.
    pub(super) fn run<P: Pixel>(&self, image: &mut Image<P>, rgb: ImageView<'_, [u8; 4]>) {
        let (width, height) = (image.width() as usize, image.height() as usize);
        let (rgb_width, rgb_height) = (rgb.width() as usize, rgb.height() as usize);
        if rgb.pixels().is_empty() {
            return;
        }
        let rows = image.pixels_mut().chunks_exact_mut(width.max(1));
        for (y, row) in rows.enumerate() {
            let start = y * rgb_height / height * rgb_width;
            for (x, pixel) in row.iter_mut().enumerate() {
                let [r, g, b, _] = rgb.pixels()[start + x * rgb_width / width].map(i32::from);
                let luma = (299 * r + 587 * g + 114 * b + 500) / 1000;
                if luma <= self.min_brightness || luma >= self.max_brightness {
                    *pixel = P::default();
                }
            }
        }
    }
}
