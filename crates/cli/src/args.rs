//! The command-line arguments.

#[cfg(not(all(feature = "bridge", feature = "generate", feature = "studio")))]
mod absent;
mod accuracy;
mod align;
mod annotators;
mod asset;
#[cfg(feature = "bridge")]
mod bridge;
mod calibration;
pub(crate) mod choice;
mod coverage;
mod export;
mod fit;
#[cfg(feature = "generate")]
mod generate;
mod imu;
mod imu_frame;
mod limit;
pub(crate) mod numbers;
mod outputs;
mod pair;
mod place;
mod population;
mod render;
mod robot;
mod scene;
mod sense;
mod sensor;
mod shutter;
mod stereo;
#[cfg(feature = "studio")]
mod studio;
mod threads;
mod unit;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueHint};
use oaktwin::catalog::DepthFilter;
use oaktwin::depth::parameters::choice;
use oaktwin::depth::preset::Platform;
use oaktwin::memory;
use oaktwin::usd::stage::SceneLimit;

#[cfg(not(all(feature = "bridge", feature = "generate", feature = "studio")))]
pub(crate) use absent::AbsentArgs;
#[cfg(not(feature = "bridge"))]
pub(crate) use absent::AbsentArgs as BridgeArgs;
#[cfg(not(feature = "generate"))]
pub(crate) use absent::AbsentArgs as GenerateArgs;
#[cfg(not(feature = "studio"))]
pub(crate) use absent::AbsentArgs as StudioArgs;
pub(crate) use accuracy::AccuracyArgs;
pub(crate) use align::AlignArgs;
pub(crate) use asset::AssetArgs;
#[cfg(feature = "bridge")]
pub(crate) use bridge::BridgeArgs;
pub(crate) use calibration::{
    CalibrationArgs, CalibrationCommand, CalibrationExportArgs, CalibrationImportArgs, CalibrationShowArgs,
};
pub(crate) use coverage::CoverageArgs;
pub(crate) use export::ExportArgs;
pub(crate) use fit::{Also, FitArgs};
#[cfg(feature = "generate")]
pub(crate) use generate::GenerateArgs;
pub(crate) use imu::ImuArgs;
pub(crate) use imu_frame::ImuFrameArgs;
pub(crate) use outputs::OutputArgs;
pub(crate) use pair::PairArgs;
pub(crate) use place::PlaceArgs;
pub(crate) use population::PopulationArgs;
pub(crate) use render::RenderArgs;
#[cfg(feature = "studio")]
pub(crate) use robot::RobotPlaceArgs;
pub(crate) use robot::{OpenedRobot, RobotArgs};
pub(crate) use scene::SceneArgs;
#[cfg(feature = "studio")]
pub(crate) use scene::checked_scale;
pub(crate) use sense::SenseArgs;
pub(crate) use sensor::{MatcherArgs, SensorArgs};
pub(crate) use shutter::ShutterArgs;
pub(crate) use stereo::StereoArgs;
#[cfg(feature = "studio")]
pub(crate) use studio::StudioArgs;
pub(crate) use threads::ThreadArgs;
pub(crate) use unit::{MeasuredUnitArgs, UnitArgs};

/// Digital twins of Luxonis OAK depth cameras.
#[derive(Parser, Debug)]
#[command(
    name = "oaktwin",
    version,
    propagate_version = true,
    arg_required_else_help = true
)]
#[command(
    after_help = "Exit codes: 0 success, 1 findings (check, accuracy, stereo, fit), 2 error.\n\
    MODEL is a name from `oaktwin models`; case, spaces and hyphens are ignored."
)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,

    /// Add the sensors and devices in this folder's TOML files to the catalog
    #[arg(long, global = true, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) catalog: Option<PathBuf>,

    /// Use at most this much memory, such as 4G [default: what the system allows]
    #[arg(long, global = true, value_name = "SIZE", value_parser = memory::parse_size)]
    pub(crate) memory_limit: Option<u64>,
}

