//! Depth frames: prepares the data and environments of `render-bench` and runs it.

use std::path::PathBuf;
use std::process::Command;

use super::turns::{Script, program};
use crate::python::RENDER;
use crate::workspace::{self, check, output};

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Arguments of render-bench; `--help` lists them
    #[arg(trailing_var_arg = true, allow_hyphen_values = true)]
    arguments: Vec<String>,
}

/// Prepares and runs the benchmark, and reports what it has to skip.
pub(crate) fn run(args: &Args) -> Result<(), String> {
    let program = program("render-bench")?;
    if args.arguments.iter().any(|word| word == "--help" || word == "-h") {
        return check(Command::new(program).args(&args.arguments));
    }
    if let Err(reason) = prepare() {
        println!("skipped: {reason}");
    }
    let mut command = Command::new(program);
    check(
        command
            .args(&args.arguments)
            .arg("--environment")
            .arg(RENDER.folder()),
    )?;
    super::shutter::run()
}

/// Returns the Python environment, and the triangles of the chess set as extracted by OpenUSD.
fn prepare() -> Result<(), String> {
    let script = Script::new(&RENDER, "extract_triangles.py")?;
    let data = std::env::var_os("OAKTWIN_TEST_DATA").ok_or("the chess set: OAKTWIN_TEST_DATA is not set")?;
    let stage = PathBuf::from(data).join("data/scenes/OpenChessSet/chess_set.usda");
    if !stage.exists() {
        return Err(format!("the chess set: {}: not there", stage.display()));
    }
    let folder = workspace::target().join("bench-render");
    std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut extract = script.command();
    extract.arg(stage);
    extract.args(["positions.f32", "triangles.u32"].map(|part| folder.join(format!("chess.{part}"))));
    output(&mut extract)?;
    Ok(())
}
