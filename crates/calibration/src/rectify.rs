use oaktwin_camera::math::DMat3;
use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, Rectification, RectifiedIntrinsics, RigidTransform,
    stereo_rectify, stereo_rectify_to,
};

use crate::{Calibration, CalibrationError, Socket};

/// The rotations that make a pair's rows parallel: (rectified-left from left, rectified-right from right). They depend on
/// nothing but the extrinsics. `None` where the two cameras are in one place.
pub(crate) fn rectifying_rotations(right_from_left: &RigidTransform) -> Option<(DMat3, DMat3)> {
    let any = Camera::new(
        Intrinsics::from_hfov(ImageSize::new(2, 2), 1.0),
        LensModel::Pinhole,
    );
    stereo_rectify_to(&any, &any, right_from_left, RectifiedIntrinsics::LeftCamera)
        .ok()
        .map(|pair| (pair.rectified_from_left, pair.rectified_from_right))
}

/// A calibrated stereo pair and its rectification.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoPair {
    /// The left camera's socket.
    pub left: Socket,
    /// The right camera's socket.
    pub right: Socket,
    /// The calibrated extrinsics, m.
    pub right_from_left: RigidTransform,
    /// As `cv2.stereoRectify` computes it with its default flags, for images of the left camera's size; for fisheye
    /// lenses, which that function does not know, the rectified intrinsics are the left camera's.
    pub rectification: Rectification,
}

impl Calibration {
    /// The stereo pair, rectified. `None` where the calibration has no two such cameras, or nothing joins them.
    ///
    /// # Errors
    /// The two cameras are in one place.
    pub fn rectified_pair(&self) -> Result<Option<StereoPair>, CalibrationError> {
        let Some((left, right)) = self.stereo_pair() else {
            return Ok(None);
        };
        let Ok(right_from_left) = self.transform(left, right, false) else {
            return Ok(None);
        };
        let (a, b) = (self.camera(left)?, self.camera(right)?);
        let right_at_size = Camera::new(b.intrinsics.resized(a.size(), true), b.lens);
        let rectification =
            stereo_rectify(&a.camera(), &right_at_size, &right_from_left).map_err(|error| {
                CalibrationError::Unsuited {
                    file: self.file_name.clone(),
                    place: crate::check::pair_place(self, left, right),
                    what: error.to_string(),
                    remedy: "calibrate the stereo pair again",
                }
            })?;
        Ok(Some(StereoPair {
            left,
            right,
            right_from_left,
            rectification,
        }))
    }
}
