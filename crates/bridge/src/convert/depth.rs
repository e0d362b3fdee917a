use oaktwin::camera::ImageSize;
use oaktwin::image::{Image, millimetres};
use oaktwin::sense::DepthUnit;
use oaktwin_base::parameter::choice;

use super::rows::pixels;
use super::{MessageError, check_header};
use crate::message;

choice! {
    /// The encoding of depth images (REP-118).
    Encoding {
        /// Millimetres in uint16, as the vendor's driver publishes; 0 where nothing was measured.
        Millimetres = "16UC1",
        /// Metres in float32; NaN where nothing was measured.
        Metres = "32FC1",
    }
}

/// A depth image.
#[derive(Clone, Debug, PartialEq)]
pub struct Depth {
    /// The depth in metres; invalid values as they arrived.
    pub metres: Image<f32>,
    /// The unit of the message.
    pub unit: DepthUnit,
}

/// Converts a message of `32FC1` or `16UC1` in either byte order to a depth image.
///
/// # Errors
/// Returns an error if the message is not a whole depth image, or its header is invalid.
pub fn depth(message: &message::Image) -> Result<Depth, MessageError> {
    check_header(&message.header)?;
    let size = ImageSize::new(message.width, message.height);
    let is_big = message.is_bigendian != 0;
    let (pixels, unit): (Vec<f32>, _) = match message.encoding.as_str() {
        "32FC1" => {
            let metres = match is_big {
                true => pixels(message, f32::from_be_bytes)?,
                false => pixels(message, f32::from_le_bytes)?,
            };
            (metres, DepthUnit::Metres)
        }
        // Some publishers call millimetres mono16.
        "16UC1" | "mono16" => {
            let metres = match is_big {
                true => pixels(message, |bytes| f32::from(u16::from_be_bytes(bytes)) / 1000.0)?,
                false => pixels(message, |bytes| f32::from(u16::from_le_bytes(bytes)) / 1000.0)?,
            };
            (metres, DepthUnit::Millimetres)
        }
        other => {
            let shown: String = other.chars().take(40).collect();
            return Err(MessageError::new(
                "encoding",
                format!("'{shown}' is not an encoding of depth"),
                "publish 32FC1 (metres) or 16UC1 (millimetres)",
            ));
        }
    };
    match Image::new(size.width, size.height, pixels) {
        Some(metres) => Ok(Depth { metres, unit }),
        None => Err(MessageError::new("data", "is incomplete", "publish whole images")),
    }
}

/// Converts measured depth in metres to a message; 0 means that nothing was measured.
#[must_use]
pub fn depth_message(header: message::Header, metres: &Image<f32>, encoding: Encoding) -> message::Image {
    let (bytes_per_pixel, data) = match encoding {
        Encoding::Millimetres => {
            let whole = millimetres::from_metres(metres);
            (2, bytes(whole.pixels(), u16::to_le_bytes))
        }
        Encoding::Metres => {
            let valid = |z: f32| if z > 0.0 { z } else { f32::NAN };
            (4, bytes(metres.pixels(), |z| valid(z).to_le_bytes()))
        }
    };
    message::Image {
        header,
        height: metres.height(),
        width: metres.width(),
        encoding: encoding.name().to_owned(),
        is_bigendian: 0,
        step: metres.width().saturating_mul(bytes_per_pixel),
        data,
    }
}

/// Returns the bytes of all pixels, in a loop that the compiler vectorizes.
fn bytes<T: Copy, const N: usize>(pixels: &[T], convert: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    let mut bytes = vec![0; N * pixels.len()];
    for (place, pixel) in bytes.as_chunks_mut().0.iter_mut().zip(pixels) {
        *place = convert(*pixel);
    }
    bytes
}
