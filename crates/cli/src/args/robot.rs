use std::path::{Path, PathBuf};

use clap::{Args, ValueHint};
use oaktwin::camera::RigidTransform;
use oaktwin::diagnostic::{Finding, Level};
use oaktwin::render;
use oaktwin::robot::{JointPositions, PlacedRobot, Robot};
use oaktwin::scene::Scene;

use crate::context::Result;

/// A robot in the scene, and its place.
#[derive(Args, Debug)]
pub(crate) struct RobotPlaceArgs {
    /// Put this robot into the scene: URDF, MJCF, or USD with physical joints
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) robot: Option<PathBuf>,

    /// The position of the robot's base, and its rotation as a quaternion [default: upright at 0 0 0]
    #[arg(
        long,
        num_args = 7,
        value_names = ["X", "Y", "Z", "QX", "QY", "QZ", "QW"],
        allow_hyphen_values = true,
        requires = "robot"
    )]
    robot_pose: Option<Vec<f64>>,

    /// A folder of packages that the robot names as package://; repeatable [default: around the file]
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath, requires = "robot")]
    packages: Vec<PathBuf>,
}

/// A robot in the scene, and its postures.
#[derive(Args, Debug)]
#[command(next_help_heading = "Robot")]
pub(crate) struct RobotArgs {
    #[command(flatten, next_help_heading = "Robot")]
    place: RobotPlaceArgs,

    /// The joint positions, a line for each posture: CSV with the joints' names in the first line
    ///
    /// Positions are in radians and metres. A column `NAME_deg` is in degrees, a column `time` in seconds. Joints without a column are at 0, or in the
    /// middle of their limits if these exclude 0.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, requires = "robot")]
    pub(crate) joints: Option<PathBuf>,
}

/// A robot that was put into a scene.
pub(crate) struct OpenedRobot {
    pub(crate) placed: PlacedRobot,
    /// The link that carries the OAK.
    pub(crate) link: Option<usize>,
    pub(crate) positions: JointPositions,
    pub(crate) findings: Vec<Finding>,
}

impl RobotPlaceArgs {
    fn pose(&self) -> Result<Option<RigidTransform>> {
        let Some(numbers) = &self.robot_pose else {
            return Ok(None);
        };
        let numbers: [f64; 7] = numbers[..]
            .try_into()
            .map_err(|_| "--robot-pose takes 7 numbers")?;
        let pose = render::pose(numbers).map_err(|error| format!("--robot-pose: {error}"))?;
        Ok(Some(pose))
    }

    /// The robot for Studio.
    #[cfg(feature = "studio")]
    pub(crate) fn file(&self) -> Result<Option<oaktwin_studio::RobotFile>> {
        let Some(path) = &self.robot else {
            return Ok(None);
        };
        let mut arguments = vec!["--robot".to_owned(), path.display().to_string()];
        if let Some(pose) = &self.robot_pose {
            arguments.push("--robot-pose".to_owned());
            arguments.extend(pose.iter().map(|number| format!("{number:?}")));
        }
        for folder in &self.packages {
            arguments.extend(["--packages".to_owned(), folder.display().to_string()]);
        }
        Ok(Some(oaktwin_studio::RobotFile {
            path: path.clone(),
            packages: self.packages.clone(),
            world_from_base: self.pose()?,
            arguments,
        }))
    }
}

impl RobotArgs {
    /// The robot's file, if there is one.
    pub(crate) fn robot(&self) -> Option<&Path> {
        self.place.robot.as_deref()
    }

    /// The files that are read.
    pub(crate) fn files(&self) -> impl Iterator<Item = &Path> {
        self.robot().into_iter().chain(self.joints.as_deref())
    }

    /// Puts the robot into a scene, if there is one. `mount` is the name of the link that carries an OAK.
    pub(crate) fn open(&self, scene: &mut Scene, mount: Option<&str>) -> Result<Option<OpenedRobot>> {
        let Some(file) = self.robot() else {
            return Ok(None);
        };
        let mut robot = Robot::open(file, &self.place.packages)?;
        let positions = match &self.joints {
            Some(joints) => JointPositions::read(joints, &robot)?,
            None => JointPositions::rest(&robot),
        };
        let mut findings = std::mem::take(&mut robot.findings);
        if !positions.at_rest.is_empty() {
            findings.push(Finding::new(
                "joints-at-rest",
                Level::Note,
                self.joints.as_deref().unwrap_or(file).display().to_string(),
                format!("no column for {}; they do not move", positions.at_rest.join(", ")),
                "",
            ));
        }
        let (placed, more) = PlacedRobot::new(robot, scene, self.place.pose()?)?;
        findings.extend(more);
        let link = mount.map(|name| placed.mount(name)).transpose()?;
        Ok(Some(OpenedRobot {
            placed,
            link,
            positions,
            findings,
        }))
    }
}
