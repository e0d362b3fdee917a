use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use oaktwin::depth::preset::Platform;
use oaktwin::depth::rectify::Method;
use oaktwin::depth::stereo_matching;

use super::{OutputArgs, SettingsArgs, ThreadArgs, UnitArgs};

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    mut_arg("parameters", |arg| arg.long_help(format!(
        "Set a parameter of the matcher by its name, DepthAI's where it has one; repeatable: {}",
        stereo_matching::NAMES.join(", ")
    ))),
    mut_arg("annotators", |arg| arg.help(
        "Comma-separated outputs beside depth_sensor_distance: disparity (px), confidence (255 = highest), rectified (both \
         images), depth_sensor_point_cloud_position, depth_sensor_point_cloud_color"
    )),
    after_help = "Images are PNG, JPEG or NPY; grey of 8 bits, or of 16, which are those of a camera of 10; colours become \
    grey. In two folders those with the same names but for the words left and right are a pair, and one folder may hold \
    both; pairs whose names differ in their number alone are a sequence, seen in its order by filters that remember.\n\n\
    Written are depth_sensor_distance NPY, float32 metres of the rectified left image, 0 where nothing was measured, and \
    what else is asked for.\n\n\
    Ends with 1 where something is wrong with the images: left and right swapped, a vertical offset, nothing to match, too \
    bright, or narrower than the search."
)]
pub(crate) struct StereoArgs {
    /// The left image, or a folder of them
    #[arg(value_name = "LEFT", value_hint = ValueHint::AnyPath)]
    pub(crate) left: PathBuf,

    /// The right image, or a folder of them
    #[arg(value_name = "RIGHT", value_hint = ValueHint::AnyPath)]
    pub(crate) right: PathBuf,

    /// The folder to write into
    #[arg(short, long, value_name = "DIR", default_value = "oaktwin-stereo", value_hint = ValueHint::DirPath)]
    pub(crate) output: PathBuf,

    /// The model whose cameras they are; by default the one that the calibration's product name says
    #[arg(long, help_heading = "The cameras")]
    pub(crate) model: Option<String>,

    #[command(flatten, next_help_heading = "The cameras")]
    pub(crate) unit: UnitArgs,

    /// The images' focal length, px, of any rectified pair
    #[arg(
        long,
        value_name = "F",
        allow_negative_numbers = true,
        conflicts_with_all = ["hfov", "model", "calibration"],
        requires = "baseline",
        help_heading = "The cameras"
    )]
    pub(crate) fx: Option<f64>,

    /// The images' horizontal field of view, degrees, of any rectified pair
    #[arg(
        long,
        value_name = "D",
        allow_negative_numbers = true,
        conflicts_with_all = ["model", "calibration"],
        requires = "baseline",
        help_heading = "The cameras"
    )]
    pub(crate) hfov: Option<f64>,

    /// Between the two cameras, metres
    #[arg(
        long,
        value_name = "METRES",
        allow_negative_numbers = true,
        conflicts_with_all = ["model", "calibration"],
        help_heading = "The cameras"
    )]
    pub(crate) baseline: Option<f64>,

    /// The images are as the cameras take them (the default with a calibration, or the fisheye lens)
    #[arg(long, conflicts_with_all = ["rectified", "fx", "hfov"], help_heading = "The cameras")]
    pub(crate) raw: bool,

    /// The images are rectified (the default without)
    #[arg(long, help_heading = "The cameras")]
    pub(crate) rectified: bool,

    /// How raw images are rectified; by default as the device does it
    #[arg(long, value_enum, conflicts_with_all = ["rectified", "fx", "hfov"], help_heading = "The cameras")]
    pub(crate) rectify: Option<RectifyMethod>,

    /// The processor whose defaults and presets hold; by default the device's, else RVC2
    #[arg(long, value_enum, help_heading = "The depth sensor")]
    pub(crate) platform: Option<StereoPlatform>,

    #[command(flatten)]
    pub(crate) settings: SettingsArgs,

    #[command(flatten)]
    pub(crate) outputs: OutputArgs,

    #[arg(long, hide = true)]
    pub(crate) disparity: bool,

    #[arg(long, hide = true)]
    pub(crate) confidence: bool,

    #[arg(long, hide = true)]
    pub(crate) rectified_images: bool,

    #[command(flatten, next_help_heading = "How")]
    pub(crate) threads: ThreadArgs,

    /// Print what was written as JSON
    #[arg(long, help_heading = "How")]
    pub(crate) json: bool,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum RectifyMethod {
    /// A homography up to 85° of view, a mesh above: RVC2
    Auto,
    /// A 3x3 matrix, which leaves the lens's distortion
    Homography,
    /// A position every 16 pixels
    Mesh,
    /// A position for each pixel: RVC4
    Full,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StereoPlatform {
    Rvc2,
    Rvc4,
}

impl From<RectifyMethod> for Method {
    fn from(method: RectifyMethod) -> Self {
        match method {
            RectifyMethod::Auto => Self::Auto,
            RectifyMethod::Homography => Self::Homography,
            RectifyMethod::Mesh => Self::Mesh,
            RectifyMethod::Full => Self::Full,
        }
    }
}

impl From<StereoPlatform> for Platform {
    fn from(platform: StereoPlatform) -> Self {
        match platform {
            StereoPlatform::Rvc2 => Self::Rvc2,
            StereoPlatform::Rvc4 => Self::Rvc4,
        }
    }
}
