//! What the program understands.

mod accuracy;
mod fit;
mod pair;
mod sense;
mod sensor;
mod stereo;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum, ValueHint};
use oaktwin::camera::ApertureOffsets;
use oaktwin::usd::{asset, optics};
use oaktwin::{render, scene};

pub(crate) use accuracy::AccuracyArgs;
pub(crate) use fit::{Also, FitArgs};
pub(crate) use pair::PairArgs;
pub(crate) use sense::SenseArgs;
pub(crate) use sensor::{SensorArgs, SettingsArgs};
pub(crate) use stereo::StereoArgs;

/// Digital twins of Luxonis OAK depth cameras.
#[derive(Parser, Debug)]
#[command(
    name = "oaktwin",
    version,
    propagate_version = true,
    arg_required_else_help = true
)]
#[command(
    after_help = "Exit codes: 0 good, 1 findings (check, accuracy, stereo, fit), 2 error.\n\
    A MODEL is a name from `oaktwin models`; case, spaces and hyphens do not matter."
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,

    /// Add the sensors and devices of your own TOML files in this folder to the catalog
    #[arg(long, global = true, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) catalog: Option<PathBuf>,
}

#[derive(Subcommand, Debug)]
pub(crate) enum Command {
    /// Write the five assets, one unit's own twin and what all see of a room, and compare the models
    Demo(DemoArgs),
    /// List the models
    Models(JsonArgs),
    /// Print every number of a model, and what is known about it
    Show(ShowArgs),
    /// Print the comparison tables of some or all models
    Compare(CompareArgs),
    /// Read a DepthAI calibration, or export one to other formats
    Calibration(CalibrationArgs),
    /// Write a model as a USD asset
    Asset(AssetArgs),
    /// Render what cameras see of a scene: depth, colour, normals, labels, and what depth sensors report
    Render(Box<RenderArgs>),
    /// Make of depth images from anywhere what a model's depth sensor would report
    Sense(Box<SenseArgs>),
    /// Match pairs of images as an OAK does
    Stereo(Box<StereoArgs>),
    /// Measure a model's depth as the vendor measures its cameras, and compare
    Accuracy(Box<AccuracyArgs>),
    /// Find the parameters of a depth sensor's errors in recordings of a flat target
    Fit(Box<FitArgs>),
    /// Find mistakes in the cameras and depth sensors of a USD file
    Check(CheckArgs),
    /// Print a script that completes commands in a shell
    Completions(CompletionsArgs),
    /// Print the manual page
    Man(ManArgs),
}

#[derive(Args, Debug)]
pub(crate) struct JsonArgs {
    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct DemoArgs {
    /// Where to write
    #[arg(short, long, value_name = "DIR", default_value = "oaktwin-demo", value_hint = ValueHint::DirPath)]
    pub(crate) output: PathBuf,
}

/// A model, and the calibration that makes it one unit's twin.
#[derive(Args, Debug)]
pub(crate) struct UnitArgs {
    /// The DepthAI calibration (JSON) of one unit
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) calibration: Option<PathBuf>,

    /// Use a calibration in spite of the errors found in it
    #[arg(long, requires = "calibration")]
    pub(crate) force: bool,

    /// The lens of the left and right cameras of the wide models
    #[arg(long, value_enum, default_value_t = Lens::Pinhole)]
    pub(crate) lens: Lens,
}

#[derive(Args, Debug)]
pub(crate) struct ShowArgs {
    /// The model
    pub(crate) model: String,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    /// Say where each number comes from, and what other sources say
    #[arg(long)]
    pub(crate) provenance: bool,

    /// Print JSON (always with provenance)
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct CompareArgs {
    /// The models; all when none is named
    pub(crate) models: Vec<String>,

    /// How to print
    #[arg(long, value_enum, default_value_t = TableFormat::Text)]
    pub(crate) format: TableFormat,
}

#[derive(Args, Debug)]
pub(crate) struct CalibrationArgs {
    #[command(subcommand)]
    pub(crate) command: CalibrationCommand,
}

#[derive(Subcommand, Debug)]
pub(crate) enum CalibrationCommand {
    /// Print what a calibration says, and what is odd in it
    Show(CalibrationShowArgs),
    /// Write a calibration for other programs
    Export(CalibrationExportArgs),
}

#[derive(Args, Debug)]
pub(crate) struct CalibrationShowArgs {
    /// The DepthAI calibration (JSON)
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) file: PathBuf,

