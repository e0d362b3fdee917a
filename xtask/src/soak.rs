//! `cargo xtask soak`: long runs of the program and the Python package under constant load.

use std::process::Command;

use crate::python::{PACKAGE, build_wheel, install_wheel};
use crate::workspace::{self, check};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Duration of the loads, which run at the same time
    #[arg(long, default_value_t = 60.0)]
    minutes: f64,
    /// Only these loads: render, sense, python, studio
    #[arg(long)]
    load: Vec<String>,
    /// Cargo profile of the program and the package
    #[arg(long, default_value = "release")]
    profile: String,
}

/// Runs the loads and prints their table. An error if memory or descriptors grew, or if results changed.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    if !cfg!(target_os = "linux") {
        return Err("memory and descriptors are read below /proc, which only Linux has".into());
    }
    let program = workspace::oaktwin(&args.profile)?;
    let python = PACKAGE.ready()?;
    install_wheel(&python, &build_wheel(&python, &args.profile)?)?;
    let mut soak = Command::new(&python);
    soak.arg(workspace::root().join("tests/soak/soak.py"));
    soak.arg("--program").arg(program);
    soak.args(["--minutes", &args.minutes.to_string()]);
    for load in &args.load {
        soak.args(["--load", load]);
    }
    check(&mut soak)
}
