//! Depth images on disk: files of one image or many, numbered sequences, folders in Replicator's layout.

pub mod name;
pub mod reader;
pub mod replicator;

use oaktwin_base::diagnostic::{Message, message, opt};

oaktwin_base::parameter::choice! {
    /// The kind of depth in an image.
    InputKind {
        /// The distance along the optical axis: `distance_to_image_plane`.
        Z = "z",
        /// The distance from the optical centre: `distance_to_camera`.
        Range = "range",
    }
}

/// Checks the metres per unit of integer depth images.
///
/// # Errors
/// Returns an error unless the number is finite and positive.
pub fn check_depth_scale(scale: f64) -> Result<(), Message> {
    if scale.is_finite() && scale > 0.0 {
        return Ok(());
    }
    let is = format!(": must be a finite number > 0 (got {scale}); give metres per integer depth unit");
    Err(message![opt("depth-scale"), is])
}
