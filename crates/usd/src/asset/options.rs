use oaktwin_camera::ApertureOffsets;
use oaktwin_catalog::{LensChoice, Twin};

use super::AssetError;

/// What to write into an asset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AssetOptions {
    /// The schema generation.
    pub isaac: IsaacVersion,
    /// The renderer.
    pub target: Target,
    /// The stereo cameras' lenses, where no calibration says.
    pub lens: LensChoice,
    /// How a calibrated principal point becomes aperture offsets.
    pub aperture_offsets: ApertureOffsets,
    /// The depth sensor's extended mode: near objects, twice the disparity range.
    pub extended_disparity: bool,
    /// The old distortion attributes also where they are no longer the default.
    pub legacy_distortion: bool,
    /// A rigid body with mass and collider.
    pub rigid_body: bool,
    /// The visible body.
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

/// The Isaac Sim that an asset is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum IsaacVersion {
    /// 5.1: `outlierRemovalEnabled` is an `int`, the old distortion attributes are still read.
    #[default]
    V5_1,
    /// 6.x: `outlierRemovalEnabled` is a `bool`, render products list their render variables.
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

/// How an asset is stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Format {
    /// Text, named `.usda`.
    Usda,
    /// The same text under the name that Isaac Sim's asset paths use, `.usd`.
    #[default]
    Usd,
    /// The text in a package, `.usdz`.
    Usdz,
}

impl Format {
    /// The file name's extension, without the dot.
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
    /// `5.1` or `6`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::V5_1 => "5.1",
            Self::V6 => "6",
        }
    }
}

impl Target {
    /// `isaac` or `ovrtx`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Isaac => "isaac",
            Self::Ovrtx => "ovrtx",
        }
    }
}

impl AssetOptions {
    /// Whether the model can have all of this.
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
