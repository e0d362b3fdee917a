use std::collections::BTreeMap;

use oaktwin_base::diagnostic::fold_name;
use oaktwin_base::parameter::Platform;
use oaktwin_base::parameter::nvidia::Attributes;
use oaktwin_camera::math::DVec3;
use oaktwin_camera::{
    Camera as Optics, Intrinsics, LensModel, OpenCvFisheye, PixelPoint, RectifiedIntrinsics, RigidTransform,
    Usd, stereo_rectify_to,
};

use crate::{Camera, DepthSensor, Device, Role};

/// A device with the intrinsics, lens and pose of each camera: nominal values of the catalog, or the values of one unit's
/// calibration.
#[derive(Clone, Debug, PartialEq)]
pub struct Twin {
    /// The catalog's entry.
    pub device: Device,
    /// The cameras in the catalog's order.
    pub cameras: Vec<TwinCamera>,
    /// The depth sensors in the catalog's order.
    pub depth_sensors: Vec<TwinDepthSensor>,
    /// The pose of the inertial unit in the body frame in m, if it is known.
    pub body_from_imu: Option<RigidTransform>,
    /// The baselines with which the device's processor converts disparity to depth where it does not use the cameras' distance, in m:
    /// the design's of a calibrated unit, by the roles of the left and the right camera.
    pub design_baselines_m: BTreeMap<(Role, Role), f64>,
    /// The origin of the numbers.
    pub origin: Origin,
}

/// The origin of a [`Twin`]'s numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The catalog.
    Nominal,
    /// The calibration of a unit.
    Calibration {
        /// The product name in the file; may be empty.
        product_name: String,
        /// The file name without the folder.
        file_name: String,
    },
}

/// One camera of a [`Twin`].
#[derive(Clone, Debug, PartialEq)]
pub struct TwinCamera {
    /// The catalog's entry.
    pub spec: Camera,
    /// The pixel pitch of the sensor's mode, µm.
    pub pixel_size_um: f64,
    /// Whether the sensor has no colour filters.
    pub is_monochrome: bool,
    /// The readout time, s: how much later the last row is exposed than the first; 0 unless the sensor rolls.
    pub readout_s: f64,
    /// The intrinsics at the sensor's used resolution.
    pub intrinsics: Intrinsics,
    /// The lens.
    pub lens: LensModel,
    /// The transform from the camera's optical frame (x right, y down, z forward) to the body frame (x forward, y left, z up;
    /// origin midway between left and right), m.
    pub body_from_camera: RigidTransform,
}

/// One depth sensor of a [`Twin`].
#[derive(Clone, Debug, PartialEq)]
pub struct TwinDepthSensor {
    /// The catalog's entry.
    pub spec: DepthSensor,
    /// `focalLengthPixel` of this twin: the rounded fx of [`Twin::depth_camera`].
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

impl Device {
    /// Returns the processor of the device for `DepthAI`, or `None` if it is unknown.
    #[must_use]
    pub fn depthai_platform(&self) -> Option<Platform> {
        let generation = fold_name(&self.generation);
        let mut all = [Platform::Rvc2, Platform::Rvc4].into_iter();
        all.find(|platform| fold_name(platform.name()) == generation)
    }
}

impl Twin {
    /// Returns the camera of a role, if the device has it.
    #[must_use]
    pub fn camera(&self, role: Role) -> Option<&TwinCamera> {
        self.cameras.iter().find(|camera| camera.spec.role == role)
    }

    /// Returns the distance of two cameras in m, if the device has both.
    #[must_use]
    pub fn baseline_m(&self, (left, right): (Role, Role)) -> Option<f64> {
        let centre = |role| Some(self.camera(role)?.body_from_camera.translation);
        Some(centre(left)?.distance(centre(right)?))
    }

