use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use oaktwin::catalog::{DepthKind, Role};
use oaktwin::depth::align;
use oaktwin::sense;

use super::{OutputArgs, SensorArgs, ThreadArgs, UnitArgs};

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    mut_arg("annotators", |arg| arg.help(
        "Comma-separated sensor outputs beside depth_sensor_distance: depth_sensor_point_cloud_position, \
         depth_sensor_point_cloud_color, depth_sensor_imager, depth_sensor_output_visualization (the view of \
         rgbDepthOutputMode)"
    )),
    after_help = "DEPTH is NPY (float16, 32 or 64 in metres, uint16 in --depth-scale; (H, W), (H, W, 1) or batches (N, H, W)), \
    16-bit grey PNG, EXR, PFM, a folder in the layout of Replicator's BasicWriter, or - for standard input. What is not \
    finite and above 0 is no surface. The number at the end of a name is the frame: noise is new in each, and files whose \
    names differ in it alone are a sequence.\n\n\
    Written are depth_sensor_distance NPY, float32 metres, 0 where nothing was measured; a batch stays one. In a folder \
    they lie beside the ground truth unless -o names another. From standard input without -o the distances go to standard \
    output, or what --align makes of them."
)]
pub(crate) struct SenseArgs {
    /// Depth images, folders of them, or - for standard input
    #[arg(required = true, value_name = "DEPTH", value_hint = ValueHint::AnyPath)]
    pub(crate) depth: Vec<PathBuf>,

    /// The model
    #[arg(long)]
    pub(crate) model: String,

    /// The folder to write into; by default the folder that DEPTH is
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    /// Which of a model's depth sensors; by default time of flight where it has it
    #[arg(long, value_enum)]
    pub(crate) sensor: Option<SensorKind>,

    /// The pictures of the same camera, one for each depth image, or an NPY array of as many; a folder's are found
    #[arg(long, value_name = "IMAGE", num_args = 1.., value_hint = ValueHint::FilePath, help_heading = "The images")]
    pub(crate) rgb: Vec<PathBuf>,

    #[arg(
        long,
        value_enum,
        help = "What the numbers are: along the optical axis or from the camera. Needed where the file's name does \
                not say it (distance_to_image_plane, depth: z; distance_to_camera: range)",
        help_heading = "The images"
    )]
    pub(crate) input_kind: Option<InputKind>,

    /// Metres to a unit of whole numbers
    #[arg(
        long,
        value_name = "METRES",
        default_value_t = 0.001,
        allow_negative_numbers = true,
        help_heading = "The images"
    )]
    pub(crate) depth_scale: f64,

    #[arg(
        long,
        value_name = "F",
        help = "The images' focal length, px; by default what a folder's camera_params say, else the model's field of view",
        allow_negative_numbers = true,
        conflicts_with = "hfov",
        help_heading = "The images"
    )]
    pub(crate) fx: Option<f64>,

    /// The images' horizontal field of view, degrees
    #[arg(
        long,
        value_name = "D",
        allow_negative_numbers = true,
        help_heading = "The images"
    )]
    pub(crate) hfov: Option<f64>,

    /// Make images of another size or field of view the model's, by the nearest sample, instead of using them as they are
    #[arg(long, help_heading = "The images")]
    pub(crate) resample: bool,

    /// The images of a batch are one after the other in time, not side by side
    #[arg(long, help_heading = "The images")]
    pub(crate) sequence: bool,

    #[command(flatten, next_help_heading = "The depth sensor")]
    pub(crate) engine: SensorArgs,

    /// Depth also as another camera of the model sees it, by its place and lens
    #[arg(long, value_enum, value_name = "CAMERA", help_heading = "Outputs")]
    pub(crate) align: Option<AlignCamera>,

    /// The size of aligned images, 1280x800, by DepthAI's rule; by default the camera's own
    #[arg(long, value_name = "WxH", requires = "align", help_heading = "Outputs")]
    pub(crate) align_size: Option<String>,

    /// Which pixels a sample goes into: all that it covers, or the one that it falls into
    #[arg(long, value_enum, default_value_t = AlignFill::Footprint, help_heading = "Outputs")]
    pub(crate) align_fill: AlignFill,

    #[command(flatten)]
    pub(crate) outputs: OutputArgs,

    /// The axes of the PLY: x right, y down, z forward, or ROS's x forward, y left, z up
    #[arg(
        long,
        value_enum,
        default_value_t = CloudFrame::Optical,
        alias = "pointcloud-frame",
        help_heading = "Outputs"
    )]
    pub(crate) ply_frame: CloudFrame,

    #[command(flatten, next_help_heading = "How")]
    pub(crate) threads: ThreadArgs,

    /// Print what was written as JSON
    #[arg(long, help_heading = "How")]
    pub(crate) json: bool,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SensorKind {
    Stereo,
    Tof,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum InputKind {
    Z,
    Range,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AlignCamera {
    Left,
    Right,
    Rgb,
    Tof,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AlignFill {
    Footprint,
    Nearest,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CloudFrame {
    Optical,
    Ros,
}

impl From<SensorKind> for DepthKind {
    fn from(kind: SensorKind) -> Self {
        match kind {
            SensorKind::Stereo => Self::Stereo,
            SensorKind::Tof => Self::Tof,
        }
    }
}

impl From<InputKind> for sense::InputKind {
    fn from(kind: InputKind) -> Self {
        match kind {
            InputKind::Z => Self::Z,
            InputKind::Range => Self::Range,
        }
    }
}

impl From<AlignCamera> for Role {
    fn from(camera: AlignCamera) -> Self {
        match camera {
            AlignCamera::Left => Self::Left,
            AlignCamera::Right => Self::Right,
            AlignCamera::Rgb => Self::Rgb,
            AlignCamera::Tof => Self::Tof,
        }
    }
}

impl From<AlignFill> for align::Fill {
    fn from(fill: AlignFill) -> Self {
        match fill {
            AlignFill::Footprint => Self::Footprint,
            AlignFill::Nearest => Self::Nearest,
        }
    }
}

impl From<CloudFrame> for sense::CloudAxes {
    fn from(frame: CloudFrame) -> Self {
        match frame {
            CloudFrame::Optical => Self::Optical,
            CloudFrame::Ros => Self::Ros,
        }
    }
}
