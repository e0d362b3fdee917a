use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::depth::parameters::choice;
use oaktwin::latency::LONGEST_S;

use super::choice::parser;
use super::{MeasuredUnitArgs, SensorArgs, ThreadArgs};

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    mut_arg("seed", |arg| arg.hide(true)),
    mut_arg("device_seed", |arg| arg.hide(true)),
    mut_arg("drift", |arg| arg.hide(true)),
    mut_arg("filters", |arg| arg.hide(true)),
    mut_arg("isaac", |arg| arg.hide(true)),
    mut_arg("stereo_width", |arg| arg.help(
        "The width of the matcher's images: 1280 at 800P, 640 at 480P and 400P"
    )),
    after_help = "RECORDING is one of:\n\
    - A folder of depth images of a flat target, perpendicular to the camera, with a table distances.csv whose columns are \
    file (an image, an NPY batch, or a folder of images) and distance_m. Without true distances, only the noise is fitted.\n\
    - A folder in the layout of Replicator's BasicWriter with distance_to_image_plane and depth_sensor_distance.\n\
    - A CSV file of errors with the columns distance_m and depth_error_percent. Only bias, pixel locking and focal length, \
    or bias and wiggling, are fitted.\n\n\
    Depth is along the optical axis, as NPY or NPZ in metres or as 16-bit PNG, TIFF, EXR or PFM. Record without post filters, several \
    frames at each distance. Choose distances that cover all phases of a pixel of disparity, or for time of flight, of \
    the wiggling error, which repeats about every 0.4 m.\n\n\
    With --latency, RECORDING is two CSV files with the columns time_s and position: first the camera's, with the time at which \
    each image arrived at the host and the position of an edge in it, in pixels, then a reference's, such as an encoder of the axis that \
    moves the edge, on the same clock and in any unit. Move the edge irregularly for 10 s or more, and sample the reference densely. \
    The result is the time from the middle of an exposure until its image arrives, for Stream in Python and bridge --latency.\n\n\
    PARAMS.toml is read by --params of sense, accuracy and render.\n\n\
    The exit code is 1 if a parameter cannot be fitted or the recording has findings."
)]
pub(crate) struct FitArgs {
    /// Folders of depth images, tables of distances, or a curve of errors
    #[arg(required = true, value_name = "RECORDING", value_hint = ValueHint::AnyPath)]
    pub(crate) recordings: Vec<PathBuf>,

    /// The model
    #[arg(long, required_unless_present = "latency")]
    pub(crate) model: Option<String>,

    /// Estimate the latency: the RECORDINGs are two CSV files of times and positions
    #[arg(long, conflicts_with_all = ["model", "output", "plot"])]
    pub(crate) latency: bool,

    /// The longest latency that is searched, in seconds
    #[arg(long, value_name = "SECONDS", default_value_t = LONGEST_S, requires = "latency")]
    pub(crate) longest: f64,

    /// Write the parameters to this file
    #[arg(short, long, value_name = "PARAMS.toml", value_hint = ValueHint::FilePath)]
    pub(crate) output: Option<PathBuf>,

    /// The depth sensor: stereo, tof or a prim [default: the engine's, else time of flight if present]
    #[arg(long, value_name = "KIND|PRIM")]
    pub(crate) sensor: Option<String>,

    /// Also fit the focal length, which converts distances to disparities
    #[arg(long, value_parser = parser::<Also>(), value_name = "WHAT")]
    pub(crate) fit: Vec<Also>,

    /// Ignore errors at distances below this, in metres
    #[arg(long, value_name = "METRES", default_value_t = 0.0)]
    pub(crate) from: f64,

    /// The side of the measured central region, in percent of the image's side
    #[arg(long, value_name = "PERCENT", default_value_t = 100.0 * oaktwin::accuracy::REGION)]
    pub(crate) region: f64,

    /// Metres per integer depth unit
    #[arg(long, value_name = "METRES", default_value_t = 0.001)]
    pub(crate) depth_scale: f64,

    #[command(flatten)]
    pub(crate) engine: SensorArgs,

    #[command(flatten, next_help_heading = "The recorded unit")]
    pub(crate) unit: MeasuredUnitArgs,

    /// Draw the errors, the fitted curve and the residuals as SVG or PNG
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "Output")]
    pub(crate) plot: Option<PathBuf>,

    #[command(flatten, next_help_heading = "Output")]
    pub(crate) threads: ThreadArgs,

    /// Print the result as JSON
    #[arg(long, help_heading = "Output")]
    pub(crate) json: bool,
}

choice! {
    /// A parameter of the optics to fit as well.
    Also {
        /// The focal length.
        Focal = "focal",
    }
}
