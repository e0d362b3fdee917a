//! `cargo xtask conformance`: compares the program's output with Isaac Sim's.

use std::path::PathBuf;
use std::process::ExitCode;

use crate::python::{CURRENT, isolated};
use crate::workspace;

#[derive(clap::Args)]
pub(crate) struct Args {
    /// Folder with isaac-pointcloud and isaac-camera-params [default: `conformance` in `OAKTWIN_TEST_DATA`]
    #[arg(long, value_name = "DIR")]
    data: Option<PathBuf>,
}

/// The exit code if the reference data are missing.
const NO_DATA: u8 = 2;

/// Builds the program, compares, and prints a table.
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
    let program = workspace::oaktwin("dev")?;
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
