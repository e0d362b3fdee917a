use std::net::IpAddr;
use std::path::PathBuf;

use clap::{Args, ValueHint};
use oaktwin::scene::Up;
use oaktwin::usd::stage::SceneLimit;

use super::choice::parser;
use super::{RobotPlaceArgs, ThreadArgs, limit};

#[derive(Args, Debug)]
pub(crate) struct StudioArgs {
    /// The scene: USD, glTF, Collada, OBJ, STL or PLY [default: the room of `oaktwin demo`]
    #[arg(value_hint = ValueHint::FilePath)]
    pub(crate) scene: Option<PathBuf>,

    /// The first OAK's model
    #[arg(long, default_value = "OAK4-D")]
    pub(crate) model: String,

    /// The port to listen on; 0 chooses a free one
    #[arg(long, default_value_t = 0)]
    pub(crate) port: u16,

    /// The address to listen on, for browsers on other machines [default: this machine only]
    #[arg(long, value_name = "ADDRESS")]
    pub(crate) host: Option<IpAddr>,

    /// Do not open a browser
    #[arg(long)]
    pub(crate) no_open: bool,

    /// The up axis of a glTF, Collada, OBJ, STL or PLY file [default: the file's or its format's]
    #[arg(long, requires = "scene", value_parser = parser::<Up>())]
    pub(crate) up: Option<Up>,

    /// Metres per unit of a mesh file, or per unit that it states [default: 1]
    #[arg(long, requires = "scene", value_name = "METRES")]
    pub(crate) scale: Option<f64>,

    /// Let a glTF file name files outside its folder; only for trusted files
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
    pub(crate) robot: RobotPlaceArgs,

    #[command(flatten)]
    pub(crate) threads: ThreadArgs,

    /// Print the link as JSON
    #[arg(long)]
    pub(crate) json: bool,
}
