use std::collections::BTreeMap;

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Camera, ImageSize, Intrinsics, LensModel, RigidTransform};
use serde::Serialize;

use crate::{CalibrationError, Socket};

/// The checked calibration of one unit: all numbers are finite, extrinsics have no cycles, and rotations are orthonormal.
#[derive(Clone, Debug, PartialEq)]
pub struct Calibration {
    /// The file's name in messages.
    pub file_name: String,
    /// The version of the format, 4 to 7.
    pub version: u32,
    /// The identification of the board.
    pub board: Board,
    /// The cameras.
    pub cameras: BTreeMap<Socket, CameraCalibration>,
    /// The extrinsics of cameras without intrinsics; `None` at the root of a chain. These cameras count as missing, but others may
    /// refer to them.
    pub uncalibrated: BTreeMap<Socket, Option<ExtrinsicLink>>,
    /// The stereo pair in the file.
    pub stereo: Option<StereoRectification>,
    /// The extrinsics of the inertial unit.
    pub imu: Option<ExtrinsicLink>,
    /// The extrinsics of the housing.
    pub housing: Option<ExtrinsicLink>,
    /// `stereoUseSpecTranslation`: whether the device converts disparity to depth with the baseline of the board's design, by default
    /// true.
    pub use_spec_translation: bool,
}

/// The names and numbers of a board as in the file; missing names are empty.
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
    /// A free text.
    pub board_custom: String,
    /// The name of the unit.
    pub device_name: String,
    /// The time of production or calibration, seconds since 1970; 0 if unknown.
    pub batch_time: i64,
    /// Bit flags.
    pub board_options: i64,
}

/// One camera of a [`Calibration`].
#[derive(Clone, Debug, PartialEq)]
pub struct CameraCalibration {
    /// The socket.
    pub socket: Socket,
    /// The path in the file for findings, such as `cameraData[1]`.
    pub place: String,
    /// The family of lens models of the coefficients.
    pub kind: CameraKind,
    /// The intrinsics at the calibrated image size.
    pub intrinsics: Intrinsics,
    /// The lens.
    pub lens: LensModel,
    /// The coefficients in the file; of a fisheye the first four.
    pub distortion: Vec<f64>,
    /// `specHfovDeg`: the horizontal field of view of the design including distortion, degrees. It does not determine the
    /// focal length.
    pub spec_hfov_deg: f64,
    /// The position of the focus motor, 0 to 255; 0 for a fixed focus.
    pub lens_position: u8,
    /// The extrinsics to another camera; `None` at the root of a chain.
    pub extrinsics: Option<ExtrinsicLink>,
}

/// `cameraType`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum CameraKind {
    /// OpenCV's pinhole with up to 14 coefficients.
    Perspective,
    /// OpenCV's fisheye with four coefficients.
    Fisheye,
}

/// The extrinsics of a part of the device, relative to a camera.
#[derive(Clone, Debug, PartialEq)]
pub struct ExtrinsicLink {
    /// The path in the file for findings, such as `cameraData[1].extrinsics`.
    pub place: String,
    /// The camera.
    pub to: Socket,
    /// The calibrated transform to the camera's optical frame (x right, y down, z forward), m.
    pub camera_from_self: RigidTransform,
    /// The translation of the board's design, m; `None` if the file has zeros.
    pub spec_translation: Option<DVec3>,
}

/// `stereoRectificationData`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StereoRectification {
    /// The left camera.
    pub left: Socket,
    /// The right camera.
    pub right: Socket,
    /// The rotation from left to rectified-left, if the file contains it.
    pub rectified_from_left: Option<DMat3>,
    /// The rotation from right to rectified-right, if the file contains it.
    pub rectified_from_right: Option<DMat3>,
}

impl CameraCalibration {
    /// Returns the calibrated image size.
    #[must_use]
    pub const fn size(&self) -> ImageSize {
        self.intrinsics.size
    }

    /// Returns the intrinsics and the lens.
    #[must_use]
    pub const fn camera(&self) -> Camera {
        Camera::new(self.intrinsics, self.lens)
    }
}

impl ExtrinsicLink {
    /// Returns [`Self::camera_from_self`], with `use_spec` with the translation of the board's design.
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
    /// Returns the camera of a socket.
    ///
    /// # Errors
    /// Returns [`CalibrationError::NoCamera`] if there is none.
    pub fn camera(&self, socket: Socket) -> Result<&CameraCalibration, CalibrationError> {
        self.cameras
            .get(&socket)
            .ok_or_else(|| CalibrationError::NoCamera {
                file: self.file_name.clone(),
                socket,
                present: self.cameras.keys().copied().collect(),
            })
    }

    /// Returns the extrinsics of a camera, with or without intrinsics, `Some(None)` at a root, or `None` if there is no such camera.
    #[expect(
        clippy::option_option,
        reason = "no camera, a root, and extrinsics are three things"
    )]
    pub(crate) fn link(&self, socket: Socket) -> Option<Option<&ExtrinsicLink>> {
        let calibrated = self.cameras.get(&socket).map(|camera| camera.extrinsics.as_ref());
        calibrated.or_else(|| self.uncalibrated.get(&socket).map(Option::as_ref))
    }

    /// Returns the sockets of the stereo pair, (left, right): those in the file, or else `CAM_B` and `CAM_C` if it has both.
    #[must_use]
    pub fn stereo_pair(&self) -> Option<(Socket, Socket)> {
        let pair = self
            .stereo
            .map_or((Socket::CAM_B, Socket::CAM_C), |s| (s.left, s.right));
        (self.cameras.contains_key(&pair.0) && self.cameras.contains_key(&pair.1)).then_some(pair)
    }

    /// Returns the path of a pair's baseline in the file: the translation of the left camera, or of the right one if the left
    /// is the root.
    pub(crate) fn baseline_place(&self, left: Socket, right: Socket) -> String {
        let camera = [left, right]
            .into_iter()
            .filter_map(|socket| self.cameras.get(&socket))
            .find(|camera| camera.extrinsics.is_some());
        camera.map_or_else(
            || "cameraData".to_owned(),
            |camera| format!("{}.extrinsics.translation", camera.place),
        )
    }
}