    /// Check it against this model; by default the one that its product name says
    #[arg(long)]
    pub(crate) model: Option<String>,

    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct CalibrationExportArgs {
    /// A DepthAI calibration (JSON), or a model for its nominal device
    #[arg(value_name = "FILE|MODEL", value_hint = ValueHint::FilePath)]
    pub(crate) from: String,

    /// The format: ROS camera info, OpenCV FileStorage, Kalibr camchain, DepthAI JSON
    #[arg(long, value_enum)]
    pub(crate) to: ExportFormat,

    /// A file, or a folder where the format has several files; standard output by default
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::AnyPath)]
    pub(crate) output: Option<PathBuf>,

    /// Export in spite of the errors found in the calibration
    #[arg(long)]
    pub(crate) force: bool,
}

#[derive(Args, Debug)]
pub(crate) struct AssetArgs {
    /// The model, or `all`
    #[arg(value_name = "MODEL|all")]
    pub(crate) model: String,

    /// A file, or a folder; with `all` a folder
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::AnyPath)]
    pub(crate) output: PathBuf,

    /// The file format; by default the output's extension says it, else usd
    #[arg(long, value_enum)]
    pub(crate) format: Option<AssetFormat>,

    /// The Isaac Sim that will load it
    #[arg(long, value_enum, default_value_t = Isaac::V5_1)]
    pub(crate) isaac: Isaac,

    /// The renderer that will load it (ovrtx is experimental)
    #[arg(long, value_enum, default_value_t = Target::Isaac)]
    pub(crate) target: Target,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    /// How a principal point becomes aperture offsets
    #[arg(long, value_enum, default_value_t = Offsets::Openusd)]
    pub(crate) aperture_offsets: Offsets,

    /// Disparity up to 191 px instead of 95: nearer things, the same step
    #[arg(long)]
    pub(crate) extended_disparity: bool,

    /// Write the older distortion attributes for Isaac Sim 6 too, where they do nothing
    #[arg(long)]
    pub(crate) legacy_distortion: bool,

    /// Add a rigid body, its mass and a collider: the inertial sensor needs one above it
    #[arg(long)]
    pub(crate) rigid_body: bool,

    /// Leave the visible body out
    #[arg(long)]
    pub(crate) no_body: bool,

    /// Write only what the calibration changes, as a layer over this asset (the vendor's or Isaac's own)
    #[arg(long, value_name = "ASSET", requires = "calibration", value_hint = ValueHint::FilePath)]
    pub(crate) over: Option<PathBuf>,

    /// Print what was written as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    mut_arg("engine", |arg| arg.hide_possible_values(true).help(
        "The model of the errors: single-view, as Isaac Sim has it (the default), stereo-noise or time-of-flight, as an OAK errs, or \
         stereo-matching, which matches what the two cameras of --model take"
    )),
    mut_arg("isaac", |arg| arg.help(
        "The Isaac Sim whose defaults single-view has; by default the one that the scene's asset is written for"
    )),
    after_help = "Files, names and units are those of Replicator's BasicWriter; a miss is +inf. One camera writes \
    flat into the folder, several into a folder each.\n\n\
    Annotators: rgb, distance_to_image_plane, distance_to_camera, normals, instance_id_segmentation, \
    semantic_segmentation, bounding_box_2d_tight, bounding_box_2d_loose, pointcloud, camera_params.\n\n\
    Of a depth sensor's camera also what the sensor reports: depth_sensor_distance (metres, 0 where nothing was \
    measured), depth_sensor_point_cloud_position (camera's frame, USD's axes, metres), depth_sensor_point_cloud_color, \
    depth_sensor_imager, depth_sensor_output_visualization (the view that rgbDepthOutputMode chooses). Its parameters \
    are those of the scene's render product or of the model; --param sets others, --sweep tries several.\n\n\
    A trajectory is a TUM file (lines of t x y z qx qy qz qw) or a JSON list of {\"time\": t, \"position\": [x, y, z], \
    \"orientation\": [qx, qy, qz, qw]}; its poses are those of the model's body (x forward, y left, z up), or of the \
    scene's own camera (x right, y down, z forward), metres."
)]
pub(crate) struct RenderArgs {
    /// The scene: USD (usda, usdc, usd, usdz), glTF (gltf, glb), OBJ, STL or PLY
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) scene: PathBuf,

    /// The folder to write into; by default oaktwin-render, or none where there is --record
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) output: Option<PathBuf>,

    /// Record the frames, the cameras and their poses: .mcap for ROS 2, or .rrd for Rerun where that is built in
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(crate) record: Option<PathBuf>,

    /// A camera of the scene by path or unique name, or of the model (rgb, left, right, tof, depth); repeatable. By
    /// default every depth sensor, else every camera of the scene
    #[arg(long, value_name = "PATH|NAME")]
    pub(crate) camera: Vec<String>,

    #[arg(
        long,
        value_name = "NAMES",
        value_delimiter = ',',
        help = "What to render, apart by commas; all is everything. By default rgb, distance_to_image_plane and camera_params, \
        and depth_sensor_distance where an option of the depth sensor is given"
    )]
    pub(crate) annotators: Vec<String>,

    /// The size of the images, 1280x800. A model's cameras are resized and cropped as DepthAI does, the scene's own
    /// keep their aperture
    #[arg(long, value_name = "WxH")]
    pub(crate) resolution: Option<String>,

    /// How a scene camera's apertures are read: square pixels without offsets as Isaac Sim does, or as OpenUSD defines
    #[arg(long, value_enum, default_value_t = Projection::Isaac)]
    pub(crate) projection: Projection,

    #[command(flatten)]
    pub(crate) sensor: SensorArgs,

    #[command(flatten)]
    pub(crate) pair: PairArgs,

    /// Sense each frame once for each of these values of a parameter (or engine, preset, seed), and write one picture
    /// of all; a second one makes a table
    #[arg(long, value_name = "NAME=V1,V2,…", help_heading = "The depth sensor")]
    pub(crate) sweep: Vec<String>,

    /// Put this OAK into the scene instead of using its cameras
    #[arg(long, help_heading = "An OAK of ours")]
    pub(crate) model: Option<String>,

    #[command(flatten, next_help_heading = "An OAK of ours")]
    pub(crate) unit: UnitArgs,

    /// Where the body's origin stands, metres, and its rotation as a quaternion
    #[arg(
        long,
        num_args = 7,
        allow_negative_numbers = true,
        value_names = ["X", "Y", "Z", "QX", "QY", "QZ", "QW"],
        conflicts_with_all = ["look_at", "trajectory"],
        requires = "model"
    )]
    pub(crate) pose: Option<Vec<f64>>,

    /// Where the body stands (EYE), what it looks at (TARGET) and, three numbers more, which way is UP (by default the
    /// scene's up), metres
    #[arg(
        long,
        num_args = 6..=9,
        allow_negative_numbers = true,
        value_names = ["EX", "EY", "EZ", "TX", "TY", "TZ"],
        conflicts_with = "trajectory",
        requires = "model"
    )]
    pub(crate) look_at: Option<Vec<f64>>,

    /// A frame for each pose of a file
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath, help_heading = "Scene and path")]
    pub(crate) trajectory: Option<PathBuf>,

    /// The time code of a USD stage
    #[arg(
        long,
        value_name = "T",
        allow_negative_numbers = true,
        help_heading = "Scene and path"
    )]
    pub(crate) time: Option<f64>,

    /// Refine a USD stage's subdivision meshes so often; Isaac Sim does not
    #[arg(
        long,
        value_name = "N",
        default_value_t = 0,
        value_parser = clap::value_parser!(u32).range(0..=8),
        help_heading = "Scene and path"
    )]
    pub(crate) subdivide: u32,

    /// The axis of a glTF, OBJ, STL or PLY file that points up; by default what its format says
    #[arg(long, value_enum, help_heading = "Scene and path")]
    pub(crate) up: Option<Up>,

    /// Metres to a unit of a glTF, OBJ, STL or PLY file
    #[arg(long, value_name = "METRES", help_heading = "Scene and path")]
    pub(crate) scale: Option<f64>,

    /// Fail where something is missing or not supported, before anything is written
    #[arg(long, help_heading = "Scene and path")]
    pub(crate) strict: bool,

    /// Depth also as 16-bit PNG in millimetres
    #[arg(long, help_heading = "More files")]
    pub(crate) png16: bool,

    /// Depth also as EXR
    #[arg(long, help_heading = "More files")]
    pub(crate) exr: bool,

    /// Point clouds also as PLY: the depth sensor's where its positions are asked for, else the scene's (added to the
    /// annotators)
    #[arg(long, help_heading = "More files")]
    pub(crate) ply: bool,

    /// Each depth image also as a picture, coloured by distance
    #[arg(long, help_heading = "More files")]
    pub(crate) preview: bool,

    /// How to find what a pixel sees: rasterize pinholes and cast rays for other lenses, or only one of them
    #[arg(long, value_enum, default_value_t = Backend::Auto, help_heading = "How")]
    pub(crate) backend: Backend,

    /// Threads; by default one a core
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u32).range(1..=1024),
        help_heading = "How"
    )]
    pub(crate) threads: Option<u32>,

    /// Print what was written as JSON
    #[arg(long, help_heading = "How")]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct CheckArgs {
    /// The USD file: usda, usdc, usd or usdz
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) file: PathBuf,

    /// Compare with this model; by default the one that the prim names say
    #[arg(long)]
    pub(crate) model: Option<String>,

    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct CompletionsArgs {
    /// The shell
    #[arg(value_enum)]
    pub(crate) shell: clap_complete::Shell,
}

