use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::robot::{Attachment, Format, Mount, RobotError};

use super::UnitArgs;
use super::choice::parser;

#[derive(Args, Debug)]
pub(crate) struct ExportArgs {
    /// Model, or a DepthAI calibration (JSON) whose product name tells the model
    #[arg(value_name = "MODEL|FILE")]
    pub(crate) model: String,

    /// Format
    #[arg(long, value_parser = parser::<Format>())]
    pub(crate) to: Format,

    /// Output folder
    #[arg(short, long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) output: PathBuf,

    #[command(flatten)]
    pub(crate) unit: UnitArgs,

    /// Name of the device, which begins the names of its frames
    #[arg(long, default_value = "oak")]
    name: String,

    /// Link of a robot that carries the device
    #[arg(long, value_name = "LINK")]
    parent: Option<String>,

    /// Point of the device that is placed
    #[arg(long, value_parser = parser::<Mount>(), default_value_t)]
    mount: Mount,

    /// Position of that point in the parent's frame, metres
    #[arg(long, num_args = 3, allow_negative_numbers = true, value_names = ["X", "Y", "Z"])]
    xyz: Option<Vec<f64>>,

    /// Roll, pitch and yaw of the device in the parent's frame, radians
    #[arg(long, num_args = 3, allow_negative_numbers = true, value_names = ["R", "P", "Y"])]
    rpy: Option<Vec<f64>>,

    /// Print the written files and findings as JSON
    #[arg(long)]
    pub(crate) json: bool,
}

impl ExportArgs {
    pub(crate) fn attachment(&self) -> Result<Attachment, RobotError> {
        let three = |values: &Option<Vec<f64>>| {
            let values = values.as_deref().and_then(|values| values.first_chunk());
            values.copied().unwrap_or_default()
        };
        Ok(Attachment {
            name: self.name.clone(),
            parent: self.parent.clone(),
            mount: self.mount,
            parent_from_mount: Attachment::pose(three(&self.xyz), three(&self.rpy))?,
        })
    }
}
