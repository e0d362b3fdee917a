use oaktwin_image::{CodecError, Image, png};

use super::Bits;
use crate::stereo_matching::LuminanceImage;

/// A recorded grey image with linear values.
#[derive(Clone, Debug, PartialEq)]
pub enum Recorded {
    /// 0 to 255.
    Eight(Image<u8>),
    /// 0 to 1023.
    Ten(Image<u16>),
}

impl Recorded {
    /// The number of bits.
    #[must_use]
    pub fn bits(&self) -> Bits {
        match self {
            Self::Eight(_) => Bits::Eight,
            Self::Ten(_) => Bits::Ten,
        }
    }

    /// The width, px.
    #[must_use]
    pub fn width(&self) -> u32 {
        match self {
            Self::Eight(image) => image.width(),
            Self::Ten(image) => image.width(),
        }
    }

    /// The height, px.
    #[must_use]
    pub fn height(&self) -> u32 {
        match self {
            Self::Eight(image) => image.height(),
            Self::Ten(image) => image.height(),
        }
    }

    /// Encodes the image as PNG: grey with 8 bits, or with 16 bits and values up to 1023.
    ///
    /// # Errors
    /// Returns an error if the image has no pixels.
    pub fn to_png(&self) -> Result<Vec<u8>, CodecError> {
        match self {
            Self::Eight(image) => png::encode(image),
            Self::Ten(image) => png::encode(image),
        }
    }

    /// The upper 8 bits, for display.
    #[must_use]
    pub fn to_eight(&self) -> Image<u8> {
        match self {
            Self::Eight(image) => image.clone(),
            Self::Ten(image) => image.map(|&number| (number >> 2).min(255) as u8),
        }
    }
}

impl<'a> From<&'a Recorded> for LuminanceImage<'a> {
    fn from(recorded: &'a Recorded) -> Self {
        match recorded {
            Recorded::Eight(image) => Self::Bits8(image.into()),
            Recorded::Ten(image) => Self::Bits10(image.into()),
        }
    }
}
