//! The messages between the page and the server. `web/src/protocol.ts` is made from them: see `typescript`.

mod scene;

use std::collections::BTreeMap;

use oaktwin::diagnostic::Finding;
use oaktwin::render::Transparent;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::value::RawValue;

pub(crate) use scene::{
    AnimationInfo, CalibrationInfo, MeshHeader, RobotInfo, RobotJoint, RobotLink, SceneInfo, SceneObject,
    TrajectoryInfo,
};

/// What a request on the WebSocket asks for.
#[derive(Clone, Copy, Debug, Deserialize)]
pub(crate) struct Kind {
    #[serde(rename = "type")]
    pub(crate) is: RequestKind,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum RequestKind {
    Frame,
    Probe,
}

/// Asks for the images of an OAK.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct FrameRequest {
    #[cfg_attr(test, ts(type = "\"frame\""))]
    #[serde(rename = "type")]
    pub(crate) _kind: RequestKind,
    /// Increasing; the answer repeats it. A newer request of the same `oak` replaces older ones, which are not answered.
    pub(crate) id: u64,
    /// A key that the page chooses for each OAK.
    pub(crate) oak: String,
    pub(crate) scene: String,
    pub(crate) state: OakState,
    /// The size of the images; null for the sensor's own.
    pub(crate) size: Option<[u32; 2]>,
    pub(crate) images: Vec<ImageName>,
    /// The rectangle for the statistics, as fractions of the image: left, top, right, bottom.
    pub(crate) region: [f64; 4],
    /// Every so many pixels of a row and of a column have a colour of their own, 1 to 8; those between are interpolated. 1 if missing.
    /// Colour takes most of the time of a new view.
    #[cfg_attr(test, ts(optional))]
    #[serde(default)]
    pub(crate) color_step: Option<u32>,
    /// Whether images for rest follow. A preview comes first, and interrupts images for rest that are being computed.
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    #[serde(default)]
    pub(crate) is_preview: bool,
}

/// Asks about a pixel of the last frame of an OAK.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct ProbeRequest {
    #[cfg_attr(test, ts(type = "\"probe\""))]
    #[serde(rename = "type")]
    pub(crate) _kind: RequestKind,
    pub(crate) id: u64,
    pub(crate) oak: String,
    /// Fractions of the sensor's image: 0 is the left or top edge.
    pub(crate) x: f64,
    pub(crate) y: f64,
}

/// Everything that determines the outputs of one OAK. It is what a link to the page stores.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct OakState {
    pub(crate) model: String,
    /// The id of a dropped calibration.
    pub(crate) calibration: Option<String>,
    pub(crate) pose: Pose,
    /// `DepthSensor.id`.
    pub(crate) sensor: String,
    /// The optics of the wide models' left and right cameras.
    #[cfg_attr(test, ts(type = "\"pinhole\" | \"fisheye\""))]
    pub(crate) lens: String,
    pub(crate) engine: String,
    pub(crate) preset: Option<String>,
    /// Filters as text, "NAME" or "NAME:KEY=VALUE,…", in order; they replace the preset's. Null: the preset's.
    pub(crate) filters: Option<Vec<String>>,
    /// Only those that were changed, as text.
    #[cfg_attr(test, ts(type = "Record<string, string>"))]
    pub(crate) parameters: BTreeMap<String, String>,
    pub(crate) extended_disparity: bool,
    pub(crate) seed: u64,
    /// The seed of an individual unit's calibration error; null for a unit without one.
    pub(crate) device_seed: Option<u64>,
    /// The seed of a unit of the model's population, whose cameras differ from the nominal ones; null for the nominal device.
    #[serde(default)]
    pub(crate) population_seed: Option<u64>,
    /// The drift of the stereo pair since its calibration: only what is not 0, as text, by the names in `Catalog.drift`.
    #[cfg_attr(test, ts(type = "Record<string, string>"))]
    #[serde(default)]
    pub(crate) drift: BTreeMap<String, String>,
    /// The brightness of the dot projector and of the scene's own light, for stereo engines. Night is an ambient of 0.
    pub(crate) projector: f64,
    pub(crate) ambient: f64,
    /// The ground truth of transparent surfaces: themselves, or what lies behind the clear ones.
    #[cfg_attr(test, ts(type = "\"surface\" | \"through\""))]
    #[serde(default = "surface")]
    pub(crate) transparent: String,
    /// The image sensor of colours: only its changed parameters, as text; null if colours are exact.
    #[cfg_attr(test, ts(type = "Record<string, string> | null"))]
    #[serde(default)]
    pub(crate) color_imager: Option<BTreeMap<String, String>>,
    /// The number of the frame of a trajectory or an animation: frames differ in their noise. 0 for a frame on its own.
    #[serde(default)]
    pub(crate) frame: u64,
}

