//! Frames per second of a virtual device.

use std::process::Command;

use crate::depthai_examples::demo;
use crate::python::{PEERS, build_wheel, install_wheel};
use crate::workspace::{self, check};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Seconds of each measurement
    #[arg(long, default_value_t = 10.0)]
    seconds: f64,
    /// Cargo profile of the package
    #[arg(long, default_value = "release")]
    profile: String,
}

/// Runs the benchmark and prints its table.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let python = PEERS.ready()?;
    install_wheel(&python, &build_wheel(&python, &args.profile)?)?;
    let room = demo(&args.profile)?.room;
    let script = workspace::root().join("tests/oracles/bench_depthai.py");
    check(
        Command::new(&python)
            .arg(script)
            .arg(args.seconds.to_string())
            .arg(room),
    )
}
