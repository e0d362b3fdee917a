use std::path::PathBuf;

use clap::{Args, ValueHint};

use super::SensorArgs;

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    after_help = "A board of random grey squares is rendered at each distance, perpendicular, and the sensor looks at its \
    middle: of ten captures drop what is invalid and the top and bottom 5 %, take the median, and hold the mean of those \
    against the true distance. By default 200 devices are measured (25 by stereo-matching, which sees the board as a rendered pair), each with the calibration error of its seed, and their \
    median counts, as the vendor's figures are those of the median device.\n\n\
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

    /// The DepthAI calibration (JSON) of one unit: its optics
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "A measured unit")]
    pub(crate) calibration: Option<PathBuf>,

    /// Use a calibration in spite of the errors found in it
    #[arg(long, requires = "calibration", help_heading = "A measured unit")]
    pub(crate) force: bool,

    /// Its focal length, pixels of the width below
    #[arg(
        long,
        value_name = "F",
        allow_negative_numbers = true,
        help_heading = "A measured unit"
    )]
    pub(crate) focal_px: Option<f64>,

    /// The width of its images: 1280 at 800P, 640 at 480P and 400P
    #[arg(long, value_name = "W", help_heading = "A measured unit")]
    pub(crate) stereo_width: Option<u32>,

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

    /// Threads; by default one a core
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u32).range(1..=1024),
        help_heading = "Output"
    )]
    pub(crate) threads: Option<u32>,

    /// Print JSON
    #[arg(long, help_heading = "Output")]
    pub(crate) json: bool,
}
