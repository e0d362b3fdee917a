//! Calibrations of OAK cameras: `DepthAI`'s JSON, lossless ([`raw`]) and checked ([`Calibration`]), applied to a device of the
//! catalog ([`twin()`]), exported ([`export`]), imported from other formats ([`import`]), and drawn at random ([`population`]).
//!
//! Lengths are in metres, in the files in centimetres. Camera frames are OpenCV's (x right, y down, z forward).

mod against;
mod check;
mod design;
mod document;
mod error;
pub mod export;
mod extrinsics;
pub mod import;
mod model;
mod nominal;
pub mod population;
pub mod raw;
mod read;
mod reader;
mod rectify;
mod rig;
mod socket;
mod summary;
mod twin;

pub use against::check_against;
pub use check::force;
pub use error::CalibrationError;
pub use model::{Board, Calibration, CameraCalibration, CameraKind, ExtrinsicLink, StereoRectification};
pub use nominal::{calibration_of, nominal_calibration};
pub use raw::Raw;
pub use rectify::StereoPair;
pub use rig::rig;
pub use socket::Socket;
pub use summary::{CalibrationSummary, CameraSummary, ImuSummary, PairSummary, StereoSummary, summary};
pub use twin::twin;

/// A plausible, synthetic calibration of an OAK-D Pro PoE for demonstrations.
pub const EXAMPLE: &str = include_str!("../fixtures/example-oak-d-pro-poe.json");
