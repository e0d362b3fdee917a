use oaktwin_camera::{Camera, Rectification, RectifyError, RigidTransform, stereo_rectify_to};
use oaktwin_image::{Image, ImageView};

use super::options::{Method, RectifyOptions};
use super::positions::remaining;
use super::{Grey, Rectify};

/// Rectifies raw pairs.
#[derive(Clone, Debug, PartialEq)]
pub struct StereoRectify {
    left: Rectify,
    right: Rectify,
    method: Method,
    geometry: Rectification,
    remaining: RemainingDistortion,
}

/// The lens distortion that rectification leaves in the images of a pair.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RemainingDistortion {
    /// The share of the pixels of both images that are off by more than 1 px.
    pub share: f64,
    /// The largest distance, px.
    pub max_px: f64,
}

impl RemainingDistortion {
    fn of(distances: impl Iterator<Item = f32>) -> Self {
        let (mut count, mut far, mut max_px) = (0_u32, 0_u32, 0.0_f64);
        for distance in distances {
            count += 1;
            far += u32::from(distance > 1.0);
            max_px = max_px.max(f64::from(distance));
        }
        Self {
            share: f64::from(far) / f64::from(count.max(1)),
            max_px,
        }
    }
}

impl StereoRectify {
    /// Creates the rectification of two cameras, with `right_from_left` in metres.
    ///
    /// The method is chosen for the left camera and used for both.
    ///
    /// # Errors
    /// Returns an error if the cameras are at the same position, the rotation is invalid or the image sizes differ.
    pub fn new(
        left: &Camera,
        right: &Camera,
        right_from_left: &RigidTransform,
        options: &RectifyOptions,
    ) -> Result<Self, RectifyError> {
        let geometry = stereo_rectify_to(left, right, right_from_left, options.target)?;
        let target = geometry.left;
        let method = options.method.for_camera(left);
        let one =
            |camera: &Camera, rotation| Rectify::new(camera, rotation, &target, method, options.edge_fill);
        let (rotated_left, rotated_right) = (geometry.rectified_from_left, geometry.rectified_from_right);
        let remaining = match method {
            Method::Homography => RemainingDistortion::of(
                remaining(left, rotated_left, &target).chain(remaining(right, rotated_right, &target)),
            ),
            _ => RemainingDistortion::default(),
        };
        let (left, right) = rayon::join(|| one(left, rotated_left), || one(right, rotated_right));
        Ok(Self {
            left,
            right,
            method,
            geometry,
            remaining,
        })
    }

    /// The lens distortion that is left after a homography; none after the other methods.
    #[must_use]
    pub fn remaining(&self) -> RemainingDistortion {
        self.remaining
    }

    /// The rectified cameras: intrinsics, rotations and baseline. After a homography the images still have the lens
    /// distortion, which this does not contain.
    #[must_use]
    pub fn geometry(&self) -> &Rectification {
        &self.geometry
    }

    /// The method, never [`Method::Auto`].
    #[must_use]
    pub fn method(&self) -> Method {
        self.method
    }

    /// The rectification of the left camera.
    #[must_use]
    pub fn left(&self) -> &Rectify {
        &self.left
    }

    /// The rectification of the right camera.
    #[must_use]
    pub fn right(&self) -> &Rectify {
        &self.right
    }

    /// Rectifies a pair; `None` if an image does not have the size of its camera.
    #[must_use]
    pub fn rectify<P: Grey>(&self, left: ImageView<'_, P>, right: ImageView<'_, P>) -> Option<[Image<P>; 2]> {
        Some([self.left.rectify(left)?, self.right.rectify(right)?])
    }
}
