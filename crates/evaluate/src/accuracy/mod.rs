//! The twin measured as the vendor measures the camera.
//!
//! A textured board, perpendicular to the optical axis, is rendered at each distance; the sensor looks at its middle ten
//! times, without post filters and with five subpixel bits; of each image's region what is invalid and the top and bottom
//! 5 % are dropped, and the mean of the medians is held against the true distance. The vendor's figures are those of the
//! median device: so by default 200 devices are measured, each with the calibration bias of its seed, and the median of
//! their absolute errors has the verdict.
//!
//! The engine that matches has its board rendered as a pair, as its image sensors record it; a device's bias is then how much
//! farther left its right image lies than its calibration says.
//!
//! Only the part of the image that has a say in the region is rendered and sensed; what comes out is the same, but that a matcher's paths
//! begin nearer.

mod bands;
mod bench;
mod board;
pub(crate) mod distances;
mod error;
mod eyes;
pub mod measured;
mod measurement;
mod optics;
mod options;
mod plot;
mod report;
mod test_rig;
#[cfg(test)]
mod tests;
mod units;
mod vendor;

pub use bands::{Band, Bands};
pub use bench::Bench;
pub use distances::{FARTHEST_M, parse as parse_distances};
pub use error::AccuracyError;
pub use measurement::Measurement;
pub use optics::MeasuredOptics;
pub use options::Options;
pub use report::{ComparedPoint, Comparison, Devices, Reading, Report, Row, Verdict};

/// As many devices as are measured by default.
pub const DEVICES: u32 = 200;

/// As many of them where each has a pair of images to match.
pub const MATCHING_DEVICES: u32 = 25;

/// As many captures as the vendor averages.
pub const CAPTURES: u32 = 10;

/// The side of the region by default, as a share of the image's.
pub const REGION: f64 = 0.05;
