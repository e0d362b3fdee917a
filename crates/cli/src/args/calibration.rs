use std::path::PathBuf;

use clap::{Args, Subcommand, ValueHint};
use oaktwin::calibration::export::Format;
use oaktwin::calibration::import::{LengthUnit, NamedCamera};

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
    /// Convert a calibration of ROS, Kalibr or OpenCV to DepthAI's JSON
    Import(CalibrationImportArgs),
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

    /// Ignore calibration errors, and lenses that the format cannot represent
    #[arg(long)]
    pub(crate) force: bool,
}

#[derive(Args, Debug)]
#[command(after_help = "FILES are one or more of:\n\
    - ROS's camera_info, one file per camera. The baseline of a pair is in the projection matrix of the right camera.\n\
    - Kalibr's camchain.yaml or camchain-imucam.yaml.\n\
    - OpenCV's FileStorage in YAML: files with a camera matrix and coefficients, the intrinsics.yml and extrinsics.yml of its \
    stereo sample, or both in one file.\n\n\
    The position of a camera is in its name or its file's name: left, right, rgb, tof, or a socket such as cam_d. Kalibr's \
    cam0, cam1 and cam2 are left, right and rgb otherwise.")]
pub(crate) struct CalibrationImportArgs {
    /// The files of one device; their formats are recognized
    #[arg(required = true, value_name = "FILES", value_hint = ValueHint::FilePath)]
    pub(crate) files: Vec<PathBuf>,

    /// The output file (JSON) [default: standard output]
    #[arg(short, long, value_name = "OUT.json", value_hint = ValueHint::FilePath)]
    pub(crate) output: Option<PathBuf>,

    /// The model, whose name and design are added and which the result is checked against
    #[arg(long)]
    pub(crate) model: Option<String>,

    /// The position of a camera: left, right, rgb, tof or a socket [default: from its name]
    #[arg(long = "camera", value_name = "NAME=POSITION", value_parser = named_camera)]
    pub(crate) cameras: Vec<NamedCamera>,

    /// The unit of lengths in the files; OpenCV's is that of the calibration board
    #[arg(long, value_parser = parser::<LengthUnit>(), default_value_t)]
    pub(crate) unit: LengthUnit,

    /// The image size of files without one
    #[arg(long, value_name = "WxH")]
    pub(crate) size: Option<String>,

    /// The coefficients of OpenCV files that do not state it are of cv2.fisheye
    #[arg(long)]
    pub(crate) fisheye: bool,

    /// Ignore calibration errors
    #[arg(long)]
    pub(crate) force: bool,
}

fn named_camera(text: &str) -> Result<NamedCamera, String> {
    NamedCamera::from_text(text)
        .ok_or_else(|| "use NAME=POSITION with left, right, rgb, tof, or cam_a to cam_j".to_owned())
}
