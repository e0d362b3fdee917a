use oaktwin_camera::{
    Camera, Rectification, RectifiedIntrinsics, RectifyError, RigidTransform, stereo_rectify_to,
};
use oaktwin_image::{Image, ImageView};

use super::options::{Method, RectifyOptions, Target};
use super::{Grey, Rectify};

/// Raw pairs to rectified ones.
#[derive(Clone, Debug, PartialEq)]
pub struct StereoRectify {
    left: Rectify,
    right: Rectify,
    method: Method,
    geometry: Rectification,
}

impl StereoRectify {
    /// Of two cameras, `right_from_left` in metres.
    ///
    /// Both images are rectified by the method that suits the left camera.
    ///
    /// # Errors
    /// Cameras in one place, no rotation between them, or images of two sizes.
    pub fn new(
        left: &Camera,
        right: &Camera,
        right_from_left: &RigidTransform,
        options: &RectifyOptions,
    ) -> Result<Self, RectifyError> {
        let mut geometry = stereo_rectify_to(left, right, right_from_left, RectifiedIntrinsics::LeftCamera)?;
        let target = match options.target {
            Target::Left => left.intrinsics,
            Target::Right => right.intrinsics,
        };
        (geometry.left, geometry.right) = (target, target);
        let method = options.method.for_camera(left);
        let one =
            |camera: &Camera, rotation| Rectify::new(camera, rotation, &target, method, options.edge_fill);
        let (left, right) = rayon::join(
            || one(left, geometry.rectified_from_left),
            || one(right, geometry.rectified_from_right),
        );
        Ok(Self {
            left,
            right,
            method,
            geometry,
        })
    }

    /// What the rectified cameras are: their intrinsics, rotations and baseline. After a homography they still have their
    /// lenses, which are not in it.
    #[must_use]
    pub fn geometry(&self) -> &Rectification {
        &self.geometry
    }

    /// How pixels find their place: never [`Method::Auto`].
    #[must_use]
    pub fn method(&self) -> Method {
        self.method
    }

    /// Of the left camera.
    #[must_use]
    pub fn left(&self) -> &Rectify {
        &self.left
    }

    /// Of the right camera.
    #[must_use]
    pub fn right(&self) -> &Rectify {
        &self.right
    }

    /// A rectified pair; `None` where an image is not of the size of its camera's.
    #[must_use]
    pub fn rectify<P: Grey>(&self, left: ImageView<'_, P>, right: ImageView<'_, P>) -> Option<[Image<P>; 2]> {
        Some([self.left.rectify(left)?, self.right.rectify(right)?])
    }
}
