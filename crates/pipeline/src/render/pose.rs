//! Poses from user input.

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DQuat, DVec3};

/// The tolerance of a quaternion's length, because files round to a few decimals.
const QUATERNION_TOLERANCE: f64 = 1e-2;

/// An invalid pose.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PoseError {
    /// A number is not finite.
    #[error("{value} is not finite; give finite numbers")]
    NotFinite {
        /// The number.
        value: f64,
    },
    /// A quaternion is not a rotation.
    #[error("the quaternion ({x}, {y}, {z}, {w}) has length {length}, not 1; the order is qx qy qz qw")]
    NotUnit {
        /// The x component.
        x: f64,
        /// The y component.
        y: f64,
        /// The z component.
        z: f64,
        /// The real part.
        w: f64,
        /// The length.
        length: f64,
    },
    /// The direction of view is undefined.
    #[error("the eye and the target are equal; give another target")]
    NoDirection,
    /// The roll of the view is undefined.
    #[error("the direction of view is parallel to the up direction; give another one")]
    NoUpright,
}

/// Returns the pose `x y z qx qy qz qw`: metres and a unit quaternion, which may be rounded.
///
/// # Errors
/// Returns an error if a number is not finite or the quaternion is not a rotation.
pub fn pose([x, y, z, qx, qy, qz, qw]: [f64; 7]) -> Result<RigidTransform, PoseError> {
    finite(&[x, y, z, qx, qy, qz, qw])?;
    let q = DQuat::from_xyzw(qx, qy, qz, qw);
    let length = q.length();
    // This also rejects a length that overflows.
    if (length - 1.0).abs() > QUATERNION_TOLERANCE {
        return Err(PoseError::NotUnit {
            x: qx,
            y: qy,
            z: qz,
            w: qw,
            length,
        });
    }
    Ok(RigidTransform::new(
        DMat3::from_quat(q.normalize()),
        DVec3::new(x, y, z),
    ))
}

/// Returns the pose of a body (x forward, y left, z up) at `eye` that faces `target`, with its z axis towards `up`; world
/// coordinates in metres.
///
/// # Errors
/// Returns an error if a number is not finite, `target` equals `eye`, or `up` is parallel to the view.
pub fn look_at(eye: DVec3, target: DVec3, up: DVec3) -> Result<RigidTransform, PoseError> {
    for point in [eye, target, up] {
        finite(&point.to_array())?;
    }
    let forward = (target - eye).try_normalize().ok_or(PoseError::NoDirection)?;
    let up = up.try_normalize().ok_or(PoseError::NoUpright)?;
    let left = up.cross(forward);
    // The sine of the angle between them; below a millionth of a radian the roll is undefined.
    if left.length() < 1e-6 {
        return Err(PoseError::NoUpright);
    }
    let left = left.normalize();
    Ok(RigidTransform::new(
        DMat3::from_cols(forward, left, forward.cross(left)),
        eye,
    ))
}

fn finite(numbers: &[f64]) -> Result<(), PoseError> {
    match numbers.iter().find(|number| !number.is_finite()) {
        Some(&value) => Err(PoseError::NotFinite { value }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn look_at_points_the_x_axis_at_the_target() {
        let world_from_body =
            look_at(DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, 5.0, 3.0), DVec3::Z).unwrap();
        assert_eq!(world_from_body.rotation * DVec3::X, DVec3::Y);
        assert_eq!(world_from_body.rotation * DVec3::Y, DVec3::NEG_X);
        assert_eq!(world_from_body.rotation * DVec3::Z, DVec3::Z);
        assert_eq!(world_from_body.translation, DVec3::new(1.0, 2.0, 3.0));
        // A world with y up.
        let world_from_body = look_at(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y).unwrap();
        assert_eq!(world_from_body.rotation * DVec3::Z, DVec3::Y);
    }

    #[test]
    fn rejects_invalid_poses() {
        assert_eq!(look_at(DVec3::X, DVec3::X, DVec3::Z), Err(PoseError::NoDirection));
        assert_eq!(
            look_at(DVec3::ZERO, DVec3::NEG_Z, DVec3::Z),
            Err(PoseError::NoUpright)
        );
        assert_eq!(
            look_at(DVec3::ZERO, DVec3::X, DVec3::ZERO),
            Err(PoseError::NoUpright)
        );
        assert!(look_at(DVec3::NAN, DVec3::X, DVec3::Z).is_err());
        assert!(pose([0.0, 0.0, f64::INFINITY, 0.0, 0.0, 0.0, 1.0]).is_err());
        assert!(pose([0.0; 7]).is_err());
        assert!(pose([0.0, 0.0, 0.0, 0.5, 0.5, 0.5, 0.6]).is_err());
        assert!(pose([0.0, 0.0, 0.0, 1e300, 1e300, 0.0, 0.0]).is_err());
    }

    #[test]
    fn normalizes_rounded_quaternions() {
        let half = 0.707;
        let pose = pose([1.0, 2.0, 3.0, 0.0, 0.0, half, half]).unwrap();
        assert!(pose.orthonormality_error() < 1e-14);
        assert!((pose.rotation * DVec3::X - DVec3::Y).length() < 1e-12);
    }

    proptest! {
        #[test]
        fn the_target_is_straight_ahead(
            eye in prop::array::uniform3(-10.0..10.0f64),
            target in prop::array::uniform3(-10.0..10.0f64),
            up in prop::array::uniform3(-1.0..1.0f64),
        ) {
            let (eye, target, up) = (DVec3::from(eye), DVec3::from(target), DVec3::from(up));
            let Ok(world_from_body) = look_at(eye, target, up) else {
                return Ok(());
            };
            prop_assert!(world_from_body.orthonormality_error() < 1e-9);
            let seen = world_from_body.inverse().apply(target);
            let distance = (target - eye).length();
            prop_assert!((seen - DVec3::new(distance, 0.0, 0.0)).length() < 1e-9 * (1.0 + distance));
            prop_assert!((world_from_body.rotation.transpose() * up).y.abs() < 1e-9);
        }
    }
}
