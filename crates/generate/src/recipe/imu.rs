use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The inertial sensor of the camera, whose samples along the trajectory the format `euroc` has.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ImuRule {
    /// The samples per second; by default 400, or what the part reports if that is less.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate_hz: Option<f64>,
    /// The inertial part, such as `BMI270`; by default the model's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<String>,
}
