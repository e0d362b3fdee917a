//! Conversion between messages and images, without a network. Every field of a message may have any value.

mod camera;
mod color;
mod compressed;
mod depth;
mod points;
mod rows;
mod stamp;
#[cfg(test)]
mod tests;

pub use camera::{camera, camera_info};
pub use color::color;
pub use compressed::compressed_depth;
pub use depth::{Depth, Encoding, depth, depth_message};
pub use points::Points;
pub use stamp::{Frames, Stamped, nanoseconds};

use crate::message::Header;

/// An unusable message: `FIELD: what is wrong; what to do`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{field}: {what}; {remedy}")]
pub struct MessageError {
    /// The field.
    pub field: &'static str,
    /// What is wrong with it.
    pub what: String,
    /// What to do.
    pub remedy: String,
}

impl MessageError {
    fn new(field: &'static str, what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self {
            field,
            what: what.into(),
            remedy: remedy.into(),
        }
    }
}

/// The longest `frame_id` that is passed on, bytes.
const MAX_FRAME_ID: usize = 1024;

/// Checks the header of an input, which the outputs take over.
///
/// # Errors
/// Returns an error if the stamp or the frame is invalid.
pub fn check_header(header: &Header) -> Result<(), MessageError> {
    nanoseconds(header.stamp)?;
    if header.frame_id.len() > MAX_FRAME_ID {
        return Err(MessageError::new(
            "header.frame_id",
            format!("is longer than {MAX_FRAME_ID} bytes"),
            "publish the name of the optical frame",
        ));
    }
    Ok(())
}
