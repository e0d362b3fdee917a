//! Frames of an animated scene.

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::RigidTransform;
use oaktwin_imu::Motion;
use oaktwin_render::Renderer;
use oaktwin_scene::Scene;
use oaktwin_usd::stage::StageTiming;

use super::PlacedCamera;
use super::frames::{Frames, FramesError, Outputs, Written, at, motion, times_ns, write};
use super::rig::{Rig, RigSpec};
use super::scene_camera::{SceneCameraOptions, scene_cameras};
use super::scene_file::{AnimatedScene, SceneChange, SceneFile};
use super::trajectory::TimedPose;
use crate::progress::Watch;

/// The largest number of frames of an animation.
pub const MAX_FRAMES: usize = 1_000_000;

/// Time codes of frames.
#[derive(Clone, Debug, PartialEq)]
pub struct TimeCodes {
    /// The time codes.
    pub codes: Vec<f64>,
    /// The time codes from frame to frame.
    pub step: f64,
}

impl TimeCodes {
    /// Reads `FIRST:LAST` or `FIRST:LAST:STEP`; LAST is included if a step ends at it. A single number is one frame.
    ///
    /// # Errors
    /// Returns what is wrong and what to do: a text of another form, a step of 0 or away from LAST, and more than [`MAX_FRAMES`].
    pub fn parse(text: &str) -> Result<Self, String> {
        let numbers: Option<Vec<f64>> = text
            .split(':')
            .map(|part| part.trim().parse().ok().filter(|number: &f64| number.is_finite()))
            .collect();
        let (first, last, step) = match numbers.as_deref() {
            Some(&[only]) => (only, only, 1.0),
            Some(&[first, last]) => (first, last, 1.0),
            Some(&[first, last, step]) => (first, last, step),
            _ => {
                return Err(format!(
                    "invalid time codes '{text}'; write FIRST:LAST or FIRST:LAST:STEP, such as 0:100:2"
                ));
            }
        };
        if step <= 0.0 {
            return Err(format!("the step is {step}; give a number above 0"));
        }
        if last < first {
            return Err(format!(
                "{last} is before {first}; write the smaller time code first"
            ));
        }
        // The sum of steps of 0.1 may miss the last time code by rounding.
        let count = ((last - first) / step + 1e-9).floor() + 1.0;
        if count > MAX_FRAMES as f64 {
            return Err(format!("{count} frames; give at most {MAX_FRAMES}"));
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "at most MAX_FRAMES"
        )]
        let codes = (0..count as usize)
            .map(|number| first + number as f64 * step)
            .collect();
        Ok(Self { codes, step })
    }

    /// Returns the time of each frame, s, from 0: as the stage plays it, or at a rate of frames per second.
    #[must_use]
    pub fn times_s(&self, timing: &StageTiming, frames_per_second: Option<f64>) -> Vec<Option<f64>> {
        let period_s = frames_per_second.map_or(self.step / timing.time_codes_per_second, |rate| 1.0 / rate);
        (0..self.codes.len())
            .map(|number| Some(number as f64 * period_s))
            .collect()
    }
}

/// An animated scene, from which [`write_animation`] makes frames.
#[derive(Debug)]
pub struct Animation<'a> {
    scene: &'a mut AnimatedScene,
    times: Vec<f64>,
    times_ns: Vec<u64>,
    /// The time codes in a second of the frames' time.
    codes_per_s: f64,
    path: &'a [TimedPose],
    /// The motion along the path, if frames take time.
    motion: Option<Motion>,
    renderer: Renderer,
    stage: Option<StageCameras<'a>>,
    own_pose: RigidTransform,
}

/// The cameras of a stage, which may move.
#[derive(Debug)]
struct StageCameras<'a> {
    file: SceneFile,
    spec: &'a RigSpec,
    /// The poses of the rig's cameras at the time that was read last, if they were asked for.
    placed: Option<Vec<RigidTransform>>,
}

