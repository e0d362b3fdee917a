use oaktwin_base::parameter::choice;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Quantity;

choice! {
    /// The population that units are drawn from.
    PopulationKind {
        /// Units as they leave the factory, each with its calibration.
        Factory = "factory",
    }
}

/// The unit that takes the frames; by default the nominal device.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct UnitRule {
    /// The calibration of one unit, a DepthAI export, relative to the recipe.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibration: Option<String>,
    /// The population from which each arrangement's unit is drawn. The units' calibrations are written to `units/`.
    #[serde(
        with = "crate::recipe::choice::optional",
        skip_serializing_if = "Option::is_none"
    )]
    #[schemars(with = "Option<String>", extend("enum" = ["factory"]))]
    pub population: Option<PopulationKind>,
    /// The number of units of the population, which take turns; by default every arrangement has its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub count: Option<u64>,
    /// The change of the stereo pair since the calibration.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drift: Option<DriftRule>,
}

/// The change of a unit's stereo pair since the calibration to which its images are rectified. It is drawn once for each unit of a
/// population, otherwise for each arrangement.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct DriftRule {
    /// The rotation of the right camera to the right, mrad. It adds an offset to disparity.
    pub yaw_mrad: Quantity,
    /// The rotation of the right camera upwards, mrad. It moves rows, and pixels are lost.
    pub pitch_mrad: Quantity,
    /// The clockwise rotation of the right camera about its optical axis, mrad.
    pub roll_mrad: Quantity,
    /// The growth of the baseline, µm.
    pub baseline_um: Quantity,
    /// The growth of both focal lengths, parts per million.
    pub focal_length_ppm: Quantity,
    /// The warming of both lenses, kelvin, each of which adds 50 ppm to the focal lengths (an estimate).
    pub temperature_k: Quantity,
}

impl Default for DriftRule {
    fn default() -> Self {
        let none = || Quantity::Constant(0.0);
        Self {
            yaw_mrad: none(),
            pitch_mrad: none(),
            roll_mrad: none(),
            baseline_um: none(),
            focal_length_ppm: none(),
            temperature_k: none(),
        }
    }
}

impl DriftRule {
    /// The quantities with their keys and the names of the drift's parameters.
    pub(crate) fn quantities(&self) -> [(&'static str, &'static str, &Quantity); 6] {
        [
            ("yaw_mrad", "yaw", &self.yaw_mrad),
            ("pitch_mrad", "pitch", &self.pitch_mrad),
            ("roll_mrad", "roll", &self.roll_mrad),
            ("baseline_um", "baseline", &self.baseline_um),
            ("focal_length_ppm", "focalLength", &self.focal_length_ppm),
            ("temperature_k", "temperature", &self.temperature_k),
        ]
    }
}
