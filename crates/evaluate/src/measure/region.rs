use std::ops::Range;

use oaktwin_image::ImageView;

/// A rectangle of an image in pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ImageRegion {
    /// The columns.
    pub columns: Range<u32>,
    /// The rows.
    pub rows: Range<u32>,
}

impl ImageRegion {
    /// Creates a region at the centre of an image with a share (0 to 1) of its width and height, at least one pixel if the image
    /// has any.
    #[must_use]
    pub fn centred(width: u32, height: u32, share: f64) -> Self {
        let middle = |length: u32| {
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "saturates, and is limited to the image"
            )]
            let size = ((f64::from(length) * share).round() as u32).clamp(1.min(length), length);
            let first = (length - size) / 2;
            first..first + size
        };
        Self {
            columns: middle(width),
            rows: middle(height),
        }
    }

    /// Returns the number of pixels.
    #[must_use]
    pub fn pixels(&self) -> usize {
        self.columns.len() * self.rows.len()
    }

    /// Returns the rows of the region in an image, cropped to the image.
    pub fn rows_of<'a>(&self, image: ImageView<'a, f32>) -> impl Iterator<Item = &'a [f32]> + use<'a> {
        let width = image.width();
        let columns = self.columns.start.min(width) as usize..self.columns.end.min(width) as usize;
        let rows = self.rows.clone();
        image
            .rows()
            .skip(rows.start as usize)
            .take(rows.len())
            .filter_map(move |row| row.get(columns.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin_image::Image;

    #[test]
    fn selects_the_middle_of_an_image() {
        let region = ImageRegion::centred(1280, 800, 0.05);
        assert_eq!(
            (region.columns.clone(), region.rows.clone()),
            (608..672, 380..420)
        );
        assert_eq!(region.pixels(), 2560);
        assert_eq!(ImageRegion::centred(5, 1, 1e-9).pixels(), 1);
        assert_eq!(ImageRegion::centred(5, 3, 7.0).pixels(), 15);
        assert_eq!(ImageRegion::centred(0, 3, 0.5).pixels(), 0);
        assert_eq!(ImageRegion::centred(4, 4, f64::NAN).pixels(), 1);
    }

    #[test]
    fn rows_are_cropped_to_the_image() {
        let image = Image::new(3, 2, vec![0.0f32, 1.0, 2.0, 3.0, 4.0, 5.0]).unwrap();
        let region = ImageRegion {
            columns: 1..9,
            rows: 1..9,
        };
        let rows: Vec<&[f32]> = region.rows_of((&image).into()).collect();
        assert_eq!(rows, [[4.0, 5.0]]);
        let outside = ImageRegion {
            columns: 7..9,
            rows: 0..1,
        };
        assert!(outside.rows_of((&image).into()).all(<[f32]>::is_empty));
    }
}
