//! The contents of sensor and device files, key by key, with units in the names as in the files.

mod body;
mod depth_sensor;
mod inertial;
mod names;
mod sensor;

pub use body::{Body, BodyShape, Projector};
pub use depth_sensor::{DepthKind, DepthSensor};
pub use inertial::{Accelerometer, Gyroscope, InertialPart, Magnetometer};
pub use sensor::{Sensor, ShutterKind};

use std::collections::BTreeMap;
use std::fmt;

use oaktwin_base::parameter::Choice;
use serde::{Deserialize, Serialize};

use crate::{Source, Sources};

/// A depth camera: `data/devices/*.toml`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Device {
    /// The stem of the asset's file name, such as `oak_d_pro_poe`.
    pub id: String,
    /// The common name, such as `OAK-D Pro PoE`.
    pub name: String,
    /// The name with its variant as in the sheet's device table, such as `OAK-D Pro PoE (Fixed Focus)`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub full_name: Option<String>,
    /// Alternative names, such as the `productName` of calibration files.
    #[serde(default)]
    pub aliases: Vec<String>,
    /// Other models for which it can be used, with the difference: `"D435" = "has no inertial sensor"`. Their use is reported.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub stands_in_for: BTreeMap<String, String>,
    /// The board names by which calibrations without a product name identify it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub boards: Vec<String>,
    /// The prim below `/Root` in the asset, such as `oak_d_pro`.
    pub prim: String,
    /// The manufacturer, such as `Luxonis`.
    pub manufacturer: String,
    /// The platform of Luxonis' devices, `RVC2` or `RVC4`; otherwise the family, such as `RealSense D400`.
    pub generation: String,
    /// The processor, such as `Myriad X (Intel VPU)`; absent if no source names it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub platform: Option<String>,
    /// The kind of processor, such as `VPU`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub processor: Option<String>,
    /// Lens and focus in a few words, such as `fixed focus, wide field of view`.
    pub variant: String,
    /// The origin of the numbers for the comparison, such as `Theoretical (spec sheet)`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub data_source: Option<String>,
    /// The body.
    pub body: Body,
    /// The inertial unit. It is absent if the device has none, or if no source states its pose; a note with the topic `imu` explains
    /// which of the two applies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub imu: Option<Imu>,
    /// The infrared dot projector, if the device has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub projector: Option<Projector>,
    /// The distance between the left and the right optical centre in mm, if the device has a stereo pair.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stereo_baseline_mm: Option<f64>,
    /// The cameras in the order of the sheet's columns.
    #[serde(rename = "camera")]
    pub cameras: Vec<Camera>,
    /// The depth sensors, each with one template render product.
    #[serde(rename = "depth_sensor", default)]
    pub depth_sensors: Vec<DepthSensor>,
    /// The published accuracy; several tables if sources disagree. The comparison prints the first.
    #[serde(default)]
    pub accuracy: Vec<Accuracy>,
    /// The accuracy in one line, as printed in two places that do not always agree.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accuracy_headline: Option<AccuracyHeadline>,
    /// Further evidence about the values above.
    #[serde(default)]
    pub evidence: Vec<Evidence>,
    /// Notes for readers of the numbers.
    #[serde(default)]
    pub notes: Vec<Note>,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// The role of a camera in a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// The colour camera, which may be part of a second stereo pair.
    Rgb,
    /// The left camera of the stereo pair, as seen from behind the device.
    Left,
    /// The right camera of the stereo pair.
    Right,
    /// The time-of-flight camera.
    Tof,
}

impl Role {
    /// Returns the name in files, such as `rgb`.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Rgb => "rgb",
            Self::Left => "left",
            Self::Right => "right",
            Self::Tof => "tof",
        }
    }
}

impl Choice for Role {
    const VARIANTS: &'static [Self] = &[Self::Rgb, Self::Left, Self::Right, Self::Tof];
    const NAMES: &'static [&'static str] = &[
        Self::Rgb.as_str(),
        Self::Left.as_str(),
        Self::Right.as_str(),
        Self::Tof.as_str(),
    ];
    const ABOUT: &'static [&'static str] = &[
        "The colour camera.",
        "The left camera of the stereo pair.",
        "The right camera of the stereo pair.",
        "The time-of-flight camera.",
    ];
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// A camera of a device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// The role.
    pub role: Role,
    /// The name of the prim, such as `Camera_rgb_imx378`.
    pub prim: String,
    /// The id of the image sensor.
    pub sensor: String,
    /// A remark that the comparison adds to the sensor's name: `wide optics`, `color`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
    /// The socket in `DepthAI` calibration files; 0 is `CAM_A`. By default, as for other makers' cameras, see
    /// [`Camera::socket`].
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub socket: Option<i32>,
    /// The horizontal field of view of the ideal pinhole in degrees, which determines fx.
    pub hfov_deg: f64,
    /// The horizontal field of view of the real, distorted lens in degrees: the span of the equidistant fisheye.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fisheye_hfov_deg: Option<f64>,
    /// The optical centre in the body frame (x forward, y left, z up), mm. The origin is midway between left and right; without
    /// a stereo pair, it is the optical centre of the time-of-flight camera, or of the only camera.
    pub position_mm: [f64; 3],
    /// The angle by which the camera looks down from the x axis of the body in degrees; 0 by default.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub pitch_deg: f64,
    /// `focusDistance` as in the sheet.
    pub focus_distance: f64,
    /// `fStop`; 0 disables depth of field.
    pub f_stop: f64,
    /// `projection`; `perspective` by default.
    #[serde(default = "perspective")]
    pub projection: String,
    /// `stereoRole`; `mono` by default.
    #[serde(default = "mono")]
    pub stereo_role: String,
    /// `clippingRange`, m; 0.01 to 100 by default.
    #[serde(default = "clipping_range")]
    pub clipping_range_m: (f64, f64),
    /// `cameraProjectionType` of the older distortion attributes; `pinhole` by default.
    #[serde(default = "pinhole")]
    pub projection_type: String,
    /// `maxFOV` in degrees, as in the sheet.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_fov_deg: Option<f64>,
    /// The sheet's column of distortion values, which have no effect on a pinhole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub legacy_distortion: Option<LegacyDistortion>,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

