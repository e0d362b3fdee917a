use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum, ValueHint};

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

#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ExportFormat {
    Ros,
    Opencv,
    Kalibr,
    Depthai,
}
