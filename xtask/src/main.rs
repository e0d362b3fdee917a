//! `cargo xtask`: what people and CI run.

#![expect(
    clippy::print_stdout,
    reason = "a program for people: its output is what it is for"
)]

mod bench;
mod conformance;
mod counts;
mod docs;
mod python;
mod report;
mod schema;
mod test;
mod workspace;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(
    name = "cargo xtask",
    bin_name = "cargo xtask",
    about = "What people and CI run"
)]
struct Args {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Formatter, clippy, docs, Rust tests and the Python oracles: what CI runs.
    Test(test::Args),
    /// Compare the speed of this project with a peer, in one run.
    #[command(subcommand)]
    Bench(bench::Bench),
    /// Compare what the program renders with what Isaac Sim rendered; exit code 1 where they differ, 2 without the data.
    Conformance(conformance::Args),
    /// Build the manual of the Python package into target/docs-python
    Docs,
    /// Write the JSON schemas of the catalog's files anew.
    Schema,
}

fn main() -> ExitCode {
    let result = match Args::parse().task {
        Task::Test(args) => return test::run(&args),
        Task::Conformance(args) => return conformance::run(&args),
        Task::Bench(bench) => bench::run(&bench),
        Task::Docs => docs::run(),
        Task::Schema => schema::run(),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            println!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
