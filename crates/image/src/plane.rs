/// An image of pixels `T`, row by row from the top, without padding.
#[derive(Clone, Debug, PartialEq)]
pub struct Image<T> {
    width: u32,
    height: u32,
    pixels: Vec<T>,
}

impl<T> Image<T> {
    /// Creates an image from its pixels, row by row, or returns `None` if their number is not `width × height`.
    #[must_use]
    pub fn new(width: u32, height: u32, pixels: Vec<T>) -> Option<Self> {
        (pixels.len() == width as usize * height as usize).then_some(Self {
            width,
            height,
            pixels,
        })
    }

    /// Creates an image with the same value everywhere.
    #[must_use]
    pub fn filled(width: u32, height: u32, value: T) -> Self
    where
        T: Clone,
    {
        let pixels = vec![value; width as usize * height as usize];
        Self {
            width,
            height,
            pixels,
        }
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
    pub fn pixels(&self) -> &[T] {
        &self.pixels
    }

    /// Returns the pixels, row by row.
    pub fn pixels_mut(&mut self) -> &mut [T] {
        &mut self.pixels
    }

    /// Returns the pixels, row by row.
    #[must_use]
    pub fn into_pixels(self) -> Vec<T> {
        self.pixels
    }

    /// Returns the pixel in column `x` of row `y`, or `None` outside the image.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> Option<&T> {
        if x >= self.width {
            return None;
        }
        self.pixels.get(y as usize * self.width as usize + x as usize)
    }

    /// Returns the rows from the top. An image without columns has none.
    pub fn rows(&self) -> std::slice::ChunksExact<'_, T> {
        self.pixels.chunks_exact((self.width as usize).max(1))
    }

    /// Applies a function to each pixel.
    #[must_use]
    pub fn map<U>(&self, value: impl FnMut(&T) -> U) -> Image<U> {
        Image {
            width: self.width,
            height: self.height,
            pixels: self.pixels.iter().map(value).collect(),
        }
    }
}
