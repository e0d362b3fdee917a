//! `cargo xtask conformance`: the program as a user runs it, against Isaac Sim's own output.

use std::path::PathBuf;
use std::process::ExitCode;

use crate::python::{CURRENT, isolated};
use crate::workspace;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// The folder with isaac-pointcloud and isaac-camera-params; by default `conformance` in `OAKTWIN_TEST_DATA`
    #[arg(long, value_name = "DIR")]
    data: Option<PathBuf>,
}

/// Exit code when there is nothing to compare with.
const NO_DATA: u8 = 2;

/// Builds, compares, prints a table.
pub(crate) fn run(args: &Args) -> ExitCode {
    let data = args
        .data
        .clone()
        .or_else(|| Some(PathBuf::from(std::env::var_os("OAKTWIN_TEST_DATA")?).join("conformance")));
    let Some(data) = data.filter(|folder| folder.is_dir()) else {
        println!("error: no data: --data DIR or OAKTWIN_TEST_DATA names the folder");
        return ExitCode::from(NO_DATA);
    };
    match compare(data) {
        Ok(code) => ExitCode::from(code),
        Err(message) => {
            println!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

fn compare(data: PathBuf) -> Result<u8, String> {
    let program = workspace::build_program("oaktwin", &["--workspace"])?;
    let python = CURRENT.ready()?;
    let script = workspace::root().join("tests/oracles/conformance.py");
    let mut command = isolated(&python);
    command.arg(script).arg(program).arg(data);
    let status = command
        .status()
        .map_err(|error| format!("{}: {error}", workspace::shown(&command)))?;
    let code = status.code().and_then(|code| u8::try_from(code).ok());
    Ok(code.unwrap_or(1))
}
