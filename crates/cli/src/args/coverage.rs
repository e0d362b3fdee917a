use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::coverage::{SAMPLES, reasons};

use super::{PairArgs, PlaceArgs, RobotArgs, SceneArgs, SensorArgs, ThreadArgs, UnitArgs};

fn after_help() -> String {
    let reasons: String = reasons()[1..]
        .iter()
        .map(|reason| format!("\n  {}: {}", reason.name, reason.doc))
        .collect();
    format!(
        "Points are distributed evenly over the surface of the region, and a ray decides whether a camera sees a point. A point is \
        measured if its pixel in the sensor's image has a value. All faces count, even if no camera can see them, such as the \
        underside of a box on the floor.\n\n\
        Poses describe the body (x forward, y left, z up), in metres. A file of poses is a trajectory as for `oaktwin render`. \
        A list is comma-separated numbers and ranges FROM:TO:STEP. Every model is placed at every pose, height and tilt; without \
        --model, the depth sensors of the scene are compared.\n\n\
        With --robot, each candidate is measured in each posture of --joints, and ranked by what it measures over the whole motion. The \
        robot does not belong to the region. Own robot is the share of the pixels that show the robot itself.\n\n\
        Candidates are ranked by the share of points that they measure, then by their median absolute error.\n\n\
        Reasons why a point is not measured:{reasons}"
    )
}

#[derive(Args, Debug)]
#[command(
    next_line_help = true,
    mut_arg("engine", |arg| arg.hide_possible_values(true).help(
        "The error model: stereo-noise, time-of-flight, stereo-matching, single-view [default: the model's]"
    )),
    after_help = after_help()
)]
pub(crate) struct CoverageArgs {
    /// The scene: USD (usda, usdc, usd, usdz), glTF (gltf, glb), Collada (dae), OBJ, STL or PLY
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) scene: PathBuf,

    /// Measure the meshes at and below this path; repeatable [default: the whole scene]
    #[arg(long, value_name = "PRIM")]
    pub(crate) region: Vec<String>,

    /// Measure only the surface inside a box, from its minimum to its maximum corner, in metres
    #[arg(
        long,
        num_args = 6,
        value_names = ["X0", "Y0", "Z0", "X1", "Y1", "Z1"]
    )]
    pub(crate) region_box: Option<Vec<f64>>,

    /// The number of points on the surface
    #[arg(long, value_name = "N", default_value_t = SAMPLES)]
    pub(crate) samples: u32,

    /// Count a point as measured only if its error is at most this many millimetres [default: any error]
    #[arg(long, value_name = "MM")]
    pub(crate) tolerance: Option<f64>,

    /// Write coverage.csv, coverage.json and coverage.png (the best candidate's) to this folder
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) output: Option<PathBuf>,

    /// Write report.html and report.csv, with pictures by day and by night, to this folder
    ///
    /// By night, the scene's lights are off. Stereo pairs are measured by stereo-matching, unless --engine names another engine.
    #[arg(
        long,
        value_name = "DIR",
        value_hint = ValueHint::DirPath,
        requires = "model",
        conflicts_with_all = ["output", "ambient", "json", "robot"]
    )]
    pub(crate) report: Option<PathBuf>,

    /// Place this model in the scene; repeatable
    #[arg(long, help_heading = "OAK")]
    pub(crate) model: Vec<String>,

    #[command(flatten, next_help_heading = "OAK")]
    pub(crate) unit: UnitArgs,

    /// The depth sensor: stereo, tof or a prim [default: time of flight if the model has it]
    #[arg(long, value_name = "KIND|PRIM", requires = "model", help_heading = "OAK")]
    pub(crate) sensor: Option<String>,

    /// The size of the sensor's image, such as 640x400 [default: its own]
    #[arg(long, value_name = "WxH", requires = "model", help_heading = "OAK")]
    pub(crate) resolution: Option<String>,

    #[command(flatten)]
    pub(crate) place: PlaceArgs,

    /// A file of poses to compare: TUM or JSON
    #[arg(
        long,
        value_name = "FILE",
        value_hint = ValueHint::FilePath,
        conflicts_with_all = ["pose", "look_at"],
        requires = "model",
        help_heading = "OAK"
    )]
    pub(crate) poses: Option<PathBuf>,

    /// Compare these heights along the up axis, a list in metres; --look-at keeps its target
    #[arg(
        long,
        value_name = "LIST",
        allow_hyphen_values = true,
        requires = "model",
        help_heading = "OAK"
    )]
    pub(crate) height: Option<String>,

    /// Compare these angles below the horizontal, a list in degrees; the heading is kept
    #[arg(
        long,
        value_name = "LIST",
        allow_hyphen_values = true,
        requires = "model",
        help_heading = "OAK"
    )]
    pub(crate) tilt: Option<String>,

    #[command(flatten, next_help_heading = "Robot")]
    pub(crate) robot: RobotArgs,

    /// Mount the OAK on this link of the robot: poses are relative to it, and follow it
    #[arg(
        long,
        value_name = "LINK",
        requires_all = ["robot", "model"],
        help_heading = "Robot"
    )]
    pub(crate) mount: Option<String>,

    #[command(flatten)]
    pub(crate) engine: SensorArgs,

    #[command(flatten)]
    pub(crate) pair: PairArgs,

    #[command(flatten, next_help_heading = "Scene")]
    pub(crate) scene_options: SceneArgs,

    #[command(flatten, next_help_heading = "Execution")]
    pub(crate) threads: ThreadArgs,

    /// Print the result as JSON
    #[arg(long, help_heading = "Execution")]
    pub(crate) json: bool,
}
