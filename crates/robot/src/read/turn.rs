//! Rotations, with sines that do not depend on the machine.

use oaktwin_camera::math::{DMat3, DQuat, DVec3};

/// Returns the rotation about a unit vector by an angle in radians.
pub(super) fn about(axis: DVec3, angle: f64) -> DMat3 {
    let (sine, cosine) = libm::sincos(0.5 * angle);
    let vector = axis * sine;
    DMat3::from_quat(DQuat::from_xyzw(vector.x, vector.y, vector.z, cosine))
}

/// Returns URDF's rotation by roll, pitch and yaw: about the fixed axes x, y and z, in this order.
pub(super) fn roll_pitch_yaw(angles: DVec3) -> DMat3 {
    about(DVec3::Z, angles.z) * about(DVec3::Y, angles.y) * about(DVec3::X, angles.x)
}

/// Returns the smallest rotation that turns the z axis to a direction.
pub(super) fn z_to(direction: DVec3) -> DMat3 {
    let direction = direction.normalize_or(DVec3::Z);
    let axis = DVec3::Z.cross(direction);
    let sine = axis.length();
    let axis = if sine > 1e-12 { axis / sine } else { DVec3::X };
    about(axis, libm::atan2(sine, direction.z))
}
