use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::dataset::CloudAxes;
use oaktwin::sense::InputKind;

use super::annotators::sensor_outputs;
use super::choice::parser;
use super::{AlignArgs, OutputArgs, SensorArgs, ThreadArgs, UnitArgs};

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    mut_arg("annotators", |arg| {
        let help = "More outputs of the sensor, comma-separated";
        arg.help(help).long_help(format!("{help}:\n\n{}", sensor_outputs()))
    }),
    after_help = "DEPTH is NPY or NPZ (floats in metres, integers in units of --depth-scale; (H, W), (H, W, 1) or batches (N, H, W)), \
    TIFF of one channel, 16-bit grey PNG, EXR, PFM, a folder in the layout of Replicator's BasicWriter, or - for standard input. Values that are \
    not finite and above 0 are invalid. The number at the end of a file name is the frame: each has its own noise, and \
    files whose names differ only in this number are a sequence.\n\n\
    The output is depth_sensor_distance as NPY, float32 metres, 0 where nothing was measured; a batch stays a batch. For a \
    folder it is written beside the ground truth unless -o names another. For standard input without -o, the distances, or \
    with --align the aligned distances, are written to standard output."
)]
pub(crate) struct SenseArgs {
    /// Depth images, folders of them, or - for standard input
    #[arg(required = true, value_name = "DEPTH", value_hint = ValueHint::AnyPath)]
    pub(crate) depth: Vec<PathBuf>,

    /// The model
    #[arg(long)]
    pub(crate) model: String,

    /// The output folder [default: DEPTH if it is a folder]
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    /// The depth sensor: stereo, tof or a prim [default: time of flight if the model has it]
    #[arg(long, value_name = "KIND|PRIM")]
    pub(crate) sensor: Option<String>,

    /// The camera's colour images, one per depth image, or one NPY array [default: a folder's own]
    #[arg(long, value_name = "IMAGE", num_args = 1.., value_hint = ValueHint::FilePath, help_heading = "Images")]
    pub(crate) rgb: Vec<PathBuf>,

    #[arg(
        long,
        value_parser = parser::<InputKind>(),
        help = "The kind of depth: along the optical axis (z) or from the optical centre (range)",
        long_help = "The kind of depth: along the optical axis (z) or from the optical centre (range)\n\n\
                     Required unless the file's name implies it: distance_to_image_plane and depth are z, distance_to_camera is \
                     range.",
        help_heading = "Images"
    )]
    pub(crate) input_kind: Option<InputKind>,

    /// Metres per integer depth unit
    #[arg(long, value_name = "METRES", default_value_t = 0.001, help_heading = "Images")]
    pub(crate) depth_scale: f64,

    #[arg(
        long,
        value_name = "F",
        help = "The focal length of the images, px [default: from a folder's camera_params, else the model's]",
        conflicts_with = "hfov",
        help_heading = "Images"
    )]
    pub(crate) fx: Option<f64>,

    /// The horizontal field of view of the images, degrees
    #[arg(long, value_name = "D", help_heading = "Images")]
    pub(crate) hfov: Option<f64>,

    /// Resample images of another size or field of view to the model's (nearest samples)
    #[arg(long, help_heading = "Images")]
    pub(crate) resample: bool,

    /// Treat the images of a batch as successive frames [default: as simultaneous ones]
    #[arg(long, help_heading = "Images")]
    pub(crate) sequence: bool,

    #[command(flatten, next_help_heading = "Depth sensor")]
    pub(crate) engine: SensorArgs,

    #[command(flatten)]
    pub(crate) align: AlignArgs,

    #[command(flatten)]
    pub(crate) outputs: OutputArgs,

    /// The axes of the PLY
    #[arg(
        long,
        value_parser = parser::<CloudAxes>(),
        default_value_t,
        alias = "pointcloud-frame",
        help_heading = "Outputs"
    )]
    pub(crate) ply_frame: CloudAxes,

    #[command(flatten, next_help_heading = "Execution")]
    pub(crate) threads: ThreadArgs,

    /// Print the result as JSON
    #[arg(long, help_heading = "Execution")]
    pub(crate) json: bool,
}
