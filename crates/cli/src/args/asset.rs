use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::camera::ApertureOffsets;
use oaktwin::usd::asset::{AssetTarget, Format, IsaacVersion};
use oaktwin::usd::stage::SceneLimit;

use super::choice::parser;
use super::{ImuFrameArgs, UnitArgs, limit};

#[derive(Args, Debug)]
pub(crate) struct AssetArgs {
    /// The model, `sheet` for the five of the parameter sheet, or `all`
    #[arg(value_name = "MODEL|sheet|all")]
    pub(crate) model: String,

    /// The output file or folder; a folder with `sheet` and `all`
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::AnyPath)]
    pub(crate) output: PathBuf,

    /// The file format [default: from the output's extension, else usd]
    #[arg(long, value_parser = parser::<Format>())]
    pub(crate) format: Option<Format>,

    /// Write for this version of Isaac Sim
    #[arg(long, value_parser = parser::<IsaacVersion>(), default_value_t)]
    pub(crate) isaac: IsaacVersion,

    /// Write for this renderer (ovrtx is experimental)
    #[arg(long, value_parser = parser::<AssetTarget>(), default_value_t)]
    pub(crate) target: AssetTarget,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    #[command(flatten)]
    pub(crate) axes: ImuFrameArgs,

    /// The convention of aperture offsets for a calibrated principal point
    #[arg(long, value_parser = parser::<ApertureOffsets>(), default_value_t)]
    pub(crate) aperture_offsets: ApertureOffsets,

    /// Write the extended mode, with twice the disparity range, for closer objects
    #[arg(long)]
    pub(crate) extended_disparity: bool,

    /// Also write the legacy distortion attributes for Isaac Sim 6, where they have no effect
    #[arg(long)]
    pub(crate) legacy_distortion: bool,

    /// Add a rigid body with mass and collider, as the inertial sensor requires
    #[arg(long)]
    pub(crate) rigid_body: bool,

    /// Omit the visible body
    #[arg(long)]
    pub(crate) no_body: bool,

    /// Write only a layer with the calibrated values over this asset, the vendor's or Isaac Sim's
    #[arg(long, value_name = "ASSET", requires = "calibration", value_hint = ValueHint::FilePath)]
    pub(crate) over: Option<PathBuf>,

    #[arg(
        long,
        value_name = "FACTOR",
        default_value = "1",
        value_parser = limit::parse,
        requires = "over",
        help = limit::HELP
    )]
    pub(crate) scene_limit: SceneLimit,

    /// Print the written files and findings as JSON
    #[arg(long)]
    pub(crate) json: bool,
}
