//! How good a depth camera is, from its images of a flat board at a known distance: numbers, no opinions.
//!
//! [`vendor`] measures as Luxonis does (its documentation of depth accuracy): of each capture's region drop what is
//! invalid and the top and bottom 5 %, take the median; the mean of that over the captures against the true distance is
//! the error. [`quality`] has the measures of the field beside it, as librealsense's depth quality tool defines them:
//! fill rate, plane-fit RMS in metres and in pixels of disparity, Z accuracy, temporal noise.
//!
//! Images are metres along the optical axis; what is not finite and above 0 is no value. Captures are images of one
//! camera that does not move, in one size. Nothing here is limited to stereo but the RMS in pixels.

mod autocovariance;
mod plane;
mod quality;
mod region;
mod statistics;
mod vendor;

pub use autocovariance::Autocovariance;
pub use plane::Plane;
pub use quality::{Optics, Quality, quality};
pub use region::Region;
pub use statistics::{median, quantile, r_squared};
pub use vendor::{TRIMMED, Vendor, vendor};

/// Whether something was measured.
fn is_valid(z: f32) -> bool {
    z.is_finite() && z > 0.0
}
