//! Depth sensors: images in, images out; this crate knows no scenes.
//!
//! An [`Engine`] turns an [`Input`] into measured depth: ground truth from any renderer ([`DepthShot`]), or a rectified stereo
//! pair. [`engines::ENGINES`] lists the engines: [`single_view`] is Isaac Sim's `DepthSensorDistance`, [`stereo_noise`] a
//! parametric error model of an OAK's stereo, [`stereo_matching`] matches the images of the pair as the device does, and
//! [`time_of_flight`] models a time-of-flight camera. A [`Sensor`] is an engine with its filters, which may remember
//! earlier frames.
//!
//! Input depth is in metres along the optical axis; values that are not finite and positive mean no surface. Output depth
//! is in metres, 0 where nothing was measured. All randomness is counter-based ([`random`]): a pixel's value depends on
//! the seed, the camera's name, the frame and the pixel, never on threads, tiles, batch order or call history.

pub mod align;
mod batch;
mod capture;
mod disparity;
pub mod dots;
mod engine;
pub mod engines;
mod error;
pub mod filter;
#[cfg(test)]
mod fixture;
pub mod imager;
mod kind;
pub mod parameters;
pub mod preset;
pub mod random;
pub mod reason;
pub mod rectify;
mod sensor;
mod setup;
mod shot;
pub mod single_view;
pub mod stereo_matching;
pub mod stereo_noise;
pub mod time_of_flight;
mod turns;

pub use capture::{Capture, CaptureLayer, FixedDisparity};
pub use engine::{BatchEngine, Comparable, Engine, Input};
pub use error::{BatchError, ParameterError, ShotError};
pub use kind::{Create, EngineInput, EngineKind, EngineRef, Factory, Technology};
pub use reason::{Reason, ReasonCodes};
pub use sensor::{DriftedPair, OutputCamera, Sensor};
pub use setup::{PresetConfig, Setup};
pub use shot::DepthShot;
