//! Data sets: the table-top recipe, compared with a script that uses Open3D and NumPy, and with the rendering of Blender and pyrender;
//! heaps, compared with MuJoCo.

use std::process::Command;

use crate::python::{BLENDER, PEERS, ROBOT};
use crate::workspace::{self, check};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Number of frames
    #[arg(long, default_value_t = 40)]
    frames: usize,
}

/// Runs the benchmarks and prints their rates and times.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let program = workspace::oaktwin("release")?;
    let python = PEERS.ready()?;
    let root = workspace::root();
    let script = root.join("tests/oracles/bench_generate.py");
    let recipe = root.join("examples/recipes/table_top.toml");
    let mut command = Command::new(&python);
    command
        .arg(script)
        .arg(&program)
        .arg(recipe)
        .arg(args.frames.to_string());
    match BLENDER.ready() {
        Ok(blender) => _ = command.arg(blender),
        Err(error) => println!("Blender and pyrender are skipped: {error}"),
    }
    check(&mut command)?;
    let robot = ROBOT.ready()?;
    let script = root.join("tests/oracles/bench_heaps.py");
    check(Command::new(&robot).arg(script).arg(&program))
}
