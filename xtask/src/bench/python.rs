//! The cost of calls from Python.

use std::process::Command;

use crate::python::{PEERS, build_wheel, install_wheel};
use crate::workspace::{self, check};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Number of rounds
    #[arg(long, default_value_t = 7)]
    rounds: usize,
    /// Cargo profile of the package
    #[arg(long, default_value = "release")]
    profile: String,
}

/// Runs the benchmark and prints its table.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let python = PEERS.ready()?;
    install_wheel(&python, &build_wheel(&python, &args.profile)?)?;
    let script = workspace::root().join("tests/oracles/bench_python.py");
    check(Command::new(&python).arg(script).arg(args.rounds.to_string()))
}
