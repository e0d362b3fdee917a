//! Measures the quality of a depth camera from images of a flat board at a known distance.
//!
//! [`vendor`] implements Luxonis' method (documentation of depth accuracy): in the region of each capture it drops invalid
//! pixels and the top and bottom 5 % and takes the median; the error is the mean of the medians over the captures compared
//! with the true distance. [`quality`] returns the field's other measures as librealsense's depth quality tool defines them:
//! fill rate, plane-fit RMS in metres and in pixels of disparity, Z accuracy, temporal noise.
//!
//! Images are in metres along the optical axis; values that are not finite or not above 0 are invalid. Captures are images
//! of one size from a camera that does not move. Only the RMS in pixels is specific to stereo.

mod autocovariance;
mod errors;
mod plane;
mod quality;
mod region;
mod statistics;
mod vendor;

pub use autocovariance::Autocovariance;
pub use errors::{Errors, Histogram};
pub use plane::FittedPlane;
pub use quality::{Optics, Quality, quality};
pub use region::ImageRegion;
pub use statistics::{median, quantile, r_squared};
pub use vendor::{TRIMMED, Vendor, vendor};

/// Whether a value is valid.
fn is_valid(z: f32) -> bool {
    z.is_finite() && z > 0.0
}
