use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use oaktwin::camera::ApertureOffsets;
use oaktwin::usd::asset;

use super::{Isaac, UnitArgs};

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

impl From<AssetFormat> for asset::Format {
    fn from(format: AssetFormat) -> Self {
        match format {
            AssetFormat::Usda => Self::Usda,
            AssetFormat::Usd => Self::Usd,
            AssetFormat::Usdz => Self::Usdz,
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
