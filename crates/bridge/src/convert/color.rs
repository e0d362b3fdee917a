use oaktwin::image::Image;

use super::rows::pixels;
use super::{MessageError, check_header};
use crate::message;

/// Converts a message of 8-bit colours or grey to an image.
///
/// # Errors
/// Returns an error if the message is not a whole image in one of these encodings, or its header is invalid.
pub fn color(message: &message::Image) -> Result<Image<[u8; 4]>, MessageError> {
    check_header(&message.header)?;
    let pixels: Vec<[u8; 4]> = match message.encoding.as_str() {
        "rgb8" | "8UC3" => pixels(message, |[r, g, b]| [r, g, b, 255])?,
        "bgr8" => pixels(message, |[b, g, r]| [r, g, b, 255])?,
        "rgba8" => pixels(message, |[r, g, b, _]| [r, g, b, 255])?,
        "bgra8" => pixels(message, |[b, g, r, _]| [r, g, b, 255])?,
        "mono8" | "8UC1" => pixels(message, |[grey]| [grey, grey, grey, 255])?,
        other => {
            let shown: String = other.chars().take(40).collect();
            return Err(MessageError::new(
                "encoding",
                format!("'{shown}' is not an encoding of 8-bit colours"),
                "publish rgb8, bgr8, rgba8, bgra8 or mono8",
            ));
        }
    };
    Image::new(message.width, message.height, pixels)
        .ok_or_else(|| MessageError::new("data", "is incomplete", "publish whole images"))
}
