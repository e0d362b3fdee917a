use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::{MeasuredUnitArgs, SensorArgs, ThreadArgs};

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    after_help = "A board of random grey squares is rendered at each distance, perpendicular, and the sensor looks at its \
    middle: of ten captures drop what is invalid and the top and bottom 5 %, take the median, and hold the mean of those \
    against the true distance. By default 200 devices are measured (25 by stereo-matching, which sees the board as a rendered pair), each with the calibration error of its seed, and their \
    median counts, as the vendor's figures are those of the median device.\n\n\
    Time of flight is measured indoors; outdoors with --param ambient=outdoor.\n\n\
    Measured errors are CSV with the columns distance_m and depth_error_percent.\n\n\
    Ends with 1 where the error is outside the published accuracy at some distance."
)]
pub(crate) struct AccuracyArgs {
    /// The model
    pub(crate) model: String,

    /// The depth sensor by kind (stereo, tof) or prim; by default the device's own
    #[arg(long, value_name = "KIND|PRIM")]
    pub(crate) sensor: Option<String>,

    /// The true distances, metres: numbers apart by commas, and ranges FROM:TO:STEP. By default about twenty, from the
    /// nearest that can be measured to the end of the published accuracy
    #[arg(long, value_name = "LIST", allow_hyphen_values = true)]
    pub(crate) distances: Option<String>,

    /// How many devices; the first have the seeds 0, 1, 2, … 200 by default where devices differ, 25 with
    /// stereo-matching
    #[arg(long, value_name = "N", conflicts_with = "device_seed")]
    pub(crate) devices: Option<u32>,

    /// Images of each board
    #[arg(long, value_name = "N", default_value_t = oaktwin::accuracy::CAPTURES)]
    pub(crate) captures: u32,

    /// The side of the region in the middle that is measured, percent of the image's
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0 * oaktwin::accuracy::REGION, allow_negative_numbers = true)]
    pub(crate) region: f64,

    #[command(flatten)]
    pub(crate) engine: SensorArgs,

    #[command(flatten, next_help_heading = "A measured unit")]
    pub(crate) unit: MeasuredUnitArgs,

    /// Its measured errors to lay over the curve: CSV with columns for the distance in metres and the error in percent
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "A measured unit")]
    pub(crate) measured: Option<PathBuf>,

    /// Compare from this distance on, metres
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 0.0,
        allow_negative_numbers = true,
        requires = "measured",
        help_heading = "A measured unit"
    )]
    pub(crate) from: f64,

    /// Draw error over distance, with the published accuracy: svg or png
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "Output")]
    pub(crate) plot: Option<PathBuf>,

    #[command(flatten, next_help_heading = "Output")]
    pub(crate) threads: ThreadArgs,

    /// Print JSON
    #[arg(long, help_heading = "Output")]
    pub(crate) json: bool,
}
