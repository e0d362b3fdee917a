use oaktwin_catalog::Twin;

use super::{AssetOptions, IMU, describe, pose};
use crate::text::PrimSpec;

/// Creates the inertial sensor, if its pose is known. It has Isaac Sim's schema; other tools see a prim of unknown type.
pub(super) fn prim(twin: &Twin, options: &AssetOptions) -> Option<PrimSpec> {
    let (imu, pose) = (twin.device.imu.as_ref()?, twin.body_from_imu.as_ref()?);
    let mut prim = PrimSpec::def("IsaacImuSensor", IMU).documented(describe::imu(imu, options));
    pose::set(&mut prim, pose);
    Some(prim)
}
