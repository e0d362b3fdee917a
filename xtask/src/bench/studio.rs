//! `cargo xtask bench studio`: the page in a headless browser, with the demo room.

use std::path::Path;

use crate::web::{self, Server};
use crate::workspace;

#[derive(clap::Args)]
pub(crate) struct Args {}

pub(crate) fn run(_: &Args) -> Result<(), String> {
    let program = workspace::build_program("oaktwin", &["--release", "-p", "oaktwin-cli"])?;
    let server = Server::of(Path::new(&program))?;
    web::install()?;
    println!("| from a slider to new pixels | median (from, to) |\n|---|---|");
    workspace::check(web::npm(&["run", "--silent", "bench"]).env("OAKTWIN_STUDIO_URL", &server.link))
}
