use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::ImuFrameArgs;

/// The options of the inertial sensor.
#[derive(Args, Debug)]
pub(crate) struct ImuArgs {
    /// Write the inertial sensor's samples along the trajectory as EuRoC CSV, and into the recording
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) imu: Option<PathBuf>,

    /// The samples per second [default: 400, or the part's maximum if lower]
    #[arg(long, value_name = "HZ", requires = "imu")]
    pub(crate) imu_rate: Option<f64>,

    /// Simulate this inertial part, such as BMI270 [default: the model's]
    #[arg(long, value_name = "PART", requires = "imu")]
    pub(crate) imu_part: Option<String>,

    #[command(flatten)]
    pub(crate) axes: ImuFrameArgs,
}
