//! The scene of the command, still or animated.

use oaktwin::camera::RigidTransform;
use oaktwin::diagnostic::{Finding, Level};
use oaktwin::render::trajectory::{self, TimedPose};
use oaktwin::render::{
    AnimatedScene, Animation, Carried, OpenOptions, Outputs, Renderer, Rig, RigSpec, SceneFile, TimeCodes,
    Written, write_animation, write_carried, write_frames,
};

use crate::args::{OpenedRobot, RenderArgs};
use crate::context::Result;
use crate::{output, progress};

/// A scene that was read at its first time.
pub(super) struct Opened {
    pub(super) scene: SceneFile,
    /// A finding about the time codes.
    pub(super) finding: Option<Finding>,
    /// The stage, if it has a mount or is animated.
    animated: Option<AnimatedScene>,
    times: Option<TimeCodes>,
    /// The robot in the scene.
    robot: Option<OpenedRobot>,
}

impl Opened {
    pub(super) fn new(args: &RenderArgs) -> Result<Self> {
        let options = args.scene_options.open_options()?;
        if args.robot.robot().is_some() {
            return Self::with_robot(args, &options);
        }
        if args.frames.is_none() && args.mount.is_none() {
            return Ok(Self {
                scene: SceneFile::open(&args.scene, &options)?,
                finding: None,
                animated: None,
                times: None,
                robot: None,
            });
        }
        if args.imu.imu.is_some() {
            return Err("--imu requires a trajectory in the world; remove --frames and --mount".into());
        }
        if args.model.is_none() && args.trajectory.is_some() {
            return Err("--trajectory moves the cameras of a model beside --frames; add --model, or remove one of them".into());
        }
        if let Some(rate) = args.fps.filter(|rate| !(rate.is_finite() && *rate > 0.0)) {
            return Err(format!("--fps: must be a number above 0 (got {rate})").into());
        }
        let times = args.frames.as_deref().map(TimeCodes::parse);
        let times = times.transpose().map_err(|error| format!("--frames: {error}"))?;
        let codes = times.as_ref().map(|times| &times.codes);
        let codes = codes.map_or_else(|| Vec::from_iter(options.time), Clone::clone);
        let options = OpenOptions {
            time: codes.first().copied(),
            ..options
        };
        let (animated, scene) = SceneFile::open_animated(&args.scene, &options, args.mount.as_deref())?;
        Ok(Self {
            scene,
            finding: (!codes.is_empty())
                .then(|| animated.timing().check(&codes))
                .flatten(),
            animated: Some(animated),
            times,
            robot: None,
        })
    }

    /// Opens a scene, and puts the robot into it.
    fn with_robot(args: &RenderArgs, options: &OpenOptions) -> Result<Self> {
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

    /// Returns the pose in the world of an OAK without animation. An animated one follows its prim.
    pub(super) fn place(&self, pose: RigidTransform) -> RigidTransform {
        self.mount()
            .map_or(pose, |world_from_mount| *world_from_mount * pose)
    }

    /// Returns a path in the world, as [`Opened::place`] does.
    pub(super) fn in_world(&self, path: Vec<TimedPose>) -> Vec<TimedPose> {
        let moved = path.into_iter().map(|pose| TimedPose {
            world_from_mount: self.place(pose.world_from_mount),
            ..pose
        });
        moved.collect()
    }

    fn mount(&self) -> Option<&RigidTransform> {
        let animated = self.animated.as_ref().filter(|_| self.times.is_none());
        animated.and_then(AnimatedScene::world_from_mount)
    }

    /// Returns the time of each frame, s.
    pub(super) fn times_s(&self, args: &RenderArgs, path: &[TimedPose]) -> Vec<Option<f64>> {
        if let Some(robot) = self.robot.as_ref().filter(|_| args.trajectory.is_none()) {
            return robot.positions.times_s.clone();
        }
        match (&self.animated, &self.times) {
            (Some(scene), Some(times)) => times.times_s(scene.timing(), args.fps),
            _ => trajectory::times_s(path),
        }
    }

    /// Writes the frames of a rig.
    pub(super) fn write(
        self,
        args: &RenderArgs,
        (rig, spec): (&Rig, &RigSpec),
        path: &[TimedPose],
        outputs: Outputs<'_>,
    ) -> Result<Written> {
        if let Some(robot) = &self.robot {
            let mut renderer = Renderer::new(self.scene.scene);
            if args.trajectory.is_some() {
                let links = robot.placed.world_from_links(&robot.positions.positions[0]);
                renderer.set_poses(robot.placed.poses(&links));
                let written = progress::watched(|watch| {
                    write_frames(&renderer, rig, path, args.strict, outputs, watch)
                })?;
                return Ok(written);
            }
            let own_pose = rig.cameras().first().map(|camera| camera.world_from_mount);
            let mount = robot.link.zip(own_pose);
            let mut carried = Carried::new(renderer, &robot.placed, &robot.positions, mount);
            let written =
                progress::watched(|watch| write_carried(&mut carried, rig, args.strict, outputs, watch))?;
            return Ok(written);
        }
        let (Some(mut scene), Some(times)) = (self.animated, self.times) else {
            let renderer = Renderer::new(self.scene.scene);
            let written =
                progress::watched(|watch| write_frames(&renderer, rig, path, args.strict, outputs, watch))?;
            return Ok(written);
        };
        let times_s = times.times_s(scene.timing(), args.fps);
        let times = (&times, times_s.as_slice());
        let mut animation = match args.model {
            Some(_) => Animation::of_oak(&mut scene, self.scene, times, rig, path)
                .map_err(|error| format!("--trajectory: {error}"))?,
            None => Animation::of_stage(&mut scene, self.scene, times, spec),
        };
        let written =
            progress::watched(|watch| write_animation(&mut animation, rig, args.strict, outputs, watch))?;
        Ok(written)
    }
}
