use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{Quantity, Region, Texts};

/// The lights of a scene. Only ratios of intensities matter, because cameras adapt their exposure.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct LightRule {
    /// Whether the base scene's own lights are kept.
    pub keep: bool,
    /// The sun.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sun: Option<Sun>,
    /// The sky.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sky: Option<Sky>,
    /// Lamps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lamps: Option<Lamps>,
    /// The factor of ambient light in the images of the stereo cameras: 1 for visible light, 0 for a dark room or a filter that only the
    /// projector passes. With `stereo-noise`, noise hides texture in little light.
    pub infrared_ambient: Quantity,
    /// The intensity of the dot projector of models that have one, 0 to 1; by default full, 1. With `stereo-matching` the dots are
    /// rendered; with `stereo-noise` they add to the texture of surfaces, less with distance and on dark ones.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub projector: Option<Quantity>,
}

impl Default for LightRule {
    fn default() -> Self {
        Self {
            keep: true,
            sun: None,
            sky: None,
            lamps: None,
            infrared_ambient: 1.0.into(),
            projector: None,
        }
    }
}

/// The sun.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Sun {
    /// The irradiance of a surface that faces the sun, in the unit of USD's distant lights.
    pub intensity: Quantity,
    /// The elevation above the horizon, degrees.
    pub elevation_deg: Quantity,
    /// The azimuth, degrees from the x axis counter-clockwise seen from above.
    pub azimuth_deg: Quantity,
    /// The colour temperature, kelvin.
    pub temperature_k: Quantity,
}

impl Default for Sun {
    fn default() -> Self {
        Self {
            intensity: Quantity::Uniform([1000.0, 4000.0]),
            elevation_deg: Quantity::Uniform([20.0, 80.0]),
            azimuth_deg: Quantity::Uniform([0.0, 360.0]),
            temperature_k: Quantity::Uniform([4500.0, 6500.0]),
        }
    }
}

/// The sky.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Sky {
    /// The radiance, or the factor on the image's radiance.
    pub intensity: Quantity,
    /// Latitude-longitude images and folders of images; without one the sky is uniform.
    pub images: Texts,
    /// The rotation of the image about the vertical axis, degrees.
    pub azimuth_deg: Quantity,
}

impl Default for Sky {
    fn default() -> Self {
        Self {
            intensity: Quantity::Uniform([300.0, 1200.0]),
            images: Texts::default(),
            azimuth_deg: Quantity::Uniform([0.0, 360.0]),
        }
    }
}

/// Square lamps that shine downwards.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Lamps {
    /// The number of lamps, rounded to a whole number.
    pub count: Quantity,
    /// The radiance of their surface.
    pub intensity: Quantity,
    /// The length of their edges, metres.
    pub size_m: Quantity,
    /// The height above the objects, or above the centre of the base scene, metres.
    pub height_m: Quantity,
    /// The horizontal distance from the same point, metres.
    pub distance_m: Quantity,
    /// The colour temperature, kelvin.
    pub temperature_k: Quantity,
    /// The region of the lamps' centres, instead of the height and the distance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub region: Option<Region>,
}

impl Default for Lamps {
    fn default() -> Self {
        Self {
            count: Quantity::Uniform([1.0, 3.0]),
            intensity: Quantity::Uniform([5000.0, 20000.0]),
            size_m: Quantity::Uniform([0.2, 1.0]),
            height_m: Quantity::Uniform([1.0, 2.5]),
            distance_m: Quantity::Uniform([0.0, 1.5]),
            temperature_k: Quantity::Uniform([2700.0, 6500.0]),
            region: None,
        }
    }
}
