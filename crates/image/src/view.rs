use crate::Image;

/// An image of pixels `T` that somebody else holds, row by row from the top, without padding.
#[derive(Debug, PartialEq)]
pub struct ImageView<'a, T> {
    width: u32,
    height: u32,
    pixels: &'a [T],
}

// Not derived: a view of what cannot be copied is copied too.
impl<T> Clone for ImageView<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for ImageView<'_, T> {}

impl<'a, T> ImageView<'a, T> {
    /// Of its pixels, row by row; `None` where their number is not `width × height`.
    #[must_use]
    pub fn new(width: u32, height: u32, pixels: &'a [T]) -> Option<Self> {
        (pixels.len() == width as usize * height as usize).then_some(Self {
            width,
            height,
            pixels,
        })
    }

    /// Columns, px.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows, px.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// All pixels, row by row.
    #[must_use]
    pub fn pixels(&self) -> &'a [T] {
        self.pixels
    }

    /// The rows, from the top. An image without columns has none.
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
