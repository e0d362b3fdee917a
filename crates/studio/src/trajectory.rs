//! Trajectories that were dropped onto the page.

use std::path::Path;

use oaktwin::render::trajectory::parse_numbers;

use crate::kept::{Keep, Kept};
use crate::protocol::{Failure, Pose, TrajectoryInfo};
use crate::upload::bytes_id;

/// The maximum number of poses.
const MAX_POSES: usize = 50_000;
/// The maximum size of a file, bytes.
pub(crate) const MAX_BYTES: usize = 16 << 20;
/// The frames per second of poses without times, as in `render`.
const FRAME_RATE: f64 = 30.0;

/// A trajectory with the file that has it.
#[derive(Debug)]
pub(crate) struct Dropped {
    pub(crate) info: TrajectoryInfo,
    pub(crate) bytes: Vec<u8>,
}

pub(crate) type Trajectories = Kept<Dropped>;

impl Keep for Dropped {
    type Info = TrajectoryInfo;
    const NAME: &'static str = "trajectory";
    const COUNT: usize = 8;

    fn known(&self) -> (&str, &TrajectoryInfo) {
        (&self.info.id, &self.info)
    }
}

impl Dropped {
    /// Reads a trajectory.
    pub(crate) fn read(name: &str, bytes: Vec<u8>) -> Result<Self, Failure> {
        let read = parse_numbers(Path::new(name), &bytes);
        let read = read.map_err(|error| Failure::from(error.to_string()))?;
        if read.len() > MAX_POSES {
            return Err(Failure::from(format!(
                "{name}: has {} poses, more than the {MAX_POSES} that the page plays; drop a part of it, or use `oaktwin render --trajectory`",
                read.len()
            )));
        }
        let own: Option<Vec<f64>> = read.iter().map(|(pose, _)| pose.time_s).collect();
        let times_s = match own {
            Some(times) => times.iter().map(|time| time - times[0]).collect(),
            None => (0..read.len()).map(|number| number as f64 / FRAME_RATE).collect(),
        };
        let is_backwards = |times: &&[f64]| times[1] < times[0];
        if let Some(times) = Vec::as_slice(&times_s).windows(2).find(is_backwards) {
            return Err(Failure::from(format!(
                "{name}: the time {} s after the first pose follows {} s; sort the poses by their times",
                times[1], times[0]
            )));
        }
        let pose = |[x, y, z, qx, qy, qz, qw]: [f64; 7]| Pose {
            position: [x, y, z],
            quaternion: [qx, qy, qz, qw],
        };
        let info = TrajectoryInfo {
            id: format!("trajectory-{}", bytes_id(name, &bytes)),
            name: name.to_owned(),
            poses: read.iter().map(|(_, numbers)| pose(*numbers)).collect(),
            times_s,
        };
        Ok(Self { info, bytes })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_count_from_the_first_pose_or_30_per_second() {
        let of = |text: &str| Dropped::read("a.txt", text.as_bytes().to_vec()).map(|read| read.info.times_s);
        let timed = "5 0 0 0 0 0 0 1\n5.5 0 0 0 0 0 0 1\n";
        assert_eq!(of(timed).unwrap(), [0.0, 0.5]);
        let pose = r#"{"position": [0, 0, 0], "orientation": [0, 0, 0, 1]}"#;
        assert_eq!(of(&format!("[{pose}, {pose}]")).unwrap(), [0.0, 1.0 / 30.0]);
        let error = of("1 0 0 0 0 0 0 1\n0 0 0 0 0 0 0 1\n").unwrap_err().error;
        assert!(error.contains("a.txt: the time -1 s"), "{error}");
        let error = of(&"0 0 0 0 0 0 0 1\n".repeat(MAX_POSES + 1)).unwrap_err().error;
        assert!(error.contains("more than the 50000"), "{error}");
    }
}
