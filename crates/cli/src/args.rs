//! What the program understands.

mod accuracy;
mod annotators;
mod asset;
mod calibration;
mod fit;
mod outputs;
mod pair;
mod render;
mod sense;
mod sensor;
mod stereo;
mod threads;
mod unit;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum, ValueHint};
use oaktwin::usd::asset::IsaacVersion;

pub(crate) use accuracy::AccuracyArgs;
pub(crate) use asset::AssetArgs;
pub(crate) use calibration::{
    CalibrationArgs, CalibrationCommand, CalibrationExportArgs, CalibrationShowArgs, ExportFormat,
};
pub(crate) use fit::{Also, FitArgs};
pub(crate) use outputs::OutputArgs;
pub(crate) use pair::PairArgs;
pub(crate) use render::RenderArgs;
pub(crate) use sense::SenseArgs;
pub(crate) use sensor::{SensorArgs, SettingsArgs};
pub(crate) use stereo::StereoArgs;
pub(crate) use threads::ThreadArgs;
pub(crate) use unit::{Lens, MeasuredUnitArgs, UnitArgs};

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
pub(crate) enum TableFormat {
    Text,
    Markdown,
    Json,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Isaac {
    #[value(name = "5.1")]
    V5_1,
    #[value(name = "6")]
    V6,
}

impl From<Isaac> for IsaacVersion {
    fn from(isaac: Isaac) -> Self {
        match isaac {
            Isaac::V5_1 => Self::V5_1,
            Isaac::V6 => Self::V6,
        }
    }
}
