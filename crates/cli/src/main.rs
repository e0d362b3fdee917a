//! The program `oaktwin`: digital twins of Luxonis OAK depth cameras. Arguments, messages and exit codes; the work
//! is the library's.

mod args;
mod commands;
mod context;
mod destination;
mod interrupt;
mod output;
mod progress;
mod size;

use std::process::ExitCode;

use clap::Parser;

use args::{Cli, Command};
use context::{Context, Exit, Result};

fn main() -> ExitCode {
    let cli = Cli::parse();
    match run(&cli) {
        Ok(exit) => exit.into(),
        Err(error) if output::is_closed_pipe(error.as_ref()) => Exit::Good.into(),
        Err(error) => {
            output::say(&format!("error: {error}"));
            Exit::Error.into()
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
        Command::Accuracy(args) => commands::accuracy::run(&context, args),
        Command::Check(args) => commands::check::run(&context, args),
        Command::Completions(_) | Command::Man(_) => Ok(Exit::Good),
    }
}
