use std::path::PathBuf;

use clap::{Args, ValueEnum, ValueHint};
use oaktwin::camera::ApertureOffsets;
use oaktwin::usd::asset;

use super::{Isaac, UnitArgs};

#[derive(Args, Debug)]
pub(crate) struct AssetArgs {
    /// Model, or `all`
    #[arg(value_name = "MODEL|all")]
    pub(crate) model: String,

    /// Output file or folder; a folder with `all`
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::AnyPath)]
    pub(crate) output: PathBuf,

    /// File format [default: from the output's extension, else usd]
    #[arg(long, value_enum)]
    pub(crate) format: Option<AssetFormat>,

    /// Isaac Sim version to write for
    #[arg(long, value_enum, default_value_t = Isaac::V5_1)]
    pub(crate) isaac: Isaac,

    /// Renderer to write for (ovrtx is experimental)
    #[arg(long, value_enum, default_value_t = Target::Isaac)]
    pub(crate) target: Target,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    /// Convention of aperture offsets for a calibrated principal point
    #[arg(long, value_enum, default_value_t = Offsets::Openusd)]
    pub(crate) aperture_offsets: Offsets,

    /// Use extended disparity: up to 191 px instead of 95, for nearer objects
    #[arg(long)]
    pub(crate) extended_disparity: bool,

    /// Also write the legacy distortion attributes for Isaac Sim 6, where they have no effect
    #[arg(long)]
    pub(crate) legacy_distortion: bool,

    /// Add a rigid body with mass and collider, which the inertial sensor requires
    #[arg(long)]
    pub(crate) rigid_body: bool,

    /// Omit the visible body
    #[arg(long)]
    pub(crate) no_body: bool,

    /// Write only a layer with the calibrated values over this asset (the vendor's or Isaac Sim's)
    #[arg(long, value_name = "ASSET", requires = "calibration", value_hint = ValueHint::FilePath)]
    pub(crate) over: Option<PathBuf>,

    /// Print the written files and findings as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(ValueEnum, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum AssetFormat {
    /// Text
    Usda,
    /// Text with the extension that Isaac Sim's asset paths use
    #[default]
    Usd,
    /// Package
    Usdz,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    Isaac,
    Ovrtx,
}

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Offsets {
    /// OpenUSD's sign convention
    Openusd,
    /// The parameter sheet's formula
    Document,
    /// No offsets
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
