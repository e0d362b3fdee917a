//! What a sensor and a device file hold, key by key. Units are in the names, as in the files.

use std::collections::BTreeMap;
use std::fmt;

use oaktwin_camera::ImageSize;
use oaktwin_parameter::Choice;
use oaktwin_parameter::nvidia::Attributes;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{Source, Sources};

/// An image sensor: `data/sensors/*.toml`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sensor {
    /// The name that devices refer to, `OV9282`.
    pub id: String,
    /// Who makes it, `OmniVision`.
    pub manufacturer: String,
    /// What it is, in words: `CMOS, global shutter`.
    pub kind: String,
    /// Every pixel of the array, (width, height).
    pub native_resolution: (u32, u32),
    /// The mode that the assets use, (width, height).
    pub used_resolution: (u32, u32),
    /// How the mode comes from the array: `full`, `centre crop`, `2x2 binned`.
    pub used_mode: String,
    /// The pitch of the array's own pixels, µm.
    pub native_pixel_size_um: f64,
    /// The pitch of a pixel of the used mode, µm.
    pub pixel_size_um: f64,
    /// `1/4"`.
    pub optical_format: String,
    /// Megapixels as marketed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub megapixels: Option<f64>,
    /// Wavelength of its light source, nm: time-of-flight sensors only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wavelength_nm: Option<f64>,
    /// The range that it measures, (nearest, farthest), m: time-of-flight sensors only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_range_m: Option<(f64, f64)>,
    /// Its accuracy as the sheet words it: time-of-flight sensors only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub depth_accuracy: Option<String>,
    /// Other evidence about a value above.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub evidence: Vec<Evidence>,
    /// What else the sources say.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<Note>,
    /// Where the values above come from.
    pub source: Source,
    /// The keys that come from elsewhere.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// A depth camera: `data/devices/*.toml`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Device {
    /// The stem of its asset's file, `oak_d_pro_poe`.
    pub id: String,
    /// What people call it, `OAK-D Pro PoE`.
    pub name: String,
    /// The name with its variant, as the sheet's device table prints it: `OAK-D Pro PoE (Fixed Focus)`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub full_name: Option<String>,
    /// Other names that mean it, such as the `productName` of calibration files.
    #[serde(default)]
    pub aliases: Vec<String>,
    /// The prim below `/Root` in its asset, `oak_d_pro`.
    pub prim: String,
    /// `Luxonis`.
    pub manufacturer: String,
    /// `RVC2` or `RVC4`.
    pub generation: String,
    /// `Myriad X (Intel VPU)`.
    pub platform: String,
    /// What kind of processor that is: `VPU`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub processor: Option<String>,
    /// Lens and focus in a word or two: `fixed focus, wide field of view`.
    pub variant: String,
    /// What the numbers come from, for the comparison: `Theoretical (spec sheet)`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub data_source: Option<String>,
    /// The body.
    pub body: Body,
    /// The inertial unit.
    pub imu: Imu,
    /// The infrared dot projector, where the device has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub projector: Option<Projector>,
    /// Distance from the left to the right optical centre, mm.
    pub stereo_baseline_mm: f64,
    /// The cameras, in the order in which the sheet's columns list them.
    #[serde(rename = "camera")]
    pub cameras: Vec<Camera>,
    /// The depth sensors: one template render product each.
    #[serde(rename = "depth_sensor")]
    pub depth_sensors: Vec<DepthSensor>,
    /// Published accuracy: several tables where sources disagree. The first is what the comparison prints.
    #[serde(default)]
    pub accuracy: Vec<Accuracy>,
    /// The accuracy in one line, as printed in two places which do not always agree.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub accuracy_headline: Option<AccuracyHeadline>,
    /// Other evidence about a value above.
    #[serde(default)]
    pub evidence: Vec<Evidence>,
    /// What a reader of the numbers must know.
    #[serde(default)]
    pub notes: Vec<Note>,
    /// Where the values above come from.
    pub source: Source,
    /// The keys that come from elsewhere.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// Which camera of a device.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// The colour camera between the stereo pair.
    Rgb,
    /// The left camera of the stereo pair, as seen from behind the device.
    Left,
    /// The right camera of the stereo pair.
    Right,
    /// The time-of-flight camera.
    Tof,
}

