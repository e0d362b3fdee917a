use clap::Args;
use oaktwin::camera::RigidTransform;
use oaktwin::camera::math::DVec3;
use oaktwin::render;
use oaktwin::scene::Up;

use crate::context::Result;

/// The pose of an OAK.
#[derive(Args, Debug)]
#[command(next_help_heading = "OAK")]
pub(crate) struct PlaceArgs {
    /// The body's position in metres, and its rotation as a quaternion
    #[arg(
        long,
        num_args = 7,
        value_names = ["X", "Y", "Z", "QX", "QY", "QZ", "QW"],
        conflicts_with = "look_at",
        requires = "model"
    )]
    pose: Option<Vec<f64>>,

    /// The body's position, the point that it faces, and its up direction [default: the scene's]
    ///
    /// EX EY EZ and TX TY TZ are in metres; three more numbers are the up direction.
    #[arg(
        long,
        num_args = 6..=9,
        value_names = ["EX", "EY", "EZ", "TX", "TY", "TZ"],
        requires = "model"
    )]
    look_at: Option<Vec<f64>>,
}

impl PlaceArgs {
    /// Whether both `--pose` and `--look-at` are absent.
    pub(crate) fn is_none(&self) -> bool {
        self.pose.is_none() && self.look_at.is_none()
    }

    /// The pose that is given as numbers.
    pub(crate) fn pose(&self) -> Result<Option<RigidTransform>> {
        let Some(numbers) = &self.pose else {
            return Ok(None);
        };
        let numbers: [f64; 7] = numbers[..].try_into().map_err(|_| "--pose takes 7 numbers")?;
        let pose = render::pose(numbers).map_err(|error| format!("--pose: {error}"))?;
        Ok(Some(pose))
    }

    /// The eye, target and up direction of `--look-at` in a scene with this up axis.
    pub(crate) fn look_at(&self, up: Up) -> Result<Option<[DVec3; 3]>> {
        let Some(numbers) = &self.look_at else {
            return Ok(None);
        };
        let (points, rest) = numbers.as_chunks::<3>();
        let (eye, target, up) = match (points, rest) {
            ([eye, target], []) => (eye, target, up.direction()),
            ([eye, target, up], []) => (eye, target, DVec3::from(*up)),
            _ => {
                let count = numbers.len();
                return Err(format!("--look-at: {count} numbers; EYE, TARGET and UP have three each").into());
            }
        };
        Ok(Some([DVec3::from(*eye), DVec3::from(*target), up]))
    }
}
