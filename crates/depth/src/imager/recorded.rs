use oaktwin_image::{CodecError, Image, png};

use super::Bits;
use crate::stereo_matching::Luminance;

/// A grey image as a sensor recorded it: linear numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Recorded {
    /// 0 to 255.
    Eight(Image<u8>),
    /// 0 to 1023.
    Ten(Image<u16>),
}

impl Recorded {
    /// How many bits its numbers have.
    #[must_use]
    pub fn bits(&self) -> Bits {
        match self {
            Self::Eight(_) => Bits::Eight,
            Self::Ten(_) => Bits::Ten,
        }
    }

    /// Columns, px.
    #[must_use]
    pub fn width(&self) -> u32 {
        match self {
            Self::Eight(image) => image.width(),
            Self::Ten(image) => image.width(),
        }
    }

    /// Rows, px.
    #[must_use]
    pub fn height(&self) -> u32 {
        match self {
            Self::Eight(image) => image.height(),
            Self::Ten(image) => image.height(),
        }
    }

    /// As PNG, grey of 8 bits, or of 16 with numbers up to 1023.
    ///
    /// # Errors
    /// An image without pixels.
    pub fn to_png(&self) -> Result<Vec<u8>, CodecError> {
        match self {
            Self::Eight(image) => png::encode(image),
            Self::Ten(image) => png::encode(image),
        }
    }

    /// To look at: the upper 8 bits.
    #[must_use]
    pub fn to_eight(&self) -> Image<u8> {
        match self {
            Self::Eight(image) => image.clone(),
            Self::Ten(image) => image.map(|&number| (number >> 2).min(255) as u8),
        }
    }
}

impl<'a> From<&'a Recorded> for Luminance<'a> {
    fn from(recorded: &'a Recorded) -> Self {
        match recorded {
            Recorded::Eight(image) => Self::Bits8(image.into()),
            Recorded::Ten(image) => Self::Bits10(image.into()),
        }
    }
}
