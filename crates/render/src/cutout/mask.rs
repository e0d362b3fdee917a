use oaktwin_base::diagnostic::Finding;
use oaktwin_image::Image;
use oaktwin_image::srgb::{linear_from_data, linear_from_srgb};
use oaktwin_scene::{ColorSpace, Texture, TextureMask};

use crate::texture_file;

/// One channel of an image.
#[derive(Debug)]
pub(super) struct MaskImage {
    values: Image<u8>,
    /// The values of bytes.
    meaning: &'static [f32; 256],
}

impl MaskImage {
    /// Decodes a channel of a texture. Returns the finding that it cannot be read, and what is the case `otherwise`.
    pub(super) fn new(texture: &Texture, channel: u8, otherwise: &str) -> Result<Self, Finding> {
        let (pixels, _) = texture_file::decoded(texture, otherwise)?;
        // Masks are data unless the file says otherwise.
        let is_srgb = channel < 3 && texture.color_space == ColorSpace::Srgb;
        Ok(Self {
            values: pixels.map(|pixel| pixel[usize::from(channel & 3)]),
            meaning: if is_srgb {
                linear_from_srgb()
            } else {
                linear_from_data()
            },
        })
    }

    /// Returns the value of a mask, interpolated between the centres of pixels, at texture coordinates.
    #[inline]
    pub(super) fn value(&self, mask: &TextureMask, [u, v]: [f64; 2]) -> f32 {
        let used = &mask.texture;
        let [s, t] = used
            .image_from_uv
            .map(|row| f64::from(row[0]) * u + f64::from(row[1]) * v + f64::from(row[2]));
        let (width, height) = (self.values.width(), self.values.height());
        let (x, y) = (s * f64::from(width) - 0.5, (1.0 - t) * f64::from(height) - 0.5);
        let ([left, top], [across, down]) = ([x.floor(), y.floor()], [x - x.floor(), y - y.floor()]);
        #[expect(clippy::cast_possible_truncation, reason = "casts of floats saturate")]
        let at = |right: f64, below: f64| {
            let column = used.wrap_s.index((left + right) as i64, width);
            let row = used.wrap_t.index((top + below) as i64, height);
            let byte = column.zip(row).and_then(|(x, y)| self.values.get(x, y));
            byte.map_or(0.0, |byte| self.meaning[usize::from(*byte)])
        };
        let mix = |a: f32, b: f32, part: f64| f64::from(a) + (f64::from(b) - f64::from(a)) * part;
        let (above, below) = (
            mix(at(0.0, 0.0), at(1.0, 0.0), across),
            mix(at(0.0, 1.0), at(1.0, 1.0), across),
        );
        let channel = usize::from(mask.channel & 3);
        #[expect(
            clippy::cast_possible_truncation,
            reason = "values of textures have single precision"
        )]
        let value = (above + (below - above) * down) as f32;
        value * used.scale[channel] + used.bias[channel]
    }
}