fn surface() -> String {
    Transparent::default().name().to_owned()
}

/// A pose of the body in the world.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub(crate) struct Pose {
    #[cfg_attr(test, ts(type = "Vec3"))]
    #[serde(deserialize_with = "exact")]
    pub(crate) position: [f64; 3],
    /// x, y, z, w.
    #[serde(deserialize_with = "exact")]
    pub(crate) quaternion: [f64; 4],
}

/// Reads numbers to the last digit, which JSON's reader may round: a frame of a trajectory must be at the pose of its file.
fn exact<'de, D: Deserializer<'de>, const N: usize>(numbers: D) -> Result<[f64; N], D::Error> {
    let texts = Vec::<Box<RawValue>>::deserialize(numbers)?;
    let number = |text: &RawValue| {
        let number = text.get().parse();
        number.map_err(|_| D::Error::custom(format!("`{}` is not a number", text.get())))
    };
    let numbers = texts
        .iter()
        .map(|text| number(text))
        .collect::<Result<Vec<f64>, D::Error>>()?;
    numbers
        .try_into()
        .map_err(|numbers: Vec<f64>| D::Error::custom(format!("{} numbers instead of {N}", numbers.len())))
}

/// An image of an OAK.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub(crate) enum ImageName {
    /// rgba8.
    Color,
    /// u16mm: ground truth in the camera of the sensor.
    Depth,
    /// u16mm: ground truth at the pixels of `sensor`: only sent where it differs from `depth`; errors refer to it.
    Reference,
    /// u16mm: the measured depth.
    Sensor,
    /// u8; not made by every engine.
    Confidence,
    /// u8: the infrared image of the left camera, rectified.
    Left,
    /// u8: the infrared image of the right camera, rectified.
    Right,
    /// u8: codes of `Catalog.reasons`.
    Reason,
}

impl ImageName {
    /// Whether it is an image of the stereo pair.
    pub(crate) fn is_of_pair(self) -> bool {
        matches!(self, Self::Left | Self::Right)
    }
}

/// A binary message: 4 bytes, the length N of the JSON in little endian; N bytes of JSON, which is this header; then the images.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct FrameHeader {
    pub(crate) id: u64,
    pub(crate) oak: String,
    pub(crate) images: Vec<ImageHeader>,
    /// The effective parameters of the engine, as text.
    #[cfg_attr(test, ts(type = "Record<string, string>"))]
    pub(crate) parameters: BTreeMap<&'static str, String>,
    /// Those filters that ran, as text.
    pub(crate) filters: Vec<String>,
    #[cfg_attr(test, ts(type = "Finding[]"))]
    pub(crate) findings: Vec<Finding>,
    pub(crate) statistics: Statistics,
    /// What the frame took on the server, ms.
    pub(crate) milliseconds: f64,
    /// The horizontal field of view of the images.
    pub(crate) hfov_deg: f64,
    pub(crate) vfov_deg: f64,
}

#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct ImageHeader {
    pub(crate) name: ImageName,
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// `u16mm`: millimetres, 0 for none, 65535 for 65.535 m and beyond.
    #[cfg_attr(test, ts(type = "\"rgba8\" | \"u16mm\" | \"u8\""))]
    pub(crate) format: &'static str,
    /// The place in the payload after the header. The bytes are an LZ4 block of the little-endian pixels, row by row.
    pub(crate) offset: usize,
    pub(crate) length: usize,
    /// Whether the pixels are those of the last frame with this image that the server sent for this OAK. Such an image has a `length` of
    /// 0, because the page still has it.
    pub(crate) unchanged: bool,
}

#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct Statistics {
    /// The number of pixels in the region that show a surface.
    pub(crate) pixels: u64,
    /// The fraction of them with a value.
    pub(crate) fill_rate: f64,
    /// Of the measured ones; null if there are none. Errors are measured minus true.
    pub(crate) median_error_m: Option<f64>,
    pub(crate) median_absolute_error_m: Option<f64>,
    pub(crate) median_absolute_error_percent: Option<f64>,
    pub(crate) p95_absolute_error_m: Option<f64>,
    /// The number of pixels of each reason, by its code.
    pub(crate) reasons: Vec<u64>,
    pub(crate) histogram: Histogram,
}

/// Errors in bins of equal width between the ends.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct Histogram {
    pub(crate) from_m: f64,
    pub(crate) to_m: f64,
    pub(crate) counts: Vec<u64>,
}

