//! Measures a twin's depth accuracy by the vendor's method.
//!
//! A textured board, perpendicular to the optical axis, is rendered at each distance. The sensor captures it ten times, without
//! post filters and with five subpixel bits. In a region at the centre of each capture, invalid pixels and the top and bottom 5 %
//! are dropped; the mean of the medians is compared with the true distance. The vendor publishes the error of the median
//! device, so by default 200 devices are measured, each with the calibration bias of its seed, and the median of their absolute
//! errors is compared with the published bands.
//!
//! For an engine that matches images, the board is rendered as a pair, as the image sensors record it. The bias of a device
//! then shifts its right image relative to its calibration.
//!
//! Only the part of the image that affects the region is rendered and sensed. The result is the same, except that a matcher's
//! paths start closer to the region.

mod bands;
mod bench;
mod board;
pub(crate) mod distances;
mod error;
pub mod measured;
mod measurement;
mod optics;
mod options;
mod plot;
mod report;
mod stereo_camera;
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
pub use options::AccuracyOptions;
pub use report::{AccuracyReport, AccuracyRow, ComparedPoint, Comparison, Devices, Reading, Verdict};

/// The default number of devices.
pub const DEVICES: u32 = 200;

/// The default number of devices for an engine that matches pairs.
pub const MATCHING_DEVICES: u32 = 25;

/// The number of captures that the vendor averages.
pub const CAPTURES: u32 = 10;

/// The default side of the region as a share of the image's side.
pub const REGION: f64 = 0.05;
