//! The motion of the camera while it takes a frame.

use oaktwin_camera::RigidTransform;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_imu::Motion;
use oaktwin_pipeline::imu;
use oaktwin_pipeline::render::trajectory::TimedPose;
use oaktwin_pipeline::render::{Moments, Renderer, RigError, Shutter};
use serde::Serialize;

use crate::GenerateError;
use crate::context::Context;
use crate::random::rotation_around;
use crate::recipe::{MotionRule, Quantity};

/// How long a frame takes, and how the camera moves meanwhile unless it follows a trajectory.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct DrawnMotion {
    exposure_ms: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    readout_ms: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    velocity_m_s: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    angular_velocity_deg_s: Option<[f64; 3]>,
}

/// A camera that moves past an arrangement.
pub(crate) struct Moving<'a> {
    renderer: &'a Renderer,
    /// The pose of its body at the time of the frame.
    world_from_body: RigidTransform,
    way: MotionSource<'a>,
}

enum MotionSource<'a> {
    /// A trajectory, and the time of the frame since its first pose, s.
    Along(&'a Motion, f64),
    /// A velocity in the world, m/s, and an angular velocity about the axes of the body, rad/s.
    Twist(DVec3, DVec3),
}

impl DrawnMotion {
    pub(crate) fn shutter(&self) -> Shutter {
        Shutter {
            exposure_ms: self.exposure_ms,
            readout_ms: self.readout_ms,
        }
    }
}

impl Moments for Moving<'_> {
    fn at(&mut self, offset_s: f64, _: usize) -> Result<(&Renderer, RigidTransform), RigError> {
        let now = &self.world_from_body;
        let pose = match &self.way {
            // Ground truth has exactly the pose of the frame.
            _ if offset_s == 0.0 => *now,
            MotionSource::Along(motion, since_first_s) => motion.at(since_first_s + offset_s).world_from_body,
            MotionSource::Twist(velocity, angular_velocity) => {
                let axis = angular_velocity.try_normalize();
                let turn = axis.map_or(DMat3::IDENTITY, |axis| {
                    rotation_around(axis, angular_velocity.length() * offset_s)
                });
                RigidTransform::new(now.rotation * turn, now.translation + *velocity * offset_s)
            }
        };
        Ok((self.renderer, pose))
    }
}

impl Context {
    /// Draws the motion of a frame, if its recipe has one.
    pub(crate) fn drawn_motion(&self, frame: u64) -> Option<DrawnMotion> {
        let rule = self.file.recipe.camera.motion.as_ref()?;
        let number = |key: &str, quantity: &Quantity| {
            let mut numbers = self.random.numbers(&format!("camera.motion.{key}"), frame);
            quantity.draw(&mut numbers)
        };
        let axes = |key: &str, axes: &Option<[Quantity; 3]>| {
            let names = ["x", "y", "z"].map(|axis| format!("{key}.{axis}"));
            (axes.as_ref()).map(|axes| [0, 1, 2].map(|axis| number(&names[axis], &axes[axis])))
        };
        Some(DrawnMotion {
            exposure_ms: number("exposure_ms", &rule.exposure_ms),
            readout_ms: (rule.readout_ms.as_ref()).map(|readout| number("readout_ms", readout)),
            velocity_m_s: axes("velocity_m_s", &rule.velocity_m_s),
            angular_velocity_deg_s: axes("angular_velocity_deg_s", &rule.angular_velocity_deg_s),
        })
    }