impl Role {
    /// As files spell it: `rgb`.
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

/// One camera of a device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Which one.
    pub role: Role,
    /// The prim's name, `Camera_rgb_imx378`.
    pub prim: String,
    /// The sensor's id.
    pub sensor: String,
    /// What the comparison adds to the sensor's name: `wide optics`, `color`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
    /// The socket that calibration files know it by: 0 is `CAM_A`.
    pub socket: i32,
    /// Horizontal field of view of the ideal pinhole, degrees: fx follows from it.
    pub hfov_deg: f64,
    /// Horizontal field of view of the real, distorted lens, degrees: the span of the equidistant fisheye.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fisheye_hfov_deg: Option<f64>,
    /// The optical centre in the body frame (x forward, y left, z up; origin midway between left and right), mm.
    pub position_mm: [f64; 3],
    /// `focusDistance`, as the sheet prints it.
    pub focus_distance: f64,
    /// `fStop`: 0 switches depth of field off.
    pub f_stop: f64,
    /// `projection`.
    pub projection: String,
    /// `stereoRole`.
    pub stereo_role: String,
    /// `clippingRange`, m.
    pub clipping_range_m: (f64, f64),
    /// `cameraProjectionType` of the older distortion attributes.
    pub projection_type: String,
    /// `maxFOV` as the sheet prints it, degrees.
    pub max_fov_deg: f64,
    /// The sheet's column of distortion values, which do nothing on a pinhole.
    pub legacy_distortion: LegacyDistortion,
    /// Where the values above come from.
    pub source: Source,
    /// The keys that come from elsewhere.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// The distortion rows of the sheet's camera tables.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LegacyDistortion {
    /// `polyK0` to `polyK5`.
    pub poly_k: [f64; 6],
    /// `p0`, `p1`.
    pub p: [f64; 2],
    /// `s0` to `s3`.
    pub s: [f64; 4],
    /// `physicalDistortionModel`: "Not Applicable" in the sheet, never authored.
    pub physical_model: String,
    /// `physicalDistortionCoefficients`: likewise.
    pub physical_coefficients: String,
}

/// How a depth sensor measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum DepthKind {
    /// By the disparity of the stereo pair.
    Stereo,
    /// By time of flight, which the sheet writes as stereo with a very short baseline.
    Tof,
}

