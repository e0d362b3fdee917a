use oaktwin_camera::{
    Camera as Optics, Intrinsics, LensModel, OpenCvFisheye, PixelPoint, RigidTransform, Usd,
};
use oaktwin_parameter::nvidia::Attributes;

use crate::{Camera, DepthSensor, Device, Role};

/// A device with every camera resolved: its optics, lens and place. Nominal as the catalog has it, or one unit as
/// its calibration has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Twin {
    /// The catalog's entry.
    pub device: Device,
    /// The cameras, in the catalog's order.
    pub cameras: Vec<TwinCamera>,
    /// The depth sensors, in the catalog's order.
    pub depth_sensors: Vec<TwinDepthSensor>,
    /// The inertial unit's place in the body frame, m.
    pub body_from_imu: RigidTransform,
    /// What the numbers come from.
    pub origin: Origin,
}

/// What the numbers of a [`Twin`] come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The catalog alone.
    Nominal,
    /// A unit's calibration: its product name and, where known, its file's name.
    Calibration {
        /// As the file spells it; may be empty.
        product_name: String,
        /// The file's name without its folder.
        file_name: String,
    },
}

/// One camera of a [`Twin`].
#[derive(Clone, Debug, PartialEq)]
pub struct TwinCamera {
    /// The catalog's entry.
    pub spec: Camera,
    /// Pixel pitch of the used mode, µm.
    pub pixel_size_um: f64,
    /// At the sensor's used resolution.
    pub intrinsics: Intrinsics,
    /// The lens.
    pub lens: LensModel,
    /// From the camera's optical frame (x right, y down, z forward) to the body frame (x forward, y left, z up;
    /// origin midway between left and right), m.
    pub body_from_camera: RigidTransform,
}

/// One depth sensor of a [`Twin`].
#[derive(Clone, Debug, PartialEq)]
pub struct TwinDepthSensor {
    /// The catalog's entry.
    pub spec: DepthSensor,
    /// `focalLengthPixel` of this twin: the rounded fx of [`DepthSensor::camera`].
    pub focal_length_px: f64,
}

impl TwinDepthSensor {
    /// The attributes of the render product in the standard or the extended mode.
    #[must_use]
    pub fn attributes(&self, is_extended: bool) -> Attributes {
        Attributes {
            focal_length_px: self.focal_length_px,
            ..self.spec.attributes(is_extended)
        }
    }
}

impl Twin {
    /// The camera of a role, if the device has it.
    #[must_use]
    pub fn camera(&self, role: Role) -> Option<&TwinCamera> {
        self.cameras.iter().find(|camera| camera.spec.role == role)
    }
}

impl TwinCamera {
    /// The equidistant lens `r = f θ` that spans the real lens's field of view across the image, `f = width / hfov`,
    /// centred: for the cameras whose catalog entry has such a field of view. No unit's coefficients are known.
    #[must_use]
    pub fn nominal_fisheye(&self) -> Option<Optics> {
        let size = self.intrinsics.size;
        let (width, height) = (f64::from(size.width), f64::from(size.height));
        let f = width / self.spec.fisheye_hfov_deg?.to_radians();
        let centre = PixelPoint::<Usd>::new(width / 2.0, height / 2.0);
        Some(Optics {
            intrinsics: Intrinsics::new(size, f, f, centre),
            lens: LensModel::OpenCvFisheye(OpenCvFisheye { k: [0.0; 4] }),
        })
    }
}
