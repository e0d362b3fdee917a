use oaktwin_catalog::Twin;

use super::{AssetOptions, IMU, describe, pose};
use crate::text::Prim;

/// The inertial sensor. Its schema is Isaac Sim's; other tools see a prim of a type they do not know.
pub(super) fn prim(twin: &Twin, options: &AssetOptions) -> Prim {
    let mut prim = Prim::def("IsaacImuSensor", IMU).documented(describe::imu(twin, options));
    pose::set(&mut prim, &twin.body_from_imu);
    prim
}
