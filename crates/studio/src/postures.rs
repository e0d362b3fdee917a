//! Lists of postures of a robot, which were dropped onto the page or collected on it.

use std::path::Path;

use oaktwin::robot::JointPositions;
use serde::Serialize;

use crate::kept::{Keep, Kept};
use crate::protocol::Failure;
use crate::robot::SceneRobot;
use crate::scene::{LoadedScene, in_any_state};
use crate::upload::bytes_id;

/// The maximum number of postures.
const MAX_POSTURES: usize = 1000;
/// The maximum size of a list, bytes.
pub(crate) const MAX_BYTES: usize = 4 << 20;

/// A list of postures of the robot in a scene.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub(crate) struct MotionInfo {
    pub(crate) id: String,
    pub(crate) name: String,
    /// The positions of `RobotInfo.joints` in each posture.
    pub(crate) postures: Vec<Vec<f64>>,
    /// The joints that have no column in the file, so that they do not move.
    pub(crate) at_rest: Vec<String>,
}

/// A list with the file that has it.
#[derive(Debug)]
pub(crate) struct Dropped {
    pub(crate) info: MotionInfo,
    pub(crate) bytes: Vec<u8>,
}

pub(crate) type Motions = Kept<Dropped>;

impl Keep for Dropped {
    type Info = MotionInfo;
    const NAME: &'static str = "list of postures";
    // Each posture that is added on the page makes another list, and undo returns to earlier ones.
    const COUNT: usize = 64;

    fn known(&self) -> (&str, &MotionInfo) {
        (&self.info.id, &self.info)
    }
}

impl Dropped {
    /// Reads a list for the robot of a scene, in any posture.
    pub(crate) fn read(scene: &LoadedScene, name: &str, bytes: Vec<u8>) -> Result<Self, Failure> {
        let robot = robot_of(scene)?;
        let read = positions(robot, name, &bytes)?;
        let free: Vec<usize> = robot.placed.robot().free_joints().collect();
        let of_free = |posture: &Vec<f64>| free.iter().map(|&joint| posture[joint]).collect();
        let info = MotionInfo {
            // Another robot may have joints of the same names in another order.
            id: bytes_id(&format!("{name}\0{}", in_any_state(&scene.info.id)), &bytes),
            name: name.to_owned(),
            postures: read.positions.iter().map(of_free).collect(),
            at_rest: read.at_rest,
        };
        Ok(Self { info, bytes })
    }
}

/// Returns the robot of a scene.
pub(crate) fn robot_of(scene: &LoadedScene) -> Result<&SceneRobot, Failure> {
    scene.robot.as_ref().ok_or_else(|| {
        let error = "the scene has no robot whose postures these could be; drop the robot's URDF or MJCF file first, then the list";
        Failure::of("motion", error)
    })
}

/// Reads a list as `--joints` does.
pub(crate) fn positions(robot: &SceneRobot, name: &str, bytes: &[u8]) -> Result<JointPositions, Failure> {
    let read = JointPositions::parse(Path::new(name), bytes, robot.placed.robot());
    let read = read.map_err(|error| Failure::of("motion", &error))?;
    match read.positions.len() <= MAX_POSTURES {
        true => Ok(read),
        false => Err(Failure::of(
            "motion",
            &format!(
                "{name}: has {} postures, more than the {MAX_POSTURES} that the page measures; drop a part of it, or use `oaktwin coverage --joints`",
                read.positions.len()
            ),
        )),
    }
}
