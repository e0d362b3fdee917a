//! `oaktwin bridge` between a publisher and a subscriber of Cyclone DDS in Python.

use super::turns::Script;
use crate::python::CURRENT;
use crate::workspace::{self, check};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Duration of each case, seconds
    #[arg(long, default_value_t = 60)]
    seconds: u32,
}

/// Runs the benchmark, which prints its table.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let program = workspace::oaktwin("release")?;
    let script = Script::new(&CURRENT, "bench_bridge.py")?;
    let mut command = script.command();
    command
        .arg(program)
        .args(["--seconds", &args.seconds.to_string()]);
    check(&mut command)
}
