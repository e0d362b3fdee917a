//! Checks USD files and prints each report as a line of JSON: `cargo run -p oaktwin-usd --example check -- FILE…`
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program")]

use std::process::ExitCode;

use oaktwin_usd::check::{CheckOptions, check};

fn main() -> ExitCode {
    let mut code = ExitCode::SUCCESS;
    for file in std::env::args().skip(1) {
        match check(&file, &CheckOptions::default()).map(|report| serde_json::to_string(&report)) {
            Ok(Ok(json)) => println!("{json}"),
            Ok(Err(error)) => eprintln!("{file}: {error}"),
            Err(error) => {
                eprintln!("{error}");
                code = ExitCode::from(2);
            }
        }
    }
    code
}
