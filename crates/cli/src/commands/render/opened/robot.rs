//! A scene with a robot.

use oaktwin::diagnostic::Level;
use oaktwin::render::{OpenOptions, SceneFile};

use super::Opened;
use crate::args::RenderArgs;
use crate::context::Result;
use crate::output;

impl Opened {
    /// Opens a scene, and puts the robot into it.
    pub(super) fn with_robot(args: &RenderArgs, options: &OpenOptions) -> Result<Self> {
        let follows = args.trajectory.is_some();
        let others = [
            ("--frames", args.frames.is_some()),
            ("--imu", args.imu.imu.is_some() && !follows),
        ];
        if let Some((option, _)) = others.into_iter().find(|(_, is_given)| *is_given) {
            return Err(
                format!("{option}: the frames are the postures of the robot; remove it, or --robot").into(),
            );
        }
        let mut scene = SceneFile::open(&args.scene, options)?;
        let robot = args.robot.open(&mut scene.scene, args.mount.as_deref())?;
        let postures = robot.as_ref().map_or(0, |robot| robot.positions.positions.len());
        if follows && (postures > 1 || args.mount.is_some()) {
            let what = match args.mount {
                Some(_) => "the OAK follows it or the link of --mount; remove one of them".to_owned(),
                None => format!(
                    "the robot stands still along it, and --joints has {postures} postures; give a table with one"
                ),
            };
            return Err(format!("--trajectory: {what}").into());
        }
        if let (Some(file), Some(robot)) = (args.robot.robot(), &robot) {
            output::say_findings(file, &robot.findings);
            let warning = robot
                .findings
                .iter()
                .find(|finding| finding.level >= Level::Warning);
            if let Some(warning) = warning.filter(|_| args.strict) {
                return Err(format!("{}: {warning}", file.display()).into());
            }
        }
        Ok(Self {
            scene,
            finding: None,
            animated: None,
            times: None,
            robot,
        })
    }
}
