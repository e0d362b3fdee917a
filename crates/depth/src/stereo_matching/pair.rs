use oaktwin_image::{Image, ImageView};

/// The image of a monochrome camera.
#[derive(Clone, Copy, Debug)]
pub enum LuminanceImage<'a> {
    /// 0 to 255.
    Bits8(ImageView<'a, u8>),
    /// 0 to 1023; larger values are clamped.
    Bits10(ImageView<'a, u16>),
}

impl<'a> From<ImageView<'a, u8>> for LuminanceImage<'a> {
    fn from(image: ImageView<'a, u8>) -> Self {
        Self::Bits8(image)
    }
}

impl<'a> From<ImageView<'a, u16>> for LuminanceImage<'a> {
    fn from(image: ImageView<'a, u16>) -> Self {
        Self::Bits10(image)
    }
}

impl LuminanceImage<'_> {
    /// The width, px.
    #[must_use]
    pub fn width(&self) -> u32 {
        match self {
            Self::Bits8(image) => image.width(),
            Self::Bits10(image) => image.width(),
        }
    }

    /// The height, px.
    #[must_use]
    pub fn height(&self) -> u32 {
        match self {
            Self::Bits8(image) => image.height(),
            Self::Bits10(image) => image.height(),
        }
    }

    /// The number of bits per pixel.
    #[must_use]
    pub const fn bits(&self) -> u32 {
        match self {
            Self::Bits8(_) => 8,
            Self::Bits10(_) => 10,
        }
    }

    /// Returns the image as 8-bit grey sRGB.
    pub(crate) fn picture(&self) -> Image<[u8; 4]> {
        let more = self.bits() - 8;
        let grey = self.levels().into_iter().map(|level| {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "8 bits")]
            let level = (level >> more) as u8;
            [level, level, level, 255]
        });
        let none = || Image::filled(0, 0, [0; 4]);
        Image::new(self.width(), self.height(), grey.collect()).unwrap_or_else(none)
    }

    /// Returns the pixels, row by row: 0 to 255 of 8 bits, 0 to 1023 of 10 bits.
    #[must_use]
    pub fn levels(&self) -> Vec<i16> {
        match self {
            Self::Bits8(image) => image.pixels().iter().map(|&level| level.into()).collect(),
            #[expect(clippy::cast_possible_wrap, reason = "10 bits")]
            Self::Bits10(image) => image
                .pixels()
                .iter()
                .map(|&level| level.min(1023) as i16)
                .collect(),
        }
    }
}

/// A rectified pair: a point of the scene is on the same row of both images, in the right one farther left.
#[derive(Clone, Copy, Debug)]
pub struct RectifiedPair<'a> {
    left: LuminanceImage<'a>,
    right: LuminanceImage<'a>,
}

/// An invalid pair of images.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("stereo pair: {what}; {remedy}")]
pub struct RectifiedPairError {
    /// What is wrong.
    pub what: String,
    /// How to fix it.
    pub remedy: &'static str,
}

impl<'a> RectifiedPair<'a> {
    /// Creates a pair from the rectified left and right images.
    ///
    /// # Errors
    /// Returns an error if their sizes or numbers of bits differ, or if they have no pixels.
    pub fn new(
        left: impl Into<LuminanceImage<'a>>,
        right: impl Into<LuminanceImage<'a>>,
    ) -> Result<Self, RectifiedPairError> {
        let (left, right) = (left.into(), right.into());
        let error = |what, remedy| Err(RectifiedPairError { what, remedy });
        if (left.width(), left.height()) != (right.width(), right.height()) {
            return error(
                format!(
                    "the left image is {}x{}, the right one {}x{}",
                    left.width(),
                    left.height(),
                    right.width(),
                    right.height()
                ),
                "rectify both to one size",
            );
        }
        if left.bits() != right.bits() {
            return error(
                format!(
                    "the left image has {} bits, the right one {}",
                    left.bits(),
                    right.bits()
                ),
                "give both with 8 bits or both with 10",
            );
        }
        if left.width() == 0 || left.height() == 0 {
            return error("the images have no pixels".to_owned(), "give images with pixels");
        }
        Ok(Self { left, right })
    }

    /// The left image, for whose pixels disparities are computed.
    #[must_use]
    pub fn left(&self) -> LuminanceImage<'a> {
        self.left
    }

    /// The right image.
    #[must_use]
    pub fn right(&self) -> LuminanceImage<'a> {
        self.right
    }

    /// The width of each image, px.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.left.width()
    }

    /// The height of each image, px.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.left.height()
    }
}
