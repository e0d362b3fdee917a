use oaktwin_camera::math::DAffine3;
use oaktwin_camera::{Camera, RigidTransform};

/// A camera that stands somewhere: all that decides which ray belongs to a pixel.
///
/// Pixel `(x, y)`, counted from 0 at the upper left, sees along the ray through its centre, `(x + 0.5, y + 0.5)` in
/// the [`Usd`](oaktwin_camera::Usd) convention.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Intrinsics, which also say the image's size, and the lens.
    pub camera: Camera,
    /// Where it stands; the camera's axes are `OpenCV`'s, lengths metres.
    pub world_from_camera: RigidTransform,
    /// What is seen of the depth.
    pub clip: Clip,
}

impl View {
    /// From the world into the camera's frame.
    #[must_use]
    pub fn camera_from_world(&self) -> DAffine3 {
        let inverse = self.world_from_camera.inverse();
        DAffine3::from_mat3_translation(inverse.rotation, inverse.translation)
    }

    /// Whether [`Clip`] is measured along the optical axis; else along the ray.
    #[must_use]
    pub fn clips_along_axis(&self) -> bool {
        self.camera.lens.is_perspective()
    }
}

/// The part of space that is seen, metres along the optical axis; along the ray for lenses that see sideways
/// (fisheye and f-theta). What lies outside is as if it was not there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clip {
    /// From here on, positive.
    pub near_m: f64,
    /// Up to here; may be infinite.
    pub far_m: f64,
}

impl Default for Clip {
    /// Isaac Sim's own: 1 cm to 10 000 km.
    fn default() -> Self {
        Self {
            near_m: 0.01,
            far_m: 1e7,
        }
    }
}
