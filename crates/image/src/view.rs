use crate::Image;

/// A borrowed image of pixels `T`, row by row from the top, without padding.
#[derive(Debug, PartialEq)]
pub struct ImageView<'a, T> {
    width: u32,
    height: u32,
    pixels: &'a [T],
}

// Not derived, because views are copied even if their pixels cannot be.
impl<T> Clone for ImageView<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for ImageView<'_, T> {}

impl<'a, T> ImageView<'a, T> {
    /// Creates an image from its pixels, row by row, or returns `None` if their number is not `width × height`.
    #[must_use]
    pub fn new(width: u32, height: u32, pixels: &'a [T]) -> Option<Self> {
        (pixels.len() == width as usize * height as usize).then_some(Self {
            width,
            height,
            pixels,
        })
    }

    /// Returns the number of columns.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Returns the number of rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Returns the pixels, row by row.
    #[must_use]
    pub fn pixels(&self) -> &'a [T] {
        self.pixels
    }

    /// Returns row `y`, or `None` below the image.
    #[must_use]
    pub fn row(&self, y: usize) -> Option<&'a [T]> {
        let width = self.width as usize;
        self.pixels.get(y.checked_mul(width)?..)?.get(..width)
    }

    /// Returns the rows from the top. An image without columns has none.
    pub fn rows(&self) -> std::slice::ChunksExact<'a, T> {
        self.pixels.chunks_exact((self.width as usize).max(1))
    }
}

impl<'a, T> From<&'a Image<T>> for ImageView<'a, T> {
    fn from(image: &'a Image<T>) -> Self {
        Self {
            width: image.width(),
            height: image.height(),
            pixels: image.pixels(),
        }
    }
}
