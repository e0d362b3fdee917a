use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::calibration::Socket;
use oaktwin::depth::preset::Platform;
use oaktwin::depth::rectify::Method;

use super::choice::parser;
use super::{AlignArgs, MatcherArgs, OutputArgs, ThreadArgs, UnitArgs};

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    mut_arg("parameters", |arg| arg.help(
        "Set a parameter of the matcher, listed by `oaktwin params stereo-matching`; repeatable"
    )),
    mut_arg("annotators", |arg| arg.help(
        "More outputs, comma-separated, such as disparity,confidence"
    ).long_help(
        "More outputs, comma-separated:\n\n\
         disparity (px), confidence (255 is highest), rectified (both images), depth_sensor_point_cloud_position, \
         depth_sensor_point_cloud_color"
    )),
    after_help = "Images are PNG, JPEG or NPY: 8-bit grey, 16-bit grey with 10-bit values, or colours, which become grey. In \
    two folders, files whose names are equal except for the words left and right are a pair; one folder may contain both. \
    Pairs whose names differ only in their number are a sequence, processed in order by temporal filters.\n\n\
    The output is depth_sensor_distance as NPY, float32 metres of the rectified left image, 0 where nothing was measured, \
    and the outputs of --annotators.\n\n\
    The exit code is 1 for unsuitable images: left and right swapped, a vertical offset, too little texture, saturated, or \
    narrower than the disparity search."
)]
pub(crate) struct StereoArgs {
    /// The left image, or a folder of left images
    #[arg(value_name = "LEFT", value_hint = ValueHint::AnyPath)]
    pub(crate) left: PathBuf,

    /// The right image, or a folder of right images
    #[arg(value_name = "RIGHT", value_hint = ValueHint::AnyPath)]
    pub(crate) right: PathBuf,

    /// The output folder
    #[arg(short, long, value_name = "DIR", default_value = "oaktwin-stereo", value_hint = ValueHint::DirPath)]
    pub(crate) output: PathBuf,

    /// The model of the cameras [default: from the calibration, which need not be of a model]
    #[arg(long, help_heading = "Cameras")]
    pub(crate) model: Option<String>,

    #[command(flatten, next_help_heading = "Cameras")]
    pub(crate) unit: UnitArgs,

    #[arg(
        long,
        help = "The sockets of a rig's pair, such as CAM_B CAM_C [default: from the calibration]",
        num_args = 2,
        value_names = ["LEFT", "RIGHT"],
        value_parser = socket,
        requires = "calibration",
        conflicts_with_all = ["model", "sensor"],
        help_heading = "Cameras"
    )]
    pub(crate) pair: Option<Vec<Socket>>,

    /// The prim of the depth sensor whose pair took the images [default: the model's first pair]
    #[arg(
        long,
        value_name = "PRIM",
        conflicts_with_all = ["fx", "hfov"],
        help_heading = "Cameras"
    )]
    pub(crate) sensor: Option<String>,

    /// The focal length of another maker's rectified pair, px
    #[arg(
        long,
        value_name = "F",
        conflicts_with_all = ["hfov", "model", "calibration"],
        requires = "baseline",
        help_heading = "Cameras"
    )]
    pub(crate) fx: Option<f64>,

    /// The horizontal field of view of another maker's rectified pair, degrees
    #[arg(
        long,
        value_name = "D",
        conflicts_with_all = ["model", "calibration"],
        requires = "baseline",
        help_heading = "Cameras"
    )]
    pub(crate) hfov: Option<f64>,

    /// The baseline of another maker's rectified pair, metres
    #[arg(
        long,
        value_name = "METRES",
        conflicts_with_all = ["model", "calibration"],
        help_heading = "Cameras"
    )]
    pub(crate) baseline: Option<f64>,

    /// Treat the images as raw [default: with a calibration or the fisheye lens]
    #[arg(long, conflicts_with_all = ["rectified", "fx", "hfov"], help_heading = "Cameras")]
    pub(crate) raw: bool,

    /// Treat the images as rectified [default: without a calibration and the fisheye lens]
    #[arg(long, help_heading = "Cameras")]
    pub(crate) rectified: bool,

    /// The rectification of raw images [default: the device's]
    #[arg(long, value_parser = parser::<Method>(), conflicts_with_all = ["rectified", "fx", "hfov"], help_heading = "Cameras")]
    pub(crate) rectify: Option<Method>,

    /// The processor whose defaults and presets apply [default: the device's, else rvc2]
    #[arg(long, value_parser = parser::<Platform>(), help_heading = "Depth sensor")]
    pub(crate) platform: Option<Platform>,

    #[command(flatten)]
    pub(crate) settings: MatcherArgs,

    #[command(flatten)]
    pub(crate) align: AlignArgs,

    #[command(flatten)]
    pub(crate) outputs: OutputArgs,

    #[arg(long, hide = true)]
    pub(crate) disparity: bool,

    #[arg(long, hide = true)]
    pub(crate) confidence: bool,

    #[arg(long, hide = true)]
    pub(crate) rectified_images: bool,

    #[command(flatten, next_help_heading = "Execution")]
    pub(crate) threads: ThreadArgs,

    /// Print the result as JSON
    #[arg(long, help_heading = "Execution")]
    pub(crate) json: bool,
}

fn socket(name: &str) -> Result<Socket, String> {
    Socket::from_name(name).ok_or_else(|| "use CAM_A to CAM_J".to_owned())
}