    /// Returns the baseline with which the device's processor converts the disparity of a pair to depth, in m, if the device has both
    /// cameras. A calibrated unit's differs from [`Self::baseline_m`] if the processor uses the design's, which scales its depth.
    #[must_use]
    pub fn depth_baseline_m(&self, pair: (Role, Role)) -> Option<f64> {
        let calibrated = self.baseline_m(pair)?;
        Some(self.design_baselines_m.get(&pair).copied().unwrap_or(calibrated))
    }

    /// Returns the distances of all pairs of cameras, for [`Self::design_baselines_m`] of a unit with this design.
    #[must_use]
    pub fn baselines_m(&self) -> BTreeMap<(Role, Role), f64> {
        let roles = || self.cameras.iter().map(|camera| camera.spec.role);
        let pairs = roles().flat_map(|left| roles().map(move |right| (left, right)));
        pairs
            .filter(|(left, right)| left != right)
            .filter_map(|pair| Some((pair, self.baseline_m(pair)?)))
            .collect()
    }

    /// Returns the processor of the device, or `None` if it is unknown.
    #[must_use]
    pub fn platform(&self) -> Option<Platform> {
        self.device.depthai_platform()
    }

    /// Returns the role of a depth sensor's camera in the names of frames: `stereo_depth` or `tof_depth`, numbered if there are
    /// several of a kind.
    #[must_use]
    pub fn depth_role(&self, sensor: &TwinDepthSensor) -> String {
        let kind = sensor.spec.kind;
        let same_kind = self.depth_sensors.iter().filter(|one| one.spec.kind == kind);
        let prims: Vec<&str> = same_kind.map(|one| one.spec.prim.as_str()).collect();
        let number = prims.iter().position(|prim| *prim == sensor.spec.prim);
        match (prims.len(), number) {
            (2.., Some(number)) => format!("{kind}_{}_depth", number + 1),
            _ => format!("{kind}_depth"),
        }
    }

    /// Returns the camera that the images of a depth sensor are from: a pinhole, because depth is rectified.
    ///
    /// The camera of a stereo pair has the left camera's centre. In a calibrated unit, it is rotated like the rectified left
    /// image, and has the intrinsics that the device's processor gives to both images: the right camera's on RVC2,
    /// the left camera's otherwise.
    #[must_use]
    pub fn depth_camera(&self, sensor: &TwinDepthSensor) -> Option<TwinCamera> {
        let mut camera = self.camera(sensor.spec.camera)?.clone();
        if let Some(pair) = sensor.spec.pair() {
            camera = self.rectified_left(pair)?;
        }
        camera.lens = LensModel::Pinhole;
        Some(camera)
    }

    /// Returns the rectified left camera of a pair, or `None` if the device has no such camera. Without a right camera, or
    /// extrinsics that can be rectified, it is the left camera without its lens.
    #[must_use]
    pub fn rectified_left(&self, (left, right): (Role, Role)) -> Option<TwinCamera> {
        let mut left = self.camera(left)?.clone();
        let optics = |camera: &TwinCamera| Optics::new(camera.intrinsics, camera.lens);
        if let (Origin::Calibration { .. }, Some(right)) = (&self.origin, self.camera(right)) {
            let right_from_left = right.body_from_camera.inverse() * left.body_from_camera;
            let target = RectifiedIntrinsics::of(self.platform().unwrap_or(Platform::Rvc4));
            if let Ok(pair) = stereo_rectify_to(&optics(&left), &optics(right), &right_from_left, target) {
                let left_from_rectified = pair.rectified_from_left.transpose();
                left.intrinsics = pair.left;
                left.body_from_camera =
                    left.body_from_camera * RigidTransform::new(left_from_rectified, DVec3::ZERO);
            }
        }
        left.lens = LensModel::Pinhole;
        Some(left)
    }
}

impl TwinCamera {
    /// Returns a centred equidistant lens `r = f θ` with the field of view of the real lens, `f = width / hfov`, if the catalog
    /// contains that field of view. The distortion of individual units is not known.
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
