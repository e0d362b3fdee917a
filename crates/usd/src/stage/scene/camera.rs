use oaktwin_camera::math::{DAffine3, DMat3, DVec3};
use oaktwin_camera::{Axes, RigidTransform};

/// The tolerance of a camera's axes being orthonormal.
const TOLERANCE: f64 = 1e-5;

/// Returns a camera's pose: its transform without scale, shear and mirroring, and which of these was removed. `None` if
/// the transform is singular.
pub(in crate::stage) fn pose(
    stage_from_prim: &DAffine3,
    meters_per_unit: f64,
) -> Option<(RigidTransform, Option<&'static str>)> {
    let (pose, removed) = rigid(stage_from_prim, meters_per_unit)?;
    let axes = Axes::Usd.rotation_from(Axes::OpenCv);
    Some((
        RigidTransform::new(pose.rotation * axes, pose.translation),
        removed,
    ))
}

/// Returns [`pose`] for a prim with any axes.
pub(in crate::stage) fn rigid(
    stage_from_prim: &DAffine3,
    meters_per_unit: f64,
) -> Option<(RigidTransform, Option<&'static str>)> {
    let axes = stage_from_prim.matrix3;
    let translation = stage_from_prim.translation * meters_per_unit;
    // The viewing direction is kept exactly, the up direction as far as possible.
    let backward = axes.z_axis.try_normalize()?;
    let up = (axes.y_axis - backward * backward.dot(axes.y_axis)).try_normalize()?;
    let rotation = DMat3::from_cols(up.cross(backward), up, backward);
    if !translation.is_finite() {
        return None;
    }
    let lengths = DVec3::new(axes.x_axis.length(), axes.y_axis.length(), axes.z_axis.length());
    let unscaled = DMat3::from_cols(
        axes.x_axis / lengths.x,
        axes.y_axis / lengths.y,
        axes.z_axis / lengths.z,
    );
    let shear = RigidTransform::new(unscaled, DVec3::ZERO).orthonormality_error();
    let removed = if axes.determinant() < 0.0 {
        Some("a reflection")
    } else if shear.is_nan() || shear > TOLERANCE {
        Some("a shear")
    } else if (lengths - 1.0).abs().max_element() > TOLERANCE {
        Some("a scale")
    } else {
        None
    };
    Some((RigidTransform::new(rotation, translation), removed))
}
