//! Numbers of a robot that are so large that the poses of its links would not be finite.

use std::path::Path;

use super::{Robot, RobotFileError};

/// The largest length, in metres, and position, in metres or radians.
pub(super) const LARGEST: f64 = 1e9;

/// The largest position of a joint that follows others.
const LARGEST_FOLLOWED: f64 = 1e18;

impl Robot {
    /// Rejects lengths and positions above [`LARGEST`], and clamps larger limits to it: files write them for joints without limits.
    pub(super) fn with_checked_sizes(mut self, path: &Path) -> Result<Self, RobotFileError> {
        let too_large = |place: String, value: f64| RobotFileError::TooLarge {
            path: path.to_owned(),
            place,
            value,
        };
        for link in &self.links {
            let value = link.parent_from_link.translation.abs().max_element();
            if value > LARGEST {
                return Err(too_large(format!("link '{}'", link.name), value));
            }
        }
        for limit in self
            .joints
            .iter_mut()
            .flat_map(|joint| &mut joint.limits)
            .flatten()
        {
            *limit = limit.clamp(-LARGEST, LARGEST);
        }
        for (index, joint) in self.joints.iter().enumerate() {
            let value = joint.anchor.abs().max_element().max(joint.reference.abs());
            let followed = self.largest(index);
            if value > LARGEST || followed > LARGEST_FOLLOWED {
                let value = if value > LARGEST { value } else { followed };
                return Err(too_large(format!("joint '{}'", joint.name), value));
            }
        }
        Ok(self)
    }

    /// The largest position that a joint can have.
    fn largest(&self, joint: usize) -> f64 {
        match self.joints[joint].mimic {
            Some(mimic) => mimic.multiplier.abs() * self.largest(mimic.joint) + mimic.offset.abs(),
            None => LARGEST,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    fn opened(joint: &str) -> Result<Robot, RobotFileError> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("x.urdf");
        let text = format!(
            "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>\
             <joint name=\"k\" type=\"prismatic\"><parent link=\"a\"/><child link=\"c\"/><limit lower=\"0\" upper=\"1\"/></joint>\
             <joint name=\"j\" type=\"prismatic\"><parent link=\"a\"/><child link=\"b\"/>{joint}</joint></robot>"
        );
        fs::write(&path, text).unwrap();
        Robot::open(&path, &[])
    }

    #[test]
    fn numbers_that_overflow_are_rejected() {
        for (joint, what) in [
            (
                "<origin xyz=\"1e308 0 0\"/><limit lower=\"0\" upper=\"1\"/>",
                "link 'b': 1e308",
            ),
            (
                "<limit lower=\"0\" upper=\"1\"/><mimic joint=\"k\" multiplier=\"1e200\"/>",
                "joint 'j': 9.99",
            ),
        ] {
            let error = opened(joint).unwrap_err().to_string();
            assert!(error.contains("x.urdf") && error.contains(what), "{error}");
        }
        let robot = opened("<origin xyz=\"1e8 0 0\"/><limit lower=\"-1e308\" upper=\"1e8\"/>").unwrap();
        assert_eq!(robot.joints[1].limits, Some([-1e9, 1e8]));
    }
}
