use oaktwin_catalog::Twin;

use super::{AssetOptions, IMU, describe, pose};
use crate::text::Prim;

/// Creates the inertial sensor, which has Isaac Sim's schema; other tools see a prim of unknown type.
pub(super) fn prim(twin: &Twin, options: &AssetOptions) -> Prim {
    let mut prim = Prim::def("IsaacImuSensor", IMU).documented(describe::imu(twin, options));
    pose::set(&mut prim, &twin.body_from_imu);
    prim
}
