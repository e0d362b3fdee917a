use std::path::PathBuf;

use clap::{Args, ValueHint};

/// The options of the inertial sensor.
#[derive(Args, Debug)]
pub(crate) struct ImuArgs {
    /// Write the model's inertial sensor along the trajectory as EuRoC CSV, and into the recording
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) imu: Option<PathBuf>,

    /// The samples per second; by default 400, or what the part reports if that is less
    #[arg(long, value_name = "HZ", requires = "imu", allow_negative_numbers = true)]
    pub(crate) imu_rate: Option<f64>,

    /// Simulate this inertial part, such as BMI270, instead of the model's
    #[arg(long, value_name = "PART", requires = "imu")]
    pub(crate) imu_part: Option<String>,
}
