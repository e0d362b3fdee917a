//! Previews of depth images: turbo colours, red for near, with a legend below.

mod legend;
mod scale;

use crate::colormap::turbo;
use crate::{Image, RangeDepth, ZDepth};
use legend::Legend;
use scale::{Scale, is_value, step};

/// The colour of invalid pixels: a grey that turbo does not contain.
pub const NONE: [u8; 3] = [96, 96, 96];

/// The background of the legend.
const PAPER: [u8; 3] = [24, 24, 24];

const INK: [u8; 3] = [235, 235, 235];

/// The options of a preview.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PreviewOptions {
    /// The minimum and maximum of the colour map, metres. The default is the range of the image without half a percent of its
    /// values at both ends.
    pub range: Option<(f32, f32)>,
}

impl ZDepth {
    /// Draws a preview with [`depth`].
    #[must_use]
    pub fn preview(&self, options: &PreviewOptions) -> Image<[u8; 3]> {
        depth(&self.0, options)
    }
}

impl RangeDepth {
    /// Draws a preview with [`depth`].
    #[must_use]
    pub fn preview(&self, options: &PreviewOptions) -> Image<[u8; 3]> {
        depth(&self.0, options)
    }
}

/// Draws a depth image (metres; values that are not positive and finite are invalid) at its own size, with a legend in
/// [`legend_height`] additional rows below.
///
/// The scale is linear, or logarithmic if the maximum is more than twelve times the minimum. `<` and `>` at its ends mean that
/// values beyond have the same colour.
#[must_use]
pub fn depth(metres: &Image<f32>, options: &PreviewOptions) -> Image<[u8; 3]> {
    let scale = Scale::of(metres, options);
    let (width, height) = (metres.width(), metres.height());
    let legend_height = legend_height(width);
    let capacity = width as usize * height.saturating_add(legend_height) as usize;
    let (mut pixels, marks) = paint(metres, scale.as_ref(), capacity);
    pixels.resize(pixels.len() + width as usize * legend_height as usize, PAPER);
    let Some(mut picture) = Image::new(width, height.saturating_add(legend_height), pixels) else {
        return Image::filled(0, 0, PAPER);
    };
    Legend::new(&mut picture, height).draw(scale.as_ref(), marks);
    picture
}

/// Colours a depth image like [`depth`], without a legend, for several images with a common [`legend`].
#[must_use]
pub fn colors(metres: &Image<f32>, range: (f32, f32)) -> (Image<[u8; 3]>, Marks) {
    let scale = Scale::of(metres, &PreviewOptions { range: Some(range) });
    let (pixels, marks) = paint(metres, scale.as_ref(), metres.pixels().len());
    let picture = Image::new(metres.width(), metres.height(), pixels);
    (picture.unwrap_or_else(|| Image::filled(0, 0, PAPER)), marks)
}

/// Draws the legend of images of [`colors`], [`legend_height`] rows.
#[must_use]
pub fn legend(width: u32, range: (f32, f32), marks: Marks) -> Image<[u8; 3]> {
    let mut picture = Image::filled(width, legend_height(width), PAPER);
    let none = Image::filled(0, 0, 0.0);
    let scale = Scale::of(&none, &PreviewOptions { range: Some(range) });
    Legend::new(&mut picture, 0).draw(scale.as_ref(), marks);
    picture
}

/// Returns the minimum and maximum depth of an image without half a percent of its values at both ends, or `None` if it has no
/// valid values.
#[must_use]
pub fn range(metres: &Image<f32>) -> Option<(f32, f32)> {
    scale::range(metres)
}

/// The marks that a legend explains.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Marks {
    /// Whether there are invalid pixels.
    pub missing: bool,
    /// Whether there are depths below the scale.
    pub nearer: bool,
    /// Whether there are depths above the scale.
    pub farther: bool,
}

impl std::ops::BitOrAssign for Marks {
    fn bitor_assign(&mut self, other: Self) {
        self.missing |= other.missing;
        self.nearer |= other.nearer;
        self.farther |= other.farther;
    }
}

