use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueHint};
use oaktwin::dataset::{FORMATS, FormatKind, Needs};
use oaktwin::render::{Backend, Transparent};
use oaktwin::usd::optics::Projection;

use super::annotators::annotators;
use super::choice::parser;
use super::pair::switched;
use super::{
    ImuArgs, OutputArgs, PairArgs, PlaceArgs, RobotArgs, SceneArgs, SensorArgs, ShutterArgs, ThreadArgs,
    UnitArgs,
};

fn after_help() -> String {
    format!(
        "Files, names and units follow Replicator's BasicWriter; a miss is +inf. With several cameras, each has its own folder \
        in the output folder.\n\n\
        Annotators:{}\n\n\
        Annotators of cameras with a depth sensor:{}\n\n\
        The sensor's parameters come from the scene's render product or from the model; --param overrides them and \
        --sweep compares several values.\n\n\
        A trajectory is a TUM file (lines of t x y z qx qy qz qw) or a JSON list of {{\"time\": t, \"position\": [x, y, z], \
        \"orientation\": [qx, qy, qz, qw]}}. Its poses, in metres, describe the model's body (x forward, y left, z up) or the \
        scene's camera (x right, y down, z forward).",
        annotators(false),
        annotators(true),
    )
}

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    mut_arg("engine", |arg| arg.hide_possible_values(true).help(
        "The error model [default: the one of the model's technology; single-view without --model]"
    ).long_help(
        "The error model: stereo-noise, time-of-flight, stereo-matching, single-view [default: the one of the model's technology; \
         single-view without --model]\n\n\
         stereo-matching requires --model and renders its stereo pair. single-view is Isaac Sim's DepthSensorDistance."
    )),
    mut_arg("isaac", |arg| arg.help(
        "Use single-view's defaults of this Isaac Sim version [default: the version of the scene's asset]"
    )),
    mut_arg("annotators", |arg| arg.help(
        "The annotators, comma-separated, or all [default: rgb,distance_to_image_plane,camera_params]"
    ).long_help(
        "The annotators, comma-separated, or all [default: rgb,distance_to_image_plane,camera_params]\n\n\
         With an option of the depth sensor, the default also contains depth_sensor_distance."
    )),
    mut_arg("ply", |arg| arg.help(
        "Also write point clouds as PLY, the depth sensor's if its positions are rendered, else the scene's"
    )),
    after_help = after_help()
)]
pub(crate) struct RenderArgs {
    /// The scene: USD (usda, usdc, usd, usdz), glTF (gltf, glb), Collada (dae), OBJ, STL or PLY
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) scene: PathBuf,

    /// The output folder [default: oaktwin-render, or none with --record]
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) output: Option<PathBuf>,

    /// Record the frames, cameras and poses as .mcap, for ROS 2, Foxglove and Rerun
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) record: Option<PathBuf>,

    /// Render this camera; repeatable [default: every depth sensor, else every camera of the scene]
    ///
    /// A camera of the scene by path or unique name, or with --model rgb, left, right, tof or depth.
    #[arg(long, value_name = "PATH|NAME")]
    pub(crate) camera: Vec<String>,

    /// The image size, such as 1280x800 [default: each camera's own]
    ///
    /// A model's images are resized and cropped like DepthAI's; a camera of the scene keeps its apertures.
    #[arg(long, value_name = "WxH")]
    pub(crate) resolution: Option<String>,

    /// Interpret the apertures of the scene's cameras like Isaac Sim or like OpenUSD
    #[arg(long, value_parser = parser::<Projection>(), default_value_t)]
    pub(crate) projection: Projection,

    #[command(flatten)]
    pub(crate) sensor: SensorArgs,

    #[command(flatten)]
    pub(crate) pair: PairArgs,

    #[arg(
        long = "pair",
        help = "Also write the pair as PNG for `oaktwin stereo`: left, right, rectified_left, rectified_right",
        help_heading = "Stereo pair"
    )]
    pub(crate) writes_pair: bool,

    /// Simulate the sensor with each of these values, and write one comparison sheet
    ///
    /// NAME is a parameter, or engine, preset or seed. A second --sweep makes a table.
    #[arg(long, value_name = "NAME=V1,V2,…", help_heading = "Depth sensor")]
    pub(crate) sweep: Vec<String>,

    /// Place this OAK in the scene instead of using its cameras
    #[arg(long, help_heading = "OAK")]
    pub(crate) model: Option<String>,

    #[command(flatten, next_help_heading = "OAK")]
    pub(crate) unit: UnitArgs,

    #[command(flatten)]
    pub(crate) place: PlaceArgs,

    /// Render a frame for each pose of a file
    #[arg(
        long,
        value_name = "FILE",
        value_hint = ValueHint::FilePath,
        conflicts_with_all = ["pose", "look_at"],
        help_heading = "Scene and trajectory"
    )]
    pub(crate) trajectory: Option<PathBuf>,

    /// Render an animated stage at these time codes, LAST included, such as 0:100 or 0:100:2
    ///
    /// The stage is loaded once; only what moves is read again. With --trajectory, each frame has its own pose.
    #[arg(
        long,
        value_name = "FIRST:LAST[:STEP]",
        allow_hyphen_values = true,
        conflicts_with = "time",
        help_heading = "Scene and trajectory"
    )]
    pub(crate) frames: Option<String>,

    /// The frames per second of --frames [default: the stage's time codes per second / STEP]
    #[arg(
        long,
        value_name = "RATE",
        requires = "frames",
        help_heading = "Scene and trajectory"
    )]
    pub(crate) fps: Option<f64>,

    /// Mount the OAK on this prim of the stage or link of the robot: poses are relative to it
    #[arg(long, value_name = "PRIM|LINK", requires = "model", help_heading = "OAK")]
    pub(crate) mount: Option<String>,

    #[command(flatten, next_help_heading = "Robot")]
    pub(crate) robot: RobotArgs,

    #[command(flatten)]
    pub(crate) shutter: ShutterArgs,

    #[command(flatten, next_help_heading = "Inertial sensor")]
    pub(crate) imu: ImuArgs,

    #[command(flatten, next_help_heading = "Scene and trajectory")]
    pub(crate) scene_options: SceneArgs,

    /// Write nothing and fail on warnings, such as missing or unsupported scene contents
    #[arg(long, help_heading = "Scene and trajectory")]
    pub(crate) strict: bool,

    #[command(flatten)]
    pub(crate) outputs: OutputArgs,

    /// The format of the data set
    #[arg(
        long,
        value_name = "NAME",
        default_value = FORMATS[0].name,
        value_parser = PossibleValuesParser::new(formats()),
        help_heading = "Outputs"
    )]
    pub(crate) writer: String,

    /// The backend that finds the visible surface in each pixel
    #[arg(long, value_parser = parser::<Backend>(), default_value_t, help_heading = "Execution")]
    pub(crate) backend: Backend,

    /// The ground truth of transparent surfaces: themselves, or what lies behind the clear ones
    #[arg(
        long,
        value_parser = parser::<Transparent>(),
        default_value_t,
        value_name = "WHAT",
        help_heading = "Outputs"
    )]
    pub(crate) transparent: Transparent,

    #[command(flatten, next_help_heading = "Execution")]
    pub(crate) threads: ThreadArgs,

    /// Record rgb as a camera does: on, or NAME=VALUE of `oaktwin params color-imager` [default: off]
    #[arg(long, value_name = "on|NAME=VALUE", value_parser = switched, help_heading = "Outputs")]
    pub(crate) rgb_imager: Vec<Option<(String, String)>>,

    /// Print the result as JSON
    #[arg(long, help_heading = "Execution")]
    pub(crate) json: bool,
}

/// The formats for which a rendered scene is enough.
fn formats() -> impl Iterator<Item = PossibleValue> {
    let suits = |format: &&FormatKind| format.needs == Needs::default();
    FORMATS.iter().filter(suits).map(format_value)
}

/// Returns the name of a format with its help.
pub(super) fn format_value(format: &FormatKind) -> PossibleValue {
    PossibleValue::new(format.name).help(format.help)
}
