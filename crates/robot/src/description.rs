use oaktwin_base::diagnostic::{Finding, Level};
use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Intrinsics, LensModel, RigidTransform, Usd};
use oaktwin_catalog::{Catalog, InertialPart, Twin, TwinCamera};
use oaktwin_imu::ChannelNoise;
use oaktwin_usd::body;

use crate::{Attachment, HousingMesh, RobotError};

/// The axes of an optical frame (x right, y down, z forward) in a camera frame (x forward, y left, z up), as in REP-103.
pub(crate) const CAMERA_FROM_OPTICAL: DMat3 = DMat3::from_cols(DVec3::NEG_Y, DVec3::NEG_Z, DVec3::X);

/// A device as a robot sees it. All poses are in the body frame: x forward, y left, z up, metres.
#[derive(Clone, Debug, PartialEq)]
pub struct Description {
    /// The name that begins the names of frames.
    pub name: String,
    /// The model's id, which names files.
    pub id: String,
    /// The model's name, and the calibration of a unit.
    pub title: String,
    /// The link that carries the device.
    pub parent: Option<String>,
    /// The pose of the body in the parent's frame.
    pub parent_from_body: RigidTransform,
    /// The housing.
    pub housing: Housing,
    /// The cameras.
    pub cameras: Vec<CameraFrame>,
    /// The depth sensors.
    pub depth_sensors: Vec<DepthFrame>,
    /// The inertial unit, if its pose is known.
    pub imu: Option<ImuFrame>,
    /// What no format can represent.
    pub findings: Vec<Finding>,
}

/// The rate for which the noise of inertial samples is written, Hz.
pub(crate) const IMU_RATE: f64 = 200.0;

/// A housing.
#[derive(Clone, Debug, PartialEq)]
pub struct Housing {
    /// The visible meshes, one per material.
    pub visuals: Vec<Visual>,
    /// A convex mesh.
    pub collider: HousingMesh,
    /// The centre of the housing, which is used as its centre of mass.
    pub centre: DVec3,
    /// The outer dimensions along x, y and z.
    pub size: DVec3,
    /// The mass in kg.
    pub mass: f64,
    /// The moments of inertia about the centre in kg m², of a solid cuboid of this size and mass.
    pub inertia: DVec3,
}

/// A visible mesh of one colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Visual {
    /// The material.
    pub name: &'static str,
    /// The linear colour.
    pub color: [f32; 3],
    /// Metallic, 0 to 1.
    pub metallic: f32,
    /// Roughness, 0 to 1.
    pub roughness: f32,
    /// The mesh.
    pub mesh: HousingMesh,
}

/// A camera: a pinhole with these intrinsics.
#[derive(Clone, Debug, PartialEq)]
pub struct CameraFrame {
    /// The role: `rgb`, `left`, `right` or `tof`.
    pub role: String,
    /// The intrinsics at the resolution of the model.
    pub intrinsics: Intrinsics,
    /// The pixel pitch in metres.
    pub pitch: f64,
    /// The pose of the optical frame (x right, y down, z forward).
    pub body_from_optical: RigidTransform,
    /// The clipping range in metres.
    pub clip: (f64, f64),
}

/// A depth sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct DepthFrame {
    /// The rectified camera whose images the depth images are; its role is `stereo_depth` or `tof_depth`, numbered if there are
    /// several.
    pub camera: CameraFrame,
    /// The measuring range in metres.
    pub range: (f64, f64),
}

/// An inertial unit.
#[derive(Clone, Debug, PartialEq)]
pub struct ImuFrame {
    /// The pose of the sensor's axes.
    pub body_from_imu: RigidTransform,
    /// The errors of the accelerometer, m/s², if the part is known.
    pub accelerometer: Option<ChannelNoise>,
    /// The errors of the gyroscope, rad/s, if the part is known.
    pub gyroscope: Option<ChannelNoise>,
}

impl CameraFrame {
    /// Returns the pose of the camera frame, whose x axis points forward.
    #[must_use]
    pub fn body_from_camera(&self) -> RigidTransform {
        let rotation = self.body_from_optical.rotation * CAMERA_FROM_OPTICAL.transpose();
        RigidTransform::new(rotation, self.body_from_optical.translation)
    }

