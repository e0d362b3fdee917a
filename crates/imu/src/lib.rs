//! Inertial sensors: what an accelerometer and a gyroscope report along a trajectory. Pure `f64` mathematics; no files, no
//! random numbers of its own.
//!
//! # Conventions
//! * Positions are in metres, times in seconds; angular velocities in rad/s, accelerations in m/s².
//! * An accelerometer measures specific force: at rest it reports +g along the axis that points up.
//! * Angular velocities and accelerations are in the frame of the sensor, which moves with it.

mod noise;

pub use noise::{Channel, ChannelNoise, Draws};