/// Returns the colours of the pixels in a vector with the given capacity.
fn paint(metres: &Image<f32>, scale: Option<&Scale>, capacity: usize) -> (Vec<[u8; 3]>, Marks) {
    let mut pixels = Vec::with_capacity(capacity);
    let mut marks = Marks::default();
    if let Some(scale) = scale {
        let turbo = turbo();
        for &z in metres.pixels() {
            let valid = is_value(z);
            marks.missing |= !valid;
            marks.nearer |= valid & (z < scale.near);
            marks.farther |= valid & (z > scale.far);
            let color = turbo[step(scale.place(z))];
            pixels.push(if valid { color } else { NONE });
        }
    } else {
        marks.missing = !metres.pixels().is_empty();
        pixels.resize(metres.pixels().len(), NONE);
    }
    (pixels, marks)
}

/// Returns the number of rows that [`depth`] adds to an image of this width.
#[must_use]
pub fn legend_height(width: u32) -> u32 {
    text_height(width) * 4
}

/// Returns the height of the legend's capital letters, px.
fn text_height(width: u32) -> u32 {
    (width / 80).max(10)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn ramp(width: u32, near: f32, far: f32) -> Image<f32> {
        let row = (0..width).map(|x| near + (far - near) * x as f32 / (width - 1) as f32);
        Image::new(width, 2, row.clone().chain(row).collect()).unwrap()
    }

    #[test]
    fn near_is_red_far_is_blue_and_invalid_is_grey() {
        let mut image = ramp(300, 1.0, 3.0);
        image.pixels_mut()[5] = f32::INFINITY;
        image.pixels_mut()[6] = 0.0;
        image.pixels_mut()[7] = f32::NAN;
        image.pixels_mut()[8] = -2.0;
        let picture = depth(
            &image,
            &PreviewOptions {
                range: Some((1.0, 3.0)),
            },
        );
        assert_eq!((picture.width(), picture.height()), (300, 2 + legend_height(300)));
        assert_eq!(picture.get(0, 0), Some(&turbo()[243]));
        assert_eq!(picture.get(299, 0), Some(&turbo()[12]));
        assert_eq!(picture.get(150, 1), Some(&turbo()[127]));
        for x in 5..9 {
            assert_eq!(picture.get(x, 0), Some(&NONE));
        }
    }

    #[test]
    fn images_can_share_a_scale() {
        let mut image = ramp(300, 1.0, 3.0);
        image.pixels_mut()[5] = 0.0;
        let options = PreviewOptions {
            range: Some((1.0, 2.5)),
        };
        let whole = depth(&image, &options);
        let (picture, marks) = colors(&image, (1.0, 2.5));
        let expected = Marks {
            missing: true,
            nearer: false,
            farther: true,
        };
        assert_eq!(marks, expected);
        let legend = legend(300, (1.0, 2.5), marks);
        assert_eq!([picture.pixels(), legend.pixels()].concat(), whole.pixels());
        let mut all = Marks::default();
        all |= marks;
        assert_eq!(all, marks);
    }

    #[test]
    fn draws_invalid_images() {
        for image in [
            Image::filled(0, 0, 0.0),
            Image::filled(1, 1, f32::NAN),
            Image::filled(3, 2, 1.0),
            Image::filled(0, 5, 1.0),
        ] {
            let picture = depth(&image, &PreviewOptions::default());
            assert_eq!(picture.width(), image.width());
            assert_eq!(picture.height(), image.height() + legend_height(image.width()));
        }
    }

    proptest! {
        #[test]
        fn never_panics_on_any_numbers(
            values in prop::collection::vec(prop::num::f32::ANY, 60), near: f32, far: f32,
        ) {
            let image = Image::new(60, 1, values).unwrap();
            let _ = depth(&image, &PreviewOptions::default());
            let _ = depth(&image, &PreviewOptions { range: Some((near, far)) });
        }
    }
}