/// A message as text; frames are binary.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(tag = "type", rename_all = "lowercase")]
pub(crate) enum ServerMessage {
    /// The answer to a [`ProbeRequest`].
    Probe(ProbeAnswer),
    /// A request that cannot be answered.
    Error(Rejection),
}

/// What a pixel shows.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct ProbeAnswer {
    pub(crate) id: u64,
    pub(crate) oak: String,
    /// The pixel of the sensor's image.
    pub(crate) pixel: [u32; 2],
    pub(crate) true_m: Option<f64>,
    /// In pixels of the matcher; null without a stereo pair.
    pub(crate) disparity_px: Option<f64>,
    pub(crate) measured_m: Option<f64>,
    pub(crate) error_m: Option<f64>,
    /// The distance to the next depth that the sensor can report; null without disparity.
    pub(crate) step_m: Option<f64>,
    /// The code in `Catalog.reasons`.
    pub(crate) reason: u8,
    /// The prim in the pixel.
    pub(crate) object: Option<String>,
    /// The prim that hides it from the other camera, for a reason of occlusion.
    pub(crate) occluder: Option<String>,
    /// The point on the surface, in the world.
    #[cfg_attr(test, ts(type = "Vec3 | null"))]
    pub(crate) point: Option<[f64; 3]>,
}

/// A request that cannot be answered.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Rejection {
    pub(crate) id: u64,
    pub(crate) oak: String,
    #[serde(flatten)]
    pub(crate) failure: Failure,
}

/// What is wrong with a request.
#[derive(Clone, Debug, Default, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Failure {
    /// `FILE: PLACE: what is wrong; what to do`.
    pub(crate) error: String,
    /// The parameter or field at fault, if one is.
    pub(crate) field: Option<String>,
    #[cfg_attr(test, ts(optional, type = "Finding[]"))]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) findings: Vec<Finding>,
}

impl Failure {
    /// Creates the failure of a field.
    pub(crate) fn of(field: &str, error: &(impl ToString + ?Sized)) -> Self {
        Self {
            field: Some(field.to_owned()),
            ..Self::from(error.to_string())
        }
    }
}

impl From<String> for Failure {
    fn from(error: String) -> Self {
        Self {
            error,
            ..Self::default()
        }
    }
}

/// Asks for a file.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct ExportRequest {
    pub(crate) what: Export,
    pub(crate) scene: String,
    pub(crate) state: OakState,
    pub(crate) size: Option<[u32; 2]>,
    /// For `image`.
    #[cfg_attr(test, ts(optional))]
    pub(crate) image: Option<ImageName>,
    /// `usda` or `usdz` for an asset; a name of `Catalog.robotFormats` for `robot`, a zip archive; `npy` or `png` for an image; `json` or
    /// `csv` for statistics.
    #[cfg_attr(test, ts(optional))]
    pub(crate) format: Option<String>,
    /// For `statistics`: the rectangle as fractions of the image.
    #[cfg_attr(test, ts(optional))]
    pub(crate) region: Option<[f64; 4]>,
    /// For `statistics`: the other OAKs.
    #[cfg_attr(test, ts(optional))]
    pub(crate) others: Option<Vec<SizedState>>,
    /// For commands: the trajectory to which the state's frame belongs.
    #[cfg_attr(test, ts(optional))]
    pub(crate) trajectory: Option<String>,
    /// For commands of an animated scene: the first time code of its frames, and the time codes from frame to frame.
    #[cfg_attr(test, ts(optional))]
    pub(crate) codes: Option<[f64; 2]>,
}

/// An OAK with the size of its images.
#[derive(Clone, Debug, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(deny_unknown_fields)]
pub(crate) struct SizedState {
    pub(crate) state: OakState,
    pub(crate) size: Option<[u32; 2]>,
}

/// What can be taken away.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub(crate) enum Export {
    Asset,
    Robot,
    Image,
    Error,
    Statistics,
    Parameters,
    Command,
    Python,
}

/// The accuracy by the vendor's method: the error of the median over distances.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct AccuracyCurve {
    pub(crate) distances_m: Vec<f64>,
    /// The median error of the median unit, percent; null where nothing was measured.
    pub(crate) error_percent: Vec<Option<f64>>,
    /// The fraction of the pixels with a value.
    pub(crate) fill_rate: Vec<f64>,
    pub(crate) bands: Vec<Band>,
}

/// An accuracy that the maker publishes: an error of at most `percent`.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct Band {
    pub(crate) from_m: f64,
    pub(crate) to_m: f64,
    pub(crate) percent: f64,
}
