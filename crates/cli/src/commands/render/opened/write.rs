//! The frames of a scene, still, animated, or with a robot.

use oaktwin::render::trajectory::TimedPose;
use oaktwin::render::{
    Animation, Carried, Outputs, Renderer, Rig, RigSpec, Written, write_animation, write_carried,
    write_frames,
};

use super::Opened;
use crate::args::RenderArgs;
use crate::context::Result;
use crate::progress;

impl Opened {
    /// Writes the frames of a rig.
    pub(in crate::commands::render) fn write(
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
