use oaktwin_camera::math::DMat3;
use oaktwin_camera::{
    Camera, ImageSize, Intrinsics, LensModel, Rectification, RectifiedIntrinsics, RectifyError,
    RigidTransform, stereo_rectify, stereo_rectify_to,
};

use crate::{Calibration, CalibrationError, Socket};

/// Returns the rectifying rotations of a pair: (rectified-left from left, rectified-right from right). They depend on the
/// extrinsics only. `None` if the baseline is zero.
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
    /// The rectification by `cv2.stereoRectify` with its default flags, for images of the left camera's size. For fisheye
    /// lenses, which that function does not support, the rectified intrinsics are the left camera's.
    pub rectification: Rectification,
}

impl Calibration {
    /// Returns the rectified stereo pair, or `None` if the calibration has no such cameras or no extrinsics connect them.
    ///
    /// # Errors
    /// Returns an error if the baseline is zero.
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
                let place = match error {
                    RectifyError::Lens("left") => format!("{}.distortionCoeff", a.place),
                    RectifyError::Lens(_) => format!("{}.distortionCoeff", b.place),
                    _ => self.baseline_place(left, right),
                };
                CalibrationError::Unsuited {
                    file: self.file_name.clone(),
                    place,
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
