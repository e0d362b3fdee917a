//! Samples of inertial sensors as CSV in the format of the EuRoC data sets: nanoseconds, angular velocity, specific force.

use std::fmt;

use oaktwin_camera::RigidTransform;

use crate::ImuSample;

/// The first line, with its end.
pub const HEADER: &str = "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],\
    a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\n";

/// The time of the first frame of a sequence whose times count from its start, nanoseconds: 14 July 2017. Kalibr and others fail at 0.
const START_NS: u64 = 1_500_000_000_000_000_000;

/// Times below this, three years, count from the start of a sequence; others are the sequence's own.
const RELATIVE_NS: u64 = 100_000_000_000_000_000;

/// Returns the stamp of a time of a sequence, nanoseconds since 1970.
#[must_use]
pub const fn stamp(time_ns: u64) -> u64 {
    if time_ns < RELATIVE_NS {
        START_NS + time_ns
    } else {
        time_ns
    }
}

/// The line of a sample, with its end. Numbers have as many digits as their values need.
#[derive(Clone, Copy, Debug)]
pub struct EurocLine<'a>(pub &'a ImuSample);

impl fmt::Display for EurocLine<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0.time.nanoseconds())?;
        for vector in [self.0.angular_velocity, self.0.linear_acceleration] {
            for value in vector.to_array() {
                write!(f, ",{value}")?;
            }
        }
        f.write_str("\n")
    }
}

/// An inertial sensor.
#[derive(Clone, Copy, Debug)]
pub struct ImuDescription<'a> {
    /// The name of the part.
    pub part: &'a str,
    /// The pose in the body's frame, metres.
    pub body_from_imu: &'a RigidTransform,
    /// The samples per second.
    pub rate_hz: f64,
    /// The density of the white noise and of the random walk, in rad/s.
    pub gyroscope: [f64; 2],
    /// The same of the accelerometer, in m/s².
    pub accelerometer: [f64; 2],
}

/// Returns the `sensor.yaml` of an inertial sensor. A density that no source states is 0.
#[must_use]
pub fn imu_description(sensor: &ImuDescription<'_>) -> String {
    let [[gyroscope, gyroscope_walk], [accelerometer, accelerometer_walk]] =
        [sensor.gyroscope, sensor.accelerometer];
    format!(
        "sensor_type: imu\ncomment: {}\n{}rate_hz: {:.6}\ngyroscope_noise_density: {gyroscope:e}\n\
         gyroscope_random_walk: {gyroscope_walk:e}\naccelerometer_noise_density: {accelerometer:e}\n\
         accelerometer_random_walk: {accelerometer_walk:e}\n",
        sensor.part,
        pose(sensor.body_from_imu),
        sensor.rate_hz,
    )
}

/// The pose `T_BS` of a sensor in the body's frame.
pub(crate) fn pose(body_from_sensor: &RigidTransform) -> String {
    let rows = [0, 1, 2].map(|row| {
        let rotation = body_from_sensor.rotation.row(row);
        [
            rotation.x,
            rotation.y,
            rotation.z,
            body_from_sensor.translation[row],
        ]
    });
    let [x, y, z] = rows.map(line);
    let last = line([0.0, 0.0, 0.0, 1.0]);
    format!("T_BS:\n  cols: 4\n  rows: 4\n  data: [{x},\n         {y},\n         {z},\n         {last}]\n")
}

fn line(row: [f64; 4]) -> String {
    row.map(|value| format!("{value:.12}")).join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recording::Time;
    use oaktwin_camera::math::DVec3;

    #[test]
    fn lines_have_the_columns_of_the_header() {
        let sample = ImuSample {
            time: Time::from_seconds(1.5).unwrap(),
            angular_velocity: DVec3::new(0.1, -0.25, 0.0),
            linear_acceleration: DVec3::new(1e-7, 9.806_65, -3.0),
        };
        let line = EurocLine(&sample).to_string();
        assert_eq!(line, "1500000000,0.1,-0.25,0,0.0000001,9.80665,-3\n");
        let own = 1_403_636_579_763_555_584;
        assert_eq!([stamp(0), stamp(own)], [1_500_000_000_000_000_000, own]);
        assert_eq!(HEADER.split(',').count(), line.split(',').count());
    }
}