#[derive(Args, Debug)]
pub(crate) struct ManArgs {
    /// The page of this command; by default the program's
    pub(crate) command: Vec<String>,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lens {
    Pinhole,
    Fisheye,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum TableFormat {
    Text,
    Markdown,
    Json,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ExportFormat {
    Ros,
    Opencv,
    Kalibr,
    Depthai,
}

#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum AssetFormat {
    /// Text
    Usda,
    /// The same text under the name that Isaac Sim's own asset paths use
    #[default]
    Usd,
    /// A package
    Usdz,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Isaac {
    #[value(name = "5.1")]
    V5_1,
    #[value(name = "6")]
    V6,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    Isaac,
    Ovrtx,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Offsets {
    /// OpenUSD's sign: the window moves to the principal point
    Openusd,
    /// The parameter sheet's formula
    Document,
    /// None
    Zero,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Projection {
    Isaac,
    Openusd,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Up {
    Y,
    Z,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Backend {
    Auto,
    Raster,
    Ray,
}

impl From<Projection> for optics::Projection {
    fn from(projection: Projection) -> Self {
        match projection {
            Projection::Isaac => Self::Isaac,
            Projection::Openusd => Self::OpenUsd,
        }
    }
}

impl From<Up> for scene::Up {
    fn from(up: Up) -> Self {
        match up {
            Up::Y => Self::Y,
            Up::Z => Self::Z,
        }
    }
}

impl From<Backend> for render::Backend {
    fn from(backend: Backend) -> Self {
        match backend {
            Backend::Auto => Self::Auto,
            Backend::Raster => Self::Raster,
            Backend::Ray => Self::Ray,
        }
    }
}

impl From<Lens> for asset::LensChoice {
    fn from(lens: Lens) -> Self {
        match lens {
            Lens::Pinhole => Self::Pinhole,
            Lens::Fisheye => Self::Fisheye,
        }
    }
}

impl From<AssetFormat> for asset::Format {
    fn from(format: AssetFormat) -> Self {
        match format {
            AssetFormat::Usda => Self::Usda,
            AssetFormat::Usd => Self::Usd,
            AssetFormat::Usdz => Self::Usdz,
        }
    }
}

impl From<Isaac> for asset::IsaacVersion {
    fn from(isaac: Isaac) -> Self {
        match isaac {
            Isaac::V5_1 => Self::V5_1,
            Isaac::V6 => Self::V6,
        }
    }
}

impl From<Target> for asset::Target {
    fn from(target: Target) -> Self {
        match target {
            Target::Isaac => Self::Isaac,
            Target::Ovrtx => Self::Ovrtx,
        }
    }
}

impl From<Offsets> for ApertureOffsets {
    fn from(offsets: Offsets) -> Self {
        match offsets {
            Offsets::Openusd => Self::OpenUsd,
            Offsets::Document => Self::Document,
            Offsets::Zero => Self::Zero,
        }
    }
}
