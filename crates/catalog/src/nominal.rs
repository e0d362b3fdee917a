use std::collections::BTreeMap;

use oaktwin_camera::math::{DMat3, DVec3};
use oaktwin_camera::{Axes, Intrinsics, LensModel, RigidTransform};

use crate::{Catalog, Device, Origin, Twin, TwinCamera, TwinDepthSensor, UnknownModel};

const M_PER_MM: f64 = 1e-3;

impl Catalog {
    /// Returns the [nominal](Self::nominal) twins of all devices in order.
    #[must_use]
    pub fn nominals(&self) -> Vec<Twin> {
        self.devices().iter().map(|device| self.nominal(device)).collect()
    }

    /// Returns the [nominal](Self::nominal) twin of the [device](Self::device) with this name.
    ///
    /// # Errors
    /// Returns an error with the nearest names if no device has this name.
    pub fn twin(&self, name: &str) -> Result<Twin, UnknownModel> {
        Ok(self.nominal(self.device(name)?))
    }

    /// Returns the nominal twin of a device: each camera is a centred pinhole with its field of view, at its sensor's used
    /// resolution and nominal position, facing +x of the body.
    ///
    /// # Panics
    /// Panics if the catalog does not contain a sensor of the device; it contains the sensors of its own devices.
    #[must_use]
    pub fn nominal(&self, device: &Device) -> Twin {
        let cameras = device
            .cameras
            .iter()
            .map(|spec| {
                #[expect(clippy::expect_used, reason = "checked when the device was loaded")]
                let sensor = self
                    .sensor(&spec.sensor)
                    .expect("the sensors of a catalog's devices are in it");
                TwinCamera {
                    spec: spec.clone(),
                    pixel_size_um: sensor.pixel_size_um,
                    is_monochrome: sensor.monochrome,
                    readout_s: sensor.readout_s(),
                    intrinsics: Intrinsics::from_hfov(sensor.used_size(), spec.hfov_deg.to_radians()),
                    lens: LensModel::Pinhole,
                    body_from_camera: RigidTransform::new(
                        forward(spec.pitch_deg),
                        DVec3::from(spec.position_mm) * M_PER_MM,
                    ),
                }
            })
            .collect();
        Twin {
            cameras,
            depth_sensors: device
                .depth_sensors
                .iter()
                .map(|spec| TwinDepthSensor {
                    focal_length_px: spec.focal_length_px,
                    spec: spec.clone(),
                })
                .collect(),
            body_from_imu: device.imu.as_ref().map(|imu| {
                RigidTransform::new(
                    DMat3::from_cols_array_2d(&imu.rotation).transpose(),
                    DVec3::from(imu.position_mm) * M_PER_MM,
                )
            }),
            design_baselines_m: BTreeMap::new(),
            origin: Origin::Nominal,
            device: device.clone(),
        }
    }
}

/// Returns the rotation from the optical frame of a camera that looks forward, and down by an angle, to the body frame.
fn forward(pitch_deg: f64) -> DMat3 {
    let forward = Axes::Ros.rotation_from(Axes::OpenCv);
    if pitch_deg == 0.0 {
        return forward;
    }
    DMat3::from_rotation_y(pitch_deg.to_radians()) * forward
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{DepthKind, ImuFrame, Role};

    #[test]
    fn depth_focal_lengths_are_the_rounded_fx_of_their_camera() {
        let catalog = Catalog::builtin();
        for device in catalog.devices() {
            let twin = catalog.nominal(device);
            for depth in &twin.depth_sensors {
                let fx = twin.camera(depth.spec.camera).unwrap().intrinsics.fx;
                assert_eq!(depth.focal_length_px, fx.round(), "{}", device.id);
            }
        }
    }

    #[test]
    fn cameras_have_their_nominal_poses() {
        let catalog = Catalog::builtin();
        for device in catalog.devices() {
            let twin = catalog.nominal(device);
            let at = |role| twin.camera(role).map(|c| c.body_from_camera.translation);
            if let (Some(left), Some(right)) = (at(Role::Left), at(Role::Right)) {
                let baseline_m = device.stereo_baseline_mm.unwrap() * 1e-3;
                assert!(((left - right) - DVec3::new(0.0, baseline_m, 0.0)).length() < 1e-12);
                assert!((left + right).length() < 1e-15, "the origin is midway");
            } else {
                assert_eq!(device.stereo_baseline_mm, None);
                let origin = at(Role::Tof).or_else(|| at(Role::Rgb));
                assert_eq!(origin, Some(DVec3::ZERO), "{}", device.id);
            }
            for camera in twin.cameras.iter().filter(|camera| camera.spec.pitch_deg == 0.0) {
                let body_from_camera = camera.body_from_camera.rotation;
                assert_eq!(body_from_camera * DVec3::Z, DVec3::X, "forward");
                assert_eq!(body_from_camera * DVec3::NEG_Y, DVec3::Z, "up");
            }
        }
    }

    /// Compares with the poses in the board files: centimetres, in the frame of the camera on socket 0 (x right, y down,
    /// z forward), converted independently of the catalog's numbers.
    #[test]
    fn imu_poses_match_the_board_files() {
        let bno = [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
        let lsm = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let sr = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        for (model, rotation, cm) in [
            ("oak_d_pro_poe", bno, [4.0, 2.0264, -0.2]),
            ("oak_d_pro_w_poe", bno, [4.0, 2.0264, -0.2]),
            ("oak4_d", lsm, [-4.4032, -0.2697, -0.2]),
            ("oak4_d_wide", lsm, [-4.4032, -0.2697, -0.2]),
            ("oak_d_tof", sr, [0.8091, 0.849, -0.2]),
        ] {
            let catalog = Catalog::builtin();
            let device = catalog.device(model).unwrap().with_imu_frame(ImuFrame::BoardFile);
            let twin = catalog.nominal(&device);
            let cam_a = twin.cameras.iter().find(|c| c.spec.socket == Some(0)).unwrap();
            let camera_from_imu = RigidTransform::new(
                DMat3::from_cols_array_2d(&rotation).transpose(),
                DVec3::from(cm) * 1e-2,
            );
            let expected = cam_a.body_from_camera * camera_from_imu;
            let body_from_imu = twin.body_from_imu.unwrap();
            assert!(body_from_imu.orthonormality_error() < 1e-15);
            assert!(
                (body_from_imu.translation - expected.translation).length() < 1e-9,
                "{model}"
            );
            assert_eq!(body_from_imu.rotation, expected.rotation, "{model}");
        }
    }

    /// Positions from the device's board file in the time-of-flight camera's frame: right at x = -1.7382 cm, left 2 cm further.
    #[test]
    fn the_time_of_flight_camera_is_right_of_the_stereo_pair() {
        let catalog = Catalog::builtin();
        let twin = catalog.nominal(catalog.device("oak_d_tof").unwrap());
        let tof = twin.camera(Role::Tof).unwrap().body_from_camera;
        for (role, x_m) in [(Role::Right, -0.017_382), (Role::Left, -0.037_382)] {
            let in_tof = tof
                .inverse()
                .apply(twin.camera(role).unwrap().body_from_camera.translation);
            assert!((in_tof - DVec3::new(x_m, 0.0, 0.0)).length() < 1e-12);
        }
        assert_eq!(twin.depth_sensors[1].spec.kind, DepthKind::Tof);
    }
}
