//! Views of benchmark scenes.

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
use oaktwin_render::{Clip, View};

/// The horizontal field of view, degrees, like an OAK-D's stereo cameras'.
const HFOV_DEG: f64 = 77.0;

/// Returns a view from `eye` to `target`, 77° wide.
#[must_use]
pub fn looking_at(eye: DVec3, target: DVec3, up: DVec3, size: ImageSize) -> View {
    let back = (eye - target).normalize();
    let right = up.cross(back).normalize();
    let rotation = DMat3::from_cols(right, right.cross(back), -back);
    View {
        camera: Camera::new(
            Intrinsics::from_hfov(size, HFOV_DEG.to_radians()),
            LensModel::Pinhole,
        ),
        world_from_camera: RigidTransform::new(rotation, eye),
        clip: Clip::default(),
    }
}