    /// Returns the principal point in pixels from the left and the top border.
    #[must_use]
    pub fn centre(&self) -> (f64, f64) {
        let centre = self.intrinsics.principal_point::<Usd>();
        (centre.x, centre.y)
    }

    /// Returns the width and the height in pixels.
    #[must_use]
    pub fn size(&self) -> (f64, f64) {
        let size = self.intrinsics.size;
        (f64::from(size.width), f64::from(size.height))
    }

    /// Returns the horizontal field of view of a centred image in radians.
    #[must_use]
    pub fn hfov(&self) -> f64 {
        2.0 * (self.size().0 / 2.0 / self.intrinsics.fx).atan()
    }
}

impl Description {
    /// Describes a twin.
    ///
    /// # Errors
    /// Returns an error if a name of the attachment is not an identifier.
    pub fn new(catalog: &Catalog, twin: &Twin, attachment: &Attachment) -> Result<Self, RobotError> {
        check_name("name", &attachment.name)?;
        if let Some(parent) = &attachment.parent {
            check_name("parent", parent)?;
            if *parent == attachment.name {
                return Err(RobotError::Name {
                    option: "parent",
                    name: parent.clone(),
                    problem: "is the name of the device; choose another",
                });
            }
        }
        let mut findings = Vec::new();
        let cameras = twin
            .cameras
            .iter()
            .map(|camera| frame(camera, &mut findings))
            .collect();
        let device = &twin.device;
        Ok(Self {
            name: attachment.name.clone(),
            id: device.id.clone(),
            title: match &twin.origin {
                oaktwin_catalog::Origin::Nominal => device.name.clone(),
                oaktwin_catalog::Origin::Calibration { file_name, .. } => {
                    format!("{}, calibrated by {file_name}", device.name)
                }
            },
            parent: attachment.parent.clone(),
            parent_from_body: attachment.parent_from_body(&device.body),
            housing: Housing::new(twin),
            cameras,
            depth_sensors: depth_sensors(twin),
            imu: imu(catalog, twin, &mut findings),
            findings,
        })
    }

    /// Returns the cameras, including the depth sensors'.
    pub(crate) fn all_cameras(&self) -> impl Iterator<Item = &CameraFrame> {
        let depths = self.depth_sensors.iter().map(|sensor| &sensor.camera);
        self.cameras.iter().chain(depths)
    }

    /// Returns the name of the file of a visible mesh.
    pub(crate) fn visual_file(&self, visual: &Visual) -> String {
        format!("{}_{}.obj", self.id, visual.name)
    }

    /// Returns the name of the file of the collider.
    pub(crate) fn collider_file(&self) -> String {
        format!("{}_collider.obj", self.id)
    }
}

fn check_name(option: &'static str, name: &str) -> Result<(), RobotError> {
    let problem = if name.is_empty() {
        "is empty; use letters, digits and underscores"
    } else if !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        "does not begin with a letter; use letters, digits and underscores"
    } else if !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
        "is not an identifier; use letters, digits and underscores"
    } else {
        return Ok(());
    };
    Err(RobotError::Name {
        option,
        name: name.to_owned(),
        problem,
    })
}

/// Returns a camera without the distortion of its lens, which simulators lack.
fn frame(camera: &TwinCamera, findings: &mut Vec<Finding>) -> CameraFrame {
    if camera.lens != LensModel::Pinhole {
        findings.push(Finding::new(
            "lens-ignored",
            Level::Warning,
            camera.spec.role.to_string(),
            "the distortion of the lens is left out: the simulated camera is a pinhole with the same intrinsics".to_owned(),
            "render with `oaktwin render` if images with distortion are needed",
        ));
    }
    CameraFrame {
        role: camera.spec.role.to_string(),
        intrinsics: camera.intrinsics,
        pitch: camera.pixel_size_um * 1e-6,
        body_from_optical: camera.body_from_camera,
        clip: camera.spec.clipping_range_m,
    }
}

