use std::collections::BTreeMap;

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
use serde::Serialize;

use crate::{CalibrationError, Socket};

/// One unit's calibration, checked: finite, connected without cycles, with rotations that rotate.
#[derive(Clone, Debug, PartialEq)]
pub struct Calibration {
    /// What messages call the file.
    pub file_name: String,
    /// The format's version: 4 to 7.
    pub version: u32,
    /// What the board says it is.
    pub board: Board,
    /// The cameras.
    pub cameras: BTreeMap<Socket, CameraCalibration>,
    /// The stereo pair as the file has it.
    pub stereo: Option<StereoRectification>,
    /// Where the inertial unit is: from its frame to a camera's.
    pub imu: Option<Link>,
    /// Where the housing's frame is: from it to a camera's.
    pub housing: Option<Link>,
}

/// The names and numbers of a board, as the file spells them; empty where it has none.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Board {
    /// `OAK-D-PRO-POE`; the spelling varies by batch.
    pub product_name: String,
    /// `NG9097`.
    pub board_name: String,
    /// `R4M2E4`.
    pub board_rev: String,
    /// `IR-C00M00-00`.
    pub board_conf: String,
    /// `F1-FV00-BC001`.
    pub hardware_conf: String,
    /// Free text.
    pub board_custom: String,
    /// The unit's own name.
    pub device_name: String,
    /// When it was made or calibrated, seconds since 1970; 0 where unknown.
    pub batch_time: i64,
    /// Bits.
    pub board_options: i64,
}

/// One camera of a [`Calibration`].
#[derive(Clone, Debug, PartialEq)]
pub struct CameraCalibration {
    /// Its socket.
    pub socket: Socket,
    /// Its place in the file, for findings: `cameraData[1]`.
    pub place: String,
    /// Which family of lens models its coefficients belong to.
    pub kind: CameraKind,
    /// Of images of the size that it was calibrated at.
    pub intrinsics: Intrinsics,
    /// The lens.
    pub lens: LensModel,
    /// The coefficients as the file has them: for a fisheye its first four.
    pub distortion: Vec<f64>,
    /// `specHfovDeg`: of the design with its distortion; no focal length follows from it.
    pub spec_hfov_deg: f64,
    /// The focus motor's position, 0 to 255; 0 on a fixed focus.
    pub lens_position: u8,
    /// The way to another camera; none at the root of a chain.
    pub extrinsics: Option<Link>,
}

/// `cameraType`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum CameraKind {
    /// OpenCV's pinhole with up to 14 coefficients.
    Perspective,
    /// OpenCV's fisheye with four coefficients.
    Fisheye,
}

/// The place of something in a camera's frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// Its place in the file, for findings: `cameraData[1].extrinsics`.
    pub place: String,
    /// The camera.
    pub to: Socket,
    /// Calibrated: takes points to the camera's optical frame (x right, y down, z forward), m.
    pub camera_from_self: RigidTransform,
    /// The translation by the board's design, m; none where the file has zeros.
    pub spec_translation: Option<DVec3>,
}

/// `stereoRectificationData`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoRectification {
    /// The left camera.
    pub left: Socket,
    /// The right camera.
    pub right: Socket,
    /// Rectified-left from left; none where the file has none.
    pub rectified_from_left: Option<DMat3>,
    /// Rectified-right from right.
    pub rectified_from_right: Option<DMat3>,
}

impl CameraCalibration {
    /// The size that the camera was calibrated at.
    #[must_use]
    pub const fn size(&self) -> ImageSize {
        self.intrinsics.size
    }

    /// Its optics.
    #[must_use]
    pub const fn camera(&self) -> Camera {
        Camera::new(self.intrinsics, self.lens)
    }
}

impl Link {
    /// [`Self::camera_from_self`], with the board's design translation in place of the calibrated one if asked.
    pub(crate) fn transform(&self, file: &str, use_spec: bool) -> Result<RigidTransform, CalibrationError> {
        if !use_spec {
            return Ok(self.camera_from_self);
        }
        let translation = self
            .spec_translation
            .ok_or_else(|| CalibrationError::NoSpecTranslation {
                file: file.to_owned(),
                place: self.place.clone(),
            })?;
        Ok(RigidTransform::new(self.camera_from_self.rotation, translation))
    }
}

impl Calibration {
    /// The camera of a socket.
    ///
    /// # Errors
    /// [`CalibrationError::NoCamera`].
    pub fn camera(&self, socket: Socket) -> Result<&CameraCalibration, CalibrationError> {
        self.cameras
            .get(&socket)
            .ok_or_else(|| CalibrationError::NoCamera {
                file: self.file_name.clone(),
                socket,
                present: self.cameras.keys().copied().collect(),
            })
    }

    /// The sockets of the stereo pair, (left, right): the file's, or else `CAM_B` and `CAM_C` where it has both.
    #[must_use]
    pub fn stereo_pair(&self) -> Option<(Socket, Socket)> {
        let pair = self
            .stereo
            .map_or((Socket::CAM_B, Socket::CAM_C), |s| (s.left, s.right));
        (self.cameras.contains_key(&pair.0) && self.cameras.contains_key(&pair.1)).then_some(pair)
    }
}