    /// Returns the camera in motion around a frame at a place of its arrangement.
    pub(crate) fn moving<'a>(
        &'a self,
        drawn: &DrawnMotion,
        renderer: &'a Renderer,
        world_from_body: RigidTransform,
        place: u64,
    ) -> Moving<'a> {
        let way = match &self.motion {
            Some(motion) => {
                let poses = (self.trajectory.len() as u64).max(1);
                MotionSource::Along(motion, self.since_first_s(place % poses))
            }
            None => {
                let [velocity, turn] = [drawn.velocity_m_s, drawn.angular_velocity_deg_s]
                    .map(|axes| DVec3::from(axes.unwrap_or_default()));
                MotionSource::Twist(world_from_body.rotation * velocity, turn.map(f64::to_radians))
            }
        };
        Moving {
            renderer,
            world_from_body,
            way,
        }
    }

    /// Returns the motion through the poses of an arrangement.
    ///
    /// # Errors
    /// Returns an error if their times do not increase, or there are fewer than two.
    pub(crate) fn motion_of_poses(&self) -> Result<Motion, GenerateError> {
        let timed = (0..self.file.recipe.frames_per_scene).zip(&self.trajectory);
        let timed: Vec<TimedPose> = timed
            .map(|(index, pose)| TimedPose {
                time_s: Some(self.since_first_s(index)),
                ..*pose
            })
            .collect();
        let motion = imu::motion(&timed);
        motion.map_err(|error| self.unfit("camera.trajectory", error.to_string(), "correct the trajectory"))
    }

    /// Checks that frames that take time fit their trajectory and their cameras. Returns the motion along the trajectory, if there is one.
    ///
    /// # Errors
    /// Returns an error if they do not.
    pub(crate) fn open_motion(&self) -> Result<Option<Motion>, GenerateError> {
        let recipe = &self.file.recipe;
        let Some(rule) = &recipe.camera.motion else {
            return Ok(None);
        };
        let frames = recipe.frames_per_scene;
        let is_path = recipe.camera.trajectory.is_some();
        if is_path && (frames < 2 || self.trajectory.len() < 2) {
            let poses = self.trajectory.len();
            return Err(self.unfit(
                "camera.motion",
                format!("frames_per_scene is {frames}, and the trajectory has {poses} poses"),
                "give 2 or more of each, between which the camera moves",
            ));
        }
        for model in &recipe.camera.model.0 {
            self.check_cameras_in_motion(rule, model, is_path)?;
        }
        is_path.then(|| self.motion_of_poses()).transpose()
    }

    fn check_cameras_in_motion(
        &self,
        rule: &MotionRule,
        model: &str,
        is_path: bool,
    ) -> Result<(), GenerateError> {
        let cameras = self.all_cameras(self.units(model).any())?;
        for name in rule.camera_offsets_ms.keys() {
            if !cameras.iter().any(|camera| camera.is_called(name)) {
                let names = cameras
                    .iter()
                    .map(|camera| camera.role.as_deref().unwrap_or(&camera.path));
                return Err(self.unfit(
                    "camera.motion.camera_offsets_ms",
                    format!("no camera {name} of the {model} is rendered"),
                    format!("name one of {}", names.collect::<Vec<_>>().join(", ")),
                ));
            }
        }
        // Only the frames of a trajectory follow each other.
        let shown = (self.trajectory.len() as u64).min(self.file.recipe.frames_per_scene);
        let periods = (1..shown).map(|index| self.since_first_s(index) - self.since_first_s(index - 1));
        let Some(period_s) = periods.min_by(f64::total_cmp).filter(|_| is_path) else {
            return Ok(());
        };
        let most = |quantity: &Quantity| quantity.range()[1];
        let shutter = Shutter {
            exposure_ms: most(&rule.exposure_ms),
            readout_ms: rule.readout_ms.as_ref().map(most),
        };
        for camera in &cameras {
            let times_s = shutter.times_s(camera);
            for (what, time_s) in ["exposes", "reads"].iter().zip(times_s) {
                // Times of files are rounded.
                if time_s > period_s * (1.0 + 1e-3) {
                    let (time_ms, period_ms) = (time_s * 1e3, period_s * 1e3);
                    return Err(self.unfit(
                        "camera.motion",
                        format!("{} {what} a frame for {time_ms} ms, longer than the {period_ms:.4} ms between frames", camera.path),
                        "shorten exposure_ms or readout_ms, or enlarge output.interval_s",
                    ));
                }
            }
        }
        Ok(())
    }
}
