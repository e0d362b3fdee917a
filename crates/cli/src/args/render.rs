use std::path::PathBuf;

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueEnum, ValueHint};
use oaktwin::dataset::{LAYOUTS, Layout};
use oaktwin::usd::optics;
use oaktwin::{render, scene};

use super::{OutputArgs, PairArgs, SensorArgs, ThreadArgs, UnitArgs};

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
    mut_arg("annotators", |arg| arg.help(
        "Comma-separated annotators to render; all is everything. Default: rgb, distance_to_image_plane and camera_params, \
         and depth_sensor_distance if an option of the depth sensor is given"
    )),
    mut_arg("ply", |arg| arg.help(
        "Also write point clouds as PLY: the depth sensor's if its positions are rendered, else the scene's"
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

    #[command(flatten)]
    pub(crate) outputs: OutputArgs,

    /// The layout of the data set
    #[arg(
        long,
        value_name = "NAME",
        default_value = LAYOUTS[0].name,
        value_parser = PossibleValuesParser::new(LAYOUTS.iter().map(layout)),
        help_heading = "Outputs"
    )]
    pub(crate) writer: String,

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

    /// How to find what a pixel sees: rasterize pinholes and cast rays for other lenses, or only one of them
    #[arg(long, value_enum, default_value_t = Backend::Auto, help_heading = "How")]
    pub(crate) backend: Backend,

    #[command(flatten, next_help_heading = "How")]
    pub(crate) threads: ThreadArgs,

    /// Print what was written as JSON
    #[arg(long, help_heading = "How")]
    pub(crate) json: bool,
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

fn layout(layout: &Layout) -> PossibleValue {
    PossibleValue::new(layout.name).help(layout.help)
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