impl DepthKind {
    /// As files spell it: `stereo`.
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DepthSensor {
    /// How it measures.
    pub kind: DepthKind,
    /// The prim of its virtual camera, `Camera_pseudo_depth`.
    pub prim: String,
    /// The camera whose optics and place it has.
    pub camera: Role,
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
    /// `maxDisparityPixel` in the extended mode, where there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub extended_max_disparity_px: Option<f64>,
    /// `minDistance`, m.
    pub min_distance_m: f64,
    /// `minDistance` in the extended mode, m, where it differs.
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
    /// The range in which the vendor recommends it, (nearest, farthest), m.
    pub ideal_range_m: (f64, f64),
    /// Where the values above come from.
    pub source: Source,
    /// The keys that come from elsewhere.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

impl DepthSensor {
    /// The attributes of the render product in the standard or the extended mode. Attributes that the parameter sheet lacks
    /// have the schema's defaults.
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

/// The body of a device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Body {
    /// Width (along y), height (along z), depth (along x), mm.
    pub dimensions_mm: [f64; 3],
    /// The centre of the front face in the body frame (x forward, y left, z up), mm.
    pub front_mm: [f64; 3],
    /// Mass, g.
    pub mass_g: f64,
    /// The place of the infrared dot projector in the body frame, mm, where the device has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub projector_mm: Option<[f64; 3]>,
    /// Where the values above come from.
    pub source: Source,
    /// The keys that come from elsewhere.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// The infrared dot projector of a device; its place is [`Body::projector_mm`]. It looks along +x of the body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Projector {
    /// `ams Belago 1.1`.
    pub model: String,
    /// How many dots it projects.
    pub dots: u32,
    /// The horizontal field of illumination, at whose border the light is half as strong, degrees.
    pub hfoi_deg: f64,
    /// The vertical field of illumination, degrees.
    pub vfoi_deg: f64,
    /// Of its light, nm.
    pub wavelength_nm: f64,
    /// The angle across a dot where it is half as bright as in its middle, mrad.
    pub dot_width_mrad: f64,
    /// How bright the middle of a dot is on a surface that faces it 1 m away, at full power, in what the same surface
    /// sends in the light of an office.
    pub brightness: f64,
    /// Where the values above come from.
    pub source: Source,
    /// The keys that come from elsewhere.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// The inertial unit of a device.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Imu {
    /// `BNO086 (9-axis)`, or `Yes` where the sheet says no more.
    pub model: String,
    /// The longer text of the sheet's device table, where it differs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub detail: Option<String>,
    /// Its place in the body frame, mm.
    pub position_mm: [f64; 3],
    /// Its axes in the body frame: the rows of `body_from_imu`'s rotation.
    pub rotation: [[f64; 3]; 3],
    /// Where the values above come from.
    pub source: Source,
    /// The keys that come from elsewhere.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub sources: Sources,
}

/// A published table of accuracy.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Accuracy {
    /// The depth sensor that it is about.
    pub sensor: DepthKind,
    /// What the percentage is of: `error of the region's median`.
    pub measure: String,
    /// The bands, near to far.
    pub bands: Vec<AccuracyBand>,
    /// Where they come from.
    pub source: Source,
}

/// The accuracy in one range of distance.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AccuracyBand {
    /// Nearest distance, m.
    pub from_m: f64,
    /// Farthest distance, m.
    pub to_m: f64,
    /// Depth error below this, percent of the distance. Absent: not available there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub error_percent: Option<f64>,
    /// A condition (`indoors`), or why there is no figure (`8 m max`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub condition: Option<String>,
}

/// A device's depth accuracy in one line.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AccuracyHeadline {
    /// As the sheet's device table prints it: `under 2% at 4m`.
    pub specification: String,
    /// As the sheet's feature comparison prints it: `< 2% at 3.5m`.
    pub comparison: String,
    /// Where they come from.
    pub source: Source,
}

/// A value that another source gives for a key.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Evidence {
    /// The key it is about, `camera.left.hfov_deg`.
    pub about: String,
    /// The value, with its unit.
    pub value: String,
    /// Which kind of source.
    pub source: Source,
    /// Which one, so that a reader finds it.
    pub from: String,
}

/// Something a reader of the numbers must know.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Note {
    /// A short stable name, `min-distance`.
    pub topic: String,
    /// One or two sentences.
    pub text: String,
}

impl Sensor {
    /// The size of the used mode.
    #[must_use]
    pub const fn used_size(&self) -> ImageSize {
        ImageSize::new(self.used_resolution.0, self.used_resolution.1)
    }
}

impl Device {
    /// The camera of a role, if the device has it.
    #[must_use]
    pub fn camera(&self, role: Role) -> Option<&Camera> {
        self.cameras.iter().find(|camera| camera.role == role)
    }

    /// Every name that means it: id, name, prim, aliases.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.named_places().map(|(name, _)| name)
    }

    /// Every name, and the key that gives it.
    pub(crate) fn named_places(&self) -> impl Iterator<Item = (&str, String)> {
        let own = [("id", &self.id), ("name", &self.name), ("prim", &self.prim)];
        let own = own.into_iter().map(|(key, name)| (name.as_str(), key.to_owned()));
        let aliases = self.aliases.iter().enumerate();
        own.chain(aliases.map(|(i, name)| (name.as_str(), format!("aliases.{i}"))))
    }
}
