//! The program `oaktwin`: digital twins of Luxonis OAK depth cameras. Arguments, messages and exit codes; the work
//! is the library's. A library itself, so that other programs can be it.

mod args;
mod commands;
mod context;
mod destination;
mod output;
mod plot;
mod progress;
mod size;

use std::ffi::OsString;

use clap::Parser;
use oaktwin::diagnostic;

use args::{Cli, Command};
use context::{Context, Exit, Result};

/// The program, with these arguments, the first of which is its name; what it prints goes to the process's own standard
/// output and error. How it ended, as a process's exit code: 0, 1 (findings), 2 (an error), 130 (Ctrl-C).
#[must_use]
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let cli = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(message) => {
            // Help and version are messages too; a closed pipe is no error.
            let _ = message.print();
            return u8::try_from(message.exit_code()).unwrap_or(Exit::Error.code());
        }
    };
    diagnostic::with_style(output::flag, || finish(run(&cli)))
}

/// The exit code of a command that has ended, after its error has been printed.
fn finish(ended: Result<Exit>) -> u8 {
    match ended {
        Ok(exit) => exit.code(),
        Err(error) if output::is_closed_pipe(error.as_ref()) => Exit::Good.code(),
        Err(error) => {
            output::say(&format!("error: {error}"));
            Exit::Error.code()
        }
    }
}

fn run(cli: &Cli) -> Result<Exit> {
    // These two need no catalog, and must work where a catalog is broken.
    match &cli.command {
        Command::Completions(args) => return commands::manual::completions(args),
        Command::Man(args) => return commands::manual::man(args),
        _ => {}
    }
    let context = Context::new(cli.catalog.as_deref())?;
    match &cli.command {
        Command::Demo(args) => commands::demo::run(&context, args),
        Command::Models(args) => commands::models::run(&context, args),
        Command::Show(args) => commands::show::run(&context, args),
        Command::Compare(args) => commands::compare::run(&context, args),
        Command::Calibration(args) => commands::calibration::run(&context, args),
        Command::Asset(args) => commands::asset::run(&context, args),
        Command::Render(args) => commands::render::run(&context, args),
        Command::Sense(args) => commands::sense::run(&context, args),
        Command::Stereo(args) => commands::stereo::run(&context, args),
        Command::Accuracy(args) => commands::accuracy::run(&context, args),
        Command::Fit(args) => commands::fit::run(&context, args),
        Command::Check(args) => commands::check::run(&context, args),
        Command::Completions(_) | Command::Man(_) => Ok(Exit::Good),
    }
}
