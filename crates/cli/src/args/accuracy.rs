use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::{MeasuredUnitArgs, SensorArgs, ThreadArgs};

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    after_help = "The sensor captures a board of random grey squares, perpendicular to the camera, ten times at each \
    distance. In the central region of each capture, invalid pixels and the top and bottom 5 % are dropped; the mean of \
    the medians is compared with the true distance. Each device has the calibration error of its seed. The result is the \
    median of their errors, because the vendor publishes the error of the median device.\n\n\
    Time of flight is measured indoors, or outdoors with --param ambient=outdoor.\n\n\
    Measured errors are CSV with the columns distance_m and depth_error_percent.\n\n\
    The exit code is 1 if the error is outside the published accuracy at any distance."
)]
pub(crate) struct AccuracyArgs {
    /// The model
    pub(crate) model: String,

    /// The depth sensor: stereo, tof or a prim [default: time of flight if the model has it]
    #[arg(long, value_name = "KIND|PRIM")]
    pub(crate) sensor: Option<String>,

    /// The true distances in metres [default: about 20, up to the end of the published accuracy]
    ///
    /// A comma-separated list of numbers and ranges FROM:TO:STEP.
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub(crate) distances: Option<String>,

    /// The number of devices, with the seeds 0, 1, 2, … [default: 200, or 25 with stereo-matching]
    #[arg(long, value_name = "N", conflicts_with = "device_seed")]
    pub(crate) devices: Option<u32>,

    /// Measure units whose cameras vary like factory calibrations, and print the range of 5 to 95 %
    ///
    /// With --drift, its values are the standard deviations of the units' drifts.
    #[arg(long)]
    pub(crate) population: bool,

    /// The number of captures at each distance
    #[arg(long, value_name = "N", default_value_t = oaktwin::accuracy::CAPTURES)]
    pub(crate) captures: u32,

    /// The side of the measured central region, in percent of the image's side
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0 * oaktwin::accuracy::REGION)]
    pub(crate) region: f64,

    #[command(flatten)]
    pub(crate) engine: SensorArgs,

    #[command(flatten, next_help_heading = "A measured unit")]
    pub(crate) unit: MeasuredUnitArgs,

    /// Compare with measured errors: CSV with the columns `distance_m` and `depth_error_percent`
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "A measured unit")]
    pub(crate) measured: Option<PathBuf>,

    /// Ignore measured errors at distances below this, in metres
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 0.0,
        requires = "measured",
        help_heading = "A measured unit"
    )]
    pub(crate) from: f64,

    /// Draw the error over distance and the published accuracy as SVG or PNG
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "Output")]
    pub(crate) plot: Option<PathBuf>,

    #[command(flatten, next_help_heading = "Output")]
    pub(crate) threads: ThreadArgs,

    /// Print the result as JSON
    #[arg(long, help_heading = "Output")]
    pub(crate) json: bool,
}
