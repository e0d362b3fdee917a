use oaktwin::camera::RigidTransform;
use oaktwin::render;

use crate::protocol::{Failure, Pose};

/// The pose of the world's frame.
pub(crate) const ORIGIN: Pose = Pose {
    position: [0.0; 3],
    quaternion: [0.0, 0.0, 0.0, 1.0],
};

/// Returns the pose of a transform.
pub(crate) fn pose_of(world_from_body: &RigidTransform) -> Pose {
    Pose {
        position: world_from_body.translation.to_array(),
        quaternion: world_from_body.quaternion().to_array(),
    }
}

impl Pose {
    /// Returns the transform from the body to the world.
    pub(crate) fn transform(&self) -> Result<RigidTransform, Failure> {
        render::pose(self.numbers()).map_err(|error| Failure::of("pose", &error))
    }

    /// Returns the numbers of `--pose`.
    pub(crate) fn numbers(&self) -> [f64; 7] {
        let [x, y, z] = self.position;
        let [qx, qy, qz, qw] = self.quaternion;
        [x, y, z, qx, qy, qz, qw]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin::camera::math::{DMat3, DVec3};

    #[test]
    fn numbers_are_read_to_the_last_digit() {
        let numbers = [-0.21045254855051526, 1e-300, 0.1, 1.0];
        let text = format!(r#"{{"position": [1, -2.5e3, 5.884886], "quaternion": {numbers:?}}}"#);
        let pose: Pose = serde_json::from_str(&text).unwrap();
        assert_eq!(
            (pose.position, pose.quaternion),
            ([1.0, -2500.0, 5.884886], numbers)
        );
        for wrong in ["[1, 2]", "[1, 2, 3, 4]", "[1, 2, null]", r#"[1, 2, "3"]"#, "{}"] {
            let text = format!(r#"{{"position": {wrong}, "quaternion": [0, 0, 0, 1]}}"#);
            assert!(serde_json::from_str::<Pose>(&text).is_err(), "{wrong}");
        }
    }

    #[test]
    fn poses_round_trip() {
        let turned = DMat3::from_rotation_z(0.7) * DMat3::from_rotation_y(-0.2);
        let transform = RigidTransform::new(turned, DVec3::new(1.0, -2.0, 3.0));
        let again = pose_of(&transform).transform().unwrap();
        assert!(
            (again.rotation - transform.rotation)
                .to_cols_array()
                .iter()
                .all(|x| x.abs() < 1e-12)
        );
        assert_eq!(again.translation, transform.translation);
    }
}
