use oaktwin_base::parameter::by_name;
use oaktwin_camera::{ImageSize, StereoDrift};
use oaktwin_catalog::Role;
use oaktwin_depth::ParameterError;
use oaktwin_depth::imager::Parameters;
use oaktwin_depth::rectify::RectifyOptions;
use oaktwin_usd::asset::LensChoice;
use serde::{Deserialize, Serialize};

use crate::sensor::SensorOptions;

/// The options of recording a pair. In files, the fields that other options of a rig determine are left out.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct PairOptions {
    /// The left and the right camera of the pair; by default those with the roles `left` and `right`.
    pub cameras: (Role, Role),
    /// The image sensors, with their blur in px of the cameras' own resolution. Both have the same exposure.
    #[serde(with = "by_name")]
    pub imager: Parameters,
    /// The rectification; by default as on the device's processor.
    pub rectify: Option<RectifyOptions>,
    /// The intensity of the IR dot projector, 0 to 1: `DepthAI`'s `setIrLaserDotProjectorIntensity`. By default 0 (off), as on
    /// the device.
    pub projector: f64,
    /// The ambient light scale. 1 by default: the cameras of Pro models pass visible light beside the projector's 940 nm. 0 is a
    /// dark room, or a filter that passes the projector only.
    pub ambient: f64,
    /// The lens of the wide models' nominal cameras. A calibration's own lens takes precedence.
    pub lens: LensChoice,
    /// The size of the raw and rectified images, resized by `DepthAI`'s rule; by default the sensor's own.
    #[serde(skip)]
    pub size: Option<ImageSize>,
    /// The bias of disparity from the device's calibration error, px of the cameras' own resolution: the right image is shifted left
    /// by it relative to its calibration.
    #[serde(skip)]
    pub bias_px: f64,
    /// The change of the cameras since the calibration by which their images are rectified.
    #[serde(skip)]
    pub drift: StereoDrift,
    /// The noise seed.
    #[serde(skip)]
    pub seed: u64,
}

impl PairOptions {
    /// Returns the options for the pair of a depth sensor: with its calibration error, drift and noise seed.
    ///
    /// # Errors
    /// Returns an error if the calibration error is out of range.
    pub fn of_sensor(self, sensor: &SensorOptions) -> Result<Self, ParameterError> {
        Ok(Self {
            bias_px: sensor.calibration_error_px()?,
            drift: sensor.drift.unwrap_or_default(),
            seed: sensor.seed,
            ..self
        })
    }
}

impl Default for PairOptions {
    fn default() -> Self {
        Self {
            cameras: (Role::Left, Role::Right),
            imager: Parameters::default(),
            rectify: None,
            projector: 0.0,
            ambient: 1.0,
            lens: LensChoice::default(),
            size: None,
            bias_px: 0.0,
            drift: StereoDrift::default(),
            seed: 0,
        }
    }
}
