use oaktwin_camera::RigidTransform;
use serde::Serialize;

/// A pose in the output of `--explain`: a position in metres and a unit quaternion in the order x, y, z, w.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct ExplainedPose {
    position: [f64; 3],
    orientation: [f64; 4],
}

impl From<&RigidTransform> for ExplainedPose {
    fn from(pose: &RigidTransform) -> Self {
        Self {
            position: pose.translation.to_array(),
            orientation: oaktwin_camera::math::DQuat::from_mat3(&pose.rotation).to_array(),
        }
    }
}

pub(crate) fn serialize_pose<S: serde::Serializer>(
    pose: &RigidTransform,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    ExplainedPose::from(pose).serialize(serializer)
}
