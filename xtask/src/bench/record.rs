//! Recordings as MCAP, compared with the Python package `mcap` writing the same messages.

use std::process::Command;

use crate::python::PACKAGE;
use crate::workspace::{self, check};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Number of frames
    #[arg(long, default_value_t = 300)]
    frames: usize,
    /// The image size
    #[arg(long, default_value = "1280x800")]
    resolution: String,
}

/// Runs the benchmark and prints both rates and the program's memory.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let program = workspace::oaktwin("release")?;
    let python = PACKAGE.ready()?;
    check(
        Command::new(&python)
            .arg(workspace::root().join("tests/oracles/bench_record.py"))
            .arg(program)
            .arg(args.frames.to_string())
            .arg(&args.resolution),
    )
}
