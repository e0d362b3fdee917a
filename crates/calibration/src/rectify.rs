use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DQuat, DVec3};

/// The rotations that make a pair's rows parallel: (rectified-left from left, rectified-right from right). Each camera
/// takes half of the relative rotation, then both turn their x axis (y of a vertical pair) along the baseline, as in
/// `cv2.stereoRectify`.
pub(crate) fn rectifying_rotations(right_from_left: &RigidTransform) -> (DMat3, DMat3) {
    let (axis, angle) = DQuat::from_mat3(&right_from_left.rotation)
        .normalize()
        .to_axis_angle();
    let angle = if angle > std::f64::consts::PI {
        angle - std::f64::consts::TAU
    } else {
        angle
    };
    let half_back = DMat3::from_axis_angle(axis, -angle / 2.0);
    let t = half_back * right_from_left.translation;
    let horizontal = t.x.abs() > t.y.abs();
    let along = if horizontal { t.x } else { t.y };
    let unit = if horizontal { DVec3::X } else { DVec3::Y } * along.signum();
    let w = t.cross(unit);
    let turn = if w.length() > 0.0 {
        let angle = (along.abs() / t.length()).clamp(-1.0, 1.0).acos();
        DMat3::from_axis_angle(w.normalize(), angle)
    } else {
        DMat3::IDENTITY
    };
    (turn * half_back.transpose(), turn * half_back)
}