fn depth_sensors(twin: &Twin) -> Vec<DepthFrame> {
    let frames = twin.depth_sensors.iter().filter_map(|sensor| {
        let camera = twin.depth_camera(sensor)?;
        Some(DepthFrame {
            camera: CameraFrame {
                role: twin.depth_role(sensor),
                ..frame(&camera, &mut Vec::new())
            },
            range: (sensor.spec.min_distance_m, sensor.spec.max_distance_m),
        })
    });
    frames.collect()
}

fn imu(catalog: &Catalog, twin: &Twin, findings: &mut Vec<Finding>) -> Option<ImuFrame> {
    let Some(body_from_imu) = twin.body_from_imu else {
        findings.push(Finding::new(
            "no-imu",
            Level::Note,
            "imu",
            "the model has no inertial unit whose pose is known; its frame is left out".to_owned(),
            "",
        ));
        return None;
    };
    let part = catalog.inertial_part_of(&twin.device);
    Some(ImuFrame {
        body_from_imu,
        accelerometer: part.and_then(InertialPart::accelerometer_noise),
        gyroscope: part.and_then(InertialPart::gyroscope_noise),
    })
}

impl Housing {
    fn new(twin: &Twin) -> Self {
        let spec = &twin.device.body;
        let [width, height, depth] = spec.dimensions_mm.map(|mm| mm * 1e-3);
        let size = DVec3::new(depth, width, height);
        let mass = spec.mass_g * 1e-3;
        let squares = size * size;
        let model = body::body(twin);
        let visuals = model.materials.iter().map(|material| {
            let mut mesh = HousingMesh::default();
            for part in model.parts.iter().filter(|part| part.material == material.name) {
                mesh.add(part);
            }
            Visual {
                name: material.name,
                color: material.diffuse,
                metallic: material.metallic,
                roughness: material.roughness,
                mesh,
            }
        });
        let visuals = visuals.collect();
        let mut collider = HousingMesh::default();
        collider.add(&model.collider);
        Self {
            visuals,
            collider,
            centre: DVec3::from(spec.front_mm) * 1e-3 - DVec3::X * (depth / 2.0),
            size,
            mass,
            inertia: DVec3::new(
                squares.y + squares.z,
                squares.x + squares.z,
                squares.x + squares.y,
            ) * (mass / 12.0),
        }
    }
}

/// Returns roll, pitch and yaw: the rotation is that about z by yaw, times that about y by pitch, times that about x by roll.
pub(crate) fn roll_pitch_yaw(rotation: &DMat3) -> DVec3 {
    let m = rotation;
    let pitch = (-m.x_axis.z).atan2(m.x_axis.x.hypot(m.x_axis.y));
    if m.x_axis.x.hypot(m.x_axis.y) < 1e-9 {
        // Only the sum or the difference of roll and yaw is determined.
        let roll = (-m.z_axis.y).atan2(m.y_axis.y);
        return DVec3::new(roll, pitch, 0.0);
    }
    DVec3::new(m.y_axis.z.atan2(m.z_axis.z), pitch, m.x_axis.y.atan2(m.x_axis.x))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_give_the_rotation() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let angles = [-3.0, -quarter, -0.4, 0.0, 0.7, quarter, 2.0];
        for roll in angles {
            for pitch in angles {
                for yaw in angles {
                    let of = |roll, pitch, yaw| {
                        DMat3::from_rotation_z(yaw)
                            * DMat3::from_rotation_y(pitch)
                            * DMat3::from_rotation_x(roll)
                    };
                    let rotation = of(roll, pitch, yaw);
                    let found = roll_pitch_yaw(&rotation);
                    let again = of(found.x, found.y, found.z);
                    assert!(again.abs_diff_eq(rotation, 1e-8), "{roll} {pitch} {yaw}: {found}");
                }
            }
        }
        let optical = roll_pitch_yaw(&CAMERA_FROM_OPTICAL);
        assert!((optical - DVec3::new(-quarter, 0.0, -quarter)).length() < 1e-12);
    }
}
