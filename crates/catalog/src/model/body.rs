//! The body of a device, with its projector.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::{Source, Sources};

/// The basic shape of a body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum BodyShape {
    /// A plain box: no source describes more than the outer dimensions.
    #[default]
    Plain,
    /// A long bar with fins between the connectors, as of the `OAK-D Pro PoE`.
    Bar,
    /// A bar in front of a comb of fins, as of the `OAK4-D`.
    Comb,
    /// A short box with fins, as of the `OAK-D ToF`.
    Compact,
}

/// The body of a device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// The basic shape; a plain box by default.
    #[serde(default)]
    pub shape: BodyShape,
    /// The width (along y), height (along z) and depth (along x) in mm.
    pub dimensions_mm: [f64; 3],
    /// The centre of the front face in the body frame (x forward, y left, z up) in mm.
    pub front_mm: [f64; 3],
    /// The mass in g.
    pub mass_g: f64,
    /// The position of the infrared dot projector in the body frame in mm, if the device has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub projector_mm: Option<[f64; 3]>,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// The infrared dot projector of a device, at [`Body::projector_mm`], facing along +x of the body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Projector {
    /// The name, such as `ams Belago 1.1`.
    pub model: String,
    /// The number of dots.
    pub dots: u32,
    /// The horizontal field of illumination in degrees, at the border of which the light has half of its intensity.
    pub hfoi_deg: f64,
    /// The vertical field of illumination in degrees.
    pub vfoi_deg: f64,
    /// The wavelength in nm.
    pub wavelength_nm: f64,
    /// The angular diameter of a dot at half of its peak brightness in mrad.
    pub dot_width_mrad: f64,
    /// The brightness of the centre of a dot on a surface that faces the projector at 1 m, at full power, relative to the same
    /// surface under office lighting.
    pub brightness: f64,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}
