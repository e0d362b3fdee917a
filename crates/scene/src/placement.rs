use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DAffine3, DMat3, DVec3};

use crate::Instance;

impl Instance {
    /// Returns the pose of the instance, and the rest of its transform: `world_from_mesh = pose * rest`, where the rest is the
    /// scale, shear and reflection.
    ///
    /// The axes of the pose are the mesh's, made orthonormal in the order x, y, z.
    #[must_use]
    pub fn pose_and_rest(&self) -> (RigidTransform, DAffine3) {
        let whole = self.world_from_mesh;
        let m = whole.matrix3;
        let x = m.x_axis.normalize_or(DVec3::X);
        let y = m
            .y_axis
            .reject_from_normalized(x)
            .normalize_or(x.any_orthonormal_vector());
        let rotation = DMat3::from_cols(x, y, x.cross(y));
        let pose = RigidTransform::new(rotation, whole.translation);
        let rest = DAffine3::from_mat3(rotation.transpose() * m);
        (pose, rest)
    }

    /// Moves the instance to another pose with the same rest; see [`pose_and_rest`](Self::pose_and_rest).
    #[must_use]
    pub fn placed(pose: &RigidTransform, rest: DAffine3) -> DAffine3 {
        DAffine3::from_mat3_translation(pose.rotation, pose.translation) * rest
    }
}

#[cfg(test)]
mod tests {
    use oaktwin_camera::math::DQuat;

    use super::*;

    #[test]
    fn pose_and_rest_are_the_whole() {
        let turn = DQuat::from_rotation_y(0.7) * DQuat::from_rotation_x(-1.2);
        let sheared = DMat3::from_cols(
            DVec3::X * 2.0,
            DVec3::new(0.5, -3.0, 0.0),
            DVec3::new(0.1, 0.2, 0.01),
        );
        let world_from_mesh =
            DAffine3::from_mat3_translation(DMat3::from_quat(turn) * sheared, DVec3::new(4.0, -5.0, 6.0));
        let instance = Instance {
            mesh: 0,
            path: "/a".into(),
            world_from_mesh,
            labels: Vec::new(),
            material_offset: 0,
        };
        let (pose, rest) = instance.pose_and_rest();
        assert!(pose.orthonormality_error() < 1e-14 && pose.rotation.determinant() > 0.0);
        assert_eq!(rest.translation, DVec3::ZERO);
        assert!(Instance::placed(&pose, rest).abs_diff_eq(world_from_mesh, 1e-14));
        // A rotation alone has no rest.
        let rigid = Instance {
            world_from_mesh: DAffine3::from_quat(turn),
            ..instance
        };
        assert!(rigid.pose_and_rest().1.abs_diff_eq(DAffine3::IDENTITY, 1e-15));
    }
}
