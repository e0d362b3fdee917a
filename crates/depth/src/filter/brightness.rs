use oaktwin_base::parameter::parameters;
use oaktwin_image::{Image, ImageView};

use super::Pixel;

parameters! {
    /// `BrightnessFilter`: drops pixels that are too dark or too bright in the colour image.
    ///
    /// Without a colour image it does nothing. The image's luma (ITU-R BT.601) replaces the monochrome camera's image.
    pub struct Brightness("brightness filter", platform) {
        /// The brightness up to which pixels are dropped. 0, `DepthAI`'s default, drops black pixels; −1 drops none.
        min_brightness: i32 = 0 => ("min".alias("minBrightness").range(-1.0..=255.0)),
        /// The brightness from which pixels are dropped; 256 drops none.
        max_brightness: i32 = 256 => ("max".alias("maxBrightness").range(0.0..=256.0)),
    }
}

impl Brightness {
    /// Runs the filter; `rgb` may be larger than a decimated image, of which the nearest pixel is used.
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