#[derive(Subcommand, Debug)]
pub(crate) enum Command {
    /// Write a folder of examples: USD assets, a calibrated twin, a rendered room, comparison tables
    Demo(DemoArgs),
    /// List the models
    Models(ModelsArgs),
    /// Print all parameters of a model
    Show(ShowArgs),
    /// List the parameters of an engine, the imager or the filters
    Params(ParamsArgs),
    /// Print tables that compare models
    Compare(CompareArgs),
    /// Inspect a DepthAI calibration, or export it to other formats
    Calibration(CalibrationArgs),
    /// Write calibrations with realistic unit-to-unit variation
    Population(PopulationArgs),
    /// Write a model as a USD asset
    Asset(AssetArgs),
    /// Describe a model for robots and simulators: URDF, SDF, MJCF, Webots, Blender
    Export(ExportArgs),
    /// Render a scene: depth, colour, normals, labels and the output of depth sensors
    Render(Box<RenderArgs>),
    /// Generate a data set of random scenes from a recipe
    Generate(Box<GenerateArgs>),
    /// Simulate a model's depth sensor on existing depth images
    Sense(Box<SenseArgs>),
    /// Simulate a model's depth sensor live, between ROS 2 topics
    Bridge(Box<BridgeArgs>),
    /// Run OAK-style stereo matching on image pairs
    Stereo(Box<StereoArgs>),
    /// Measure a model's depth accuracy by the vendor's method, and compare it with the specification
    Accuracy(Box<AccuracyArgs>),
    /// Rank poses and models by how much of a surface their depth sensors measure
    Coverage(Box<CoverageArgs>),
    /// Fit error-model parameters to recordings of a flat target
    Fit(Box<FitArgs>),
    /// Check the cameras and depth sensors of a USD file
    Check(CheckArgs),
    /// Serve a local web page to choose, tune and place OAKs
    Studio(StudioArgs),
    /// Print a shell completion script
    Completions(CompletionsArgs),
    /// Print a manual page
    Man(ManArgs),
}

#[derive(Args, Debug)]
pub(crate) struct ModelsArgs {
    /// List only this maker's models
    #[arg(long)]
    pub(crate) maker: Option<String>,

    /// List only models with this kind of depth sensor
    #[arg(long, value_parser = choice::parser::<DepthFilter>())]
    pub(crate) depth: Option<DepthFilter>,

    /// Print the result as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct DemoArgs {
    /// The output folder
    #[arg(short, long, value_name = "DIR", default_value = "oaktwin-demo", value_hint = ValueHint::DirPath)]
    pub(crate) output: PathBuf,
}

#[derive(Args, Debug)]
pub(crate) struct ShowArgs {
    /// The model
    pub(crate) model: String,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    #[command(flatten)]
    pub(crate) axes: ImuFrameArgs,

    /// Also print the source of each value and conflicting evidence
    #[arg(long)]
    pub(crate) provenance: bool,

    /// Print the result as JSON, always with provenance
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct ParamsArgs {
    /// The group of parameters: an engine, imager or filters [default: list the groups]
    pub(crate) group: Option<String>,

    /// Print the defaults of this platform [default: the model's, or rvc2]
    #[arg(long, value_parser = choice::parser::<Platform>())]
    pub(crate) platform: Option<Platform>,

    /// Print the defaults of this model
    #[arg(long)]
    pub(crate) model: Option<String>,

    /// Print the result as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct CompareArgs {
    /// The models [default: the parameter sheet's, and all in --catalog]
    pub(crate) models: Vec<String>,

    /// The output format
    #[arg(long, value_parser = choice::parser::<TableFormat>(), default_value_t)]
    pub(crate) format: TableFormat,
}

#[derive(Args, Debug)]
pub(crate) struct CheckArgs {
    /// The USD file: usda, usdc, usd or usdz
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) file: PathBuf,

    /// Check against this model [default: detected from prim names]
    #[arg(long)]
    pub(crate) model: Option<String>,

    #[arg(long, value_name = "FACTOR", default_value = "1", value_parser = limit::parse, help = limit::HELP)]
    pub(crate) scene_limit: SceneLimit,

    /// Print the result as JSON
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
    /// The command [default: the program itself]
    pub(crate) command: Vec<String>,
}

choice! {
    /// The format of comparison tables.
    TableFormat {
        /// Aligned columns.
        Text = "text",
        /// Markdown.
        Markdown = "markdown",
        /// JSON.
        Json = "json",
    }
}

#[cfg(test)]
mod tests {
    use clap::{Command, CommandFactory};

    use super::Cli;

    /// Adds the help texts of a command and its subcommands that break the rules.
    fn check(command: &Command, wrong: &mut Vec<String>) {
        let about = command.get_about().map(ToString::to_string).unwrap_or_default();
        if about.is_empty() || about.chars().count() >= 100 {
            wrong.push(format!("{}: {about}", command.get_name()));
        }
        for arg in command.get_arguments().filter(|arg| !arg.is_hide_set()) {
            let help = arg.get_help().map(ToString::to_string).unwrap_or_default();
            let text = help.split(" [default: ").next().unwrap_or_default();
            let is_last = text == help || help.ends_with(']');
            let is_short = !help.is_empty() && help.chars().count() < 100;
            let prose = text.to_lowercase();
            if !is_last || !is_short || prose.contains("by default") || prose.contains("default:") {
                wrong.push(format!("{} {}: {help}", command.get_name(), arg.get_id()));
            }
        }
        command
            .get_subcommands()
            .for_each(|command| check(command, wrong));
    }

    #[test]
    fn help_texts_are_short_and_end_with_the_default() {
        let mut wrong = Vec::new();
        check(&Cli::command(), &mut wrong);
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}
