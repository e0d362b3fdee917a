use std::net::IpAddr;
use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::usd::stage::SceneLimit;

use super::{ThreadArgs, limit};

#[derive(Args, Debug)]
pub(crate) struct StudioArgs {
    /// Scene: usd, usda, usdc, usdz, gltf, glb, obj, stl or ply [default: the room of `oaktwin demo`]
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) scene: Option<PathBuf>,

    /// Model that is shown first
    #[arg(long, default_value = "OAK4-D")]
    pub(crate) model: String,

    /// Port to listen on; 0 chooses a free one
    #[arg(long, default_value_t = 0)]
    pub(crate) port: u16,

    /// Address to listen on, for browsers on other machines [default: this machine only]
    #[arg(long, value_name = "ADDRESS")]
    pub(crate) host: Option<IpAddr>,

    /// Do not open a browser
    #[arg(long)]
    pub(crate) no_open: bool,

    /// Allow a glTF scene to name files outside its folder
    #[arg(long)]
    pub(crate) allow_outside: bool,

    #[arg(
        long,
        value_name = "FACTOR",
        default_value = "1",
        value_parser = limit::parse,
        help = limit::HELP
    )]
    pub(crate) scene_limit: SceneLimit,

    #[command(flatten)]
    pub(crate) threads: ThreadArgs,

    /// Print the link as JSON
    #[arg(long)]
    pub(crate) json: bool,
}
