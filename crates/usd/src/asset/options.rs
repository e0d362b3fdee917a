use oaktwin_camera::ApertureOffsets;
use oaktwin_catalog::{LensChoice, Twin};

use super::AssetError;

/// Options of an asset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AssetOptions {
    /// The Isaac Sim version whose schemas are used.
    pub isaac: IsaacVersion,
    /// The renderer.
    pub target: Target,
    /// The stereo cameras' lenses if there is no calibration.
    pub lens: LensChoice,
    /// The conversion of a calibrated principal point to aperture offsets.
    pub aperture_offsets: ApertureOffsets,
    /// Whether the depth sensor uses extended disparity: twice the disparity range, for near objects.
    pub extended_disparity: bool,
    /// Whether to write the legacy distortion attributes even if they are no longer the default.
    pub legacy_distortion: bool,
    /// Whether the device is a rigid body with mass and collider.
    pub rigid_body: bool,
    /// Whether to include the visible body.
    pub body: bool,
}

impl Default for AssetOptions {
    fn default() -> Self {
        Self {
            isaac: IsaacVersion::default(),
            target: Target::default(),
            lens: LensChoice::default(),
            aperture_offsets: ApertureOffsets::default(),
            extended_disparity: false,
            legacy_distortion: false,
            rigid_body: false,
            body: true,
        }
    }
}

/// The Isaac Sim version that an asset is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum IsaacVersion {
    /// 5.1: `outlierRemovalEnabled` is an `int`, and the legacy distortion attributes are still read.
    #[default]
    V5_1,
    /// 6.x: `outlierRemovalEnabled` is a `bool`, and render products list their render variables.
    V6,
}

/// The renderer that an asset is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Target {
    /// Isaac Sim: the depth sensor's schema is on the render product.
    #[default]
    Isaac,
    /// ovrtx: the depth sensor's schema is on the camera. Experimental: NVIDIA publishes no list of its attributes.
    Ovrtx,
}

/// The file format of an asset.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Format {
    /// Text with the extension `.usda`.
    Usda,
    /// The same text with the extension `.usd`, which Isaac Sim's asset paths use.
    #[default]
    Usd,
    /// A `.usdz` package of the text.
    Usdz,
}

impl Format {
    /// Returns the file extension without the dot.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Usda => "usda",
            Self::Usd => "usd",
            Self::Usdz => "usdz",
        }
    }
}

impl IsaacVersion {
    /// Returns `5.1` or `6`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::V5_1 => "5.1",
            Self::V6 => "6",
        }
    }
}

impl Target {
    /// Returns `isaac` or `ovrtx`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Isaac => "isaac",
            Self::Ovrtx => "ovrtx",
        }
    }
}

impl AssetOptions {
    /// Rejects options that the model does not support.
    pub(super) fn check(&self, twin: &Twin) -> Result<(), AssetError> {
        let model = || twin.device.name.clone();
        let is_wide = twin
            .cameras
            .iter()
            .any(|camera| camera.spec.fisheye_hfov_deg.is_some());
        if self.lens == LensChoice::Fisheye && !is_wide {
            return Err(AssetError::NoFisheyeLens { model: model() });
        }
        let lacks_extended = twin
            .depth_sensors
            .iter()
            .find(|sensor| sensor.spec.extended_max_disparity_px.is_none());
        match lacks_extended {
            Some(sensor) if self.extended_disparity => Err(AssetError::NoExtendedDisparity {
                model: model(),
                sensor: sensor.spec.prim.clone(),
            }),
            _ => Ok(()),
        }
    }
}
