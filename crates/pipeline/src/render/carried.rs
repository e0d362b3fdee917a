//! Frames of a scene in which a robot moves.

use oaktwin_base::diagnostic::Finding;
use oaktwin_camera::RigidTransform;
use oaktwin_render::Renderer;
use oaktwin_robot::{JointPositions, PlacedRobot};

use super::frames::{Frames, FramesError, Outputs, Written, times_ns, write};
use super::rig::Rig;
use crate::progress::Watch;

/// A scene with a robot, from which [`write_carried`] makes a frame for each posture.
#[derive(Debug)]
pub struct Carried<'a> {
    robot: &'a PlacedRobot,
    /// The link that carries the OAK.
    link: Option<usize>,
    positions: &'a JointPositions,
    times_ns: Vec<u64>,
    renderer: Renderer,
    /// The pose of the OAK on the link.
    link_from_body: RigidTransform,
    world_from_links: Vec<RigidTransform>,
}

impl<'a> Carried<'a> {
    /// Makes frames of a renderer whose scene has the robot. With a link, the rig is an OAK that it carries, at a pose relative to the
    /// link; otherwise the rig stays where it is.
    #[must_use]
    pub fn new(
        renderer: Renderer,
        robot: &'a PlacedRobot,
        positions: &'a JointPositions,
        mount: Option<(usize, RigidTransform)>,
    ) -> Self {
        Self {
            robot,
            link: mount.map(|(link, _)| link),
            positions,
            times_ns: times_ns(&positions.times_s),
            renderer,
            link_from_body: mount.map_or(RigidTransform::IDENTITY, |(_, pose)| pose),
            world_from_links: Vec::new(),
        }
    }

    /// Moves the robot. Returns the pose of the OAK that it carries.
    fn go(&mut self, positions: &[f64]) -> Option<RigidTransform> {
        self.world_from_links = self.robot.world_from_links(positions);
        self.renderer.set_poses(self.robot.poses(&self.world_from_links));
        self.link
            .map(|link| self.world_from_links[link] * self.link_from_body)
    }

    /// The positions at a time after a frame's: joints move evenly from posture to posture.
    #[expect(clippy::cast_precision_loss, reason = "nanoseconds of a motion")]
    fn at(&self, number: usize, offset_s: f64) -> Vec<f64> {
        let postures = &self.positions.positions;
        let other = match offset_s < 0.0 {
            true => number.saturating_sub(1),
            false => (number + 1).min(postures.len() - 1),
        };
        let time = |frame: usize| self.times_ns.get(frame).copied().unwrap_or_default() as f64 * 1e-9;
        let period_s = time(other) - time(number);
        let share = match period_s == 0.0 {
            true => 0.0,
            false => offset_s / period_s,
        };
        let pairs = postures[number].iter().zip(&postures[other]);
        pairs.map(|(own, other)| own + share * (other - own)).collect()
    }
}

impl Frames for Carried<'_> {
    fn times_ns(&self) -> &[u64] {
        &self.times_ns
    }

    fn advance(
        &mut self,
        number: usize,
        _: &mut Rig,
        _: &mut Vec<Finding>,
    ) -> Result<Option<RigidTransform>, FramesError> {
        let positions = self.positions;
        Ok(self.go(&positions.positions[number]))
    }

    fn shift(
        &mut self,
        number: usize,
        offset_s: f64,
        _: usize,
    ) -> Result<Option<RigidTransform>, FramesError> {
        let positions = self.at(number, offset_s);
        Ok(self.go(&positions))
    }

    fn renderer(&self) -> &Renderer {
        &self.renderer
    }
}

/// Renders a frame for each posture of a robot as [`write_frames`](super::write_frames) does for each pose.
///
/// # Errors
/// Returns the errors of [`write_frames`](super::write_frames).
pub fn write_carried(
    carried: &mut Carried<'_>,
    rig: &Rig,
    is_strict: bool,
    outputs: Outputs<'_>,
    watch: &Watch<'_>,
) -> Result<Written, FramesError> {
    write(carried, rig, is_strict, outputs, watch)
}
