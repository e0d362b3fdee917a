use oaktwin_base::parameter::choice;
use oaktwin_camera::ApertureOffsets;
use oaktwin_catalog::{LensChoice, Twin};

use super::AssetError;

/// Options of an asset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AssetOptions {
    /// The Isaac Sim version whose schemas are used.
    pub isaac: IsaacVersion,
    /// The renderer.
    pub target: AssetTarget,
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
            target: AssetTarget::default(),
            lens: LensChoice::default(),
            aperture_offsets: ApertureOffsets::default(),
            extended_disparity: false,
            legacy_distortion: false,
            rigid_body: false,
            body: true,
        }
    }
}

choice! {
    /// The Isaac Sim version that an asset is for.
    ///
    /// In 5.0 and 5.1, `outlierRemovalEnabled` is an `int`, and the legacy distortion attributes are still read. In 6, it is a
    /// `bool`, and render products list their render variables.
    IsaacVersion {
        /// Isaac Sim 5.0 and 5.1.
        V5_1 = "5.1",
        /// Isaac Sim 6.
        V6 = "6" | "6.0",
    }
}

choice! {
    /// The renderer that an asset is for. NVIDIA publishes no list of the attributes of ovrtx.
    AssetTarget {
        /// The depth sensor's schema is on the render product.
        Isaac = "isaac",
        /// The depth sensor's schema is on the camera; experimental.
        Ovrtx = "ovrtx",
    }
}

choice! {
    /// The file format of an asset.
    Format {
        /// USD text in a .usd file, as in Isaac Sim's asset paths.
        Usd = "usd",
        /// USD text in a .usda file.
        Usda = "usda",
        /// A USDZ package of the text.
        Usdz = "usdz",
    }
}

impl Format {
    /// Returns the file extension without the dot.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        self.name()
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
