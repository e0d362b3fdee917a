//! What a depth camera reports: images in, images out, never scenes.
//!
//! Ground truth from any renderer is a valid input: [`Shot`]. An engine turns it into what the camera would have
//! reported: [`single_view`] as Isaac Sim's `DepthSensorDistance` does, [`stereo_noise`] with the errors that an OAK's
//! stereo makes, [`stereo_matching`] from the pair of images that its cameras took, as the device does; a [`Sensor`] is an engine with its filters, which may remember earlier frames.
//!
//! Input is metres along the optical axis; what is not finite and above 0 is no surface. Output is metres, 0 where
//! nothing was measured. All randomness is counter-based ([`random`]): a pixel's value depends on the seed, the camera's
//! name, the frame and the pixel, never on threads, tiles, batch order or call history.

pub mod align;
mod batch;
mod disparity;
pub mod dots;
mod error;
pub mod filter;
#[cfg(test)]
mod fixture;
pub mod imager;
pub mod parameters;
pub mod preset;
pub mod random;
pub mod rectify;
mod sensor;
mod shot;
pub mod single_view;
pub mod stereo_matching;
pub mod stereo_noise;
pub mod time_of_flight;
mod turns;

pub use error::{BatchError, ParameterError, ShotError};
pub use sensor::{Capture, Engine, FixedDisparity, Sensor};
pub use shot::Shot;