impl<'a> Animation<'a> {
    /// Makes the animation of a scene, which was read at the first time code, for the rig of an OAK. Each frame has a time code and a time, s.
    /// The OAK is at the poses of the path, one for each frame, or at its own pose if the path is empty; relative to the prim that carries it,
    /// if there is one.
    ///
    /// # Errors
    /// Returns what is wrong and what to do if the path has another number of poses than there are time codes.
    pub fn of_oak(
        scene: &'a mut AnimatedScene,
        first: SceneFile,
        times: (&TimeCodes, &[Option<f64>]),
        rig: &Rig,
        path: &'a [TimedPose],
    ) -> Result<Self, String> {
        let count = times.0.codes.len();
        if !path.is_empty() && path.len() != count {
            return Err(format!(
                "{} poses, but {count} time codes; give one pose for each frame",
                path.len()
            ));
        }
        let mut made = Self {
            own_pose: rig
                .cameras()
                .first()
                .map_or(RigidTransform::IDENTITY, |camera| camera.world_from_mount),
            ..Self::new(scene, first.scene, times, path)
        };
        made.motion = motion(rig, path, &made.times_ns).map_err(|error| error.to_string())?;
        Ok(made)
    }

    /// Makes the animation of a scene, which was read at the first time code, for its own cameras, whose rig has this specification.
    #[must_use]
    pub fn of_stage(
        scene: &'a mut AnimatedScene,
        mut first: SceneFile,
        times: (&TimeCodes, &[Option<f64>]),
        spec: &'a RigSpec,
    ) -> Self {
        let drawn = first.take_scene();
        Self {
            stage: Some(StageCameras {
                file: first,
                spec,
                placed: None,
            }),
            ..Self::new(scene, drawn, times, &[])
        }
    }

    fn new(
        scene: &'a mut AnimatedScene,
        first: Scene,
        (times, times_s): (&TimeCodes, &[Option<f64>]),
        path: &'a [TimedPose],
    ) -> Self {
        let period_s = match times_s {
            [Some(first), Some(second), ..] => second - first,
            _ => times.step / scene.timing().time_codes_per_second,
        };
        Self {
            scene,
            times: times.codes.clone(),
            times_ns: times_ns(times_s),
            codes_per_s: times.step / period_s,
            path,
            motion: None,
            renderer: Renderer::new(first),
            stage: None,
            own_pose: RigidTransform::IDENTITY,
        }
    }
}

impl StageCameras<'_> {
    fn cameras(&self) -> Result<Vec<PlacedCamera>, FramesError> {
        let options = SceneCameraOptions {
            cameras: &self.spec.cameras,
            size: self.spec.size,
            projection: self.spec.projection,
        };
        Ok(scene_cameras(&self.file, &options)?.0)
    }

    /// Moves the cameras of the rig; a rig whose optics have changed is made again.
    fn place(&self, rig: &mut Rig) -> Result<Vec<Finding>, FramesError> {
        if rig.place_cameras(self.cameras()?) {
            return Ok(Vec::new());
        }
        let (made, findings) = Rig::of_stage(&self.file, self.spec)?;
        *rig = made;
        Ok(findings)
    }
}

impl Animation<'_> {
    /// Goes to a time code. Returns whether cameras of the stage may have changed.
    fn go(&mut self, code: f64, findings: &mut Vec<Finding>) -> Result<bool, FramesError> {
        let (change, mut found) = self.scene.at(Some(code))?;
        findings.append(&mut found);
        let has_moved = match change {
            SceneChange::Moved(instances, cameras) => {
                self.renderer.set_poses(instances);
                let has_moved = !cameras.is_empty();
                if let Some(stage) = &mut self.stage {
                    for (index, world_from_camera) in cameras {
                        stage.file.cameras[index].world_from_camera = world_from_camera;
                    }
                }
                has_moved
            }
            SceneChange::Rebuilt(mut file) => {
                self.renderer = Renderer::new(file.take_scene());
                if let Some(stage) = &mut self.stage {
                    stage.file = *file;
                }
                true
            }
        };
        if let Some(stage) = self.stage.as_mut().filter(|_| has_moved) {
            stage.placed = None;
        }
        Ok(has_moved)
    }

    /// The pose of an OAK in the world, at a pose on the prim that carries it, if there is one.
    fn mounted(&self, own: Option<RigidTransform>) -> RigidTransform {
        let own = own.unwrap_or(self.own_pose);
        match self.scene.world_from_mount() {
            Some(world_from_mount) => *world_from_mount * own,
            None => own,
        }
    }
}

