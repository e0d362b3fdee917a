use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Quantity;

/// The longest exposure, readout and offset, ms.
const MAX_MS: f64 = 10_000.0;
/// The largest velocity along an axis, m/s.
const MAX_M_S: f64 = 100.0;
/// The largest angular velocity about an axis, degrees per second.
const MAX_DEG_S: f64 = 3600.0;

/// The camera in motion: how long its frames take, and how it moves meanwhile. Colours, the stereo pair and time of flight are blurred, and
/// roll as their sensors do; ground truth is the scene at the time of the frame, the middle of the exposure of the middle row.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MotionRule {
    /// The exposure of each row, ms.
    pub exposure_ms: Quantity,
    /// How much later the last row is exposed than the first on sensors that roll, ms; by default the catalog's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub readout_ms: Option<Quantity>,
    /// The velocity of the camera's body forwards, to the left and upwards, m/s; by default 0. A trajectory has its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub velocity_m_s: Option<[Quantity; 3]>,
    /// The angular velocity about the same axes, degrees per second; by default 0. A trajectory has its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub angular_velocity_deg_s: Option<[Quantity; 3]>,
    /// How long after the time of a frame cameras take it, ms by their names; by default 0. Their images have their own times and poses.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub camera_offsets_ms: BTreeMap<String, f64>,
}

impl MotionRule {
    /// The keys of the quantities, with the smallest and the largest number of each.
    pub(crate) fn quantities(&self) -> Vec<(String, Quantity, [f64; 2])> {
        let time = [0.0, MAX_MS];
        let mut all = vec![("exposure_ms".to_owned(), self.exposure_ms.clone(), time)];
        all.extend((self.readout_ms.clone()).map(|readout| ("readout_ms".to_owned(), readout, time)));
        for (key, axes, most) in [
            ("velocity_m_s", &self.velocity_m_s, MAX_M_S),
            ("angular_velocity_deg_s", &self.angular_velocity_deg_s, MAX_DEG_S),
        ] {
            let axes = axes.iter().flatten();
            all.extend(axes.map(|axis| (key.to_owned(), axis.clone(), [-most, most])));
        }
        let offsets = self.camera_offsets_ms.iter();
        all.extend(offsets.map(|(name, ms)| (format!("camera_offsets_ms.{name}"), (*ms).into(), time)));
        all
    }

    /// Whether the recipe says how the camera moves.
    pub(crate) fn has_velocity(&self) -> bool {
        self.velocity_m_s.is_some() || self.angular_velocity_deg_s.is_some()
    }
}
