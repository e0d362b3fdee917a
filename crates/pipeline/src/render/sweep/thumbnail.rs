//! Reduced images.

use oaktwin_image::preview::{self, Marks};
use oaktwin_image::{Image, ZDepth};

/// A depth image reduced by blocks, which keeps small holes visible.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Thumbnail {
    /// A depth of each block, 0 without one; not a mean, which may lie on no surface.
    depth: Image<f32>,
    /// The fill rate of each block.
    share: Image<f32>,
    /// The fill rate of the image.
    pub(super) measured: f32,
}

impl Thumbnail {
    /// Reduces an image by blocks of `factor` × `factor` pixels; those at the right and lower edge may be smaller.
    pub(super) fn new(depth: &ZDepth, factor: u32) -> Self {
        let is_value = |z: f32| z > 0.0 && z < f32::INFINITY;
        let mut values = Vec::new();
        let mut total = (0usize, 0usize);
        let blocks = blocks(&depth.0, factor, |block| {
            values.clear();
            values.extend(block.iter().copied().filter(|&z| is_value(z)));
            total = (total.0 + values.len(), total.1 + block.len());
            let middle = values.get(values.len() / 2).copied().unwrap_or(0.0);
            (middle, values.len() as f32 / block.len().max(1) as f32)
        });
        let blocks = blocks.unwrap_or_else(|| Image::filled(0, 0, (0.0, 0.0)));
        Self {
            depth: blocks.map(|(depth, _)| *depth),
            share: blocks.map(|(_, share)| *share),
            measured: total.0 as f32 / total.1.max(1) as f32,
        }
    }

    /// The minimum and maximum depth without outliers.
    pub(super) fn range(&self) -> Option<(f32, f32)> {
        preview::range(&self.depth)
    }

    /// The depth as colours, greyer with a lower fill rate.
    pub(super) fn paint(&self, range: (f32, f32)) -> (Image<[u8; 3]>, Marks) {
        let (mut picture, mut marks) = preview::colors(&self.depth, range);
        for (pixel, &share) in picture.pixels_mut().iter_mut().zip(self.share.pixels()) {
            marks.missing |= share < 1.0;
            for (channel, none) in pixel.iter_mut().zip(preview::NONE) {
                let (value, none) = (f32::from(*channel), f32::from(none));
                *channel = byte(none + (value - none) * share);
            }
        }
        (picture, marks)
    }
}

/// A colour image reduced to the means of its blocks.
pub(super) fn averaged(rgb: &Image<[u8; 4]>, factor: u32) -> Image<[u8; 3]> {
    blocks(rgb, factor, |block| {
        let mean = |channel: usize| {
            let sum: f32 = block.iter().map(|pixel| f32::from(pixel[channel])).sum();
            byte(sum / block.len().max(1) as f32)
        };
        [mean(0), mean(1), mean(2)]
    })
    .unwrap_or_else(|| Image::filled(0, 0, [0; 3]))
}

/// One value for each block of pixels, computed by `value` from its rows.
fn blocks<T: Copy, U>(image: &Image<T>, factor: u32, mut value: impl FnMut(&[T]) -> U) -> Option<Image<U>> {
    let (width, height) = (image.width().div_ceil(factor), image.height().div_ceil(factor));
    let rows: Vec<&[T]> = image.rows().collect();
    let step = (factor as usize).max(1);
    let mut small = Vec::with_capacity(width as usize * height as usize);
    let mut block = Vec::new();
    for rows in rows.chunks(step) {
        for x in (0..image.width() as usize).step_by(step) {
            block.clear();
            for row in rows {
                block.extend(row.iter().skip(x).take(step));
            }
            small.push(value(&mut block));
        }
    }
    Image::new(width, height, small)
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 255")]
fn byte(value: f32) -> u8 {
    (value + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_holes() {
        let depth = Image::new(3, 2, vec![1.0, 0.0, 3.0, f32::INFINITY, 1.0, 3.0]).unwrap();
        let small = Thumbnail::new(&ZDepth(depth), 2);
        assert_eq!(small.depth.pixels(), [1.0, 3.0]);
        assert_eq!(small.share.pixels(), [0.5, 1.0]);
        assert!((small.measured - 4.0 / 6.0).abs() < 1e-6);
        let (picture, marks) = small.paint((1.0, 3.0));
        let (whole, _) = preview::colors(&small.depth, (1.0, 3.0));
        assert!(marks.missing && !marks.farther);
        assert_eq!(picture.get(1, 0), whole.get(1, 0));
        let half = picture.get(0, 0).unwrap()[0];
        assert!(half > preview::NONE[0].min(whole.get(0, 0).unwrap()[0]));
        assert!(half < preview::NONE[0].max(whole.get(0, 0).unwrap()[0]));
    }

    #[test]
    fn averages_colours() {
        let mut rgb = Image::filled(3, 1, [0, 0, 0, 255]);
        rgb.pixels_mut()[0] = [255, 4, 0, 255];
        assert_eq!(averaged(&rgb, 2).pixels(), [[128, 2, 0], [0, 0, 0]]);
        assert_eq!(averaged(&Image::filled(0, 3, [0; 4]), 2).pixels().len(), 0);
    }
}
