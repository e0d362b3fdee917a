//! The messages between the page and the server. `web/src/protocol.ts` documents them.

use std::collections::BTreeMap;

use oaktwin::diagnostic::Finding;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize};
use serde_json::value::RawValue;

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

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct FrameRequest {
    #[serde(rename = "type")]
    pub(crate) _kind: RequestKind,
    pub(crate) id: u64,
    pub(crate) oak: String,
    pub(crate) scene: String,
    pub(crate) state: OakState,
    pub(crate) size: Option<[u32; 2]>,
    pub(crate) images: Vec<ImageName>,
    pub(crate) region: [f64; 4],
    /// The side of the squares of pixels that share a colour.
    #[serde(default)]
    pub(crate) color_step: Option<u32>,
    /// Whether images for rest follow.
    #[serde(default)]
    pub(crate) is_preview: bool,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct ProbeRequest {
    #[serde(rename = "type")]
    pub(crate) _kind: RequestKind,
    pub(crate) id: u64,
    pub(crate) oak: String,
    pub(crate) x: f64,
    pub(crate) y: f64,
}

/// Everything that determines the outputs of one OAK.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct OakState {
    pub(crate) model: String,
    pub(crate) calibration: Option<String>,
    pub(crate) pose: Pose,
    pub(crate) sensor: String,
    pub(crate) lens: String,
    pub(crate) engine: String,
    pub(crate) preset: Option<String>,
    pub(crate) filters: Option<Vec<String>>,
    pub(crate) parameters: BTreeMap<String, String>,
    pub(crate) extended_disparity: bool,
    pub(crate) seed: u64,
    pub(crate) device_seed: Option<u64>,
    #[serde(default)]
    pub(crate) population_seed: Option<u64>,
    #[serde(default)]
    pub(crate) drift: BTreeMap<String, String>,
    pub(crate) projector: f64,
    pub(crate) ambient: f64,
    /// The number of the frame of a trajectory or an animation, by which its noise differs from other frames'.
    #[serde(default)]
    pub(crate) frame: u64,
}

/// A pose of the body in the world: metres, and a quaternion x, y, z, w.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Pose {
    #[serde(deserialize_with = "exact")]
    pub(crate) position: [f64; 3],
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
#[serde(rename_all = "lowercase")]
pub(crate) enum ImageName {
    Color,
    Depth,
    Reference,
    Sensor,
    Confidence,
    Left,
    Right,
    Reason,
}

impl ImageName {
    /// Whether it is an image of the stereo pair.
    pub(crate) fn is_of_pair(self) -> bool {
        matches!(self, Self::Left | Self::Right)
    }
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct FrameHeader {
    pub(crate) id: u64,
    pub(crate) oak: String,
    pub(crate) images: Vec<ImageHeader>,
    pub(crate) parameters: BTreeMap<&'static str, String>,
    pub(crate) filters: Vec<String>,
    pub(crate) findings: Vec<Finding>,
    pub(crate) statistics: Statistics,
    pub(crate) milliseconds: f64,
    pub(crate) hfov_deg: f64,
    pub(crate) vfov_deg: f64,
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct ImageHeader {
    pub(crate) name: ImageName,
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) format: &'static str,
    pub(crate) offset: usize,
    pub(crate) length: usize,
    pub(crate) unchanged: bool,
}

#[derive(Clone, Debug, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Statistics {
    pub(crate) pixels: u64,
    pub(crate) fill_rate: f64,
    pub(crate) median_error_m: Option<f64>,
    pub(crate) median_absolute_error_m: Option<f64>,
    pub(crate) median_absolute_error_percent: Option<f64>,
    pub(crate) p95_absolute_error_m: Option<f64>,
    pub(crate) reasons: Vec<u64>,
    pub(crate) histogram: Histogram,
}

#[derive(Clone, Debug, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Histogram {
    pub(crate) from_m: f64,
    pub(crate) to_m: f64,
    pub(crate) counts: Vec<u64>,
}