fn perspective() -> String {
    "perspective".to_owned()
}

fn mono() -> String {
    "mono".to_owned()
}

fn pinhole() -> String {
    "pinhole".to_owned()
}

const fn clipping_range() -> (f64, f64) {
    (0.01, 100.0)
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde passes a reference")]
fn is_zero(value: &f64) -> bool {
    *value == 0.0
}

/// The distortion rows of the sheet's camera tables.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct LegacyDistortion {
    /// `polyK0` to `polyK5`.
    pub poly_k: [f64; 6],
    /// `p0`, `p1`.
    pub p: [f64; 2],
    /// `s0` to `s3`.
    pub s: [f64; 4],
    /// `physicalDistortionModel`: "Not Applicable" in the sheet and never authored.
    pub physical_model: String,
    /// `physicalDistortionCoefficients`: "Not Applicable" in the sheet and never authored.
    pub physical_coefficients: String,
}

/// The inertial unit of a device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Imu {
    /// The name, such as `BNO086 (9-axis)`, or `Yes` if the sheet states no more.
    pub model: String,
    /// The longer text of the sheet's device table, if it differs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub detail: Option<String>,
    /// The ids of its parts, such as `BNO086`, of which the first with an accelerometer and a gyroscope is simulated; empty if
    /// no source names them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<String>,
    /// The position in the body frame in mm.
    pub position_mm: [f64; 3],
    /// The axes in the body frame: the rows of `body_from_imu`'s rotation.
    pub rotation: [[f64; 3]; 3],
    /// The axes according to the vendor's board file, if they differ.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub board_file_rotation: Option<[[f64; 3]; 3]>,
    /// The source of the values above.
    pub source: Source,
    /// The sources of keys that differ from `source`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// A published table of accuracy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Accuracy {
    /// The depth sensor to which the table applies.
    pub sensor: DepthKind,
    /// The prim of the depth sensor, if the table does not apply to all of that kind.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_sensor: Option<String>,
    /// The quantity of the percentage, such as `error of the region's median`.
    pub measure: String,
    /// The bands in order of distance.
    pub bands: Vec<AccuracyBand>,
    /// The source of the bands.
    pub source: Source,
}

/// The accuracy in a range of distances.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct AccuracyBand {
    /// The minimum distance in m.
    pub from_m: f64,
    /// The maximum distance in m.
    pub to_m: f64,
    /// The maximum depth error in percent of the distance; absent if it is not available.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error_percent: Option<f64>,
    /// The part of the maximum depth error that is the same at every distance, in mm; it adds to `error_percent`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error_mm: Option<f64>,
    /// A condition (`indoors`), or the reason for the absence of a figure (`8 m max`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub condition: Option<String>,
}

impl AccuracyBand {
    /// Returns the maximum error as text, `2%` or `11 mm + 0.1%`, with this unit for percent; `None` if it is not available.
    #[must_use]
    pub fn limit(&self, percent: &str) -> Option<String> {
        let parts = [
            self.error_mm.map(|error| format!("{error} mm")),
            self.error_percent.map(|error| format!("{error}{percent}")),
        ];
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        (!parts.is_empty()).then(|| parts.join(" + "))
    }
}

/// The depth accuracy of a device in one line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct AccuracyHeadline {
    /// The text of the sheet's device table, such as `under 2% at 4m`.
    pub specification: String,
    /// The text of the sheet's feature comparison, such as `< 2% at 3.5m`.
    pub comparison: String,
    /// The source of both texts.
    pub source: Source,
}

/// The value of a key according to another source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Evidence {
    /// The key, such as `camera.left.hfov_deg`.
    pub about: String,
    /// The value with its unit.
    pub value: String,
    /// The kind of source.
    pub source: Source,
    /// The source, identified so that a reader can find it.
    pub from: String,
}

/// A note for readers of the numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Note {
    /// A short stable name, such as `min-distance`.
    pub topic: String,
    /// One or two sentences.
    pub text: String,
}

impl Camera {
    /// Returns the socket in `DepthAI` calibration files: by default 0 for `rgb`, 1 for `left`, 2 for `right`, 3 for `tof`.
    #[must_use]
    pub fn socket(&self) -> i32 {
        self.socket.unwrap_or(match self.role {
            Role::Rgb => 0,
            Role::Left => 1,
            Role::Right => 2,
            Role::Tof => 3,
        })
    }
}

impl Device {
    /// Returns the camera of a role, if the device has it.
    #[must_use]
    pub fn camera(&self, role: Role) -> Option<&Camera> {
        self.cameras.iter().find(|camera| camera.role == role)
    }
}
