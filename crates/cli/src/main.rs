//! The program `oaktwin`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(oaktwin_cli::main(std::env::args_os()))
}
