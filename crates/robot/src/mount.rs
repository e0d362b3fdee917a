use oaktwin_base::parameter::choice;
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{RigidTransform, frame_names};
use oaktwin_catalog::Body;

use crate::RobotError;

choice! {
    /// The point of a device that its pose in the parent's frame places.
    Mount {
        /// The origin of the body frame, midway between the left and the right optical centre.
        Cameras = "cameras",
        /// The centre of the front face.
        Front = "front",
        /// The centre of the rear face.
        Back = "back",
        /// The centre of the lower face, where a tripod is mounted.
        Bottom = "bottom",
        /// The centre of the upper face.
        Top = "top",
    }
}

impl Mount {
    /// Returns the point in the body frame, metres.
    #[must_use]
    pub fn point(self, body: &Body) -> DVec3 {
        let [_, height, depth] = body.dimensions_mm;
        let front = DVec3::from(body.front_mm);
        let centre = front - DVec3::X * (depth / 2.0);
        let point = match self {
            Self::Cameras => DVec3::ZERO,
            Self::Front => front,
            Self::Back => front - DVec3::X * depth,
            Self::Bottom => centre - DVec3::Z * (height / 2.0),
            Self::Top => centre + DVec3::Z * (height / 2.0),
        };
        point * 1e-3
    }
}

/// The names of a device and its place on a robot.
#[derive(Clone, Debug, PartialEq)]
pub struct Attachment {
    /// The name of the device, which begins all names of frames: `oak` as in the vendor's ROS package.
    pub name: String,
    /// The link that carries the device, if a description should contain it.
    pub parent: Option<String>,
    /// The point of the device that is placed.
    pub mount: Mount,
    /// The pose of that point, with the axes of the body, in the parent's frame, metres.
    pub parent_from_mount: RigidTransform,
}

impl Default for Attachment {
    fn default() -> Self {
        Self {
            name: frame_names::DEVICE.to_owned(),
            parent: None,
            mount: Mount::default(),
            parent_from_mount: RigidTransform::IDENTITY,
        }
    }
}

impl Attachment {
    /// Creates the pose of the mount from a position in metres, and roll, pitch and yaw in radians as in URDF.
    ///
    /// # Errors
    /// Returns an error if a value is not finite.
    pub fn pose(xyz: [f64; 3], rpy: [f64; 3]) -> Result<RigidTransform, RobotError> {
        for (name, values) in [("xyz", xyz), ("rpy", rpy)] {
            if let Some(value) = values.into_iter().find(|value| !value.is_finite()) {
                return Err(RobotError::NotFinite { name, value });
            }
        }
        let [roll, pitch, yaw] = rpy;
        let rotation =
            DMat3::from_rotation_z(yaw) * DMat3::from_rotation_y(pitch) * DMat3::from_rotation_x(roll);
        Ok(RigidTransform::new(rotation, DVec3::from(xyz)))
    }

    /// Returns the pose of the body frame in the parent's frame.
    #[must_use]
    pub fn parent_from_body(&self, body: &Body) -> RigidTransform {
        self.parent_from_mount * RigidTransform::new(DMat3::IDENTITY, -self.mount.point(body))
    }
}
