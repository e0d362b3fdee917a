//! What a call from Python costs.

use std::process::Command;

use crate::python::{PEERS, build_wheel, install_wheel};
use crate::workspace::{self, check};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// How often everybody takes a turn
    #[arg(long, default_value_t = 7)]
    rounds: usize,
    /// The profile that cargo builds the package with
    #[arg(long, default_value = "release")]
    profile: String,
}

/// Measures and prints.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let python = PEERS.ready()?;
    install_wheel(&python, &build_wheel(&python, &args.profile)?)?;
    let script = workspace::root().join("tests/oracles/bench_python.py");
    check(Command::new(&python).arg(script).arg(args.rounds.to_string()))
}