impl Frames for Animation<'_> {
    fn times_ns(&self) -> &[u64] {
        &self.times_ns
    }

    fn advance(
        &mut self,
        number: usize,
        rig: &mut Rig,
        findings: &mut Vec<Finding>,
    ) -> Result<Option<RigidTransform>, FramesError> {
        // The scene was read at the first time.
        if number > 0
            && self.go(self.times[number], findings)?
            && let Some(stage) = &self.stage
        {
            findings.extend(stage.place(rig)?);
        }
        if self.stage.is_some() {
            return Ok(None);
        }
        let own = self.path.get(number).map(|pose| pose.world_from_mount);
        Ok(Some(self.mounted(own)))
    }

    fn shift(
        &mut self,
        number: usize,
        offset_s: f64,
        camera: usize,
    ) -> Result<Option<RigidTransform>, FramesError> {
        // What is found at the times of frames is reported.
        let code = self.times[number] + offset_s * self.codes_per_s;
        self.go(code, &mut Vec::new())?;
        let Some(stage) = &mut self.stage else {
            let own = at(self.motion.as_ref(), &self.times_ns, number, offset_s);
            return Ok(Some(self.mounted(own)));
        };
        if stage.placed.is_none() {
            let cameras = stage.cameras()?;
            stage.placed = Some(cameras.iter().map(|camera| camera.world_from_mount).collect());
        }
        Ok(stage
            .placed
            .as_ref()
            .and_then(|placed| placed.get(camera).copied()))
    }

    fn renderer(&self) -> &Renderer {
        &self.renderer
    }
}

/// Renders the frames of an animation as [`write_frames`](super::write_frames) does.
///
/// # Errors
/// Returns the errors of [`write_frames`](super::write_frames), and an error if the scene cannot be read at a time.
pub fn write_animation(
    animation: &mut Animation<'_>,
    rig: &Rig,
    is_strict: bool,
    outputs: Outputs<'_>,
    watch: &Watch<'_>,
) -> Result<Written, FramesError> {
    write(animation, rig, is_strict, outputs, watch)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_time_codes() {
        let of = |text: &str| TimeCodes::parse(text).unwrap();
        let timing = StageTiming {
            time_codes_per_second: 24.0,
            ..StageTiming::default()
        };
        assert_eq!(of("3").codes, [3.0]);
        assert_eq!(of("0:3").codes, [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(of("-1:1:0.5").codes, [-1.0, -0.5, 0.0, 0.5, 1.0]);
        assert_eq!(of("0:1:0.1").codes.len(), 11);
        assert_eq!(of("0:10:4").codes, [0.0, 4.0, 8.0]);
        let times = of("0:10:4");
        assert_eq!(
            times.times_s(&timing, None),
            [0.0, 4.0 / 24.0, 8.0 / 24.0].map(Some)
        );
        assert_eq!(times.times_s(&timing, Some(10.0)), [0.0, 0.1, 0.2].map(Some));
    }

    #[test]
    fn rejects_other_texts() {
        for (text, expected) in [
            ("", "invalid time codes ''"),
            ("a:b", "FIRST:LAST:STEP"),
            ("0:1:2:3", "FIRST:LAST:STEP"),
            ("0:nan", "invalid time codes"),
            ("0:5:0", "the step is 0"),
            ("0:5:-1", "the step is -1"),
            ("5:0", "0 is before 5"),
            ("0:1e9", "at most 1000000"),
        ] {
            let error = TimeCodes::parse(text).unwrap_err();
            assert!(error.contains(expected), "{text}: {error}");
        }
    }
}
