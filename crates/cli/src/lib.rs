//! The program `oaktwin`: digital twins of Luxonis OAK depth cameras. This crate parses arguments and handles messages
//! and exit codes. It is a library so that other programs can run it.

mod args;
mod commands;
mod context;
mod destination;
mod number;
mod output;
mod plot;
mod progress;
mod signals;
mod size;

use std::ffi::OsString;

use clap::{CommandFactory, FromArgMatches};
use oaktwin::{diagnostic, memory, panics};

use args::{Cli, Command, numbers};
use context::{Context, Exit, Result};

/// Runs the program with `arguments`, the first of which is its name, printing to standard output and standard error.
/// Returns the exit code: 0 (success), 1 (findings), 2 (error), or 128 plus the number of a signal: 130 after Ctrl-C.
#[must_use]
pub fn main(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    panics::hide_contained();
    let cli = match parse(arguments) {
        Ok(cli) => cli,
        Err(message) => {
            // Help and version are messages, too.
            return match message.print() {
                Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
                    finish(Err(output::not_written(&error)))
                }
                _ => u8::try_from(message.exit_code()).unwrap_or(Exit::Error.code()),
            };
        }
    };
    diagnostic::with_style(output::flag, || {
        finish(signals::handle().and_then(|()| run(&cli)))
    })
}

fn parse(arguments: impl IntoIterator<Item = OsString>) -> std::result::Result<Cli, clap::Error> {
    let parser = numbers::accept_negative(Cli::command());
    let matches = parser.try_get_matches_from(arguments.into_iter().map(numbers::plain))?;
    Cli::from_arg_matches(&matches)
}

/// Prints a command's error, if any, and returns the exit code.
fn finish(result: Result<Exit>) -> u8 {
    match result {
        Ok(exit @ (Exit::Success | Exit::Interrupted)) => signals::exit_code().unwrap_or(exit.code()),
        Ok(exit) => exit.code(),
        Err(error) if output::is_closed_pipe(error.as_ref()) => Exit::Success.code(),
        Err(error) => {
            output::say(&format!("error: {error}"));
            Exit::Error.code()
        }
    }
}

fn run(cli: &Cli) -> Result<Exit> {
    memory::set_limit(cli.memory_limit);
    // These commands need no catalog and must work even if it is invalid.
    match &cli.command {
        Command::Completions(args) => return commands::manual::completions(args),
        Command::Man(args) => return commands::manual::man(args),
        _ => {}
    }
    let context = Context::new(cli.catalog.as_deref())?;
    match &cli.command {
        Command::Demo(args) => commands::demo::run(&context, args),
        Command::Params(args) => commands::params::run(&context, args),
        Command::Models(args) => commands::models::run(&context, args),
        Command::Show(args) => commands::show::run(&context, args),
        Command::Compare(args) => commands::compare::run(&context, args),
        Command::Calibration(args) => commands::calibration::run(&context, args),
        Command::Asset(args) => commands::asset::run(&context, args),
        Command::Population(args) => commands::population::run(&context, args),
        Command::Export(args) => commands::export::run(&context, args),
        Command::Generate(args) => commands::generate::run(&context, args),
        Command::Render(args) => commands::render::run(&context, args),
        Command::Sense(args) => commands::sense::run(&context, args),
        Command::Bridge(args) => commands::bridge::run(&context, args),
        Command::Stereo(args) => commands::stereo::run(&context, args),
        Command::Accuracy(args) => commands::accuracy::run(&context, args),
        Command::Coverage(args) => commands::coverage::run(&context, args),
        Command::Fit(args) => commands::fit::run(&context, args),
        Command::Check(args) => commands::check::run(&context, args),
        Command::Studio(args) => commands::studio::run(&context, args),
        Command::Completions(_) | Command::Man(_) => Ok(Exit::Success),
    }
}
