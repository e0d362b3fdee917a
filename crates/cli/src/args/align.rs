use clap::Args;
use oaktwin::align::AlignTo;
use oaktwin::catalog::Role;
use oaktwin::depth::align::{AlignedZ, Fill};

use super::choice::parser;
use crate::context::Result;
use crate::size;

/// Depth aligned to another camera.
#[derive(Args, Debug)]
#[command(next_help_heading = "Outputs")]
pub(crate) struct AlignArgs {
    /// Also write depth aligned to another camera of the model
    #[arg(long, value_parser = parser::<Role>(), value_name = "CAMERA")]
    align: Option<Role>,

    /// The size of aligned images, such as 1280x800 [default: the camera's]
    #[arg(long, value_name = "WxH", requires = "align")]
    align_size: Option<String>,

    /// The splatting of aligned samples
    #[arg(long, value_parser = parser::<Fill>(), default_value_t)]
    align_fill: Fill,

    /// The depth of aligned samples [default: the device's, measured for stereo on RVC2, else geometric]
    #[arg(long, value_parser = parser::<AlignedZ>(), requires = "align")]
    align_depth: Option<AlignedZ>,
}

impl AlignArgs {
    /// The camera that depth is aligned to.
    pub(crate) fn to(&self) -> Result<Option<AlignTo>> {
        let size = size::parse("--align-size", self.align_size.as_deref())?;
        Ok(self.align.map(|camera| AlignTo {
            camera,
            size,
            fill: self.align_fill,
            z: self.align_depth,
        }))
    }
}