#[derive(Clone, Debug, Serialize)]
#[serde(tag = "type", rename = "probe", rename_all = "camelCase")]
pub(crate) struct ProbeAnswer {
    pub(crate) id: u64,
    pub(crate) oak: String,
    pub(crate) pixel: [u32; 2],
    pub(crate) true_m: Option<f64>,
    pub(crate) disparity_px: Option<f64>,
    pub(crate) measured_m: Option<f64>,
    pub(crate) error_m: Option<f64>,
    pub(crate) step_m: Option<f64>,
    pub(crate) reason: u8,
    pub(crate) object: Option<String>,
    pub(crate) occluder: Option<String>,
    pub(crate) point: Option<[f64; 3]>,
}

/// A request that cannot be answered.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "type", rename = "error")]
pub(crate) struct Rejection {
    pub(crate) id: u64,
    pub(crate) oak: String,
    #[serde(flatten)]
    pub(crate) failure: Failure,
}

/// An error as the page shows it.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct Failure {
    pub(crate) error: String,
    /// The parameter at fault, if one is.
    pub(crate) field: Option<String>,
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

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct SceneInfo {
    pub(crate) id: String,
    pub(crate) name: String,
    pub(crate) up: &'static str,
    /// Metres per unit of a mesh file that states no unit; none for others.
    pub(crate) scale: Option<f64>,
    pub(crate) triangles: usize,
    pub(crate) bounds: [[f64; 3]; 2],
    pub(crate) objects: Vec<SceneObject>,
    pub(crate) findings: Vec<Finding>,
    pub(crate) pose: Pose,
    pub(crate) animation: Option<AnimationInfo>,
    pub(crate) robot: Option<RobotInfo>,
}

/// The times of an animated scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct AnimationInfo {
    pub(crate) first: f64,
    pub(crate) last: f64,
    pub(crate) codes_per_second: f64,
    /// The time codes from frame to frame.
    pub(crate) step: f64,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct RobotInfo {
    pub(crate) name: String,
    pub(crate) joints: Vec<RobotJoint>,
    pub(crate) links: Vec<RobotLink>,
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct RobotJoint {
    pub(crate) name: String,
    pub(crate) is_revolute: bool,
    pub(crate) limits: Option<[f64; 2]>,
    pub(crate) position: f64,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct RobotLink {
    pub(crate) name: String,
    pub(crate) path: String,
    pub(crate) pose: Pose,
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct SceneObject {
    pub(crate) path: String,
    pub(crate) bounds: [[f64; 3]; 2],
}

#[derive(Clone, Debug, Serialize)]
pub(crate) struct CalibrationInfo {
    pub(crate) id: String,
    pub(crate) name: String,
    pub(crate) model: Option<String>,
    pub(crate) findings: Vec<Finding>,
}

/// A trajectory that was dropped onto the page.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct TrajectoryInfo {
    pub(crate) id: String,
    pub(crate) name: String,
    pub(crate) poses: Vec<Pose>,
    /// The time of each pose, s, from 0.
    pub(crate) times_s: Vec<f64>,
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct MeshHeader {
    pub(crate) vertices: usize,
    pub(crate) triangles: usize,
    pub(crate) of_triangles: usize,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct ExportRequest {
    pub(crate) what: Export,
    pub(crate) scene: String,
    pub(crate) state: OakState,
    pub(crate) size: Option<[u32; 2]>,
    pub(crate) image: Option<ImageName>,
    pub(crate) format: Option<String>,
    /// The rectangle of statistics; the whole image by default.
    pub(crate) region: Option<[f64; 4]>,
    /// The other OAKs of statistics.
    pub(crate) others: Option<Vec<SizedState>>,
    /// The trajectory to which the state's frame belongs, for commands.
    pub(crate) trajectory: Option<String>,
    /// The first time code of an animated scene's frames, and the time codes from frame to frame, for commands.
    pub(crate) codes: Option<[f64; 2]>,
}

/// An OAK with the size of its images.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SizedState {
    pub(crate) state: OakState,
    pub(crate) size: Option<[u32; 2]>,
}

/// What can be taken away.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
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

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct AccuracyCurve {
    pub(crate) distances_m: Vec<f64>,
    pub(crate) error_percent: Vec<Option<f64>>,
    pub(crate) fill_rate: Vec<f64>,
    pub(crate) bands: Vec<Band>,
}

#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Band {
    pub(crate) from_m: f64,
    pub(crate) to_m: f64,
    pub(crate) percent: f64,
}
