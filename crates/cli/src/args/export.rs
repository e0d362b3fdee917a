use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::robot::{Attachment, Format, Mount, RobotError};

use super::choice::parser;
use super::{ImuFrameArgs, UnitArgs};

#[derive(Args, Debug)]
pub(crate) struct ExportArgs {
    /// The model, or a DepthAI calibration (JSON) whose product name is the model
    #[arg(value_name = "MODEL|FILE")]
    pub(crate) model: String,

    /// The format
    #[arg(long, value_parser = parser::<Format>())]
    pub(crate) to: Format,

    /// The output folder
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) output: PathBuf,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    #[command(flatten)]
    pub(crate) axes: ImuFrameArgs,

    /// The name of the device, the prefix of its frames
    #[arg(long, default_value = "oak")]
    name: String,

    /// The robot's link that carries the device
    #[arg(long, value_name = "LINK")]
    parent: Option<String>,

    /// The point of the device that --xyz places
    #[arg(long, value_parser = parser::<Mount>(), default_value_t)]
    mount: Mount,

    /// The position of this point in the parent's frame, in metres
    #[arg(long, num_args = 3, value_names = ["X", "Y", "Z"], default_values_t = [0.0; 3])]
    xyz: Vec<f64>,

    /// The device's roll, pitch and yaw in the parent's frame, in radians
    #[arg(long, num_args = 3, value_names = ["R", "P", "Y"], default_values_t = [0.0; 3])]
    rpy: Vec<f64>,

    /// Print the written files and findings as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

impl ExportArgs {
    pub(crate) fn attachment(&self) -> Result<Attachment, RobotError> {
        let three = |values: &[f64]| values.first_chunk().copied().unwrap_or_default();
        Ok(Attachment {
            name: self.name.clone(),
            parent: self.parent.clone(),
            mount: self.mount,
            parent_from_mount: Attachment::pose(three(&self.xyz), three(&self.rpy))?,
        })
    }
}
