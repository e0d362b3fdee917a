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

/// What `oaktwin demo` wrote.
pub(crate) struct Demo {
    pub(crate) room: PathBuf,
    /// The calibration of an OAK-D Pro PoE.
    calibration: PathBuf,
}

/// Writes the demo room and the calibration of a unit.
pub(crate) fn demo(profile: &str) -> Result<Demo, String> {
    let program = workspace::oaktwin(profile)?;
    let folder = workspace::target().join("depthai-examples");
    check(Command::new(program).args(["demo", "--output"]).arg(&folder))?;
    Ok(Demo {
        room: folder.join("demo_room/demo_room.usda"),
        calibration: folder.join("example_calibration.json"),
    })
}

/// Runs the examples and prints the table of the manual.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let python = PEERS.ready()?;
    install_wheel(&python, &build_wheel(&python, &args.profile)?)?;
    let demo = demo(&args.profile)?;
    let mut examples = Command::new(&python);
    examples.arg(workspace::root().join("xtask/depthai_examples.py"));
    examples.arg(&args.examples);
    examples
        .arg("--scene")
        .arg(args.scene.as_ref().unwrap_or(&demo.room));
    examples.arg("--calibration").arg(&demo.calibration);
    check(examples.args(["--seconds", &args.seconds.to_string()]))
}
