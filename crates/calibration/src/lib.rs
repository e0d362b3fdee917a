//! Calibrations of OAK cameras: `DepthAI`'s JSON without loss ([`raw`]), checked ([`Calibration`]), applied to a
//! catalog's device ([`twin`]), and exported ([`export`]).
//!
//! Lengths are metres, where the files have centimetres; camera frames are OpenCV's (x right, y down, z forward).

mod check;
mod error;
mod extrinsics;
mod model;
pub mod raw;
mod read;
mod reader;
mod rectify;
mod resize;
mod socket;

pub use check::force;
pub use error::CalibrationError;
pub use model::{Board, Calibration, CameraCalibration, CameraKind, Link, StereoRectification};
pub use raw::Raw;
pub use socket::Socket;
