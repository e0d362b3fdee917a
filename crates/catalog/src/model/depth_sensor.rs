//! The depth sensors of a device.

use std::collections::BTreeMap;
use std::fmt;

use oaktwin_base::parameter::Choice;
use oaktwin_base::parameter::nvidia::Attributes;
use serde::{Deserialize, Serialize};

use super::Role;
use crate::{Source, Sources};

/// The measuring principle of a depth sensor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum DepthKind {
    /// Disparity of the stereo pair.
    Stereo,
    /// Time of flight, which the sheet describes as stereo with a very short baseline.
    Tof,
}

impl DepthKind {
    /// Returns the name in files, such as `stereo`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Stereo => "stereo",
            Self::Tof => "tof",
        }
    }
}

impl Choice for DepthKind {
    const VARIANTS: &'static [Self] = &[Self::Stereo, Self::Tof];
    const NAMES: &'static [&'static str] = &[Self::Stereo.as_str(), Self::Tof.as_str()];
    const ABOUT: &'static [&'static str] = &["The stereo pair.", "Time of flight."];
}

impl fmt::Display for DepthKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// A depth sensor: the parameters of one render product with `OmniSensorDepthSensorSingleViewAPI`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct DepthSensor {
    /// The measuring principle.
    pub kind: DepthKind,
    /// The prim of the virtual camera, `Camera_pseudo_depth`.
    pub prim: String,
    /// The camera whose optics and position it has: of a stereo pair, the left one.
    pub camera: Role,
    /// The right camera of its stereo pair; by default, the one with the role `right`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub right_camera: Option<Role>,
    /// `focusDistance` of the virtual camera.
    pub focus_distance: f64,
    /// `clippingRange` of the virtual camera, m.
    pub clipping_range_m: (f64, f64),
    /// `baselineMM`.
    pub baseline_mm: f64,
    /// `focalLengthPixel`.
    pub focal_length_px: f64,
    /// `sensorSizePixel`.
    pub sensor_size_px: f64,
    /// `maxDisparityPixel` in the standard mode.
    pub max_disparity_px: f64,
    /// `maxDisparityPixel` in the extended mode, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extended_max_disparity_px: Option<f64>,
    /// `minDistance`, m.
    pub min_distance_m: f64,
    /// `minDistance` in the extended mode in m, if it differs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extended_min_distance_m: Option<f64>,
    /// `maxDistance`, m.
    pub max_distance_m: f64,
    /// `noiseMean`: the quantization step of disparity, px.
    pub noise_mean_px: f64,
    /// `noiseSigma`, px.
    pub noise_sigma_px: f64,
    /// `noiseDownscaleFactorPixel`, px.
    pub noise_downscale_factor_px: f64,
    /// `confidenceThreshold`, 0 to 1.
    pub confidence_threshold: f64,
    /// The sheet's `outlierRemovalRange`, px: the attribute is `outlierRemovalEnabled`.
    pub outlier_removal_range_px: u32,
    /// The range that the vendor recommends (minimum, maximum) in m.
    pub ideal_range_m: (f64, f64),
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

impl DepthSensor {
    /// Returns the left and the right camera of its stereo pair, or `None` for time of flight.
    #[must_use]
    pub fn pair(&self) -> Option<(Role, Role)> {
        match self.kind {
            DepthKind::Stereo => Some((self.camera, self.right_camera.unwrap_or(Role::Right))),
            DepthKind::Tof => None,
        }
    }

    /// Returns the attributes of the render product in the standard or the extended mode. Attributes that the parameter sheet
    /// lacks have the schema's defaults.
    #[must_use]
    pub fn attributes(&self, is_extended: bool) -> Attributes {
        let extended =
            |standard: f64, extended: Option<f64>| extended.filter(|_| is_extended).unwrap_or(standard);
        Attributes {
            baseline_mm: self.baseline_mm,
            focal_length_px: self.focal_length_px,
            sensor_size_px: self.sensor_size_px,
            max_disparity_px: extended(self.max_disparity_px, self.extended_max_disparity_px),
            min_distance_m: extended(self.min_distance_m, self.extended_min_distance_m),
            max_distance_m: self.max_distance_m,
            noise_mean_px: self.noise_mean_px,
            noise_sigma_px: self.noise_sigma_px,
            noise_downscale_factor_px: self.noise_downscale_factor_px,
            confidence_threshold: self.confidence_threshold,
            outlier_removal_range_px: self.outlier_removal_range_px,
            ..Attributes::isaac_5_1()
        }
    }
}
