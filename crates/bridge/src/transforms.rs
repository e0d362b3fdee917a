//! The frames of the device as transforms.

use oaktwin::camera::RigidTransform;
use oaktwin::camera::math::DQuat;
use oaktwin::robot::DeviceFrame;

use crate::message::{Header, Quaternion, TfMessage, Time, Transform, TransformStamped, Vector3};

/// The frames of a device.
#[derive(Clone, Debug, PartialEq)]
pub struct DeviceFrames {
    /// The name of the body frame.
    pub device: String,
    /// The frames that it carries, directly or by another one before them.
    pub frames: Vec<DeviceFrame>,
    /// The pose of the depth sensor's optical frame in the body frame.
    pub body_from_depth: RigidTransform,
}

impl DeviceFrames {
    /// Returns the transforms of all frames. The device is carried by the optical frame `input` of the depth images, unless that is one of
    /// its own or has no name.
    #[must_use]
    pub fn message(&self, input: &str, stamp: Time) -> TfMessage {
        let own = self
            .frames
            .iter()
            .map(|frame| transform(&frame.parent, &frame.name, &frame.parent_from_frame, stamp));
        let is_own = input == self.device || self.frames.iter().any(|frame| frame.name == input);
        let attached = (!is_own && !input.is_empty())
            .then(|| transform(input, &self.device, &self.body_from_depth.inverse(), stamp));
        TfMessage {
            transforms: attached.into_iter().chain(own).collect(),
        }
    }
}

fn transform(parent: &str, child: &str, pose: &RigidTransform, stamp: Time) -> TransformStamped {
    let (at, rotation) = (pose.translation, DQuat::from_mat3(&pose.rotation));
    TransformStamped {
        header: Header {
            stamp,
            frame_id: parent.to_owned(),
        },
        child_frame_id: child.to_owned(),
        transform: Transform {
            translation: Vector3 {
                x: at.x,
                y: at.y,
                z: at.z,
            },
            rotation: Quaternion {
                x: rotation.x,
                y: rotation.y,
                z: rotation.z,
                w: rotation.w,
            },
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oaktwin::catalog::Catalog;
    use oaktwin::robot::{Attachment, Description};

    fn frames() -> DeviceFrames {
        let catalog = Catalog::builtin();
        let twin = catalog.nominal(catalog.device("OAK-D Pro PoE").unwrap());
        let description = Description::new(catalog, &twin, &Attachment::default()).unwrap();
        DeviceFrames {
            device: description.name.clone(),
            frames: description.frames(),
            body_from_depth: description.depth_sensors[0].camera.body_from_optical,
        }
    }

    fn pairs(message: &TfMessage) -> Vec<(&str, &str)> {
        let transforms = message.transforms.iter();
        transforms
            .map(|one| (one.header.frame_id.as_str(), one.child_frame_id.as_str()))
            .collect()
    }

    #[test]
    fn the_tree_has_the_names_of_the_urdf_below_the_frame_of_the_images() {
        let message = frames().message("sim_depth_optical", Time::default());
        let found = pairs(&message);
        assert_eq!(found[0], ("sim_depth_optical", "oak"));
        for expected in [
            ("oak", "oak_left_camera_frame"),
            ("oak_left_camera_frame", "oak_left_camera_optical_frame"),
            ("oak_rgb_camera_frame", "oak_rgb_camera_optical_frame"),
            (
                "oak_stereo_depth_camera_frame",
                "oak_stereo_depth_camera_optical_frame",
            ),
            ("oak", "oak_imu_frame"),
        ] {
            assert!(found.contains(&expected), "{expected:?} in {found:?}");
        }
    }

    #[test]
    fn the_depth_frame_is_that_of_the_images() {
        let message = frames().message("images", Time::default());
        let pose = |child: &str| {
            let found = message.transforms.iter().find(|one| one.child_frame_id == child);
            let Transform {
                translation: at,
                rotation,
            } = found.unwrap().transform;
            let rotation = DQuat::from_xyzw(rotation.x, rotation.y, rotation.z, rotation.w);
            (rotation, oaktwin::camera::math::DVec3::new(at.x, at.y, at.z))
        };
        let chain = [
            "oak",
            "oak_stereo_depth_camera_frame",
            "oak_stereo_depth_camera_optical_frame",
        ];
        let mut whole = (DQuat::IDENTITY, oaktwin::camera::math::DVec3::ZERO);
        for child in chain {
            let (rotation, at) = pose(child);
            whole = (whole.0 * rotation, whole.1 + whole.0 * at);
        }
        assert!(whole.0.angle_between(DQuat::IDENTITY) < 1e-7, "{whole:?}");
        assert!(whole.1.length() < 1e-12, "{whole:?}");
    }

    #[test]
    fn a_frame_of_the_device_is_not_its_parent() {
        for own in ["oak_stereo_depth_camera_optical_frame", "oak", ""] {
            let message = frames().message(own, Time::default());
            let is_root = |one: &TransformStamped| one.child_frame_id == "oak";
            assert!(!message.transforms.iter().any(is_root), "{own}");
        }
    }
}
