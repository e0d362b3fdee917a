use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DQuat, DVec3};

use crate::orientation::OrientationSpline;
use crate::position::PositionSpline;

/// A turn between successive poses in radians above which the rotation between them is uncertain.
const LARGE_TURN: f64 = std::f64::consts::FRAC_PI_2;

/// The motion of a body through poses, smoothly interpolated.
///
/// Positions follow a cubic spline, orientations a spline of rotation vectors; both pass through the poses, and velocity,
/// acceleration, angular velocity and angular acceleration are continuous. Two poses are joined by constant velocities.
#[derive(Clone, Debug)]
pub struct Motion {
    start_s: f64,
    /// The times of the poses since the first, seconds.
    times: Vec<f64>,
    positions: PositionSpline,
    orientations: OrientationSpline,
}

/// Invalid poses of a trajectory.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MotionError {
    /// There are fewer than two poses.
    #[error("has {poses} of the at least 2 poses that motion requires; add poses")]
    TooFew {
        /// The number of poses.
        poses: usize,
    },
    /// A number is not finite.
    #[error("pose {index}: a number is not finite; give finite numbers")]
    NotFinite {
        /// The index of the pose.
        index: usize,
    },
    /// The times do not increase.
    #[error(
        "pose {index}: the time {time_s} s is not after the previous pose's {previous_s} s; sort the poses by time and remove repeated ones"
    )]
    NotIncreasing {
        /// The index of the pose.
        index: usize,
        /// Its time in seconds.
        time_s: f64,
        /// The time of the pose before it, in seconds.
        previous_s: f64,
    },
}

/// The state of a moving frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionState {
    /// The pose, metres.
    pub world_from_body: RigidTransform,
    /// The velocity in the world, m/s.
    pub velocity: DVec3,
    /// The acceleration in the world, m/s².
    pub acceleration: DVec3,
    /// The angular velocity in the moving frame, rad/s.
    pub angular_velocity: DVec3,
    /// The angular acceleration in the moving frame, rad/s².
    pub angular_acceleration: DVec3,
}

/// What an ideal inertial sensor measures, in its own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImuReading {
    /// The angular velocity, rad/s.
    pub angular_velocity: DVec3,
    /// The specific force, m/s²: acceleration minus gravity; +g upwards at rest.
    pub specific_force: DVec3,
}

impl Motion {
    /// Creates the motion through poses at increasing times in seconds.
    ///
    /// # Errors
    /// Returns an error if there are fewer than two poses, a number is not finite, or the times do not increase.
    pub fn new(poses: &[(f64, RigidTransform)]) -> Result<Self, MotionError> {
        if poses.len() < 2 {
            return Err(MotionError::TooFew { poses: poses.len() });
        }
        for (index, (time_s, pose)) in poses.iter().enumerate() {
            if !(time_s.is_finite() && pose.translation.is_finite() && pose.rotation.is_finite()) {
                return Err(MotionError::NotFinite { index });
            }
            let previous_s = index
                .checked_sub(1)
                .map_or(f64::NEG_INFINITY, |before| poses[before].0);
            if *time_s <= previous_s {
                return Err(MotionError::NotIncreasing {
                    index,
                    time_s: *time_s,
                    previous_s,
                });
            }
        }
        let start_s = poses[0].0;
        let times: Vec<f64> = poses.iter().map(|(time_s, _)| time_s - start_s).collect();
        let positions = poses.iter().map(|(_, pose)| pose.translation).collect();
        let orientations = poses
            .iter()
            .map(|(_, pose)| DQuat::from_mat3(&pose.rotation).normalize())
            .collect();
        Ok(Self {
            start_s,
            positions: PositionSpline::new(&times, positions),
            orientations: OrientationSpline::new(&times, orientations),
            times,
        })
    }

    /// Returns the time of the first pose in seconds.
    #[must_use]
    pub const fn start_s(&self) -> f64 {
        self.start_s
    }

    /// Returns the time between the first and the last pose in seconds.
    #[must_use]
    pub fn duration_s(&self) -> f64 {
        self.times[self.times.len() - 1]
    }

    /// Returns the index of the first pose after which the body turns by more than 90° until the next one, and this turn in
    /// radians. The direction of such turns is uncertain.
    #[must_use]
    pub fn large_turn(&self) -> Option<(usize, f64)> {
        let turns = self.orientations.turns().iter().map(|turn| turn.length());
        turns.enumerate().find(|(_, turn)| *turn > LARGE_TURN)
    }

    /// Returns the state at a time in seconds since the first pose. Before it and after the last, the polynomials of the nearest
    /// poses continue.
    #[must_use]
    pub fn at(&self, since_start_s: f64) -> MotionState {
        let after = self.times.partition_point(|time| *time <= since_start_s);
        let segment = after.clamp(1, self.times.len() - 1) - 1;
        let h = self.times[segment + 1] - self.times[segment];
        let u = (since_start_s - self.times[segment]) / h;
        let [position, velocity, acceleration] = self.positions.at(segment, u, h);
        let (orientation, angular_velocity, angular_acceleration) = self.orientations.at(segment, u, h);
        MotionState {
            world_from_body: RigidTransform::new(DMat3::from_quat(orientation), position),
            velocity,
            acceleration,
            angular_velocity,
            angular_acceleration,
        }
    }
}

impl MotionState {
    /// Returns what an ideal inertial sensor that is mounted on the body measures. `gravity` is the acceleration of free fall in
    /// the world, m/s².
    #[must_use]
    pub fn reading(&self, body_from_imu: &RigidTransform, gravity: DVec3) -> ImuReading {
        let imu_from_body = body_from_imu.rotation.transpose();
        let lever = body_from_imu.translation;
        let rate = self.angular_velocity;
        let of_lever = self.angular_acceleration.cross(lever) + rate.cross(rate.cross(lever));
        let body_from_world = self.world_from_body.rotation.transpose();
        let of_body = body_from_world * (self.acceleration - gravity);
        ImuReading {
            angular_velocity: imu_from_body * rate,
            specific_force: imu_from_body * (of_body + of_lever),
        }
    }
}
