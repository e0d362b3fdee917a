use clap::Args;

/// What a depth image is also written as.
#[derive(Args, Debug)]
pub(crate) struct DepthFileArgs {
    /// Depth also as 16-bit PNG in millimetres
    #[arg(long)]
    pub(crate) png16: bool,

    /// Depth also as a picture, coloured by distance
    #[arg(long)]
    pub(crate) preview: bool,
}
