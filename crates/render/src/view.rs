use oaktwin_camera::math::DAffine3;
use oaktwin_camera::{Camera, RigidTransform};

/// A camera with a pose: everything that determines the ray of a pixel.
///
/// Pixel `(x, y)`, counted from 0 at the upper left, sees along the ray through its centre, `(x + 0.5, y + 0.5)` in
/// the [`Usd`](oaktwin_camera::Usd) convention.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The intrinsics, which include the size of the image, and the lens.
    pub camera: Camera,
    /// The camera pose in metres; the camera's axes are `OpenCV`'s.
    pub world_from_camera: RigidTransform,
    /// The clipping range.
    pub clip: Clip,
}

impl View {
    /// Returns the transform from the world into the camera frame.
    #[must_use]
    pub fn camera_from_world(&self) -> DAffine3 {
        let inverse = self.world_from_camera.inverse();
        DAffine3::from_mat3_translation(inverse.rotation, inverse.translation)
    }

    /// Whether [`Clip`] is measured along the optical axis rather than along the ray.
    #[must_use]
    pub fn clips_along_axis(&self) -> bool {
        self.camera.lens.is_perspective()
    }
}

/// The clipping range in metres along the optical axis, or along the ray for lenses that see sideways (fisheye and f-theta).
/// Surfaces outside it are not rendered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip {
    /// The near distance, positive.
    pub near_m: f64,
    /// The far distance, which may be infinite.
    pub far_m: f64,
}

impl Default for Clip {
    /// Returns Isaac Sim's default: 1 cm to 10 000 km.
    fn default() -> Self {
        Self {
            near_m: 0.01,
            far_m: 1e7,
        }
    }
}
