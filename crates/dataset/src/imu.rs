use oaktwin_camera::math::DVec3;

use crate::recording::Time;

/// A sample of an inertial sensor, in its own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImuSample {
    /// The time.
    pub time: Time,
    /// The angular velocity, rad/s.
    pub angular_velocity: DVec3,
    /// The specific force, which ROS calls linear acceleration, m/s²: +g upwards at rest.
    pub linear_acceleration: DVec3,
}
