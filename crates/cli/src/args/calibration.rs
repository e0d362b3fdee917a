use std::path::PathBuf;

use clap::{Args, Subcommand, ValueHint};
use oaktwin::calibration::export::Format;

use super::choice::parser;

#[derive(Args, Debug)]
pub(crate) struct CalibrationArgs {
    #[command(subcommand)]
    pub(crate) command: CalibrationCommand,
}

#[derive(Subcommand, Debug)]
pub(crate) enum CalibrationCommand {
    /// Print a calibration and problems found in it
    Show(CalibrationShowArgs),
    /// Export a calibration to other formats
    Export(CalibrationExportArgs),
}

#[derive(Args, Debug)]
pub(crate) struct CalibrationShowArgs {
    /// DepthAI calibration (JSON)
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) file: PathBuf,

    /// Model to check against [default: from the calibration's product name]
    #[arg(long)]
    pub(crate) model: Option<String>,

    /// Print JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct CalibrationExportArgs {
    /// DepthAI calibration (JSON), or a model for its nominal calibration
    #[arg(value_name = "FILE|MODEL", value_hint = ValueHint::FilePath)]
    pub(crate) from: String,

    /// Format: ROS camera info, OpenCV FileStorage, Kalibr camchain and imu, or DepthAI JSON
    #[arg(long, value_parser = parser::<Format>())]
    pub(crate) to: Format,

    /// Output file, or folder for formats with several files [default: standard output]
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::AnyPath)]
    pub(crate) output: Option<PathBuf>,

    /// Ignore calibration errors
    #[arg(long)]
    pub(crate) force: bool,
}
