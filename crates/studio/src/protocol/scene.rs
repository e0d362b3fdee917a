//! What the page knows about scenes and other files.

use oaktwin::diagnostic::Finding;
use serde::Serialize;

use super::Pose;

#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct SceneInfo {
    pub(crate) id: String,
    /// The name of the file, or "demo room".
    pub(crate) name: String,
    #[cfg_attr(test, ts(type = "\"y\" | \"z\""))]
    pub(crate) up: &'static str,
    /// Metres per unit of a mesh file that states no unit; null for others.
    pub(crate) scale: Option<f64>,
    pub(crate) triangles: usize,
    /// The corners of the bounding box.
    #[cfg_attr(test, ts(type = "[Vec3, Vec3]"))]
    pub(crate) bounds: [[f64; 3]; 2],
    pub(crate) objects: Vec<SceneObject>,
    #[cfg_attr(test, ts(type = "Finding[]"))]
    pub(crate) findings: Vec<Finding>,
    /// A pose of the body that shows the scene.
    pub(crate) pose: Pose,
    /// Null if nothing in it moves.
    pub(crate) animation: Option<AnimationInfo>,
    /// The materials and labels whose reflectance in the infrared can be set: the id of the scene with one is `ID;NAME=REFLECTANCE`, with
    /// a percent-encoded name, and may have more of them.
    pub(crate) infrared: Vec<String>,
    /// The robot in the scene. The id of the scene in another posture is `ID~P1,P2,…`, with the position of each of the joints.
    pub(crate) robot: Option<RobotInfo>,
}

/// The time codes of an animated scene.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Animation"))]
#[serde(rename_all = "camelCase")]
pub(crate) struct AnimationInfo {
    pub(crate) first: f64,
    pub(crate) last: f64,
    pub(crate) codes_per_second: f64,
    /// The time codes from frame to frame.
    pub(crate) step: f64,
}

/// A robot, in the posture of its scene.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RobotInfo {
    pub(crate) name: String,
    /// The joints that can be moved.
    pub(crate) joints: Vec<RobotJoint>,
    pub(crate) links: Vec<RobotLink>,
}

#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct RobotJoint {
    pub(crate) name: String,
    /// Whether its positions are angles in radians; otherwise lengths in metres.
    pub(crate) is_revolute: bool,
    /// Null for a joint without limits.
    pub(crate) limits: Option<[f64; 2]>,
    pub(crate) position: f64,
}

#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct RobotLink {
    pub(crate) name: String,
    /// The path below which its objects are.
    pub(crate) path: String,
    /// The pose of its frame in the world.
    pub(crate) pose: Pose,
}

#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct SceneObject {
    /// The path of the prim.
    pub(crate) path: String,
    #[cfg_attr(test, ts(type = "[Vec3, Vec3]"))]
    pub(crate) bounds: [[f64; 3]; 2],
}

/// A calibration that was dropped onto the page.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct CalibrationInfo {
    pub(crate) id: String,
    pub(crate) name: String,
    /// The model that the device says it is; null if it does not match a known one.
    pub(crate) model: Option<String>,
    #[cfg_attr(test, ts(type = "Finding[]"))]
    pub(crate) findings: Vec<Finding>,
}

/// A trajectory that was dropped onto the page.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct TrajectoryInfo {
    pub(crate) id: String,
    pub(crate) name: String,
    pub(crate) poses: Vec<Pose>,
    /// The time of each pose, s, from 0.
    pub(crate) times_s: Vec<f64>,
}

/// A binary mesh: 4 bytes, the length N of the JSON in little endian; N bytes of JSON, which is this header; padding with zeros to a
/// multiple of 4; then float32 positions (3 per vertex), uint8 sRGB colours with alpha (4 per vertex), uint32 indices (3 per
/// triangle), and for each triangle the uint32 index of its object in `SceneInfo.objects`. All little endian.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct MeshHeader {
    pub(crate) vertices: usize,
    pub(crate) triangles: usize,
    /// The number of triangles of the full scene.
    pub(crate) of_triangles: usize,
}
