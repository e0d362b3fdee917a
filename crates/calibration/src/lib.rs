//! Calibrations of OAK cameras: `DepthAI`'s JSON without loss ([`raw`]), checked ([`Calibration`]), applied to a
//! catalog's device ([`twin()`]), and exported ([`export`]).
//!
//! Lengths are metres, where the files have centimetres; camera frames are OpenCV's (x right, y down, z forward).

mod against;
mod check;
mod error;
pub mod export;
mod extrinsics;
mod model;
mod nominal;
pub mod raw;
mod read;
mod reader;
mod rectify;
mod socket;
mod summary;
mod twin;

pub use against::check_against;
pub use check::force;
pub use error::CalibrationError;
pub use model::{Board, Calibration, CameraCalibration, CameraKind, Link, StereoRectification};
pub use nominal::nominal_calibration;
pub use raw::Raw;
pub use rectify::StereoPair;
pub use socket::Socket;
pub use summary::{CalibrationSummary, CameraSummary, ImuSummary, PairSummary, StereoSummary, summary};
pub use twin::twin;

/// The calibration of one OAK-D Pro PoE, made up for demonstrations: plausible numbers, no real unit's.
pub const EXAMPLE: &str = include_str!("../fixtures/example-oak-d-pro-poe.json");
