//! `cargo xtask depthai-examples`: runs DepthAI's own examples on a virtual device.

use std::path::PathBuf;
use std::process::Command;

use crate::python::{PEERS, build_wheel, install_wheel};
use crate::workspace::{self, check};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// The folder examples/python of a checkout of luxonis/depthai-core
    examples: PathBuf,
    /// The scene that the examples see; by default the demo room
    #[arg(long)]
    scene: Option<PathBuf>,
    /// Seconds of each example
    #[arg(long, default_value_t = 20.0)]
    seconds: f64,
    /// Cargo profile of the package
    #[arg(long, default_value = "release")]
    profile: String,
}

/// Writes the demo room and returns its stage.
pub(crate) fn demo_room(profile: &str) -> Result<PathBuf, String> {
    let options = ["-p", "oaktwin-cli", "--profile", profile, "--features", "full"];
    let program = workspace::build_program("oaktwin", &options)?;
    let folder = workspace::root().join("target/depthai-examples");
    check(Command::new(program).args(["demo", "--output"]).arg(&folder))?;
    Ok(folder.join("demo_room/demo_room.usda"))
}

/// Runs the examples and prints the table of the manual.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let python = PEERS.ready()?;
    install_wheel(&python, &build_wheel(&python, &args.profile)?)?;
    let scene = match &args.scene {
        Some(scene) => scene.clone(),
        None => demo_room(&args.profile)?,
    };
    let mut examples = Command::new(&python);
    examples.arg(workspace::root().join("xtask/depthai_examples.py"));
    examples.arg(&args.examples).arg("--scene").arg(scene);
    check(examples.args(["--seconds", &args.seconds.to_string()]))
}
