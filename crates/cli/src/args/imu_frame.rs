use clap::Args;
use oaktwin::catalog::ImuFrame;

use super::choice::parser;

/// The axes of the inertial unit.
#[derive(Args, Debug)]
pub(crate) struct ImuFrameArgs {
    /// The source of the axes of the inertial unit, about which sources disagree [default: driver]
    #[arg(long, value_parser = parser::<ImuFrame>())]
    pub(crate) imu_frame: Option<ImuFrame>,
}
