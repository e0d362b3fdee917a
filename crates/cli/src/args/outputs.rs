use clap::Args;
use oaktwin::dataset::Extras;

/// The output options of `render`, `sense` and `stereo`.
#[derive(Args, Debug)]
#[command(next_help_heading = "Outputs")]
pub(crate) struct OutputArgs {
    /// The annotators to write, comma-separated
    #[arg(long, value_name = "NAMES", value_delimiter = ',', alias = "outputs")]
    pub(crate) annotators: Vec<String>,

    /// Also write point clouds as PLY
    #[arg(long, alias = "pointcloud")]
    pub(crate) ply: bool,

    /// Also write depth as EXR, float32 metres
    #[arg(long)]
    pub(crate) exr: bool,

    /// Also write depth as 16-bit PNG, millimetres
    #[arg(long)]
    pub(crate) png16: bool,

    /// Also write depth as a colour-mapped PNG
    #[arg(long)]
    pub(crate) preview: bool,
}

impl OutputArgs {
    /// The additional files of each frame.
    pub(crate) fn extras(&self) -> Extras {
        Extras {
            millimetres: self.png16,
            exr: self.exr,
            preview: self.preview,
            ply: self.ply,
        }
    }
}
