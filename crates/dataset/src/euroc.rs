//! Samples of inertial sensors as CSV in the format of the EuRoC data sets: nanoseconds, angular velocity, specific force.

use std::fmt;

use crate::ImuSample;

/// The first line, with its end.
pub const HEADER: &str = "#timestamp [ns],w_RS_S_x [rad s^-1],w_RS_S_y [rad s^-1],w_RS_S_z [rad s^-1],\
    a_RS_S_x [m s^-2],a_RS_S_y [m s^-2],a_RS_S_z [m s^-2]\n";

/// The line of a sample, with its end. Numbers have as many digits as their values need.
#[derive(Clone, Copy, Debug)]
pub struct Line<'a>(pub &'a ImuSample);

impl fmt::Display for Line<'_> {
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
        let line = Line(&sample).to_string();
        assert_eq!(line, "1500000000,0.1,-0.25,0,0.0000001,9.80665,-3\n");
        assert_eq!(HEADER.split(',').count(), line.split(',').count());
    }
}
