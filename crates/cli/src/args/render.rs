use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueHint};
use oaktwin::dataset::{FORMATS, FormatKind, Needs};
use oaktwin::render::Backend;
use oaktwin::usd::optics::Projection;

use super::annotators::annotators;
use super::choice::parser;
use super::{ImuArgs, OutputArgs, PairArgs, PlaceArgs, SceneArgs, SensorArgs, ThreadArgs, UnitArgs};

fn after_help() -> String {
    format!(
        "Files, names and units follow Replicator's BasicWriter; a miss is +inf. The files of a single camera are written \
        into the output folder, those of several cameras into a folder for each.\n\n\
        Annotators:{}\n\n\
        Annotators of cameras with a depth sensor:{}\n\n\
        The sensor's parameters come from the scene's render product or from the model; --param overrides them and \
        --sweep compares several values.\n\n\
        A trajectory is a TUM file (lines of t x y z qx qy qz qw) or a JSON list of {{\"time\": t, \"position\": [x, y, z], \
        \"orientation\": [qx, qy, qz, qw]}}. Its poses are those of the model's body (x forward, y left, z up) or of the \
        scene's camera (x right, y down, z forward), in metres.",
        annotators(false),
        annotators(true),
    )
}

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    mut_arg("engine", |arg| arg.hide_possible_values(true).help(
        "The error model: single-view (Isaac Sim's, the default), stereo-noise, time-of-flight, or stereo-matching of the \
         stereo pair of --model"
    )),
    mut_arg("isaac", |arg| arg.help(
        "The Isaac Sim version of single-view's defaults; by default that of the scene's asset"
    )),
    mut_arg("annotators", |arg| arg.help(
        "Comma-separated annotators to render; all is everything. Default: rgb, distance_to_image_plane and camera_params, \
         and depth_sensor_distance if an option of the depth sensor is given"
    )),
    mut_arg("ply", |arg| arg.help(
        "Also write point clouds as PLY: the depth sensor's if its positions are rendered, else the scene's"
    )),
    after_help = after_help()
)]
pub(crate) struct RenderArgs {
    /// The scene: USD (usda, usdc, usd, usdz), glTF (gltf, glb), OBJ, STL or PLY
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) scene: PathBuf,

    /// The output folder; by default oaktwin-render, or none with --record
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) output: Option<PathBuf>,

    /// Record the frames, cameras and poses as .mcap, for ROS 2, Foxglove and Rerun
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) record: Option<PathBuf>,

    /// A camera of the scene by path or unique name, or of the model (rgb, left, right, tof, depth); repeatable; by default
    /// every depth sensor, else every camera of the scene
    #[arg(long, value_name = "PATH|NAME")]
    pub(crate) camera: Vec<String>,

    /// The image size, such as 1280x800; a model's cameras are resized and cropped as by DepthAI, the scene's keep their
    /// apertures
    #[arg(long, value_name = "WxH")]
    pub(crate) resolution: Option<String>,

    /// The interpretation of a scene camera's apertures: Isaac Sim's (square pixels, no offsets) or OpenUSD's
    #[arg(long, value_parser = parser::<Projection>(), default_value_t)]
    pub(crate) projection: Projection,

    #[command(flatten)]
    pub(crate) sensor: SensorArgs,

    #[command(flatten)]
    pub(crate) pair: PairArgs,

    #[arg(
        long = "pair",
        help = "Also write the images of the pair, for `oaktwin stereo`: left, right, rectified_left, rectified_right PNG",
        help_heading = "Stereo pair"
    )]
    pub(crate) writes_pair: bool,

    /// Simulate the sensor with each of these values of a parameter (or engine, preset, seed) and write one comparison sheet;
    /// a second --sweep makes a table
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

    #[command(flatten, next_help_heading = "Inertial sensor")]
    pub(crate) imu: ImuArgs,

    #[command(flatten, next_help_heading = "Scene and trajectory")]
    pub(crate) scene_options: SceneArgs,

    /// Fail on warnings, such as missing or unsupported scene contents, instead of writing the results
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

    /// The visibility backend; auto rasterizes pinholes and casts rays for other lenses
    #[arg(long, value_parser = parser::<Backend>(), default_value_t, help_heading = "Execution")]
    pub(crate) backend: Backend,

    #[command(flatten, next_help_heading = "Execution")]
    pub(crate) threads: ThreadArgs,

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
