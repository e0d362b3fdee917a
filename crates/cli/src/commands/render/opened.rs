//! The scene of the command, still or animated.

mod robot;
mod write;

use oaktwin::camera::RigidTransform;
use oaktwin::diagnostic::Finding;
use oaktwin::render::trajectory::{self, TimedPose};
use oaktwin::render::{AnimatedScene, OpenOptions, SceneFile, TimeCodes};

use crate::args::{OpenedRobot, RenderArgs};
use crate::context::Result;

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
}
