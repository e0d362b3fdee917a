use oaktwin_camera::math::DVec3;
use oaktwin_camera::{RigidTransform, frame_names};

use crate::Description;
use crate::description::{CAMERA_FROM_OPTICAL, CameraFrame};

/// A coordinate frame of a device.
#[derive(Clone, Debug, PartialEq)]
pub struct DeviceFrame {
    /// The name.
    pub name: String,
    /// The name of the frame that carries it.
    pub parent: String,
    /// Its pose in that frame, metres.
    pub parent_from_frame: RigidTransform,
}

impl CameraFrame {
    /// Returns the frame of the camera and its optical frame. Their names begin with `device`.
    #[must_use]
    pub fn frames(&self, device: &str) -> [DeviceFrame; 2] {
        let camera = frame_names::camera(device, &self.role);
        let optical = DeviceFrame {
            name: frame_names::optical(&camera),
            parent: camera.clone(),
            parent_from_frame: RigidTransform::new(CAMERA_FROM_OPTICAL, DVec3::ZERO),
        };
        let camera = DeviceFrame {
            name: camera,
            parent: device.to_owned(),
            parent_from_frame: self.body_from_camera(),
        };
        [camera, optical]
    }
}

impl Description {
    /// Returns the frame of the inertial unit, if its pose is known.
    pub(crate) fn imu_frame(&self, device: &str) -> Option<DeviceFrame> {
        self.imu.as_ref().map(|imu| DeviceFrame {
            name: frame_names::imu(device),
            parent: device.to_owned(),
            parent_from_frame: imu.body_from_imu,
        })
    }

    /// Returns the frames of the cameras, the depth sensors and the inertial unit. Each follows the one that carries it.
    #[must_use]
    pub fn frames(&self) -> Vec<DeviceFrame> {
        let device = &self.name;
        let cameras = self.all_cameras().flat_map(|camera| camera.frames(device));
        cameras.chain(self.imu_frame(device)).collect()
    }
}
