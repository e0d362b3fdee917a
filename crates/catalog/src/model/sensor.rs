use std::collections::BTreeMap;

use oaktwin_camera::ImageSize;
use serde::{Deserialize, Serialize};

use super::{Evidence, Note};
use crate::{Source, Sources};

/// An image sensor: `data/sensors/*.toml`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Sensor {
    /// The name by which devices refer to it, such as `OV9282`.
    pub id: String,
    /// The manufacturer, such as `OmniVision`; absent if no source names it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub manufacturer: Option<String>,
    /// The type in words, such as `CMOS, global shutter`.
    pub kind: String,
    /// The size of the full pixel array (width, height).
    pub native_resolution: (u32, u32),
    /// The size of the mode that the assets use (width, height).
    pub used_resolution: (u32, u32),
    /// How the mode is derived from the array: `full`, `centre crop`, `2x2 binned`.
    pub used_mode: String,
    /// The pixel pitch of the array in µm.
    pub native_pixel_size_um: f64,
    /// The pixel pitch of the used mode in µm.
    pub pixel_size_um: f64,
    /// The optical format, such as `1/4"`; absent if no source states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub optical_format: Option<String>,
    /// The marketed resolution in megapixels.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub megapixels: Option<f64>,
    /// Whether all rows are exposed at once or one after another; absent if no source states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shutter: Option<ShutterKind>,
    /// The readout time in the used mode, ms: how much later a rolling sensor exposes its last row than its first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub readout_ms: Option<f64>,
    /// Whether the sensor has no colour filters, so that its images are grey.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub monochrome: bool,
    /// The wavelength of the light source in nm, for time-of-flight sensors.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wavelength_nm: Option<f64>,
    /// The measuring range (minimum, maximum) in m, for time-of-flight sensors.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_range_m: Option<(f64, f64)>,
    /// The accuracy as the sheet words it, for time-of-flight sensors.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_accuracy: Option<String>,
    /// Further evidence about the values above.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub evidence: Vec<Evidence>,
    /// Further statements of the sources.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<Note>,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// How a sensor exposes its rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum ShutterKind {
    /// All at once.
    Global,
    /// One after another.
    Rolling,
}

impl Sensor {
    /// Returns the readout time, s: how much later the last row is exposed than the first. It is 0 unless the sensor rolls.
    #[must_use]
    pub fn readout_s(&self) -> f64 {
        match self.shutter {
            Some(ShutterKind::Rolling) => self.readout_ms.unwrap_or(0.0) * 1e-3,
            Some(ShutterKind::Global) | None => 0.0,
        }
    }

    /// Returns the size of the used mode.
    #[must_use]
    pub const fn used_size(&self) -> ImageSize {
        ImageSize::new(self.used_resolution.0, self.used_resolution.1)
    }
}
