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
    /// Print a calibration and the problems found in it
    Show(CalibrationShowArgs),
    /// Export a calibration to other formats
    Export(CalibrationExportArgs),
}

#[derive(Args, Debug)]
pub(crate) struct CalibrationShowArgs {
    /// The DepthAI calibration (JSON)
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) file: PathBuf,

    /// Check against this model [default: from the calibration's product name]
    #[arg(long)]
    pub(crate) model: Option<String>,

    /// Print the result as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Args, Debug)]
pub(crate) struct CalibrationExportArgs {
    /// The DepthAI calibration (JSON), or a model for its nominal calibration
    #[arg(value_name = "FILE|MODEL", value_hint = ValueHint::FilePath)]
    pub(crate) from: String,

    /// The format
    #[arg(long, value_parser = parser::<Format>())]
    pub(crate) to: Format,

    /// The output file, or a folder for several files [default: standard output]
    #[arg(short, long, value_name = "PATH", value_hint = ValueHint::AnyPath)]
    pub(crate) output: Option<PathBuf>,

    /// Ignore calibration errors
    #[arg(long)]
    pub(crate) force: bool,
}
