//! Inertial sensors: what an accelerometer and a gyroscope report along a trajectory. Pure `f64` mathematics; no files, no
//! random number generator.
//!
//! [`Motion`] interpolates poses, [`MotionState::reading`] is what an ideal sensor at some place of the body measures, and a
//! [`Channel`] adds the errors of a part. [`allan_deviation`] finds these errors in a record again.
//!
//! # Conventions
//! * Positions are in metres, times in seconds; angular velocities in rad/s, accelerations in m/s².
//! * An accelerometer measures specific force: at rest it reports +g along the axis that points up.
//! * Readings are in the frame of the sensor, which moves with it.
//!
//! ```
//! use oaktwin_camera::RigidTransform;
//! use oaktwin_camera::math::{DMat3, DVec3};
//! use oaktwin_imu::Motion;
//!
//! // One turn per second about the vertical axis, with the sensor 0.1 m away from it.
//! let pose = |t: f64| RigidTransform::new(DMat3::from_rotation_z(std::f64::consts::TAU * t), DVec3::ZERO);
//! let poses: Vec<_> = (0..=30).map(|i| f64::from(i) / 30.0).map(|t| (t, pose(t))).collect();
//! let body_from_imu = RigidTransform::new(DMat3::IDENTITY, DVec3::new(0.1, 0.0, 0.0));
//!
//! let reading = Motion::new(&poses)?.at(0.4).reading(&body_from_imu, DVec3::new(0.0, 0.0, -9.80665));
//! let rate = std::f64::consts::TAU;
//! assert!((reading.angular_velocity - DVec3::new(0.0, 0.0, rate)).length() < 1e-9);
//! assert!((reading.specific_force - DVec3::new(-0.1 * rate * rate, 0.0, 9.80665)).length() < 1e-6);
//! # Ok::<(), oaktwin_imu::MotionError>(())
//! ```

mod allan;
mod noise;
mod orientation;
mod position;
mod so3;
mod trajectory;

pub use allan::{AllanPoint, allan_deviation};
pub use noise::{Channel, ChannelNoise, Draws};
pub use trajectory::{ImuReading, Motion, MotionError, MotionState};
