//! The robot of a scene, and the scene in other postures of it.
//!
//! The id of such a scene is the scene's own with the positions of the joints: `first~0.5,1.2`. So everything that names a scene, such as a
//! request for images, a link or an export, names a posture, too.

use std::path::PathBuf;
use std::sync::Arc;

use oaktwin::camera::RigidTransform;
use oaktwin::diagnostic::Finding;
use oaktwin::robot::{JointKind, PlacedRobot, Robot};
use oaktwin::scene::Scene;

use crate::pose::pose_of;
use crate::protocol::{Failure, RobotInfo, RobotJoint, RobotLink};

/// What separates the id of a scene from the positions of joints.
const POSTURE: char = '~';

/// A robot's file, which is put into a scene.
#[derive(Clone, Debug)]
pub struct RobotFile {
    /// The file.
    pub path: PathBuf,
    /// The folders of the packages that it names.
    pub packages: Vec<PathBuf>,
    /// The pose of its base; by default upright at the origin.
    pub world_from_base: Option<RigidTransform>,
    /// The options that put it into a scene on a command line.
    pub arguments: Vec<String>,
}

/// A robot in a scene of the page.
#[derive(Clone, Debug)]
pub(crate) struct SceneRobot {
    pub(crate) placed: PlacedRobot,
    world_from_base: Option<RigidTransform>,
    pub(crate) arguments: Vec<String>,
    /// The position of each joint.
    pub(crate) positions: Vec<f64>,
    /// The file, if it was dropped onto the page.
    pub(crate) dropped: Option<Arc<DroppedFile>>,
}

/// A robot's file that was dropped onto the page.
#[derive(Debug)]
pub(crate) struct DroppedFile {
    pub(crate) name: String,
    pub(crate) bytes: Vec<u8>,
    /// The id of the scene that the robot was put into.
    pub(crate) base: String,
}

impl SceneRobot {
    /// Reads a robot and puts it into a scene.
    pub(crate) fn open(file: &RobotFile, scene: &mut Scene) -> Result<(Self, Vec<Finding>), Failure> {
        let failed = |error: oaktwin::robot::RobotFileError| Failure::of("robot", &error);
        let mut robot = Robot::open(&file.path, &file.packages).map_err(failed)?;
        let mut findings = std::mem::take(&mut robot.findings);
        let positions = robot.rest();
        let (placed, more) = PlacedRobot::new(robot, scene, file.world_from_base).map_err(failed)?;
        findings.extend(more);
        let robot = Self {
            placed,
            world_from_base: file.world_from_base,
            arguments: file.arguments.clone(),
            positions,
            dropped: None,
        };
        Ok((robot, findings))
    }

    /// Puts the robot into the same scene that was read again.
    pub(crate) fn again(&self, scene: &mut Scene) -> Result<Self, Failure> {
        let placed = PlacedRobot::new(self.placed.robot().clone(), scene, self.world_from_base);
        let (placed, _) = placed.map_err(|error| Failure::of("robot", &error))?;
        Ok(Self {
            placed,
            ..self.clone()
        })
    }

    /// What the page knows about the robot.
    pub(crate) fn info(&self) -> RobotInfo {
        let robot = self.placed.robot();
        let links = self.placed.world_from_links(&self.positions);
        RobotInfo {
            name: robot.name.clone(),
            joints: robot
                .free_joints()
                .map(|index| {
                    let joint = &robot.joints[index];
                    RobotJoint {
                        name: joint.name.clone(),
                        is_revolute: joint.kind == JointKind::Revolute,
                        limits: joint.limits,
                        position: self.positions[index],
                    }
                })
                .collect(),
            links: (robot.links.iter().zip(&links).enumerate())
                .map(|(index, (link, pose))| RobotLink {
                    name: link.name.clone(),
                    path: self.placed.link_path(index),
                    pose: pose_of(pose),
                })
                .collect(),
        }
    }

    /// Reads the positions of a posture.
    pub(crate) fn parse(&self, text: &str) -> Result<Vec<f64>, Failure> {
        let robot = self.placed.robot();
        let free: Vec<usize> = robot.free_joints().collect();
        let numbers: Option<Vec<f64>> = (text.split(','))
            .map(|word| word.parse().ok().filter(|number: &f64| number.is_finite()))
            .collect();
        let numbers = numbers
            .filter(|numbers| numbers.len() == free.len())
            .ok_or_else(|| {
                let error = format!(
                    "a posture of {} has {} numbers; open the page without its link",
                    robot.name,
                    free.len()
                );
                Failure::of("scene", &error)
            })?;
        let mut positions = self.positions.clone();
        for (&joint, &position) in free.iter().zip(&numbers) {
            robot
                .check(joint, position)
                .map_err(|(what, remedy)| Failure::of("scene", &format!("{what}; {remedy}")))?;
            positions[joint] = position;
        }
        Ok(robot.followed(positions))
    }
}

/// Returns the id of a scene in a posture.
pub(crate) fn posed(id: &str, posture: &str) -> String {
    format!("{id}{POSTURE}{posture}")
}

/// Separates the id of a scene in a posture from the posture.
pub(crate) fn split(id: &str) -> Option<(&str, &str)> {
    id.split_once(POSTURE)
}
