//! `cargo xtask bench studio`: the page in a headless browser, with the demo room.

use std::path::Path;
use std::time::Instant;

use crate::web::{self, Server};
use crate::workspace;

#[derive(clap::Args)]
pub(crate) struct Args {}

pub(crate) fn run(_: &Args) -> Result<(), String> {
    let program = workspace::oaktwin("release")?;
    web::install()?;
    let start = Instant::now();
    let server = Server::of(Path::new(&program))?;
    let started = start.elapsed().as_millis();
    println!("| from a slider to new pixels | median (from, to) |\n|---|---|");
    println!("| from the command to the link | {started} ms |");
    workspace::check(web::npm(&["run", "--silent", "bench"]).env("OAKTWIN_STUDIO_URL", &server.link))
}
