use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The camera's inertial sensor. The format `euroc` contains its samples along the trajectory.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ImuRule {
    /// The samples per second; by default 400, or the part's maximum if lower.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate_hz: Option<f64>,
    /// The inertial part, such as `BMI270`; by default the model's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<String>,
}
